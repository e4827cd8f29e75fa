#!/usr/bin/env python3
"""Draws witnesses of two classes of the automaton, a row for each class and a picture for each of its cases.

Input is the file that `restrip-generate automaton --classes FILE` writes.
"""
import argparse
import json
from pathlib import Path

import pictures

WITNESSES = ["sd", "dSs"]


def panels(path, witness):
    """One picture with its caption for each case of a class."""
    classes = json.loads(Path(path).read_text(encoding="utf-8"))
    found = next(c for c in classes if c["witness"] == witness)
    for case in found["cases"]:
        text = f"{witness}, case {case['case']}: cost {case['value']}"
        yield pictures.arc_picture(witness, case["links"], text), text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/automaton_picture.py classes.json automaton.svg")
    parser.add_argument("classes", help="the classes of the automaton")
    parser.add_argument("out", help="the SVG file that is written")
    arguments = parser.parse_args()
    rows = [list(panels(arguments.classes, witness)) for witness in WITNESSES]
    Path(arguments.out).write_text(pictures.sheet(rows, pictures.PATCHES), encoding="utf-8")


if __name__ == "__main__":
    main()
