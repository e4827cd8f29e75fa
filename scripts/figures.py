#!/usr/bin/env python3
"""Writes the figures of the documents again, or compares them with the output of their commands.

A document marks each table with figures by the command that prints it:

    <!-- figures: COMMAND -->
    the table
    <!-- /figures -->

"figures" are the same on every machine and take seconds (CTest compares them), "long figures" are the same too but need
minutes or real meshes, "timed figures" depend on the machine or the compiler. COMMAND runs in the project's folder; ${MESHES}
in it stands for the folder of real meshes (RESTRIP_MESHES). A document that one command writes as a whole names it in its
first line: <!-- page: COMMAND -->. A table that a test compares with the program names the test: <!-- tested: TEST -->.
"""
import argparse
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BIN = "build/release/bin"
BLOCK = re.compile(r"(<!-- (?:(?P<kind>long|timed) )?figures: (?P<command>.+?) -->\n)(?P<table>.*?)(<!-- /figures -->)", re.S)
TESTED = re.compile(r"<!-- tested: [\w.]+ -->\n.*?<!-- /tested -->", re.S)
PAGE = re.compile(r"<!-- page: (?P<command>.+?) -->\n")
RULER = re.compile(r"^\|(?: *:?-+:? *\|)+$")
FIGURE = re.compile(r" *\d")


def kind_of(block):
    return block["kind"] or "quick"


def missing(command, folder):
    """What a command needs and does not find, if anything: its programs must be scripts of ours or have been built."""
    for word in shlex.split(command):
        if word.startswith(BIN + "/"):
            path = folder / word[len(BIN) + 1:]
        elif word.startswith("scripts/"):
            path = ROOT / word
        else:
            continue
        if not os.access(path, os.X_OK):
            return f"{path} is not there"
    return None


def list_bare(document, text, folder):
    """Prints each table that has a number after its first column and no command, and each command that cannot run."""
    faults = 0
    page = PAGE.match(text)
    for match in [page] if page else BLOCK.finditer(text):
        reason = missing(match["command"], folder)
        if reason:
            faults += 1
            print(f"{document}: {reason}: {match['command']}")
    blank = lambda block: "\n" * block[0].count("\n")
    lines = [] if page else TESTED.sub(blank, BLOCK.sub(blank, text)).splitlines()
    for number, line in enumerate(lines):
        if not RULER.match(line):
            continue
        rows = []
        for row in lines[number + 1:]:
            if not row.startswith("|"):
                break
            rows.append(row)
        if any(FIGURE.match(cell) for row in rows for cell in row.split("|")[2:]):
            faults += 1
            print(f"{document}:{number}: no command: {lines[number - 1]}")
    return faults


def output_of(command, folder, meshes):
    """A document keeps its table if any part of the command fails."""
    here = command.replace(BIN + "/", shlex.quote(str(folder)) + "/").replace("${MESHES}", shlex.quote(meshes))
    done = subprocess.run(["bash", "-eo", "pipefail", "-c", here], stdout=subprocess.PIPE, text=True, cwd=ROOT)
    if done.returncode != 0:
        sys.exit(f"figures.py: {missing(command, folder) or f'ended with {done.returncode}'}: {command}")
    return done.stdout


class Figures:
    """The tables of some documents, written again or compared."""

    def __init__(self, arguments):
        self.arguments = arguments
        self.meshes = os.environ.get("RESTRIP_MESHES", "")
        self.same = self.different = self.skipped = 0

    def wanted(self, block):
        return kind_of(block) in self.arguments.kind and self.arguments.only in block["command"]

    def fresh(self, document, block):
        """The block as its command prints it now."""
        if not self.wanted(block):
            return block[0]
        command = block["command"]
        if "${MESHES}" in command and not self.meshes:
            self.skipped += 1
            print(f"{document}: not run, RESTRIP_MESHES is not set: {command}", file=sys.stderr)
            return block[0]
        table = output_of(command, self.arguments.bin, self.meshes)
        if table == block["table"]:
            self.same += 1
        else:
            self.different += 1
            print(f"{document}: differs: {command}", file=sys.stderr)
        return block[1] + table + block[5]

    def go_through(self, document, text):
        new = BLOCK.sub(lambda block: self.fresh(document, block), text)
        if new != text and not self.arguments.check:
            Path(document).write_text(new, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: RESTRIP_MESHES=meshes scripts/figures.py --kind long docs/reference/policies.md")
    parser.add_argument("documents", nargs="*", metavar="DOCUMENT", help="README.md, CONTRIBUTING.md and docs/ when none is given")
    parser.add_argument("--check", action="store_true", help="change nothing; exit with 1 where a table differs")
    parser.add_argument("--kind", action="append", choices=["quick", "long", "timed"],
                        help="which figures; may be repeated; quick ones when none is given")
    parser.add_argument("--only", metavar="TEXT", default="", help="only commands that contain this text")
    parser.add_argument("--bin", type=Path, default=ROOT / BIN, help=f"where the programs are, instead of {BIN}")
    parser.add_argument("--bare", action="store_true",
                        help="run nothing; list the tables with figures that have no command, and the commands that "
                        "are not there, and exit with 1 if there are any")
    arguments = parser.parse_args()
    arguments.kind = arguments.kind or ["quick"]
    arguments.bin = arguments.bin.resolve()
    documents = arguments.documents or [ROOT / name for name in ("README.md", "CONTRIBUTING.md")] + sorted(ROOT.glob("docs/**/*.md"))
    figures, bare = Figures(arguments), 0
    for document in documents:
        try:
            text = Path(document).read_text(encoding="utf-8")
        except (OSError, UnicodeError) as error:
            sys.exit(f"figures.py: {document}: {error}")
        if arguments.bare:
            bare += list_bare(document, text, arguments.bin)
        else:
            figures.go_through(document, text)
    if arguments.bare:
        sys.exit(1 if bare else 0)
    print(f"{figures.same} tables as they were, {figures.different} {'differ' if arguments.check else 'written again'}, "
          f"{figures.skipped} not run")
    if arguments.check and (figures.different or not figures.same):
        sys.exit(1)


main()
