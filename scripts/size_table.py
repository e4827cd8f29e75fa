#!/usr/bin/env python3
"""Prints how large tables and code are, for docs/tables.md.

families: rules and bytes of each family of tables, k <= 8.
programs: bytes of split and collapse of a StripMesh, compiled by g++ -Os -DNDEBUG against single headers with tables up to
          different k.
"""
import argparse
import os
import re
import subprocess
import tempfile

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LINE = re.compile(r"^(\S+) +\d+ (?:sections|classes) +(\d+) (?:rules|rows) +(\d+) bytes$", re.M)
NOTES = {"fan-collapse": "fan-collapse (both collapses of open fans)", "linked": "linked (`linked.hpp` alone)",
         "automaton": "automaton (all valences); rows of its certificate"}
SOURCE = """#include <restrip/restrip.hpp>
using namespace restrip;
Rewrite<StripMesh::Halfedge> do_split(StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where, Vertex v) {
  return split(mesh, where, v);
}
Rewrite<StripMesh::Halfedge> do_collapse(StripMesh& mesh, StripMesh::Halfedge chord) { return collapse(mesh, chord); }
"""


def make_tables(generate, k, folder):
    out = subprocess.check_output([generate, "tables", "--max-k", str(k), "--threads", "2", "--out", folder], text=True)
    return {family: (int(rules), int(size)) for family, rules, size in LINE.findall(out)}


def row_starts(k):
    """Bytes: for closed and for open fans two for each of 2^(k + 1) masks."""
    return 2 * 2 * 2 ** (k + 1)


def print_families(generate):
    print("| family | rules | bytes of read-only data |\n| --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for family, (rules, size) in make_tables(generate, 8, folder).items():
            print(f"| {NOTES.get(family, family)} | {rules:,} | {size:,} |")
    print(f"| row starts, for those up to fan-collapse | | {row_starts(8):,} |")


def section_bytes(path, pattern):
    lines = subprocess.check_output(["size", "-A", path], text=True).splitlines()
    return sum(int(line.split()[1]) for line in lines if re.match(pattern, line))


def print_programs(generate):
    print("| `--max-k` | single header | read-only data | code | exception tables |\n| --- | --- | --- | --- | --- |")
    for k in (8, 7, 6, 5, 4):
        with tempfile.TemporaryDirectory() as folder:
            make_tables(generate, k, folder)
            source, header, compiled = (os.path.join(folder, name) for name in ("a.cpp", "restrip/restrip.hpp", "a.o"))
            subprocess.check_call([os.path.join(HERE, "scripts/amalgamate.py"), "--tables", os.path.join(folder, "include"),
                                   "-o", header])
            with open(source, "w", encoding="utf-8") as file:
                file.write(SOURCE)
            subprocess.check_call(["g++", "-std=c++20", "-Os", "-DNDEBUG", "-I", folder, "-c", source, "-o", compiled])
            print(f"| {k} | {os.path.getsize(header):,} | {section_bytes(compiled, '.rodata'):,} | "
                  f"{section_bytes(compiled, '.text'):,} | {section_bytes(compiled, '.eh_frame|.gcc_except'):,} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/size_table.py build/release/bin/restrip-generate programs")
    parser.add_argument("generate", help="restrip-generate")
    parser.add_argument("table", choices=["families", "programs"])
    arguments = parser.parse_args()
    if arguments.table == "families":
        print_families(arguments.generate)
    else:
        print_programs(arguments.generate)


main()
