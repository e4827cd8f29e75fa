#!/usr/bin/env python3
"""scripts/simplify_table.py with BENCH_SIMPLIFY on two height fields: whole tables, in which our surface of a flat one is exact
and nothing of ours is turned over.

    simplify_table_test.py BENCH_SIMPLIFY
"""
import csv
import math
import pathlib
import subprocess
import sys
import tempfile

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts/simplify_table.py"
N = 24


def field(path, height):
    place = lambda x, y: x + y * (N + 1) + 1
    points = [f"v {x} {y} {height(x, y)}" for y in range(N + 1) for x in range(N + 1)]
    faces = [f"f {a} {b} {c}" for y in range(N) for x in range(N)
             for a, b, c in ((place(x, y), place(x + 1, y), place(x + 1, y + 1)), (place(x, y), place(x + 1, y + 1), place(x, y + 1)))]
    path.write_text("\n".join(points + faces) + "\n")


with tempfile.TemporaryDirectory() as scratch:
    folder = pathlib.Path(scratch)
    field(folder / "flat.obj", lambda x, y: 0)
    field(folder / "waves.obj", lambda x, y: 3 * math.sin(x / 3) * math.cos(y / 4))
    run = lambda *meshes: subprocess.run([sys.executable, SCRIPT, sys.argv[1], *meshes, "--out", folder / "table.csv"], capture_output=True, text=True)
    done = run(folder / "flat.obj", folder / "waves.obj")
    assert done.returncode == 0, done.stderr
    rows = list(csv.DictReader(open(folder / "table.csv", encoding="utf-8")))
    assert [(row["mesh"], row["percent"], row["program"]) for row in rows] == [
        (mesh, percent, program) for mesh in ("flat", "waves") for percent in ("50", "10", "2") for program in ("restrip", "meshoptimizer", "openmesh")], rows
    for row in rows:
        value = {field: float(row[field]) for field in list(row)[3:]}
        assert 0 <= value["mean_distance"] <= value["largest_distance"], row
        if row["program"] == "meshoptimizer":
            assert value["time_of_meshoptimizer"] == 1, row
        if row["program"] == "restrip":
            assert 0 < value["triangles"] <= math.ceil(2 * N * N * int(row["percent"]) / 100), row
            assert value["turned_percent"] == 0 and (value["largest_distance"] == 0) == (row["mesh"] == "flat"), row
    ours = [float(row["mean_distance"]) for row in rows if (row["mesh"], row["program"]) == ("waves", "restrip")]
    assert ours == sorted(ours) and ours[0] < ours[2], ours
    kept = (folder / "table.csv").read_text()
    done = run(folder / "missing.obj")
    assert done.returncode != 0 and "missing.obj" in done.stderr, done.stderr
    assert (folder / "table.csv").read_text() == kept
