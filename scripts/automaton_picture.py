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
HEIGHT = pictures.SIZE + pictures.CAPTION


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
    width = pictures.SIZE * max(map(len, rows))
    style = pictures.PATCH_STYLE.replace(".patch { width: 100%; max-width: 150px; height: auto; } ", "") + pictures.PICTURE_STYLE
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HEIGHT * len(rows)}">\n<style>\n{style}</style>\n'
           '<rect width="100%" height="100%" fill="var(--surface)"/>\n')
    for y, row in enumerate(rows):
        for x, (picture, caption) in enumerate(row):
            svg += (f'<svg x="{pictures.SIZE * x}" y="{HEIGHT * y}" width="{pictures.SIZE}" height="{pictures.SIZE}">{picture}</svg>\n'
                    f'<text x="{pictures.SIZE * x + pictures.SIZE // 2}" y="{HEIGHT * y + pictures.SIZE + 10}" '
                    f'text-anchor="middle">{pictures.escaped(caption)}</text>\n')
    Path(arguments.out).write_text(svg + "</svg>\n", encoding="utf-8")


if __name__ == "__main__":
    main()
