#!/usr/bin/env python3
"""Claims: plots leave out what a logarithm cannot show, one point is a plot too, and text is safe in HTML; the pictures of a
patch have every triangle, and of every dual edge the two halves, in its colour."""
import re
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
import pictures  # noqa: E402
import plots  # noqa: E402
from plots import Axis, Series  # noqa: E402


class Plots(unittest.TestCase):
    def plot(self, points):
        return plots.line_plot(Axis("x", True), Axis("y", True), [Series("s", "ours", 0, points)], "d")

    def test_leaves_out_what_a_logarithm_cannot_show(self):
        svg = self.plot([(0, 5), (1, 0), (10, 100), (100, 1000)])
        self.assertEqual(svg.count("<title>"), 2)
        self.assertNotIn("nan", svg)
        self.assertEqual(self.plot([(0, 5)]), "")

    def test_one_point_is_a_plot_too(self):
        svg = self.plot([(4, 1)])
        self.assertNotIn("nan", svg)
        self.assertNotIn("inf", svg)
        self.assertEqual(svg.count("<title>s: 4 x, 1 y</title>"), 1)

    def test_names_are_apart(self):
        series = [Series(name, "ours", i, [(1, 5), (10, 5)]) for i, name in enumerate("abcd")]
        svg = plots.line_plot(Axis("x"), Axis("y"), series, "d")
        heights = sorted(float(y) for y in re.findall(r'class="name" x="[0-9.]+" y="([0-9.]+)"', svg))
        self.assertEqual(len(heights), 4)
        self.assertTrue(all(b - a >= 16.9 for a, b in zip(heights, heights[1:])), heights)

    def test_text(self):
        self.assertEqual(plots.escaped("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;")
        self.assertEqual([plots.grouped(n) for n in (7, 999, 69451, 1234567)], ["7", "999", "69,451", "1,234,567"])


class Patches(unittest.TestCase):
    def strokes(self, svg, style):
        paths = re.findall(f'<path class="{style}" d="([^"]*)"', svg)
        return sum(path.count("M") for path in paths)

    def test_every_triangle_and_every_edge(self):
        for k in range(3, 9):
            for a in range(1, k // 2 + 1):
                loop, ports = (1 << k - 1) - 1, 0b101
                fan = pictures.fan_picture(k, a, loop, ports, "d")
                self.assertEqual(self.strokes(fan, "old"), k)
                self.assertEqual(self.strokes(fan, "solid"), 2 * (k - 1) + 2)
                self.assertEqual(self.strokes(fan, "dashed"), 2 * 1 + k - 2)
                self.assertEqual(self.strokes(fan, "node"), k)
                inner = 1 << k + 2 | 1
                split = pictures.split_picture(k, a, inner, ports, "d")
                self.assertEqual(self.strokes(split, "old"), k)
                self.assertEqual(self.strokes(split, "new"), 2)
                self.assertEqual(self.strokes(split, "solid"), 2 * 2 + 2)
                self.assertEqual(self.strokes(split, "dashed"), 2 * (k + 1) + k - 2)

    def test_arcs_show_links_and_ports(self):
        arc = pictures.arc_picture("dsS", [True, True, False, True], "d")
        self.assertEqual(self.strokes(arc, "old"), 3)
        self.assertEqual(self.strokes(arc, "solid"), 2 + 2 + 2 + 2)  # outer links, the inner one, ports
        self.assertEqual(self.strokes(arc, "dashed"), 2 + 1)
        self.assertEqual(self.strokes(pictures.arc_picture("sbj", [False] * 4, "d"), "old"), 2)

    def test_the_chord_joins_the_new_triangles(self):
        for k, a in ((4, 2), (7, 3)):
            svg = pictures.split_picture(k, a, 1 << k + 2, 0, "d")
            nodes = re.findall(r"M([0-9.,-]+)h0", svg)
            halves = re.findall(r"M([0-9.,-]+)L([0-9.,-]+)", re.search('class="solid" d="([^"]*)"', svg)[1])
            self.assertEqual({halves[0][0], halves[1][1]}, set(nodes[-2:]))
            self.assertEqual(halves[0][1], halves[1][0])


if __name__ == "__main__":
    unittest.main()
