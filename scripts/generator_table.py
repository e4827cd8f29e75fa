#!/usr/bin/env python3
"""Runs the generator and prints a table of one of the documents.

counts:     configurations, orbits and rules that add a strip, for splits and for collapses (docs/explanation/theory.md)
ports:      what splits and collapses would gain if their rules gave solid ports up (docs/explanation/theory.md)
ports-met:  how often splits of real meshes (web/atlas/met.csv) would gain by that (docs/explanation/theory.md)
families:   rules and bytes of each family of tables, k <= 8 (docs/reference/tables.md)
programs:   bytes of split and collapse of a StripMesh, compiled by g++ -Os -DNDEBUG against single headers with tables
            up to different k (docs/reference/tables.md)
operations: claims of the certificates of the shipped operation files, proved by the verifier (docs/tutorials/custom-operation.md)
matchings:  claims of the splits, collapses and the flip of matchings, all positions of a fan together (docs/tutorials/custom-operation.md)
speed:      time to make and to prove the tables of operation files, small and at the limits (docs/tutorials/custom-operation.md)
compiling:  time and memory of compilers that read one header (docs/reference/tables.md)
languages:  bytes of the rule tables in other languages than C++, k <= 8 (docs/how-to/other-languages.md)
automata:   bytes of the automaton in other languages, for two costs (docs/how-to/other-languages.md)
verified:   time of making tables up to different k and of verifying them with what they compile to (docs/how-to/cmake.md)
costs:      the automaton of different costs (docs/explanation/automaton.md)
shards:     time, memory and bytes of tables beyond k = 8, made in three shards (docs/how-to/cluster.md)
"""
import argparse
import csv
import json
import os
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from strips_table import header, line  # noqa: E402

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LINE = re.compile(r"^(\S+) +\d+ (?:sections?|class(?:es)?) +(\d+) (?:rules?|rows?) +(\d+) bytes?$", re.M)
NOTES = {"fan-collapse": "fan-collapse (both collapses of open fans)", "linked": "linked (`linked.hpp` alone)",
         "automaton": "automaton (all valences); rows of its certificate"}
SOURCE = """#include <restrip/restrip.hpp>
using namespace restrip;
Rewrite<StripMesh::Halfedge> do_split(StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where, Vertex v) {
  return split(mesh, where, v);
}
Rewrite<StripMesh::Halfedge> do_collapse(StripMesh& mesh, StripMesh::Halfedge chord) { return collapse(mesh, chord); }
"""


def sizes_in(text):
    """Rules and bytes of each family, as the generator reports them."""
    return {family: (int(rules), int(size)) for family, rules, size in LINE.findall(text)}


def make_tables(generate, k, folder):
    return sizes_in(subprocess.check_output([generate, "tables", "--max-k", str(k), "--threads", "2", "--out", folder], text=True))


def print_counts(generate):
    counts = json.loads(subprocess.check_output([generate, "count", "--json", "-"]))
    header("operation", "k", "configurations", "valid, by a", "orbits of all, by a", "orbits of valid, by a",
           "valid whose rule adds a strip, by a")
    for operation in ("split", "collapse"):
        for row in counts[operation]:
            line([operation, str(row["k"]), f"{row['configurations']:,}"] +
                 ["; ".join(f"{number:,}" for number in row[what]) for what in ("valid", "orbits", "valid_orbits", "costing")])


class Positions:
    """Rules of one position that count strips alone: the best that keep every port, and the best that may give ports up."""

    def __init__(self, generate, family, k, a):
        self.keeping, self.giving = {}, {}  # solid edges after the operation, ports included, by (P, J) of docs/reference/operation-file.md
        self.costing = []                   # valid configurations whose rule adds a strip: keeping, giving
        printed = subprocess.check_output([generate, "describe", "--family", family, "--k", str(k), "--at", str(a)])
        operation = {**json.loads(printed), "cost": [[{"count": "strips"}]]}
        for give_up, solid in (("none", self.keeping), ("all", self.giving)):
            with tempfile.TemporaryDirectory() as out:
                file = os.path.join(out, "operation.json")
                with open(file, "w", encoding="utf-8") as written:
                    json.dump({**operation, "give_up": give_up}, written)
                report = json.loads(subprocess.check_output([generate, "rules", "--operation", file, "--out", out, "--json", "-"]))
                self.costing.append(report["operations"][0]["costing"])
                with open(os.path.join(out, "certificates/operations", operation["name"] + ".cert"), encoding="ascii") as certificate:
                    for word, *masks in (row.split()[:5] for row in certificate if row.startswith(("rule ", "copy "))):
                        ports, joined, after, kept = (int(mask, 16) for mask in masks)
                        solid[ports, joined] = bin(after).count("1") + bin(kept).count("1")
        self.joinable = {}                  # by P: pairs that some recolouring joins which keeps every port
        for ports, joined in self.keeping:
            self.joinable[ports] = self.joinable.get(ports, 0) | joined
        if not self.keeping or self.keeping.keys() != {self.where_all_stay(key) for key in self.giving}:
            raise ValueError(f"{operation['name']}: not the same keys")

    def where_all_stay(self, key):
        """The key of the same configurations where no port may be given up: giving ports up lets more pairs be joined, so J has more."""
        ports, joined = key
        return ports, joined & self.joinable[ports]

    def gains(self, key):
        return self.giving[key] > self.keeping[self.where_all_stay(key)]


