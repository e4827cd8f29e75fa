#!/usr/bin/env python3
"""Replays a mesh under local rules and prints how often a bolder recolouring would have been valid, for docs/strips.md."""
import json
import subprocess
import sys


def share(part, whole):
    return f"{100 * part / whole:.1f} %"


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: bolder_table.py RESTRIP MESH\nExample: scripts/bolder_table.py build/release/bin/restrip bunny.obj")
    program, mesh = sys.argv[1:]
    command = [program, "replay", mesh, "--base", "0.02", "--repeats", "0", "--json", "-"]
    report = json.loads(subprocess.check_output(command))["best_in_this_mesh"]
    print("| | operations | a bolder recolouring was valid | bolder than the linked rule, too | the local rule adds a strip | "
          "so does the best in that mesh |")
    print("| --- | --- | --- | --- | --- | --- |")
    for kind in ("splits", "collapses"):
        counts = report[kind]
        n = counts["operations"]
        print(f"| {kind} | {n:,} | {share(counts['bolder'], n)} | {share(counts['missed_by_linked'], n)} | "
              f"{share(counts['adding_strip'], n)} | "
              f"{share(counts['adding_strip_at_best'], n)} |")


main()
