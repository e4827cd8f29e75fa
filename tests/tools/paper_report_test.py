#!/usr/bin/env python3
"""Claims: `restrip paper` writes a report, from which scripts/paper_page.py makes CSV files and one page of well-formed,
self-contained HTML with every figure and the numbers of the CSV files. Every run produces the same bytes. Bad input produces no
files, and what is not a report gets no page. (pictures_test.py tests the script's pictures.)

    paper_report_test.py restrip SCRATCH
"""
import csv
import json
import pathlib
import shutil
import subprocess
import sys
from xml.etree import ElementTree

from program import Program

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])
script = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "paper_page.py"
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)


def make_page(folder):
    return subprocess.run([sys.executable, "-B", str(script), str(folder)], capture_output=True, text=True, check=False)


def csv_rows(file, mesh=None):
    """The rows below the header, without the mesh's name in their first column."""
    with (one / file).open(newline="", encoding="utf-8") as lines:
        rows = list(csv.reader(lines))[1:]
    assert all(mesh in (None, row[0]) for row in rows), (file, rows)
    return [row[1:] for row in rows] if mesh else rows


def figures(kind):
    return page.findall(f".//figure[@class='{kind}']")


def table(name):
    """The rows of a table, thousands without commas."""
    return [["".join(cell.itertext()).replace(",", "") for cell in row] for row in page.find(f".//table[@id='{name}']").iter("tr")]


def files(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


# ---- the page and the figures agree
mesh, one, two = scratch / 'a<b>&"c",d.ply', scratch / "one", scratch / "two"  # as awkward as a name can be
run("make-mesh", "--triangles", 1500, "-o", mesh)
printed = run("paper", "--out", one, "--base", 0.05, "--json", "-", mesh).stdout
assert (one / "report.json").read_text() == printed
report = json.loads(printed)
done = make_page(one)
assert done.returncode == 0, done
html = (one / "index.html").read_text(encoding="utf-8")
page = ElementTree.fromstring(html)  # its tags are properly nested
for outside in ("http", "<script", "<img", "<link", "url("):
    assert outside not in html, outside
assert "prefers-color-scheme: dark" in html

# Figures 6, 7 and 8.
assert len(figures("position")) == len(csv_rows("positions.csv")) == 19
assert html.count("stands for") == 9 + 8 + 88 + 55
assert len(figures("lonely")) == sum(row[0] == "6" for row in csv_rows("lonely.csv"))
assert len(csv_rows("rules-4.csv")) == 88 + 55
counts = table("lonely-counts")
assert [row[2] for row in counts[1:]] == [str(count["lonely"]) for count in report["lonely"]] and len(counts) == 16, counts

# One plot of each kind, with points in it.
for kind in ("valence", "isolating", "strips"):
    (plot,) = (ElementTree.tostring(figure, encoding="unicode") for figure in figures(kind))
    assert plot.count("title>") > 2 * 5 and "nan" not in plot and "inf" not in plot, plot

assert [row[:3] for row in table("valence-1")[1:]] == [row[:3] for row in csv_rows("valence.csv", mesh.name)]
isolating = csv_rows("isolating.csv", mesh.name)
assert [row[:4] for row in table("isolating-1")[1:]] == [row[:4] for row in isolating]
assert [row[2] for row in isolating] == [str(policy["isolating"]) for policy in report["meshes"][0]["policies"]]

# The page has a column for each policy, the file a line for each policy and level.
head, *levels = table("strips-1")
assert len(levels) == 12
on_page = {(policy, row[0]): strips for row in levels for policy, strips in zip(head[1:], row[1:])}
assert on_page == {(policy, triangles): strips for policy, triangles, strips, _ in csv_rows("strips.csv", mesh.name)}

# Again, into the same folder and into another: the same bytes, and nothing else there.
first = files(one)
assert sorted(first) == ["index.html", "isolating.csv", "lonely-counts.csv", "lonely.csv", "positions.csv", "report.json",
                         "rules-4.csv", "strips.csv", "valence.csv"], sorted(first)
for folder in (one, two):
    run("paper", "--out", folder, "--base", 0.05, mesh)
    assert make_page(folder).returncode == 0
    assert files(folder) == first, folder

# ---- bad input
good, out = scratch / "a.off", scratch / "out"
run("make-mesh", "--triangles", 200, "-o", good)
run("paper", "--out", out, good, "/no/such/mesh.obj", code=2)
assert not (out / "report.json").exists()
run("paper", "--out", good, good, code=2)
run("paper", "--out", out, code=2)
run("paper", good, code=2)
run("paper", "--levels", 1, "--out", out, good, code=2)

for name, complaint in (("empty", "name a folder that restrip paper wrote"), ("none", "name a folder that restrip paper wrote"),
                        ("broken", "is not a report of restrip paper")):
    folder = scratch / name
    if name != "none":
        folder.mkdir()
    if name == "broken":
        (folder / "report.json").write_text('{"meshes": []}')
    refused = make_page(folder)
    assert refused.returncode != 0 and complaint in refused.stderr and not (folder / "index.html").exists(), refused

# ---- a progressive mesh is replayed as it is
run("make-mesh", "--triangles", 1000, "-o", good)
run("simplify", good, "--base", 0.3, "-o", scratch / "a.pm")
(replayed,) = json.loads(run("paper", "--json", "-", "--out", out, scratch / "a.pm").stdout)["meshes"]
assert replayed["base_triangles"] > 250
assert replayed["policies"][0]["levels"][-1]["triangles"] == replayed["triangles"]
print("paper report: all hold")
