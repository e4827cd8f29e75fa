#!/usr/bin/env python3
"""Adds to the staged files of Debian packages what Debian wants in each: copyright, changelog, and a manual page for each
program, made of its --help. CPack calls it (cmake/DebianFiles.cmake).

debian_files.py SOURCE STAGE VERSION DATE MAINTAINER COMPONENT=PACKAGE…   STAGE has a folder for each component."""
import gzip
import re
import subprocess
import sys
from datetime import datetime, timezone
from email.utils import format_datetime
from pathlib import Path

ABOUT = {
    "restrip": "triangle strips of meshes, maintained while a mesh changes",
    "restrip-generate": "make tables of rules by exhaustive search",
    "restrip-verify": "prove tables of rules",
    "restrip-dump-tables": "print the answers of the compiled tables",
    "restrip-check": "check a recorded run, by functions extracted from Coq",
}


def zipped(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(gzip.compress(text.encode(), 9, mtime=0))


def verbatim(text):
    """Text as it is, for troff."""
    lines = text.replace("\\", "\\e").replace("-", "\\-").split("\n")
    return ".nf\n" + "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in lines).rstrip() + "\n.fi\n"


def help_of(*command):
    return subprocess.run([*map(str, command), "--help"], check=True, stdout=subprocess.PIPE, text=True).stdout


def manual(program, version, date):
    text = help_of(program)
    name = program.name
    page = f'.TH {name.upper()} 1 "{date}" "restrip {version}" "User Commands"\n.SH NAME\n{name} \\- {ABOUT[name]}\n.SH DESCRIPTION\n{verbatim(text)}'
    listed = re.search(r"^Subcommands:\n((?:  .*\n)*)", text, re.M)
    for command in re.findall(r"^  ([a-z][\w-]*)", listed[1], re.M) if listed else []:
        page += f".SH {name} {command}\n{verbatim(help_of(program, command))}"
    return page + ".SH SEE ALSO\nThe documents in /usr/share/doc/restrip (package librestrip\\-dev).\n"


def main():
    source, stage, version, date, maintainer = Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:6]
    day = format_datetime(datetime.fromisoformat(date).replace(tzinfo=timezone.utc))
    entry = f"  * Release; /usr/share/doc/restrip/CHANGELOG.md has the changes.\n\n -- {maintainer}  {day}\n"
    for pair in sys.argv[6:]:
        component, package = pair.split("=")
        root = stage / component / "usr"
        if not root.is_dir():
            sys.exit(f"debian_files.py: {root}: not staged")
        documents = root / "share/doc" / package
        zipped(documents / "changelog.gz", f"restrip ({version}) unstable; urgency=medium\n\n{entry}")
        programs = sorted(root.glob("bin/*"))
        notice = (source / "LICENSE").read_text(encoding="utf-8")
        if programs:  # with a name instead of the text of a licence that every Debian system has
            others = (source / "THIRD-PARTY.txt").read_text(encoding="utf-8")
            notice += "\n\n" + re.sub(r"(\nApache License 2\.0\n-+\n).*", r"\1See /usr/share/common-licenses/Apache-2.0.\n", others, flags=re.S)
        (documents / "copyright").write_text(notice, encoding="utf-8")
        for program in programs:
            zipped(root / f"share/man/man1/{program.name}.1.gz", manual(program, version, date))


main()
