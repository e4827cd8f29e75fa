#!/usr/bin/env python3
"""Claims: plots leave out what a logarithm cannot show, one point is a plot too, and text is safe in HTML; the pictures of a
patch have every triangle, and of every dual edge the two halves, in its colour.

The patches of all shipped operations and families are drawn without overlap, each triangle counter-clockwise, edges across
sides that their triangles share, ports where they are on the other side too; operation files get pictures and pages with all
rules of their certificates; graphs that are not on a disc, invalid triangles, and certificates of other operations are refused."""
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import pictures  # noqa: E402
import plots  # noqa: E402
from operations import positions_of  # noqa: E402
from plots import Axis, Series  # noqa: E402
from surfaces import drawings  # noqa: E402

OPERATIONS = ROOT / "tables/operations"
CERTIFICATES = ROOT / "tables/certificates/operations"
CORPUS = ROOT / "tests/corpus/operations"


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


def area(places):
    """Twice the area of a polygon; positive when it is counter-clockwise as seen, with y pointing down."""
    return sum(y * u - x * v for (x, y), (u, v) in zip(places, places[1:] + places[:1]))


class Drawings(unittest.TestCase):
    def check(self, side, position):
        corners = side["corners"]
        areas = [area([corners[c] for c in triangle[:3]]) for triangle in side["triangles"]]
        self.assertGreater(min(areas), 150, position.text)
        directed = {(t[i], t[(i + 1) % 3]) for t in side["triangles"] for i in range(3)}
        after = {a: b for a, b in directed if (b, a) not in directed}
        rim = [next(iter(after))]
        while len(rim) < len(after):
            rim.append(after[rim[-1]])
        self.assertAlmostEqual(sum(areas), area([corners[c] for c in rim]), delta=1)
        for u, v, a, b in side["edges"]:
            for n in (u, v):
                self.assertLessEqual({a, b}, set(side["triangles"][n][:3]), position.text)
        for n, a, b in side["ports"]:
            self.assertLessEqual({a, b}, set(side["triangles"][n][:3]), position.text)
            self.assertEqual(after[a], b)
        return [(corners[a], corners[b]) for _, a, b in side["ports"]]

    def test_all_shipped_patches(self):
        drawn = 0
        for file in [ROOT / "tables/families.json", *sorted(OPERATIONS.glob("*.json"))]:
            for position in positions_of(file):
                (before,), (after,) = drawings([position.before], [position.after])
                self.assertEqual(self.check(before, position), self.check(after, position), position.text)
                drawn += 1
        self.assertEqual(drawn, 2 * (15 + 70 + 24) + 1 + len(list(OPERATIONS.glob("*.json"))))

    def test_numbers_agree_with_the_document(self):
        position, = positions_of(OPERATIONS / "split-face.json")  # docs/reference/operation-file.md, "Triangles"
        (_,), (after,) = drawings([position.before], [position.after])
        name = after["names"][0]
        self.assertEqual([{name[a], name[b]} for *_, a, b in after["edges"]], [set("bm"), set("cm"), set("am")])
        self.assertEqual([name[a] + name[b] for _, a, b in after["ports"]], ["ab", "bc", "ca"])


