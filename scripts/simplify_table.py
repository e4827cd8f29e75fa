#!/usr/bin/env python3
"""Compares our simplifier with meshoptimizer's and OpenMesh's and writes docs/results-simplify.csv: the distance between
mesh and result in 1e-5 of the diagonal, sampled in both directions; the area that faces away from the mesh, in per cent;
and the processor time as a multiple of meshoptimizer's. bench/render.py makes a table of docs/results.md of it.

Without MESH: bunny, fandisk, rocker-arm and nefertiti of the folder RESTRIP_MESHES.
"""
import argparse
import csv
import os
import pathlib
import subprocess
import sys

PERCENTS = ["50", "10", "2"]
MESHES = ["bunny.obj", "fandisk.obj", "rocker-arm.obj", "nefertiti.obj"]
HEAD = ["mesh", "percent", "program", "triangles", "mean_distance", "largest_distance", "turned_percent", "time_of_meshoptimizer"]


def measured(program, mesh):
    """The rows of one mesh."""
    done = subprocess.run([program, mesh, *PERCENTS], stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(f"simplify_table.py: {program} {mesh} ended with {done.returncode}")
    rows = list(csv.reader(done.stdout.splitlines()))
    rival = {row[1]: float(row[-1]) for row in rows if row[2] == "meshoptimizer"}
    # The clock has microseconds.
    return [[*row[:-1], f"{float(f'{float(row[-1]) / max(rival[row[1]], 1e-6):.3g}'):g}"] for row in rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/simplify_table.py build/release/bin/bench_simplify")
    parser.add_argument("program", metavar="BENCH_SIMPLIFY", help="cmake -DRESTRIP_BUILD_BENCH=ON builds it")
    parser.add_argument("meshes", metavar="MESH", nargs="*")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path(__file__).parents[1] / "docs/results-simplify.csv")
    given = parser.parse_args()
    if not given.meshes and "RESTRIP_MESHES" not in os.environ:
        parser.error("give a mesh, or the folder of meshes by RESTRIP_MESHES")
    meshes = given.meshes or [os.path.join(os.environ["RESTRIP_MESHES"], mesh) for mesh in MESHES]
    rows = [row for mesh in meshes for row in measured(given.program, mesh)]
    partial = given.out.with_name(given.out.name + ".partial")
    with open(partial, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([HEAD, *rows])
    os.replace(partial, given.out)


if __name__ == "__main__":
    main()
