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

PROGRAMS = ["level", "replay", "scale"]
WAYS = ["local", "quick", "full", "baked"]
RIVALS = {
    "list": "`TriangleListBuffer`, no strips",
    "stripify_fast": "from scratch: `stripify`, fast",
    "meshopt_strips": "from scratch: `meshopt_optimizeVertexCacheStrip`, `meshopt_stripify`",
    "meshopt_order_given": "from scratch: `meshopt_stripify` alone, order found before",
    "openmesh": "from scratch: OpenMesh `StripifierT`",
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
        machine = f"{context['num_cpus']} processors at {context['mhz_per_cpu'] / 1000:.1f} GHz"
        return f"{machine}; caches {', '.join(caches)}" if caches else machine

    def measured(self):
        """The days on which the programs ran."""
        days = sorted({c["date"][:10] for c in self.r.context.values() if c.get("date")})
        return "on " + " and ".join(days) if days else "on a day that was not recorded"

    def load(self):
        loads = [c["load_avg"][0] for c in self.r.context.values() if c.get("load_avg")]
        return f"from {min(loads):.1f} to {max(loads):.1f}" if loads else "unknown"

    def triangles(self):
        return ", ".join(f"{mesh} {self.r.median(f'replay/{mesh}/local', 'triangles'):,.0f}" for mesh in self.meshes)

    def over_levels(self, way, other, field="move_ns"):
        """Another method's figure for one of ours, for each mesh and level."""
        return [self.r.median(f"level/{m}/{p}/{other}", field) / self.r.median(f"level/{m}/{p}/{way}", field)
                for m, p in self.levels if self.r.has(f"level/{m}/{p}/{way}")]

    def overtaken(self, way):
        """From which move on, in per cent, strips from scratch are cheaper."""
        moves = self.over_levels(way, "stripify_fast")
        return f"{plain(min(moves), 2)} % to {plain(max(moves), 2)} %"

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
            indices = [self.r.median(f"level/{m}/{p}/{way}", "indices_per_triangle") for m, p in self.levels if self.r.has(f"level/{m}/{p}/{way}")]
            rows.append([f"`{way}`", f"{min(indices):.2f} to {max(indices):.2f}", self.span(self.over_levels(way, "stripify_fast", "bytes")),
                         self.span([1 / ratio for ratio in self.over_levels(way, "list")]), self.span(self.over_levels(way, "stripify_fast")),
                         self.span(self.over_levels(way, "meshopt_strips")), self.overtaken(way),
                         self.span(self.upkeep(way, "split")), self.span(self.upkeep(way, "collapse"))])
        return table(["", "indices a triangle", "fewer bytes than from scratch", "time, of a list's", "faster than from scratch",
                      "than meshoptimizer", "from scratch is faster from", "a split, of bare", "a collapse"], rows)

    # ---- tables
    def replay(self):
        rows = []
        for mesh in self.meshes:
            for way in ["rules"] + self.ways(f"replay/{mesh}"):
                name = f"replay/{mesh}/{way}"
                triangles, strips = self.r.median(name, "triangles"), self.r.median(name, "strips")
                rows.append([mesh, f"`{way}`" if way != "rules" else "rules alone", duration(self.r.median(name, "split_ns")),
                             times(self.r.ratio(name, "split_ns", "split_bare_ns")), duration(self.r.median(name, "collapse_ns")),
                             times(self.r.ratio(name, "collapse_ns", "collapse_bare_ns")),
                             f"{self.r.median(name, 'indices_per_triangle'):.3f}", plain(triangles / strips)])
        return table(["mesh", "", "split", "of bare", "collapse", "of bare", "indices a triangle", "triangles a strip"], rows)

    def level(self):
        rows = []
        stem = "level/{}/{}".format(*self.shown())
        for way in self.ways(stem) + [rival for rival in RIVALS if self.r.has(f"{stem}/{rival}")]:
            of = lambda field: self.r.median(f"{stem}/{way}", field)
            rows.append([f"`{way}`" if way in WAYS else RIVALS[way], duration(of("move_ns")),
                         times(of("move_ns") / self.r.median(f"{stem}/list", "move_ns")), f"{of('bytes') / 1000:,.1f}",
                         f"{of('indices_per_triangle'):.3f}", f"{of('acmr_16'):.2f}", f"{of('acmr_32'):.2f}"])
        return table(["", "1 % up, or from scratch", "of the list", "kB to upload", "indices a triangle", "misses, 16", "32"], rows)

    def measured_without(self):
        return "" if self.r.parts(r"level/.*/(rm_tristripper)") else " rm_tristripper was not measured: `--tristripper` was not given."

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
        searches = max(self.of_scale(size, "random/quick", "keeper_bytes") - self.of_scale(size, "random/bare", "keeper_bytes")
                       for size in self.sizes())
        return (f"at most {of('random/bare', 'mesh_bytes')} for mesh and colours, {plain(searches, 2)} more for the searches of "
                f"`quick` and `full`, {of('buffer', 'buffer_bytes')} more for the live buffer, its indices included")

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
    """Paragraphs that have become too long, filled again; tables, pictures, comments and lists stay as they are."""
    def filled(part):
        if part.startswith("#"):
            heading, _, rest = part.partition("\n")
            return heading + ("\n" + filled(rest) if rest else "")
        if part.startswith(("|", "!", "<", "-")) or max(map(len, part.split("\n"))) <= WIDTH:
            return part
        return textwrap.fill(" ".join(part.split()), WIDTH, break_long_words=False, break_on_hyphens=False)
    return "\n\n".join(map(filled, text.split("\n\n")))


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
