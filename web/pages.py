"""What all pages of the site have in common: the navigation, and the address of their picture."""
import os
from pathlib import PurePosixPath

# By their places in the site.
PAGES = {"index.html": "restrip", "maker.html": "Make a rule", "viewer.html": "Viewer", "atlas/index.html": "Atlas of rules", "docs/README.html": "Documents"}


def navigation(page):
    """The links from the page at this place to all of PAGES; its own is marked."""
    folder = PurePosixPath(page).parent
    links = (f'<a href="{os.path.relpath(to, folder)}"{" aria-current=" + chr(34) + "page" + chr(34) if to == page else ""}>{name}</a>'
             for to, name in PAGES.items())
    return f'<nav aria-label="Pages">{" ".join(links)}</nav>'


def picture(page, address):
    """The address of the picture that links to the page show: absolute if the address of the site is known."""
    name = "docs/ribbon.png"
    return f"{address.rstrip('/')}/{name}" if address else os.path.relpath(name, PurePosixPath(page).parent)
