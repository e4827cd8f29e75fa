#!/usr/bin/env python3
"""Makes pages of the documents: documents.py ROOT OUT_FOLDER --style FILE… --script FILE… --put NAME=FILE… [--address URL]

README.md becomes index.html, below the live hare of web/documents/landing.html instead of its heading and its picture; CONTRIBUTING.md,
CHANGELOG.md and the pages below docs/ keep their names. Links between them lead from page to page, to headings as GitHub names them; pictures and data in docs/ come along. A link to another file of the repository, which the
pages do not have, is left as text with the file's name. A link to a file or heading that does not exist is refused.
Needs markdown-it-py and Pygments (packages python3-markdown-it and python3-pygments)."""
import argparse
import os
import re
import shutil
import sys
from html import escape
from pathlib import Path

from markdown_it import MarkdownIt
from pygments.lexers import get_lexer_by_name
from pygments.token import Token
from pygments.util import ClassNotFound

from bundle import inlined, packed
from pages import navigation, picture

FOLDER = Path(__file__).resolve().parent / "documents"
# The class of a word of code, by its kind; the first that fits.
CLASSES = {Token.Comment.Preproc: "k", Token.Comment.PreprocFile: "s", Token.Comment: "c", Token.Keyword: "k", Token.Operator.Word: "k",
           Token.Literal.String: "s", Token.Literal.Number: "n", Token.Name.Function: "f", Token.Name.Class: "f", Token.Name.Tag: "f",
           Token.Name.Builtin: "f", Token.Name.Attribute: "f"}


def highlighted(code, language):
    """The code as HTML, with the classes of documents.css."""
    lexer = get_lexer_by_name({"wgsl": "rust"}.get(language, language), stripnl=False)  # older versions do not know WGSL, which looks like Rust
    spans = []
    for kind, text in lexer.get_tokens(code):
        name = next((name for of, name in CLASSES.items() if kind in of), None)
        spans.append(f'<span class="{name}">{escape(text, quote=False)}</span>' if name else escape(text, quote=False))
    return "".join(spans)


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
        return Path("index.html") if file == self.root / "README.md" else file.relative_to(self.root).with_suffix(".html")

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


def landing(page, scripts, put):
    """The page of README.md with the live hare above it, which has the same heading and picture."""
    text = (FOLDER / "landing.html").read_text(encoding="utf-8").replace("/*SCRIPT*/", inlined(scripts))
    for name, file in (item.split("=", 1) for item in put):
        text = text.replace(f"<!--{name}-->", packed(file))
    rest, count = re.subn(r"<h1[^>]*>.*?</h1>\n|<p><img[^>]*></p>\n", "", page, flags=re.S)
    if count != 2:
        sys.exit(f"documents.py: README.md has not one heading and one picture of its own, which the first page replaces, but {count} of both")
    return text, rest


def whole(title, body, style, page, address, head=""):
    up = "../" * page.count("/")
    return ('<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f'<meta name="color-scheme" content="light dark">\n<title>{escape(title)}</title>\n'
            f'<meta property="og:title" content="{escape(title)}">\n<meta property="og:image" content="{escape(picture(page, address))}">\n'
            f'<link rel="icon" href="data:,">\n<style>{style}</style>\n<body>\n{navigation(page)}\n{head}<main class="prose">{body}</main>\n'
            f'<footer><a href="{up}CHANGELOG.html">Changes</a> <a href="{up}CONTRIBUTING.html">Contributing</a></footer>\n'
            f'<script>{(FOLDER / "copy.js").read_text(encoding="utf-8")}</script>\n</body>\n</html>\n')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--style", nargs="+", required=True)
    parser.add_argument("--script", nargs="+", required=True)
    parser.add_argument("--put", nargs="+", required=True)
    parser.add_argument("--address", default="")
    given = parser.parse_args()
    documents = Documents(given.root.resolve())
    style = "".join(Path(s).read_text(encoding="utf-8") for s in given.style)
    bodies = {file: documents.body(file) for file in documents.tokens}
    if documents.faults:
        sys.exit("".join(f"documents.py: {fault}\n" for fault in documents.faults))
    for file, body in bodies.items():
        page = documents.page_of(file)
        title = re.sub(r"<[^>]*>", "", re.search(r"<h1[^>]*>(.*?)</h1>", body)[1])
        (given.out / page).parent.mkdir(parents=True, exist_ok=True)
        head = ""
        if page.name == "index.html":
            title, (head, body) = "restrip: triangle strips maintained while the mesh changes", landing(body, given.script, given.put)
        (given.out / page).write_text(whole(title, body, style, page.as_posix(), given.address, head), encoding="utf-8")
    for name in documents.copied:
        shutil.copyfile(documents.root / name, given.out / name)


if __name__ == "__main__":
    main()
