#!/usr/bin/env python3
"""Makes one file of a page, which opens from the file system: styles, scripts, the WebAssembly module and the mesh
are put inside.

bundle.py PAGE.html OUT.html --place PLACE [--address URL] [--style FILE…] [--script FILE…] [--worker FILE…]
          [--part NAME=FILE…] [--code NAME=FILE…] [--put NAME=FILE…]

Scripts are ES modules in the order in which they need each other; their import and export words are taken out, so that
names at their top levels must differ; whole-line comments and indentation are left out. Scripts of a worker are bundled
in the same way. --part replaces <!--NAME--> by the file as it is, --code by its text, coloured, --put by the file,
compressed and in base64. --place is the place of the page in the site, for <!--NAVIGATION-->; title and description
become its whole head, in which --address of the site makes the address of the page's picture absolute."""
import argparse
import base64
import gzip
import html
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from pages import head, navigation  # noqa: E402


def inlined(scripts):
    out, seen = [], {}
    for path in scripts:
        text = Path(path).read_text(encoding="utf-8")
        text = re.sub(r"^import \{[^}]*\} from '[^']*';\n", "", text, flags=re.M)
        text = re.sub(r"^export (?=(async )?(const|class|function))", "", text, flags=re.M)
        if re.search(r"^(import|export)\b", text, flags=re.M):
            sys.exit(f"bundle.py: {path}: an import or export of a form that is not known here")
        for name in re.findall(r"^(?:async )?(?:const|let|class|function) (\w+)", text, flags=re.M):
            if name in seen:
                sys.exit(f"bundle.py: {path}: {name} is a name in {seen[name]} as well")
            seen[name] = path
        if "</script" in text:
            sys.exit(f"bundle.py: {path}: has </script in it")
        out.append(re.sub(r"^[ \t]+|^[ \t]*//.*\n", "", text, flags=re.M))
    return "\n".join(out)


def packed(file):
    return base64.b64encode(gzip.compress(Path(file).read_bytes(), 9, mtime=0)).decode("ascii")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page")
    parser.add_argument("out")
    parser.add_argument("--place", required=True)
    parser.add_argument("--address", default="")
    parser.add_argument("--style", nargs="*", default=[])
    parser.add_argument("--script", nargs="*", default=[])
    parser.add_argument("--worker", nargs="*", default=[])
    parser.add_argument("--part", nargs="*", default=[])
    parser.add_argument("--code", nargs="*", default=[])
    parser.add_argument("--put", nargs="*", default=[])
    given = parser.parse_args()
    page = Path(given.page).read_text(encoding="utf-8")
    parts = {"/*STYLE*/": "".join(Path(s).read_text(encoding="utf-8") for s in given.style), "/*SCRIPT*/": inlined(given.script),
             # From the file system, browsers do not start a worker that is a module, and only modules have an address.
             "/*WORKER*/": inlined(given.worker).replace("import.meta.url", "'file:///'")}
    for part in given.part:
        name, file = part.split("=", 1)
        parts[f"<!--{name}-->\n"] = Path(file).read_text(encoding="utf-8")
    for code in given.code:
        from highlight import highlighted  # Pygments, which pages without code do not need
        name, file = code.split("=", 1)
        parts[f"<!--{name}-->"] = highlighted(Path(file).read_text(encoding="utf-8").rstrip("\n"), "js" if file.endswith(".mjs") else "cpp").rstrip("\n")
    for put in given.put:
        name, file = put.split("=", 1)
        parts[f"<!--{name}-->"] = packed(file)
    parts["<!--NAVIGATION-->"] = navigation(given.place)
    page = re.sub(r'<title>(.*)</title>\n<meta name="description" content="(.*)">\n',
                  lambda found: head(html.unescape(found[1]), html.unescape(found[2]), given.place, given.address), page, count=1)
    for mark, text in parts.items():
        if text and mark not in page:
            sys.exit(f"bundle.py: {given.page}: has no {mark}")
        page = page.replace(mark, text)
    Path(given.out).parent.mkdir(parents=True, exist_ok=True)
    Path(given.out).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
