#!/usr/bin/env python3
"""Joins the library's headers and tables into one file: everything that restrip/restrip.hpp includes.

With --stand-ins, FILE lies in a folder restrip/, and next to it is written a file for every other header of the library:
one that includes FILE, for a header that is part of it, and a copy of the others (adapters). So sources that
include single headers, as our tests do, can be compiled against FILE.
"""
import argparse
import os
import re
import sys

OURS = re.compile(r'^#include "(restrip/[^"]+)"$')
STANDARD = re.compile(r"^#include <([a-z_0-9]+)>$")
FIRST = "restrip/restrip.hpp"


class Amalgamation:
    def __init__(self, folders):
        self.folders = folders
        self.seen = set()  # names of headers, as they are included
        self.standard = set()
        self.lines = []

    def read(self, name):
        for folder in self.folders:
            path = os.path.join(folder, name)
            if os.path.exists(path):
                with open(path, encoding="utf-8") as file:
                    return file.read().splitlines()
        sys.exit(f"amalgamate.py: {name}: is in none of {', '.join(self.folders)}")

    def add(self, name):
        if name in self.seen:
            return
        self.seen.add(name)
        body = []
        for number, line in enumerate(self.read(name), 1):
            ours, standard = OURS.match(line), STANDARD.match(line)
            if ours:
                self.flush(name, body)
                self.add(ours[1])
            elif standard:
                self.standard.add(standard[1])
            elif line.startswith("#include"):
                sys.exit(f"amalgamate.py: {name}:{number}: an include of neither restrip nor the standard library: {line}")
            elif line != "#pragma once":
                body.append(line)
        self.flush(name, body)

    def flush(self, name, body):
        if any(line.strip() for line in body):
            self.lines += ["", f"// ---- {name}", ""] + body
        body.clear()


def write(path, lines):
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def write_stand_ins(folder, joined):
    for source in joined.folders:
        for place, _, files in os.walk(source):
            for name in (os.path.relpath(os.path.join(place, file), source) for file in files if file.endswith(".hpp")):
                if name not in joined.seen:
                    write(os.path.join(folder, name), joined.read(name))
                elif name != FIRST:
                    write(os.path.join(folder, name), ["#pragma once", f'#include "{FIRST}"'])


def main():
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/amalgamate.py -o restrip.hpp")
    parser.add_argument("-o", "--out", required=True, metavar="FILE")
    parser.add_argument("--stand-ins", action="store_true", help="write the headers that include FILE as well")
    parser.add_argument("--tables", metavar="FOLDER", help="take tables from here: the include folder that restrip-generate wrote")
    arguments = parser.parse_args()
    if arguments.stand_ins and not os.path.abspath(arguments.out).endswith("/" + FIRST):
        sys.exit(f"amalgamate.py: {arguments.out}: with --stand-ins the file must be called {FIRST}")
    folders = [os.path.join(here, "runtime/include"), os.path.join(here, "tables/include")]
    if arguments.tables:
        if not os.path.exists(os.path.join(arguments.tables, "restrip/tables/split.hpp")):
            sys.exit(f"amalgamate.py: {arguments.tables}: no tables there; make some with restrip-generate tables --out")
        folders.insert(0, arguments.tables)
    joined = Amalgamation(folders)
    joined.add(FIRST)
    with open(os.path.join(here, "LICENSE"), encoding="utf-8") as file:
        licence = ["// " + line if line else "//" for line in file.read().splitlines()]
    text = ["// restrip in one header, made by scripts/amalgamate.py. Do not edit.", "//"] + licence + ["#pragma once", ""]
    # First the description and the check of the standard in restrip.hpp: otherwise a compiler of an older standard
    # would first miss headers.
    begin = joined.lines.index("#else") + 1
    text += joined.lines[:begin] + [""] + [f"#include <{name}>" for name in sorted(joined.standard)] + joined.lines[begin:]
    write(arguments.out, re.sub(r"\n{3,}", "\n\n", "\n".join(text)).split("\n"))
    if arguments.stand_ins:
        write_stand_ins(os.path.dirname(os.path.dirname(os.path.abspath(arguments.out))), joined)


main()
