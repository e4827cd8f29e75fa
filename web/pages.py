"""What all pages of the site have in common: the head, the navigation, and the address of their picture."""
import os
from html import escape
from pathlib import PurePosixPath

# By their places in the site.
PAGES = {"index.html": "restrip", "maker.html": "Make a rule", "viewer.html": "Viewer", "atlas/index.html": "Atlas of rules", "docs/README.html": "Documents"}
# A strip of three triangles.
ICON = ("data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16' stroke='%23fff' stroke-linejoin='round'%3E"
        "%3Cpath d='M1 14 6 2l5 12z' fill='%230b5cad'/%3E%3Cpath d='M6 2h9l-4 12z' fill='%23e8a200'/%3E%3C/svg%3E")


def navigation(page):
    """The links from the page at this place to all of PAGES; its own is marked, or the one of its part."""
    folder = PurePosixPath(page).parent
    part = "atlas/index.html" if page.startswith("atlas/") else "docs/README.html"

    def mark(to):
        if to == page:
            return ' aria-current="page"'
        return ' aria-current="true"' if page not in PAGES and to == part else ""
    links = (f'<a href="{os.path.relpath(to, folder)}"{mark(to)}>{name}</a>' for to, name in PAGES.items())
    return f'<nav aria-label="Pages">{" ".join(links)}</nav>'


def picture(page, address):
    """The address of the picture that links to the page show: absolute if the address of the site is known."""
    name = "docs/ribbon.png"
    return f"{address.rstrip('/')}/{name}" if address else os.path.relpath(name, PurePosixPath(page).parent)


def head(title, description, page, address, has_picture=True):
    """What is in front of the styles of the page at this place."""
    title, description = escape(title), escape(description)
    shown = (f'<meta property="og:image" content="{escape(picture(page, address))}">\n'
             '<meta property="og:image:width" content="1200">\n<meta property="og:image:height" content="630">\n'
             '<meta property="og:image:alt" content="A mesh at three levels of detail, each one strip">\n'
             '<meta name="twitter:card" content="summary_large_image">\n') if has_picture else ""
    return ('<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f'<meta name="color-scheme" content="light dark">\n<title>{title}</title>\n<meta name="description" content="{description}">\n'
            f'<meta property="og:title" content="{title}">\n<meta property="og:description" content="{description}">\n'
            f'{shown}<link rel="icon" href="{ICON}">\n')
