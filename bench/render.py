#!/usr/bin/env python3
"""Renders the page of results, and two CSV files, from what the benchmark programs recorded (scripts/performance.sh runs
them). Every number of the page is computed here; the prose is performance.md.in.

Example: bench/render.py --json build/performance --out docs
"""
import argparse
import csv
import os
import re
import sys
import textwrap
from pathlib import Path

sys.dont_write_bytecode = True  # nothing but the page is written, least of all into the source tree

from results import Results, duration, plain, table, times

PROGRAMS = ["level", "draw", "replay", "scale"]
WAYS = ["local", "quick", "full", "baked"]
RIVALS = {
    "meshopt_ordered": "`meshopt_optimizeVertexCacheStrip`, then `meshopt_stripify`",
    "meshopt_order_given": "`meshopt_stripify` alone, order found before",
    "meshopt_as_it_is": "`meshopt_stripify` alone, triangles as they are",
    "openmesh": "OpenMesh `StripifierT`",
    "stripify_fast": "ours from scratch, `stripify_fast`",
}
DRAWN = {
    "list": "`TriangleListBuffer`, no strips",
    "stripify_fast": "from scratch: `stripify`, fast, index cost",
    "meshopt_strips": "from scratch: `meshopt_optimizeVertexCacheStrip`, `meshopt_stripify`",
    "rm_tristripper": "from scratch: rm_tristripper",
    "meshopt_list": "from scratch: `meshopt_optimizeVertexCache`, a list",
}
WIDTH = 120


