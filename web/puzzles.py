#!/usr/bin/env python3
"""Makes the table of the puzzles of the viewer's part Your turn: puzzles.py CERTIFICATE MET.csv OUT

CERTIFICATE is the certificate of splits (docs/reference/certificate.md); MET.csv says how often splits of real meshes use a rule (scripts/met_rules.mjs).
First how many splits were counted, then a line for each column of the table of rules, which compresses better than rows: the number
of splits that use it, k, a, solid ports and joined pairs as masks, and its reason, in the certificate's words. The rules are in the
certificate's order."""
import csv
import re
import sys
from pathlib import Path


def main():
    certificate, counts, out = map(Path, sys.argv[1:])
    with counts.open(encoding="ascii", newline="") as file:
        met = {name: sum(map(int, each)) for name, *each in list(csv.reader(file))[1:]}
    rows, section = [], None
    for line in certificate.read_text(encoding="ascii").split("\n"):
        if line.startswith("section "):
            section = re.fullmatch(r"section k (\d+) a (\d+)", line).groups()
        elif line.startswith("rule "):
            ports, joined, _, _, reason = re.fullmatch(r"rule (\w+) (\w+) (\w+) (\w+) because (.+)", line).groups()
            name = "-".join(["split", *section, ports, joined])
            rows.append((str(met.get(name, 0)), *section, ports, joined, reason))
    if not rows:
        sys.exit(f"puzzles.py: {certificate}: has no rules")
    out.write_text("\n".join([str(sum(met.values())), *map(",".join, zip(*rows))]) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()
