#!/usr/bin/env python3
"""Draws witnesses of a few classes of two automata, a row for each class and a picture for each of its cases.

Input are the files that `restrip-generate automaton --classes FILE` writes for --cost strips and --cost 2,1,0.
"""
import argparse
import json
from pathlib import Path

import pictures

STRIPS = ["sd", "dSs"]
TURNS = ["dl", "drR"]


def panels(path, witness):
    """One picture with its caption for each case of a class."""
    classes = json.loads(Path(path).read_text(encoding="utf-8"))
    found = next(c for c in classes if c["witness"] == witness)
    for case in found["cases"]:
        text = f"{witness}, case {case['case']}: cost {case['value']}"
        yield pictures.arc_picture(witness, case["links"], text), text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/automaton_picture.py strips.json turns.json automaton.svg")
    parser.add_argument("strips", help="classes of the automaton of fewest strips")
    parser.add_argument("turns", help="classes of an automaton in which swaps have a price")
    parser.add_argument("out", help="the SVG file that is written")
    arguments = parser.parse_args()
    rows = [list(panels(arguments.strips, witness)) for witness in STRIPS]
    rows += [list(panels(arguments.turns, witness)) for witness in TURNS]
    Path(arguments.out).write_text(pictures.sheet(rows, pictures.PATCHES), encoding="utf-8")


if __name__ == "__main__":
    main()
