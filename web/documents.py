#!/usr/bin/env python3
"""Makes pages of the documents: documents.py ROOT OUT_FOLDER --style FILE…

README.md becomes index.html; CONTRIBUTING.md, CHANGELOG.md and the pages below docs/ keep their names. Links between them lead from page to
page, to headings as GitHub names them; pictures and data in docs/ come along. A link to another file of the repository, which the
pages do not have, is left as text with the file's name. A link to a file or heading that does not exist is refused.
Needs markdown-it-py (package python3-markdown-it)."""
import argparse
import os
import re
import shutil
import sys
from html import escape
from pathlib import Path

from markdown_it import MarkdownIt

BUTTONS = ('<p class="buttons"><a class="button" href="maker.html">Make a rule</a> <a class="button" href="viewer.html">See what strips save</a> '
           '<a class="button" href="atlas/index.html">Atlas of rules</a> <a class="button" href="atlas/paint.html">Paint a configuration</a></p>')


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
        html = MarkdownIt("commonmark").renderer.render(tokens, MarkdownIt("commonmark").options, {})
        html = html.replace("<table>", '<div class="wide" tabindex="0"><table>').replace("</table>", "</table></div>")
        html = re.sub(r"<td>(?=[+−-]?\d[\d.,]*( %)?</td>)", '<td class="number">', html)
        return html.replace("<pre>", '<pre tabindex="0">').replace("<th></th>", "<td></td>")


def whole(title, body, style, up):
    return ('<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f'<meta name="color-scheme" content="light dark">\n<title>{escape(title)}</title>\n'
            f'<meta property="og:title" content="{escape(title)}">\n<meta property="og:image" content="{up}docs/ribbon.png">\n'
            f'<link rel="icon" href="data:,">\n<style>{style}</style>\n<body>\n<nav><a href="{up}index.html">restrip</a> <a href="{up}maker.html">Make a rule</a> <a href="{up}viewer.html">Viewer</a> '
            f'<a href="{up}atlas/index.html">Atlas of rules</a></nav>\n<main class="prose">{body}</main>\n</body>\n</html>\n')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--style", nargs="+", required=True)
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
        if page.name == "index.html":
            title, body = "restrip: triangle strips maintained while the mesh changes", body.replace("</h1>", f"</h1>\n{BUTTONS}", 1)
        (given.out / page).write_text(whole(title, body, style, "../" * (len(page.parts) - 1)), encoding="utf-8")
    for name in documents.copied:
        shutil.copyfile(documents.root / name, given.out / name)


if __name__ == "__main__":
    main()
