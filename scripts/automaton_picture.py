#!/usr/bin/env python3
"""Draws witnesses of two classes of the automaton, a row for each class and a picture for each of its cases.

Input is the automaton's certificate (docs/explanation/automaton.md, "Certificate").
"""
import argparse
from pathlib import Path

import pictures

WITNESSES = ["sd", "dSs"]


class Classes:
    """The classes of a certificate."""

    def __init__(self, path):
        self.number, self.costs, self.to, self.before = {}, {}, {}, {}
        for word, *rest in map(str.split, Path(path).read_text(encoding="ascii").splitlines()):
            if word == "class":
                self.number[rest[1].strip("-")] = rest[0]
            elif word == "value":
                self.costs.setdefault(rest[0], {})[rest[1]] = rest[2]
            elif word == "step":
                self.to[rest[0], rest[1]] = rest[2]
            elif word == "from":
                self.before[tuple(rest[:3])] = rest[3]

    def links(self, witness, case):
        """The colours of the links of a witness in one of its cases, from left to right, in a best colouring."""
        arcs = ["0"]
        for letter in witness:
            arcs.append(self.to[arcs[-1], letter])
        links = [case[1] != "-"]
        for arc, letter in reversed(list(zip(arcs, witness))):
            case = self.before[arc, letter, case]
            links.insert(0, case[1] != "-")
        return links

    def panels(self, witness):
        """One picture with its caption for each case of a class."""
        for case, cost in self.costs[self.number[witness]].items():
            text = f"{witness} {case}: cost {cost}"
            yield pictures.arc_picture(witness, self.links(witness, case), text), text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/automaton_picture.py tables/certificates/automaton.cert automaton.svg")
    parser.add_argument("certificate", help="certificates/automaton.cert")
    parser.add_argument("out", help="the SVG file that is written")
    arguments = parser.parse_args()
    classes = Classes(arguments.certificate)
    rows = [list(classes.panels(witness)) for witness in WITNESSES]
    Path(arguments.out).write_text(pictures.sheet(rows, pictures.PATCHES + "text { font-size: 36px; }\n"), encoding="utf-8")


if __name__ == "__main__":
    main()
