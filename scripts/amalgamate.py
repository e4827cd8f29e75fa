#!/usr/bin/env python3
"""Joins the library into two files for programs that copy it: restrip.hpp has all public headers and the tables,
restrip.cpp the sources. Compile restrip.cpp once with your program: c++ -std=c++20 main.cpp restrip.cpp
"""
import argparse
import os
import re
import sys

OURS = re.compile(r'^#include "([^"]+)"$')
STANDARD = re.compile(r"^#include <([a-z_0-9]+)>$")
FIRST = "restrip/restrip.hpp"


class Amalgamation:
    """The text of files and of what they include, each once. `included` are files that are there already."""

    def __init__(self, folders, included=()):
        self.folders = folders
        self.seen = set(included)  # names of headers, as they are included
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
            elif line.startswith("#include") and line != "#include RESTRIP_USER_CONFIG":
                sys.exit(f"amalgamate.py: {name}:{number}: an include of neither restrip nor the standard library: {line}")
            elif line != "#pragma once":
                body.append(line)
        self.flush(name, body)

    def flush(self, name, body):
        if any(line.strip() for line in body):
            self.lines += ["", f"// ---- {name}", ""] + body
        body.clear()

    def includes(self):
        return [f"#include <{name}>" for name in sorted(self.standard)]


def write(path, lines):
    with open(path, "w", encoding="utf-8") as file:
        file.write(re.sub(r"\n{3,}", "\n\n", "\n".join(lines) + "\n"))


def main():
    here = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/amalgamate.py --out my-project/restrip")
    parser.add_argument("-o", "--out", required=True, metavar="FOLDER", help="is made; receives restrip.hpp and restrip.cpp")
    parser.add_argument("--tables", metavar="FOLDER", help="take tables from here: the include folder that restrip-generate wrote")
    arguments = parser.parse_args()
    folders = [os.path.join(here, "runtime/include"), os.path.join(here, "tables/include")]
    if arguments.tables:
        if not os.path.exists(os.path.join(arguments.tables, "restrip/tables/split.hpp")):
            sys.exit(f"amalgamate.py: {arguments.tables}: no tables there; make some with restrip-generate tables --out")
        folders.insert(0, arguments.tables)
    os.makedirs(arguments.out, exist_ok=True)

    with open(os.path.join(here, "LICENSE"), encoding="utf-8") as file:
        licence = ["// " + line if line else "//" for line in file.read().splitlines()]
    with open(os.path.join(here, "cmake/project.cmake"), encoding="utf-8") as file:
        version = re.search(r"^set\(RESTRIP_VERSION (.+)\)$", file.read(), re.M)[1]
    banner = [f"// restrip {version} in two files, made by scripts/amalgamate.py. Do not edit. Include restrip.hpp, and compile",
              "// restrip.cpp once with your program: c++ -std=c++20 main.cpp restrip.cpp", "//"] + licence
    public = Amalgamation(folders)
    public.add(FIRST)
    # First the description and the check of the standard in restrip.hpp: otherwise a compiler of an older standard
    # would first miss headers.
    begin = public.lines.index("#else") + 1
    write(os.path.join(arguments.out, "restrip.hpp"),
          banner + ["#pragma once", ""] + public.lines[:begin] + [""] + public.includes() + public.lines[begin:])

    sources = os.path.join(here, "runtime/src")
    private = Amalgamation([sources] + folders, public.seen)
    for place, inner, files in sorted(os.walk(sources)):
        for name in sorted(file for file in files if file.endswith(".cpp")):
            private.add(os.path.relpath(os.path.join(place, name), sources))
    write(os.path.join(arguments.out, "restrip.cpp"),
          banner + ["", '#include "restrip.hpp"', ""] + private.includes() + private.lines)


main()
