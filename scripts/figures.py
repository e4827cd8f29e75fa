#!/usr/bin/env python3
"""Writes the figures of the documents anew, or checks that they are what their commands print.

A document marks a table by the command that prints it:

    <!-- figures: COMMAND -->
    the table
    <!-- /figures -->

COMMAND runs in the project's folder; ${MESHES} in it stands for the folder of real meshes (RESTRIP_MESHES).
"""
import argparse
import os
import re
import subprocess
import sys

BARE = re.compile(r"^\|(?: *:?-+:? *\|)+$")
BLOCK = re.compile(r"(<!-- figures: (?P<command>.+?) -->\n)(?P<table>.*?)(<!-- /figures -->)", re.S)


def output_of(command, meshes):
    if "${MESHES}" in command:
        if not meshes:
            return None
        command = command.replace("${MESHES}", meshes)
    return subprocess.run(command, shell=True, check=True, capture_output=True, text=True).stdout


def list_bare(documents):
    """Prints each table with a number behind its first column that no command writes; returns how many there are."""
    count = 0
    for document in documents:
        with open(document, encoding="utf-8") as file:
            lines = BLOCK.sub(lambda block: "\n" * block[0].count("\n"), file.read()).splitlines()
        for number, line in enumerate(lines):
            if not BARE.match(line):
                continue
            rows = []
            for row in lines[number + 1:]:
                if not row.startswith("|"):
                    break
                rows.append(row)
            if any(re.match(r" *\d", cell) for row in rows for cell in row.split("|")[2:]):
                count += 1
                print(f"{document}:{number}: {lines[number - 1]}")
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: RESTRIP_MESHES=meshes scripts/figures.py docs/strips.md")
    parser.add_argument("documents", nargs="+", metavar="DOCUMENT")
    parser.add_argument("--check", action="store_true", help="change nothing; exit with 1 where a table differs")
    parser.add_argument("--only", metavar="TEXT", help="only commands that contain this text")
    parser.add_argument("--bare", action="store_true",
                        help="run nothing; list the tables with figures that no command writes, and exit with 1 if there are any")
    arguments = parser.parse_args()
    if arguments.bare:
        sys.exit(1 if list_bare(arguments.documents) else 0)
    meshes = os.environ.get("RESTRIP_MESHES", "")
    different = skipped = same = 0
    for document in arguments.documents:
        with open(document, encoding="utf-8") as file:
            text = file.read()

        def fresh(block):
            nonlocal different, skipped, same
            command = block["command"]
            if arguments.only and arguments.only not in command:
                return block[0]
            table = output_of(command, meshes)
            if table is None:
                skipped += 1
                print(f"{document}: not run, RESTRIP_MESHES is not set: {command}", file=sys.stderr)
                return block[0]
            if table == block["table"]:
                same += 1
            else:
                different += 1
                print(f"{document}: differs: {command}", file=sys.stderr)
            return block[1] + table + block[4]

        new = BLOCK.sub(fresh, text)
        if new != text and not arguments.check:
            with open(document, "w", encoding="utf-8") as file:
                file.write(new)
    print(f"{same} tables as they were, {different} {'differ' if arguments.check else 'written anew'}, {skipped} not run")
    if arguments.check and different:
        sys.exit(1)


main()
