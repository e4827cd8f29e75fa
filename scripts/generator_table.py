#!/usr/bin/env python3
"""Runs the generator and prints a table of one of the documents.

counts:     configurations, orbits and rules that add a strip, for splits and for collapses (docs/explanation/theory.md)
ports-met:  how often splits of real meshes (web/atlas/met.csv) would save a strip by giving a port up
            (docs/explanation/theory.md)
families:   rules and bytes of each family of tables, k <= 8 (docs/reference/tables.md)
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
NOTES = {"automaton": "automaton (all valences); rows of its certificate"}


def sizes_in(text):
    """Rules and bytes of each family, as the generator reports them."""
    return {family: (int(rules), int(size)) for family, rules, size in LINE.findall(text)}


def described(family, k, a):
    """The operation file of a split or collapse at one position: vertex v has k triangles, or v and w have the triangles between
    neighbours 0 and a, and a and k."""
    fan = [["v", f"u{i}", f"u{(i + 1) % k}"] for i in range(k)]
    ring = [["v", "u0", "w"], *(["w", *corners[1:]] for corners in fan[:a]), ["w", f"u{a}", "v"], *fan[a:]]
    before, after = (fan, ring) if family == "split" else (ring, fan)
    return {"restrip_operation": 1, "name": f"{family}-k{k}-a{a}", "before": before, "after": after}


def print_counts(generate):
    header("operation", "k", "configurations", "valid, by a", "orbits of all, by a", "orbits of valid, by a",
           "valid whose rule adds a strip, by a")
    with tempfile.TemporaryDirectory() as out:
        for family in ("split", "collapse"):
            for k in range(3, 9):
                figures = []
                for a in range(1, k // 2 + 1):
                    file = os.path.join(out, "operation.json")
                    with open(file, "w", encoding="utf-8") as written:
                        json.dump(described(family, k, a), written)
                    printed = subprocess.check_output([generate, "rules", "--operation", file, "--language", "json", "--out", out, "--json", "-"])
                    figures += json.loads(printed)["operations"]
                line([family, str(k), f"{figures[0]['configurations']:,}"] +
                     ["; ".join(f"{one[what]:,}" for one in figures) for what in ("valid", "orbits", "valid_orbits", "costing")])


class Positions:
    """Rules of one position that count strips alone: the best that keep every port, and the best that may give ports up."""

    def __init__(self, generate, family, k, a):
        self.keeping, self.giving = {}, {}  # solid edges after the operation, ports included, by (P, J) of docs/reference/operation-file.md
        operation = {**described(family, k, a), "cost": [[{"count": "strips"}]]}
        for give_up, solid in (("none", self.keeping), ("all", self.giving)):
            with tempfile.TemporaryDirectory() as out:
                file = os.path.join(out, "operation.json")
                with open(file, "w", encoding="utf-8") as written:
                    json.dump({**operation, "give_up": give_up}, written)
                subprocess.check_output([generate, "rules", "--operation", file, "--out", out])
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
        """The key of the same configurations if no port may be given up: giving ports up lets more pairs be joined, so J has more."""
        ports, joined = key
        return ports, joined & self.joinable[ports]

    def gains(self, key):
        return self.giving[key] > self.keeping[self.where_all_stay(key)]


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


def print_families(generate):
    header("family", "rules", "bytes of read-only data")
    with tempfile.TemporaryDirectory() as folder:
        printed = subprocess.check_output([generate, "tables", "--threads", "2", "--out", folder], text=True)
        for family, (rules, size) in sizes_in(printed).items():
            line([NOTES.get(family, family), f"{rules:,}", f"{size:,}"])
    line(["row starts, for split and collapse", "", f"{2 * 2 ** 9:,}"])  # two bytes for each of 2^(k + 1) masks


TABLES = {"counts": print_counts, "ports-met": print_ports_met, "families": print_families}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/generator_table.py families build/release/bin/restrip-generate")
    parser.add_argument("table", choices=TABLES)
    parser.add_argument("generate", help="restrip-generate")
    arguments = parser.parse_args()
    TABLES[arguments.table](arguments.generate)


if __name__ == "__main__":
    main()
