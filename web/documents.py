#!/usr/bin/env python3
"""Makes pages of the documents: documents.py ROOT OUT_FOLDER --style FILE… --script FILE… --put NAME=FILE… [--address URL] [--repository URL]

web/documents/landing.html becomes index.html, with what README.md guarantees; README.md, CONTRIBUTING.md, CHANGELOG.md
and the pages below docs/ keep their names. Links between them lead from page to page, to headings as GitHub names them;
pictures and data in docs/ come along. A link to another file of the repository, which the pages do not have, is left as
text with the file's name. A link to a file or heading that does not exist is refused. Needs markdown-it-py and Pygments
(packages python3-markdown-it and python3-pygments)."""
import argparse
import json
import os
import re
import shutil
import sys
from html import escape, unescape
from pathlib import Path

from markdown_it import MarkdownIt
from pygments.util import ClassNotFound

from bundle import inlined, packed
from highlight import highlighted
from pages import head, navigation

SEARCH = ('<form id="search" role="search" hidden><label>Search the documents <input type="search" name="words" autocomplete="off"></label>'
          '<ul id="found" aria-live="polite"></ul></form>')
FOLDER = Path(__file__).resolve().parent / "documents"
class Documents:
    def __init__(self, root):
        self.root = root
        files = [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")] + sorted((root / "docs").rglob("*.md"))
        self.tokens = {file: MarkdownIt("commonmark").enable("table").parse(file.read_text(encoding="utf-8")) for file in files}
        self.anchors = {file: self.name_headings(tokens) for file, tokens in self.tokens.items()}
        self.copied, self.faults = set(), []

    @staticmethod
    def name_headings(tokens):
        """Gives each heading its id; the names are GitHub's."""
        seen = {}
        for heading, content in zip(tokens, tokens[1:]):
            if heading.type != "heading_open":
                continue
            text = "".join(child.content for child in content.children if child.type in ("text", "code_inline"))
            slug = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
            number = seen[slug] = seen.get(slug, -1) + 1
            heading.attrSet("id", slug if number == 0 else f"{slug}-{number}")
        return {token.attrGet("id") for token in tokens if token.type == "heading_open"}

    def page_of(self, file):
        return file.relative_to(self.root).with_suffix(".html")

    def target(self, file, link):
        """The target of a link on a page, or None for a file that is not part of the pages."""
        if re.match(r"[a-z]+:", link):
            return link
        path, _, anchor = link.partition("#")
        to = Path(os.path.normpath(file.parent / path)) if path else file
        if not to.exists() or (anchor and anchor not in self.anchors.get(to, ())):
            self.faults.append(f"{file.relative_to(self.root)}: links to {link}, which does not exist")
            return None
        if to in self.tokens:
            page = self.page_of(to)
        elif to.parent == self.root / "docs":
            page = to.relative_to(self.root)
            self.copied.add(page)
        else:
            return None
        return (os.path.relpath(page, self.page_of(file).parent) if path else "") + (f"#{anchor}" if anchor else "")

    def rewrite(self, file, children):
        """The same inline tokens with the links and pictures of the page."""
        out, skipped = [], None
        for n, token in enumerate(children):
            if token.type == "image":
                token.attrSet("src", self.target(file, token.attrGet("src")))
            elif token.type == "link_open":
                link = token.attrGet("href")
                to = self.target(file, link)
                if to is None:
                    skipped = link
                    continue
                token.attrSet("href", to)
            elif token.type == "link_close" and skipped:
                name = os.path.normpath(file.parent / skipped).removeprefix(f"{self.root}/")
                if not name.endswith(children[n - 1].content):
                    token.type, token.tag, token.nesting, token.content = "html_inline", "", 0, f" (<code>{escape(name)}</code>)"
                    out.append(token)
                skipped = None
                continue
            out.append(token)
        return out

    def body(self, file):
        tokens = self.tokens[file]
        for token in tokens:
            if token.type == "inline":
                token.children = self.rewrite(file, token.children)
            elif token.type == "fence":
                try:
                    token.content = f'<pre tabindex="0"><code>{highlighted(token.content, token.info or "text")}</code></pre>'
                except ClassNotFound:
                    self.faults.append(f"{file.relative_to(self.root)}: a block of code in {token.info}, a language that Pygments does not know")
                token.type, token.content = "html_block", f'<div class="code">{token.content}</div>\n'
        html = MarkdownIt("commonmark").renderer.render(tokens, MarkdownIt("commonmark").options, {})
        html = html.replace("<table>", '<div class="wide" tabindex="0"><table>').replace("</table>", "</table></div>")
        html = re.sub(r"<table>.*?</table>", lambda table: aligned(table[0]), html, flags=re.S)
        # Short names in tables are not broken at their hyphens.
        html = re.sub(r"<td[^>]*>.*?</td>", lambda cell: re.sub(r"<code>(?=[^< ]{1,30}</code>)", '<code class="word">', cell[0]), html, flags=re.S)
        return html.replace("<pre>", '<pre tabindex="0">').replace("<th></th>", "<td></td>")


def aligned(table):
    """The table with its columns of numbers at the right."""
    rows = [re.findall(r"<t[hd]>.*?</t[hd]>", row, re.S) for row in table.split("</tr>")[:-1]]
    body = [row for row in rows if row and row[0].startswith("<td>")]
    numbers = {n for n in range(len(rows[0])) if body and all(re.fullmatch(r"<td>([+−-]?\d[\d.,]*( %)?|–|)</td>", row[n]) for row in body)}
    place = iter([n in numbers for row in rows for n in range(len(row))])
    return re.sub(r"<(t[hd])>", lambda cell: f'<{cell[1]} class="number">' if next(place) else cell[0], table)


def contents(body):
    """The headings of a page as a list of links."""
    heads = re.findall(r'<h2 id="([^"]*)">(.*?)</h2>', body)
    if len(heads) < 3:
        return ""
    links = "".join(f'<li><a href="#{name}">{re.sub(r"</?a[^>]*>", "", text)}</a></li>' for name, text in heads)
    return f'<nav class="contents" aria-label="Contents of this page"><details open><summary>On this page</summary><ul>{links}</ul></details></nav>'


def anchored(body):
    """Headings below the first lead to themselves."""
    return re.sub(r'<(h[23]) id="([^"]*)">(.*?)</\1>', r'<\1 id="\2">\3 <a class="anchor" href="#\2" aria-label="Link to this heading">#</a></\1>', body)


def words_of(html):
    return " ".join(sorted({word for word in re.findall(r"[a-z0-9_]{2,}", plain(html).lower())}))


def search_index(bodies, documents):
    """A script with a row for each section of each page: [page, title, anchor, heading, its words]."""
    rows = []
    for file, body in bodies.items():
        title = plain(re.search(r"<h1[^>]*>(.*?)</h1>", body)[1])
        for part in re.split(r"(?=<h[123] )", body):
            heading = re.match(r'<h[123] id="([^"]*)"[^>]*>(.*?)</h[123]>', part)
            if heading:
                rows.append([documents.page_of(file).as_posix(), title, heading[1], plain(heading[2]), words_of(part)])
    return f"window.restripIndex = {json.dumps(rows, ensure_ascii=False, separators=(',', ':'))};\n"


def neighbours(root, documents):
    """The pages before and after each, in the order in which docs/README.md leads to them."""
    first = root / "docs/README.md"
    order = [first]
    for link in re.findall(r"\]\(([^)#:]+\.md)\)", first.read_text(encoding="utf-8")):
        to = Path(os.path.normpath(first.parent / link))
        if to in documents.tokens and to not in order:
            order.append(to)
    return {page: (order[n - 1] if n else None, order[n + 1] if n + 1 < len(order) else None) for n, page in enumerate(order)}


def steps(file, beside, titles, documents):
    """Links to the pages before and after."""
    def link(to, kind, arrow):
        if to is None:
            return "<span></span>"
        page = os.path.relpath(documents.page_of(to), documents.page_of(file).parent)
        return f'<a rel="{kind}" href="{page}">{arrow.format(titles[to])}</a>'
    before, after = beside.get(file, (None, None))
    return f'<nav class="steps" aria-label="Previous and next">{link(before, "prev", "← {}")}{link(after, "next", "{} →")}</nav>' if before or after else ""


def commands(file):
    """What to type in each language: after == and its name a line of prose with links, then code."""
    out = []
    for section in file.read_text(encoding="utf-8").removeprefix("== ").split("\n== "):
        name, *lines = section.rstrip("\n").split("\n")
        out.append(f'<div class="get-{name}"><div class="code"><pre tabindex="0"><code>{escape(chr(10).join(lines[1:]), quote=False)}</code></pre></div><p>{lines[0]}</p></div>')
    return "\n".join(out)


def landing(readme, scripts, put, repository):
    """The first page; `readme`: the page of README.md. Without the address of a repository nothing links to the source."""
    source = f'<a href="{escape(repository)}">source</a>' if repository else "source"
    text = (FOLDER / "landing.html").read_text(encoding="utf-8").replace("/*SCRIPT*/", inlined(scripts))
    for name, file in (item.split("=", 1) for item in put):
        text = text.replace(f"<!--{name}-->", packed(file))
    chosen = re.findall(r'<h2 id="what-is-guaranteed">.*?(?=<h2)|<p>The idea is due to.*?</p>', readme, flags=re.S)
    if len(chosen) != 2:
        sys.exit("documents.py: README.md has not one section 'What is guaranteed' and one paragraph 'The idea is due to', which the first page shows")
    return text.replace("<!--SOURCE-->", source).replace("<!--GET-->", commands(FOLDER / "get.txt")).replace("<!--GUARANTEES-->", "".join(chosen))


def whole(title, description, body, style, page, address):
    up = "../" * page.count("/")
    return (f'<!doctype html>\n<html lang="en">\n{head(title, description, page, address)}<style>{style}</style>\n<body>\n{navigation(page)}\n{body}\n'
            f'<footer><a href="{up}README.html">README</a> <a href="{up}CHANGELOG.html">Changes</a> <a href="{up}CONTRIBUTING.html">Contributing</a></footer>\n'
            f'<script>{"".join((FOLDER / name).read_text(encoding="utf-8") for name in ("copy.js", "search.js"))}</script>\n</body>\n</html>\n')


def plain(html):
    return unescape(re.sub(r"<[^>]*>", "", html)).replace("\n", " ").strip()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--style", nargs="+", required=True)
    parser.add_argument("--script", nargs="+", required=True)
    parser.add_argument("--put", nargs="+", required=True)
    parser.add_argument("--address", default="")
    parser.add_argument("--repository", default="")
    given = parser.parse_args()
    documents = Documents(given.root.resolve())
    style = "".join(Path(s).read_text(encoding="utf-8") for s in given.style)
    bodies = {file: documents.body(file) for file in documents.tokens}
    if documents.faults:
        sys.exit("".join(f"documents.py: {fault}\n" for fault in documents.faults))
    titles = {file: plain(re.search(r"<h1[^>]*>(.*?)</h1>", body)[1]) for file, body in bodies.items()}
    beside = neighbours(documents.root, documents)
    (given.out / "docs").mkdir(parents=True, exist_ok=True)
    (given.out / "docs/search-index.js").write_text(search_index(bodies, documents), encoding="utf-8")
    for file, body in bodies.items():
        page = documents.page_of(file)
        (given.out / page).parent.mkdir(parents=True, exist_ok=True)
        title = titles[file]
        first = re.search(r"<p>(?!<img)(.*?)</p>", body, re.S)
        description = re.match(r".{1,200}?[.:](?= |$)|.{1,200}", plain(first[1]) if first else title)[0]
        (given.out / page).write_text(whole(f"{title} – restrip", description, f'<main class="prose">{SEARCH}{contents(body)}{anchored(body)}{steps(file, beside, titles, documents)}</main>', style, page.as_posix(), given.address), encoding="utf-8")
    text = landing(bodies[documents.root / "README.md"], given.script, given.put, given.repository)
    (given.out / "index.html").write_text(whole("restrip: triangle strips maintained while the mesh changes", "About half the indices of a triangle list, "
                                                "while the mesh changes: strips are repaired around each change by proved rules.", text, style, "index.html", given.address), encoding="utf-8")
    for name in documents.copied:
        shutil.copyfile(documents.root / name, given.out / name)


if __name__ == "__main__":
    main()