class Page:
    """One method for each {{name}} of the template."""

    def __init__(self, results):
        self.r = results
        self.meshes = self.r.parts(r"replay/([^/]+)/local")
        self.levels = self.r.parts(r"level/([^/]+)/(\d+)/local")

    def ways(self, stem):
        return [way for way in WAYS if self.r.has(f"{stem}/{way}")]

    # ---- the machine
    def machine(self):
        context = self.r.context["replay"]
        caches = [f"{c['size'] // 1024:,} KiB {c['type'].lower()} L{c['level']}" for c in context.get("caches", [])
                  if c["type"] != "Instruction"]
        return f"{context['num_cpus']} processors at {context['mhz_per_cpu'] / 1000:.1f} GHz; caches {', '.join(caches)}"

    def measured(self):
        """The days on which the programs ran."""
        days = sorted({c["date"][:10] for c in self.r.context.values() if c.get("date")})
        return "on " + " and ".join(days) if days else "on a day that was not recorded"

    def load(self):
        loads = [c["load_avg"][0] for c in self.r.context.values() if c.get("load_avg")]
        return f"from {min(loads):.1f} to {max(loads):.1f}" if loads else "unknown"

    def triangles(self):
        return ", ".join(f"{mesh} {self.r.median(f'replay/{mesh}/local', 'triangles'):,.0f}" for mesh in self.meshes)

    def cheaper(self, mesh, percent, way, other):
        stem = f"level/{mesh}/{percent}/"
        return self.r.median(stem + other, "up_ns") / self.r.median(stem + way, "up_ns")

    def all_cheaper(self, way, other):
        return [self.cheaper(m, p, way, other) for m, p in self.levels if self.r.has(f"level/{m}/{p}/{way}")]

    def with_buffer(self, way):
        """The same with an index buffer, which the other library's result is."""
        return [self.r.median(f"level/{m}/{p}/meshopt_ordered", "up_ns") / self.r.median(f"level/{m}/{p}/{way}", "up_with_buffer_ns")
                for m, p in self.levels if self.r.has(f"level/{m}/{p}/{way}")]

    def overtaken(self, way):
        """From which move on, in per cent, `stripify_fast` is cheaper."""
        moves = [self.cheaper(m, p, way, "stripify_fast") for m, p in self.levels if self.r.has(f"level/{m}/{p}/{way}")]
        return f"{plain(min(moves), 2)} % to {plain(max(moves), 2)} %"

    def fewer(self, way):
        """Strips of the other library for one of ours, over all meshes and levels."""
        return [self.r.median(f"level/{m}/{p}/meshopt_ordered", "strips") / self.r.median(f"level/{m}/{p}/{way}", "strips")
                for m, p in self.levels if self.r.has(f"level/{m}/{p}/{way}")]

    def upkeep(self, way, what):
        return [self.r.ratio(f"replay/{m}/{way}", f"{what}_ns", f"{what}_bare_ns") for m in self.meshes
                if self.r.has(f"replay/{m}/{way}")]

    @staticmethod
    def span(values):
        low, high = times(min(values)), times(max(values))
        return low if low == high else f"{low} to {high}"

    def in_short(self):
        rows = []
        for way in WAYS:
            if not self.upkeep(way, "split"):
                continue
            rows.append([f"`{way}`", self.span(self.upkeep(way, "split")), self.span(self.upkeep(way, "collapse")),
                         self.span(self.all_cheaper(way, "meshopt_ordered")),
                         self.span(self.all_cheaper(way, "meshopt_order_given")), self.span(self.with_buffer(way)),
                         self.span(self.fewer(way)), self.overtaken(way)])
        return table(["", "split, of bare", "collapse, of bare", "1 % up, cheaper than ordering and `meshopt_stripify`",
                      "than `meshopt_stripify` alone", "than both, with an index buffer in step", "fewer strips than it",
                      "`stripify_fast` is cheaper from"], rows)

    # ---- tables
    def replay(self):
        rows = []
        for mesh in self.meshes:
            for way in ["rules"] + self.ways(f"replay/{mesh}"):
                name = f"replay/{mesh}/{way}"
                triangles, strips = self.r.median(name, "triangles"), self.r.median(name, "strips")
                rows.append([mesh, f"`{way}`" if way != "rules" else "rules alone", duration(self.r.median(name, "split_ns")),
                             times(self.r.ratio(name, "split_ns", "split_bare_ns")), duration(self.r.median(name, "collapse_ns")),
                             times(self.r.ratio(name, "collapse_ns", "collapse_bare_ns")), f"{strips:,.0f}",
                             plain(triangles / strips), f"{self.r.median(name, 'indices_per_triangle'):.2f}"])
        return table(["mesh", "", "split", "of bare", "collapse", "of bare", "strips at the top", "triangles per strip",
                      "indices per triangle"], rows)

    def level(self):
        rows = []
        mesh, percent = self.shown()
        stem = f"level/{mesh}/{percent}"
        for way in self.ways(stem) + list(RIVALS):
            name = f"{stem}/{way}"
            ours = way in WAYS
            buffer = self.r.median(name, "up_with_buffer_ns") if ours or way == "stripify_fast" else self.r.median(name, "up_ns")
            rows.append([f"`{way}`" if ours else RIVALS[way], duration(self.r.median(name, "up_ns")),
                         times(self.cheaper(mesh, percent, way, "meshopt_ordered")),
                         duration(buffer) if way != "openmesh" else "",
                         f"{self.r.median(name, 'strips'):,.0f}", f"{self.r.median(name, 'indices_per_triangle'):.2f}"])
        return table(["", "1 % up, or from scratch", "cheaper than ordering and `meshopt_stripify`",
                      "with an index buffer", "strips", "indices per triangle"], rows)

    def drawn(self):
        rows = []
        stem = "draw/{}/{}".format(*self.shown())
        for way in self.ways(stem) + [rival for rival in DRAWN if self.r.has(f"{stem}/{rival}")]:
            of = lambda field: self.r.median(f"{stem}/{way}", field)
            rows.append([f"`{way}`" if way in WAYS else DRAWN[way], duration(of("move_ns")),
                         times(of("move_ns") / self.r.median(f"{stem}/list", "move_ns")), f"{of('bytes') / 1000:,.1f}",
                         f"{4 * of('indices_per_triangle'):.2f}", f"{of('indices_per_triangle'):.3f}"] +
                        [f"{of(field):.2f}" for field in ("acmr_16", "acmr_32", "atvr_16", "atvr_32")])
        return table(["", "1 % up, or from scratch", "of the list", "kB to upload", "bytes a triangle", "indices a triangle",
                      "ACMR, 16", "32", "ATVR, 16", "32"], rows)

    def drawn_without(self):
        return "" if self.r.parts(r"draw/.*/(rm_tristripper)") else " rm_tristripper was not measured: `--tristripper` was not given."

    # ---- scale
    def sizes(self):
        return [size for size in self.r.parts(r"scale/(\d+)/random/bare")]

    def of_scale(self, size, how, field):
        return self.r.median(f"scale/{size}/{how}", field)

    def scale_ratio(self):
        """Of a split under `local` to the bare update, at random places, over all sizes."""
        return self.span([self.of_scale(size, "random/local", "split_ns") / self.of_scale(size, "random/bare", "split_ns") for size in self.sizes()])

    def scale_csv(self):
        splits = ["side_by_side/bare", "side_by_side/local", "random/bare", "random/local", "random/quick", "random/full"]
        head = ["triangles", "mesh_mib", *(f"split_{how.replace('/', '_')}_ns" for how in splits), "collapse_random_local_ns"]
        rows = []
        for size in self.sizes():
            triangles = self.of_scale(size, "random/bare", "triangles")
            rows.append([f"{triangles:.0f}", significant(self.of_scale(size, "random/bare", "mesh_bytes") * triangles / 2**20),
                         *(significant(self.of_scale(size, how, "split_ns")) for how in splits),
                         significant(self.of_scale(size, "random/local", "collapse_ns"))])
        return [head, *rows]

    def memory(self):
        """The most over all sizes."""
        of = lambda how, field: plain(max(self.of_scale(size, how, field) for size in self.sizes()), 2)
        return (f"at most {of('random/bare', 'mesh_bytes')} for mesh and colours, {of('random/quick', 'keeper_bytes')} more for the locator of "
                f"`quick` and `full`, {of('buffer', 'buffer_bytes')} more for `StripBuffer`, the index buffer included")

    # ---- simplification, which scripts/simplify_table.py measures
    def simplified(self):
        """A row for each level: ranges over all meshes."""
        with open(Path(__file__).parents[1] / "docs/results-simplify.csv", encoding="utf-8") as file:
            of = {(row["percent"], row["program"], row["mesh"]): row for row in csv.DictReader(file)}
        rows = []
        for percent in dict.fromkeys(percent for percent, _, _ in of):
            meshes = [mesh for level, program, mesh in of if (level, program) == (percent, "restrip")]
            value = lambda program, mesh, field: float(of[percent, program, mesh][field])
            over = lambda field, rivals: self.span([value("restrip", mesh, field) / min(value(rival, mesh, field) for rival in rivals) for mesh in meshes])
            most = lambda program: f"{max(value(program, mesh, 'turned_percent') for mesh in meshes):.3f} %"
            rows.append([f"{percent} %", over("mean_distance", ["meshoptimizer", "openmesh"]), over("largest_distance", ["meshoptimizer"]), most("restrip"),
                         most("meshoptimizer"), over("time_of_meshoptimizer", ["meshoptimizer"]), over("time_of_meshoptimizer", ["openmesh"])])
        return table(["left", "mean distance, of the better", "largest, of meshoptimizer's", "facing away", "meshoptimizer's", "time, of meshoptimizer's",
                      "of OpenMesh's"], rows)

    # ---- one mesh stands for all
    def shown(self):
        mesh = "bunny" if ("bunny", "100") in self.levels else self.levels[-1][0]
        return mesh, max((p for m, p in self.levels if m == mesh), key=int)

    def level_mesh(self):
        mesh, percent = self.shown()
        return f"{mesh} at {percent} %"


