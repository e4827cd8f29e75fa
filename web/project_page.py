#!/usr/bin/env python3
"""Makes the project's page of README.md, with the plots of docs/: project_page.py ROOT OUT_FOLDER --style FILE…

Knows as much Markdown as README.md has. What the page leaves out: how to build and use the library.
Documents are linked, as pages with their text."""
import argparse
import re
import shutil
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scripts"))
from plots import escaped  # noqa: E402

SECTIONS = ["restrip", "What is guaranteed", "Figures"]
PLOTS = [("performance-level.svg", "What keeping the strips of the Stanford bunny costs, against how long they stay: see docs/performance.md"),
         ("performance-scale.svg", "The time of a split does not grow with the mesh as the strips of the whole do: see docs/performance.md")]


def inline(text):
    text = escaped(text)
    text = re.sub(r"!\[([^\]]*)\]\(docs/([^)]*)\)", r'<img src="\2" alt="\1">', text)
    text = re.sub(r"\[([^\]]*)\]\((?:http[^)]*)\)", r"\1", text)
    text = re.sub(r"\[([^\]]*)\]\((#[^)]*)\)", r'<a href="\2">\1</a>', text)
    text = re.sub(r"\[([^\]]*)\]\(docs/([\w-]+)\.md[^)]*\)", r'<a href="docs/\2.html">\1</a>', text)
    text = re.sub(r"(?<![>/\w])docs/([\w-]+)\.md", r'<a href="docs/\1.html">\g<0></a>', text)
    text = re.sub(r"\[([^\]]*)\]\(([^)#]*)[^)]*\)", lambda link: link[1] if link[1] == link[2] else f"{link[1]} (<code>{link[2]}</code>)", text)
    text = re.sub(r"\(([^()]*) \((<code>[^<]*</code>)\)\)", r"(\1: \2)", text)
    text = re.sub(r"`([^`]*)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]*)\*\*", r"<strong>\1</strong>", text)
    return re.sub(r"\*([^*]+)\*", r"<em>\1</em>", text)


def table(lines):
    rows = [[inline(cell.strip()) for cell in line.strip("|").split("|")] for line in lines]
    head = "".join(f"<th>{cell}</th>" if cell else "<td></td>" for cell in rows[0])
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows[2:])
    return f'<div class="wide" tabindex="0"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


def blocks(lines):
    out = []
    for block in re.split(r"\n\s*\n", "\n".join(line for line in lines if not line.startswith("<!--"))):
        rows = block.strip("\n").split("\n")
        if rows == [""]:
            continue
        if all(row.startswith("|") for row in rows):
            out.append(table(rows))
        elif re.match(r"\d+\. ", rows[0]):
            items = re.split(r"^\d+\. ", "\n".join(rows), flags=re.M)[1:]
            out.append("<ol>" + "".join(f"<li>{inline(' '.join(item.split()))}</li>" for item in items) + "</ol>")
        else:
            out.append(f"<p>{inline(' '.join(rows))}</p>")
    return "\n".join(out)


def sections(text):
    found, name = {}, None
    for line in text.split("\n"):
        heading = re.match(r"##? (.*)", line)
        if heading:
            name = heading.group(1)
            found[name] = []
        else:
            found[name].append(line)
    return found


def whole(title, body, style, up=""):
    return ('<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f'<meta name="color-scheme" content="light dark">\n<title>{escaped(title)}</title>\n'
            f'<meta property="og:title" content="{escaped(title)}">\n<meta property="og:image" content="{up}ribbon.png">\n'
            f'<link rel="icon" href="data:,">\n<style>{style}</style>\n<body>\n<nav><a href="{up}index.html">restrip</a> <a href="{up}viewer.html">Viewer</a> '
            f'<a href="{up}atlas/index.html">Atlas of rules</a></nav>\n<main class="prose">{body}</main>\n</body>\n</html>\n')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--style", nargs="+", required=True)
    given = parser.parse_args()
    found = sections((given.root / "README.md").read_text(encoding="utf-8"))
    missing = [name for name in SECTIONS if name not in found]
    if missing:
        sys.exit(f"project_page.py: README.md has no section {', '.join(missing)}")
    parts = [f'<h1>restrip</h1>\n{blocks(found["restrip"])}\n<p><a class="button" href="viewer.html">See strips move with the level of detail</a> '
             '<a class="button" href="atlas/index.html">Atlas of rules</a> <a class="button" href="atlas/paint.html">Paint a configuration</a></p>']
    for name in SECTIONS[1:]:
        parts.append(f"<h2 id=\"{name.lower().replace(' ', '-')}\">{escaped(name)}</h2>\n{blocks(found[name])}")
    for file, caption in PLOTS:
        parts.append(f'<figure class="plot"><img src="{file}" alt="{escaped(caption)}"><figcaption>{inline(caption)}</figcaption></figure>')
    given.out.mkdir(parents=True, exist_ok=True)
    body = "\n".join(parts)
    for name in re.findall(r'<img src="([^"]*)"', body):
        shutil.copyfile(given.root / "docs" / name, given.out / name)
    style = "".join(Path(s).read_text(encoding="utf-8") for s in given.style)
    (given.out / "index.html").write_text(whole("restrip: triangle strips kept while the mesh changes", body, style), encoding="utf-8")
    (given.out / "docs").mkdir(exist_ok=True)
    for name in sorted(set(re.findall(r'href="docs/([\w-]+)\.html"', body))):
        text = (given.root / f"docs/{name}.md").read_text(encoding="utf-8")
        (given.out / f"docs/{name}.html").write_text(whole(f"docs/{name}.md – restrip", f'<pre class="document">{escaped(text)}</pre>', style, "../"), encoding="utf-8")


if __name__ == "__main__":
    main()
