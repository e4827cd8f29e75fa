#!/usr/bin/env python3
"""Joins the library's headers and tables into one file: everything that restrip/restrip.hpp includes."""
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
        self.seen = set()
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


def main():
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, epilog="Example: scripts/amalgamate.py -o restrip.hpp")
    parser.add_argument("-o", "--out", required=True, metavar="FILE")
    arguments = parser.parse_args()
    joined = Amalgamation([os.path.join(here, "runtime/include"), os.path.join(here, "tables/include")])
    joined.add(FIRST)
    with open(os.path.join(here, "LICENSE"), encoding="utf-8") as file:
        licence = ["// " + line if line else "//" for line in file.read().splitlines()]
    text = ["// restrip in one header, made by scripts/amalgamate.py. Do not edit.", "//"] + licence + ["#pragma once", ""]
    text += [f"#include <{name}>" for name in sorted(joined.standard)] + joined.lines
    text = re.sub(r"\n{3,}", "\n\n", "\n".join(text)) + "\n"
    with open(arguments.out, "w", encoding="utf-8") as file:
        file.write(text)


main()
