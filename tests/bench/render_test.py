#!/usr/bin/env python3
"""Tests of bench/render.py on a small recorded run, and of docs/results.md: its tables must come from the renderer (their
numbers come from another machine on another day, and are not compared)."""
import json
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
KINDS = [(r"[\d.,]+ (ns|µs|ms|s)", "time"), (r"[\d.,]+x( to [\d.,]+x)?", "ratio"), (r"[\d.,]+( MiB| %( to [\d.,]+ %)?)?", "number"), (r"", "nothing")]


def kind(cell):
    return next((name for pattern, name in KINDS if re.fullmatch(pattern, cell)), "words")


def tables(page):
    """Every table as its heading cells and its rows of cells."""
    found = []
    for block in re.findall(r"(?:^\|.*\|\n)+", page, re.MULTILINE):
        rows = [[cell.strip() for cell in line.strip("|").split(" | ")] for line in block.splitlines()]
        found.append((rows[0], rows[2:]))
    return found


def shape(page):
    """Per table: its headings, and what kinds of cells each column has."""
    return [(head, [sorted({kind(row[i]) for row in rows} - {"nothing"}) for i in range(len(head))]) for head, rows in tables(page)]


class Render(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.recorded = self.folder / "recorded"
        shutil.copytree(HERE / "recorded", self.recorded)

    def run_renderer(self):
        return subprocess.run([sys.executable, ROOT / "bench/render.py", "--json", self.recorded, "--out", self.folder / "out"],
                              capture_output=True, text=True)

    def page(self):
        done = self.run_renderer()
        self.assertEqual(done.returncode, 0, done.stderr)
        return (self.folder / "out/results.md").read_text()

    def change(self, program, edit):
        path = self.recorded / f"{program}.json"
        content = json.loads(path.read_text())
        edit(content["benchmarks"])
        path.write_text(json.dumps(content))

    def row(self, page, *beginning):
        rows = [row for _, rows in tables(page) for row in rows if row[:len(beginning)] == list(beginning)]
        self.assertEqual(len(rows), 1, beginning)
        return rows[0]

    def test_the_page_is_whole(self):
        page = self.page()
        self.assertNotIn("{{", page)
        self.assertNotRegex(page, r"\bnan\b|\binf\b")
        self.assertEqual(len(tables(page)), 3)
        for head, rows in tables(page):
            self.assertGreater(len(rows), 0, head)
            for row in rows:
                self.assertEqual(len(row), len(head), row)

    def test_docs_have_the_renderers_format(self):
        docs = (ROOT / "docs/results.md").read_text()
        page = self.page()
        headings = lambda text: re.findall(r"^#.*", text, re.MULTILINE)
        self.assertEqual(headings(docs), headings(page))
        self.assertEqual(shape(docs), shape(page))

    def test_the_csv_files(self):
        """They have the same columns as in docs/, a number in each cell but the first, and the medians that were recorded."""
        self.page()
        for name in ("results-scale.csv",):
            files = [[line.split(",") for line in (folder / name).read_text().splitlines()] for folder in (self.folder / "out", ROOT / "docs")]
            self.assertEqual(files[0][0], files[1][0])
            for rows in files:
                self.assertGreater(len(rows), 1)
                for row in rows[1:]:
                    self.assertEqual(len(row), len(rows[0]))
                    self.assertTrue(all(float(cell) > 0 for cell in row[1:]), row)

    def test_medians_and_ratios_of_one_repetition(self):
        def three_repetitions(runs):
            one = next(run for run in runs if run["run_name"].startswith("replay/made/local"))
            runs.remove(one)
            for split, bare in ((100, 50), (300, 100), (200, 40)):
                runs.append({**one, "split_ns": split, "split_bare_ns": bare})
        self.change("replay", three_repetitions)
        row = self.row(self.page(), "made", "`local`")
        # The ratio of the medians would be 4.00x, the mean of the ratios 3.33x.
        self.assertEqual(row[2:4], ["200 ns", "3.00x"])

    def test_aggregates_are_not_counted_twice(self):
        def add_mean(runs):
            one = next(run for run in runs if run["run_name"].startswith("replay/made/local"))
            runs.append({**one, "run_type": "aggregate", "split_ns": 1e9})
        before = self.page()
        self.change("replay", add_mean)
        self.assertEqual(self.page(), before)

    def test_a_missing_recording_is_named(self):
        (self.recorded / "scale.json").unlink()
        done = self.run_renderer()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("scale.json", done.stderr)
        self.assertIn("--only scale", done.stderr)
        self.assertFalse((self.folder / "out/results.md").exists())

    def test_a_missing_benchmark_is_named(self):
        self.change("replay", lambda runs: [runs.remove(run) for run in list(runs) if run["run_name"].startswith("replay/made/rules")])
        done = self.run_renderer()
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("replay/made/rules", done.stderr)


if __name__ == "__main__":
    unittest.main()
