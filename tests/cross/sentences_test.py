#!/usr/bin/env python3
"""Claim: sentences of the documents agree with the tables next to them, which scripts write.

A range ends at the smallest and the largest figure, rounded."""
import math
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


def text_of(document):
    return " ".join((ROOT / document).read_text(encoding="utf-8").split())


def table(document, command):
    """The rows of the table that this command writes, as cells by the names of their columns."""
    block = re.search(rf"<!-- [a-z ]*figures: {re.escape(command)}.*? -->\n(.*?)<!-- /figures -->", (ROOT / document).read_text(encoding="utf-8"), re.S)[1]
    lines = [[cell.strip() for cell in line.strip("| ").split(" | ")] for line in block.splitlines()]
    return [dict(zip(lines[0], line)) for line in lines[2:]]


def numbers(rows, *columns):
    return [float(number.replace(",", "")) for row in rows for column in columns for number in re.findall(r"[\d,]*\d(?:\.\d+)?", row[column])]


def in_tenths(values):
    return f"{min(values):.1f} to {max(values):.1f}"


class Sentences(unittest.TestCase):
    def setUp(self):
        self.rows = table("README.md", "scripts/strips_table.py indices")
        self.kept = [row for row in self.rows if row["kept by"].startswith("`")]
        self.by = {row["kept by"].strip("`"): row for row in self.rows}

    def says(self, document, sentence):
        self.assertIn(sentence, text_of(document))

    def test_the_table_has_rows(self):
        self.assertGreaterEqual(len(self.kept), 3)
        self.assertEqual(len(self.rows), len(self.kept) + 2)

    def test_indices_of_strips_and_of_the_live_buffer(self):
        found = numbers(self.kept, "live buffer", "most: up, down")
        live = f"{min(found):.1f} to {math.ceil(20 * max(found) - 1e-9) / 20:.2f}"
        self.says("README.md", f"({live} in a buffer updated in place)")
        self.says("docs/explanation/when-not.md", f"in a live buffer {live}")

    def test_bytes_of_an_operation(self):
        low, high = (round(number / numbers([self.by["a triangle list"]], "bytes an operation")[0])
                     for number in sorted(numbers(self.kept, "bytes an operation"))[::len(self.kept) - 1])
        self.says("docs/explanation/when-not.md", f"{low} to {high} times the bytes")

    def test_when_strips_win_in_sum(self):
        written, in_a_list = numbers([self.by["quick"], self.by["a triangle list"]], "bytes an operation")
        saved = 4 * (3 - numbers([self.by["quick"]], "live buffer")[0])
        self.says("docs/explanation/when-not.md", f"for every {(written - in_a_list) / saved:.0f} triangles: {written - in_a_list:.0f} bytes more for each, "
                                                  f"{saved:.1f} fewer a triangle")

    def test_local_is_cheaper_than_quick(self):
        share = sum(numbers([self.by["local"]], "ns a split, a collapse")) / sum(numbers([self.by["quick"]], "ns a split, a collapse"))
        self.assertTrue(0.3 < share < 0.45, share)
        self.says("docs/explanation/choosing.md", "`local` costs about two fifths of `quick`")


if __name__ == "__main__":
    unittest.main()