def significant(value):
    """Three digits, without an exponent."""
    return f"{float(f'{value:.3g}'):g}" if value < 1000 else f"{float(f'{value:.3g}'):.0f}"


def csv_text(rows):
    return "".join(",".join(map(str, row)) + "\n" for row in rows)


def fill(template, page):
    def value(match):
        method = getattr(page, match.group(1), None)
        if method is None:
            sys.exit(f"render.py: the template names {match.group(0)}, which does not exist")
        return method()
    return re.sub(r"\{\{(\w+)\}\}", value, template)


def wrapped(text):
    """Long lines of prose broken; tables, pictures and comments stay whole."""
    return "\n".join(line if len(line) <= WIDTH or line.startswith(("|", "!", "<")) else
                     textwrap.fill(line, WIDTH, subsequent_indent="  " if line.startswith("- ") else "",
                                   break_long_words=False, break_on_hyphens=False)
                     for line in text.split("\n"))


def write_whole(path, text):
    partial = path.with_name(path.name + ".partial")
    partial.write_text(text)
    os.replace(partial, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", type=Path, required=True, help="the folder of level.json, replay.json, …")
    parser.add_argument("--out", type=Path, required=True, help="the folder that receives the page")
    given = parser.parse_args()
    page = Page(Results(given.json, PROGRAMS))
    text = fill((Path(__file__).parent / "performance.md.in").read_text(), page)
    given.out.mkdir(parents=True, exist_ok=True)
    write_whole(given.out / "results.md", wrapped(text))
    write_whole(given.out / "results-scale.csv", csv_text(page.scale_csv()))


if __name__ == "__main__":
    main()