def print_ports(generate):
    header("operation", "k", "a", "keys", "keys for which a port given up saves a strip", "valid configurations whose best recolouring adds a strip, ports kept",
           "ports given up")
    for family in ("split", "collapse"):
        for k in range(3, 7):
            for a in range(1, k // 2 + 1):
                rules = Positions(generate, family, k, a)
                line([family, str(k), str(a), str(len(rules.giving)), str(sum(map(rules.gains, rules.giving))), *map(str, rules.costing)])


def print_ports_met(generate):
    header("mesh", "splits with k <= 7", "a port given up saves a strip in", "share")
    rules = {(k, a): Positions(generate, "split", k, a) for k in range(3, 8) for a in range(1, k // 2 + 1)}
    with open(os.path.join(HERE, "web/atlas/met.csv"), encoding="ascii") as file:
        meshes, *rows = list(csv.reader(file))
    for column, mesh in enumerate(meshes[1:], 1):
        splits = gain = 0
        for row in rows:
            family, *words = row[0].split("-")
            if family != "split" or int(words[0]) > 7:
                continue
            k, a, ports, joined = int(words[0]), int(words[1]), int(words[2], 16), int(words[3], 16)
            splits += int(row[column])
            gain += int(row[column]) if rules[k, a].gains((ports, joined)) else 0
        line([mesh, f"{splits:,}", f"{gain:,}", f"{100 * gain / splits:.1f} %"])


def row_starts(k):
    """Bytes: for closed and for open fans two for each of 2^(k + 1) masks."""
    return 2 * 2 * 2 ** (k + 1)


def print_families(generate):
    header("family", "rules", "bytes of read-only data")
    with tempfile.TemporaryDirectory() as folder:
        for family, (rules, size) in make_tables(generate, 8, folder).items():
            line([NOTES.get(family, family), f"{rules:,}", f"{size:,}"])
    line(["row starts, for those up to fan-collapse", "", f"{row_starts(8):,}"])


def print_operations(generate):
    header("file", "operation", "configurations", "valid", "rules", "strips added at worst", "isolated at worst", "bytes")
    folder = os.path.join(HERE, "tables", "operations")
    files = sorted(os.path.join(folder, name) for name in os.listdir(folder))
    with tempfile.TemporaryDirectory() as out:
        report = json.loads(subprocess.check_output([generate, "rules", "--operation", *files, "--out", out, "--json", "-"]))
    for file, row in zip(files, report["operations"]):
        with open(file, encoding="utf-8") as source:
            about = json.load(source)["about"]
        line([f"`{os.path.basename(file)}`", about.rstrip(".")] +
             [f"{row[what]:,}" for what in ("configurations", "valid", "keys", "worst_strips", "worst_isolated", "bytes")])


def print_matchings(generate):
    header("operation", "k", "positions", "valid configurations", "after which more triangles are alone", "how many more at worst", "rules",
           "bytes")
    for family in ("split", "collapse", "flip"):
        for k in (4,) if family == "flip" else range(3, 9):
            with tempfile.TemporaryDirectory() as out:
                files = []
                for at in (0,) if family == "flip" else range(1, k // 2 + 1):
                    place = [] if family == "flip" else ["--k", str(k), "--at", str(at)]
                    files.append(os.path.join(out, f"{at}.json"))
                    with open(files[-1], "wb") as file:
                        file.write(subprocess.check_output([generate, "describe", "--family", family, *place, "--constraint", "matching"]))
                rows = json.loads(subprocess.check_output([generate, "rules", "--operation", *files, "--out", out, "--json", "-"]))["operations"]
            line([family, str(k), str(len(rows))] + [f"{sum(row[what] for row in rows):,}" for what in ("valid", "costing")] +
                 [str(max(row["worst_isolated"] for row in rows))] + [f"{sum(row[what] for row in rows):,}" for what in ("keys", "bytes")])


FILE_LINE = re.compile(r"^(restrip_tables\S+) +(\d+) bytes$", re.M)
DATA_LINE = re.compile(r"^rules up to k = \d+: (\d+) bytes of data$", re.M)
FILE_HOLDS = {"restrip_tables.h": "C99 header: data and look-up", "restrip_tables.glsl": "GLSL: look-up", "restrip_tables.wgsl": "WGSL: look-up",
              "restrip_tables.bin": "data for GLSL and WGSL", "restrip_tables.rs": "Rust module: data and look-up",
              "restrip_tables.json": "data; its schema is [tables.schema.json](tables.schema.json)",
              "restrip_tables.mjs": "JavaScript module: look-up in the JSON file"}
LANGUAGE_NAMES = ("c", "json", "rust", "glsl", "wgsl")


def print_languages(generate):
    header("file", "what it holds", "bytes", "read-only data of a program, bytes")
    with tempfile.TemporaryDirectory() as folder:
        wanted = [word for language in LANGUAGE_NAMES for word in ("--language", language)]
        printed = subprocess.check_output([generate, "tables", "--threads", "2", "--out", folder, *wanted], text=True)
    data = int(DATA_LINE.search(printed)[1])
    for name, size in FILE_LINE.findall(printed):
        line([f"`{name}`", FILE_HOLDS.get(name, "program that prints digests"), f"{int(size):,}", f"{data:,}" if name in ("restrip_tables.h", "restrip_tables.rs", "restrip_tables.bin") else ""])


def section_bytes(path, pattern):
    lines = subprocess.check_output(["size", "-A", path], text=True).splitlines()
    return sum(int(line.split()[1]) for line in lines if re.match(pattern, line))


def print_programs(generate):
    header("`--max-k`", "single header", "read-only data", "code", "exception tables")
    for k in (8, 7, 6, 5, 4):
        with tempfile.TemporaryDirectory() as folder:
            make_tables(generate, k, folder)
            source, single, compiled = (os.path.join(folder, name) for name in ("a.cpp", "restrip/restrip.hpp", "a.o"))
            subprocess.check_call([os.path.join(HERE, "scripts/amalgamate.py"), "--tables", os.path.join(folder, "include"),
                                   "-o", single])
            with open(source, "w", encoding="utf-8") as file:
                file.write(SOURCE)
            subprocess.check_call(["g++", "-std=c++20", "-Os", "-DNDEBUG", "-I", folder, "-c", source, "-o", compiled])
            sizes = [os.path.getsize(single)] + [section_bytes(compiled, part)
                                                 for part in (".rodata", ".text", ".eh_frame|.gcc_except")]
            line([str(k), *(f"{size:,}" for size in sizes)])


def watched(*command):
    """Processor seconds of a command, its largest memory in MiB, and what it prints."""
    with tempfile.TemporaryFile("w+") as printed:
        process = subprocess.Popen(command, stdout=printed)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            raise subprocess.CalledProcessError(process.returncode, command)
        printed.seek(0)
        return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, printed.read()


def print_verified(generate):
    header("`MAX_K`", "generating, seconds", "`t.rules`, seconds", "its largest memory", "bytes of headers")
    sources = [os.path.join(HERE, "runtime", f"dump_{part}.cpp") for part in ("automaton", "linked", "tables")]
    includes = [word for room in ("runtime", "tables") for word in ("-I", os.path.join(HERE, room, "include"))]
    for k in (6, 8, 9):
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as elsewhere:
            made, dump = os.path.join(folder, "include"), os.path.join(elsewhere, "dump")
            generated = watched(generate, "tables", "--max-k", str(k), "--out", folder)
            subprocess.check_call(["g++", "-std=c++20", "-O2", "-I", made, *includes, *sources, "-o", dump])
            verified = watched(os.path.join(os.path.dirname(generate), "restrip-verify"), "--tables-dir", folder,
                               "--max-k", str(k), "--all", "--dump-command", dump)
            line([str(k), f"{generated[0]:.1f}", f"{verified[0]:.1f}", f"{verified[1]:.0f} MiB",
                  f"{bytes_below(made) / 1e6:.1f} MB"])


def least(times, *command):
    """The least processor seconds of N runs, and the largest memory in MiB."""
    runs = [watched(*command) for _ in range(times)]
    return min(seconds for seconds, _, _ in runs), max(memory for _, memory, _ in runs)


def edges_and_ports(side):
    """How many a side without boundary has: a graph, or triangles with named vertices, all edges of which are inner ones or ports."""
    if isinstance(side, dict):
        return len(side["edges"]) + len(side["ports"])
    return len({frozenset(edge) for a, b, c in side for edge in ((a, b), (b, c), (c, a))})


def print_speed(generate):
    header("operation file", "bits before", "bits after", "generating, seconds", "proving, seconds")
    verify = os.path.join(os.path.dirname(generate), "restrip-verify")
    of_a_fan = json.loads(subprocess.check_output([generate, "describe", "--family", "split", "--k", "8", "--at", "4"]))
    with open(os.path.join(HERE, "tables/operations/refine-face.json"), encoding="utf-8") as file:
        red_green = json.load(file)
    strips_alone = {"give_up": "all", "cost": [[{"count": "strips"}]]}
    for name, operation in (("`refine-face.json`", red_green), ("split, k = 8, a = 4", of_a_fan),
                            ("the same, ports may be given up, strips alone count", {**of_a_fan, **strips_alone})):
        with tempfile.TemporaryDirectory() as out:
            file = os.path.join(out, "operation.json")
            with open(file, "w", encoding="utf-8") as written:
                json.dump(operation, written)
            made = least(5, generate, "rules", "--force", "--operation", file, "--out", out)
            certificate = os.path.join(out, "certificates/operations", operation["name"] + ".cert")
            proved = least(5, verify, "--operation", file, "--certificate", certificate)
        line([name, *(str(edges_and_ports(operation[side])) for side in ("before", "after")),
              f"{made[0]:.2f}", f"{proved[0]:.2f}"])


def print_compiling(_):
    header("compiler", "header", "seconds", "memory")
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "a.cpp")
        for compiler in ("g++", os.environ.get("RESTRIP_CLANG", "clang++")):
            name = subprocess.check_output([compiler, "--version"], text=True).split("\n", maxsplit=1)[0]
            for included in ("rules/rules.hpp", "operations/operations.hpp", "search/strips_of.hpp", "search/keeper.hpp", "live_mesh.hpp",
                             "restrip.hpp"):
                with open(source, "w", encoding="utf-8") as file:
                    file.write(f"#include <restrip/{included}>\n")
                seconds, memory = least(5, compiler, "-std=c++20", "-fsyntax-only", "-I", os.path.join(HERE, "runtime/include"), "-I",
                                        os.path.join(HERE, "tables/include"), source)
                line([name, f"`{included}`", f"{seconds:.2f}", f"{memory:.0f} MiB"])


def bytes_below(folder):
    return sum(os.path.getsize(os.path.join(path, name)) for path, _, names in os.walk(folder) for name in names)


def print_shards(generate):
    header("K", "seconds", "the slowest of three shards", "largest memory of a shard", "merge", "rules", "of splits",
           "linked alternatives", "bytes written", "read-only data")
    for k in (8, 9, 10):
        with tempfile.TemporaryDirectory() as folder:
            shards, tables = (os.path.join(folder, name) for name in ("shards", "tables"))
            parts = [watched(generate, "tables", "--max-k", str(k), "--shard", f"{i}/3", "--out", shards)
                     for i in range(1, 4)]
            merge = watched(generate, "merge", "--in", shards, "--out", tables)
            families = sizes_in(merge[2])
            fans = [family for name, family in families.items() if name not in ("linked", "automaton")]
            line([str(k), f"{sum(part[0] for part in parts):.1f}", f"{max(part[0] for part in parts):.1f}",
                  f"{max(part[1] for part in parts):.0f} MiB", f"{merge[0]:.1f} s, {merge[1]:.0f} MiB",
                  f"{sum(rules for rules, _ in fans):,}", f"{families['split'][0]:,}", f"{families['linked'][0]:,}",
                  f"{bytes_below(tables) / 1e6:.1f} MB", f"{sum(size for _, size in families.values()) / 1e6:.1f} MB"])


TABLES = {"counts": print_counts, "ports": print_ports, "ports-met": print_ports_met, "families": print_families,
          "programs": print_programs, "operations": print_operations, "matchings": print_matchings, "speed": print_speed,
          "compiling": print_compiling, "languages": print_languages, "shards": print_shards, "verified": print_verified}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/generator_table.py programs build/release/bin/restrip-generate")
    parser.add_argument("table", choices=TABLES)
    parser.add_argument("generate", help="restrip-generate")
    arguments = parser.parse_args()
    TABLES[arguments.table](arguments.generate)


main()
