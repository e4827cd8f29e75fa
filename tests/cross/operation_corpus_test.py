#!/usr/bin/env python3
"""What is no operation on a mesh: where its file gives triangles, generator and verifier refuse it and say where and why; where
it gives graphs, both take it and say `graph only`. Operations given by triangles are not called so.

  operation_corpus_test.py GENERATOR VERIFIER CORPUS SCRATCH
"""
import re
import subprocess
import sys
from pathlib import Path

# The place that both name, and a word of each.
REFUSED = {
    "bad-name": ("before[0]", "20 letters", "20 letters"),
    "both-forms": ("after", "a list of triangles", "a list of 1 to 16 triangles"),
    "boundary-of-a-graph": ("boundary", "given by their triangles", "given by their triangles"),
    "closed": ("before", "close up", "Euler characteristic 2"),
    "crossed-ports": ("after[0]|before[1]", "c b is an edge of the rim after", "a d is on it before"),
    "disconnected": ("before[1]", "not connected to triangle 0", "connected over edges"),
    "handle": ("before", "handle", "Euler characteristic -1"),
    "no-port": ("before", "expected 1 to 8 ports", "expected 1 to 8 ports, found 0"),
    "overlapping-stretches": ("boundary[1]", "in a stretch already", "in two"),
    "parity": ("after[0]|before[0]", "a m is an edge of the rim after", "a b is on it before"),
    "pinched": ("before", "around a are 2 fans", "around a are several"),
    "ring": ("before", "several parts", "Euler characteristic 0"),
    "stretch-to-nowhere": ("boundary[0]", "m is none before", '"m" is not there before'),
    "three-at-an-edge": ("before[2]", "has two triangles already", "found three"),
    "too-many-ports": ("before", "expected 1 to 8 ports", "expected 1 to 8 ports, found 9"),
    "turned-triangle": ("before[1]", "turn one of them", "opposite directions"),
    "vanishing-rim": ("after[0]|before[1]", "edge of the rim", "the same rim"),
    "vertex-twice": ("before[0]", "three different vertices", "three different vertices"),
}
GRAPH_ONLY = "graph only: not checked to be an operation on a mesh\n"


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


def main():
    generator, verifier, corpus, scratch = sys.argv[1:]
    faults = []

    def expect(condition, what):
        if not condition:
            faults.append(what)

    def both(file):
        yield run(generator, "rules", "--operation", file, "--out", scratch)
        certificate = Path(scratch) / "certificates/operations" / (file.stem + ".cert")
        how = ("--certificate", certificate) if certificate.exists() else ("--dump-command", "false")
        yield run(verifier, "--operation", file, *how)

    files = {file.stem: file for file in Path(corpus).glob("refused/*.json")}
    expect(files.keys() == REFUSED.keys(), f"files and expectations differ: {files.keys() ^ REFUSED.keys()}")
    for name, (place, *words) in REFUSED.items():
        for done, word in zip(both(files[name]), words):
            expect(done.returncode != 0, f"{name}: taken")
            where = "|".join(re.escape(p) for p in place.split("|"))
            expect(re.search(rf"{name}\.json:\d+(:\d+)?: ({where}): ", done.stderr), f"{name}: the place is not {place}: {done.stderr}")
            expect(re.search("|".join(re.escape(w) for w in word.split("|")), done.stderr), f"{name}: expected {word}: {done.stderr}")
    graphs = sorted(Path(corpus).glob("graphs/*.json"))
    shipped = sorted((Path(__file__).resolve().parents[2] / "tables/operations").glob("*.json"))
    expect(len(graphs) >= 4 and len(shipped) >= 10, "files are missing")
    for file in graphs + shipped:
        for done in both(file):
            expect(done.returncode == 0, f"{file.stem}: {done.stderr}{done.stdout[-300:]}")
            expect((GRAPH_ONLY in done.stdout) == (file in graphs), f"{file.stem}: graph only, or not? {done.stdout[-300:]}")
    print("\n".join(faults) or f"{len(files)} refused, {len(graphs)} graphs, {len(shipped)} on a mesh")
    sys.exit(bool(faults))


main()