class Programs(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = Path(self.scratch.name)

    def run_script(self, script, *words):
        return subprocess.run([sys.executable, ROOT / script, *words], cwd=self.folder, text=True, capture_output=True, check=False)

    def refused(self, script, *words):
        done = self.run_script(script, *words)
        self.assertEqual(done.returncode, 1, done)
        self.assertNotIn("Traceback", done.stderr)
        self.assertEqual(list(self.folder.glob("out*")), [])
        return done.stderr

    def test_pages_have_all_rules(self):
        done = self.run_script("web/atlas/atlas.py", OPERATIONS / "merge.json", OPERATIONS / "flip-matching.json", "--certificates", CERTIFICATES, "-o", "pages")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name in ("merge", "flip-matching"):
            rules = [line.split() for line in (CERTIFICATES / f"{name}.cert").read_text(encoding="ascii").split("\n") if line.startswith("rule ")]
            page = (self.folder / f"pages/{name}.html").read_text(encoding="utf-8")
            self.assertEqual(page.count("<tr id="), len(rules))
            for _, ports, joined, colors, kept, *_ in rules:
                masks = " ".join(str(int(mask, 16)) for mask in (ports, joined, colors, kept))
                self.assertEqual(page.count(f'<tr id="{name}-{ports}-{joined}" '), 1)
                self.assertEqual(page.count(f'data-rule="{masks}"'), 1)
            self.assertIn(f'href="{name}.html"', (self.folder / "pages/index.html").read_text(encoding="utf-8"))

    def test_pictures_have_the_patch_and_its_rules(self):
        certificate = ["--certificate", CERTIFICATES / "merge.cert"]
        for words, pictures in (([], 2), (certificate, 2 + 2 * 17), ([*certificate, "--rule", "3,1"], 4)):
            done = self.run_script("scripts/pictures.py", OPERATIONS / "merge.json", "out.svg", *words)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            svg = (self.folder / "out.svg").read_text(encoding="utf-8")
            self.assertEqual(svg.count('<svg class="patch"'), pictures)
            for name in ("p3", "e3", "f0", "m", "a"):
                self.assertIn(f">{name}</text>", svg)

    def test_refusals(self):
        faulty = json.loads((CORPUS.parent / "refused_operations.json").read_text(encoding="utf-8"))
        for name, operation in faulty.items():
            (self.folder / f"{name}.json").write_text(json.dumps(operation), encoding="utf-8")
        for fault, sentence in {"pinched": "not a disc", "handle": "not a disc", "closed": "not a disc", "turned-triangle": "not a disc",
                                "crossed-ports": "rim differs before and after", "parity": "rim differs before and after",
                                "stretch-to-nowhere": "restrip-generate rules names the fault"}.items():
            self.assertIn(sentence, self.refused("scripts/pictures.py", f"{fault}.json", "out.svg"), fault)
        self.assertIn("names the fault", self.refused("web/atlas/atlas.py", "no-port.json", "--certificates", CERTIFICATES, "-o", "out"))
        (self.folder / "list.json").write_text("[1]", encoding="ascii")
        self.assertIn("is not an operation file", self.refused("scripts/pictures.py", "list.json", "out.svg"))
        (self.folder / "name.json").write_text((OPERATIONS / "merge.json").read_text(encoding="utf-8").replace('"merge"', '"../merge"'), encoding="utf-8")
        self.assertIn("a name has at most", self.refused("web/atlas/atlas.py", "name.json", "--certificates", CERTIFICATES, "-o", "out"))
        self.assertIn("No such file", self.refused("scripts/pictures.py", OPERATIONS / "none.json", "out.svg"))

    def test_certificates_of_something_else(self):
        merge, certificate = OPERATIONS / "merge.json", (CERTIFICATES / "merge.cert").read_text(encoding="ascii")
        self.assertIn("is not a certificate of", self.refused("scripts/pictures.py", merge, "out.svg", "--certificate", CERTIFICATES / "bisect.cert"))
        for old, new in (("operation merge", "operation split-face"), ("claim valid 160", "claim valid 161"), ("claim costing ", "claim costing 1"),
                         ("rule 0 0", "rule 0 1"), ("section merge", "section marge"), ("restrip-certificate 3", "restrip-certificate 2")):
            self.assertIn(old, certificate)
            (self.folder / "merge.cert").write_text(certificate.replace(old, new, 1), encoding="ascii")
            self.assertIn("certificate", self.refused("web/atlas/atlas.py", merge, "--certificates", self.folder, "-o", "out"), old)


if __name__ == "__main__":
    unittest.main()
