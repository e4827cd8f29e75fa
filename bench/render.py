#!/usr/bin/env python3
"""Renders performance.md and its charts from what the benchmark programs recorded (scripts/performance.sh runs them). Every number
of the page is computed here; the prose is performance.md.in.

Example: bench/render.py --json build/performance --out docs
"""
import argparse
import os
import re
import sys
import textwrap
from pathlib import Path

sys.dont_write_bytecode = True  # nothing but the page is written, least of all into the source tree

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scripts"))
from plots import Axis, Series, line_plot, point_plot, standalone  # noqa: E402
from results import Results, duration, plain, table, times

PROGRAMS = ["lookup", "operation", "level", "draw", "buffer", "replay", "batch", "scale", "programs"]
WAYS = ["local", "linked", "quick", "full", "baked"]
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
UPKEEP_GOAL = 2.0
MOVE_GOAL = 50.0
WIDTH = 125


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
        context = self.r.context["operation"]
        caches = [f"{c['size'] // 1024:,} KiB {c['type'].lower()} L{c['level']}" for c in context.get("caches", [])
                  if c["type"] != "Instruction"]
        return f"{context['num_cpus']} processors at {context['mhz_per_cpu'] / 1000:.1f} GHz; caches {', '.join(caches)}"

    def load(self):
        loads = [c["load_avg"][0] for c in self.r.context.values() if c.get("load_avg")]
        return f"from {min(loads):.1f} to {max(loads):.1f}" if loads else "unknown"

    def triangles(self):
        return ", ".join(f"{mesh} {self.r.median(f'replay/{mesh}/local', 'triangles'):,.0f}" for mesh in self.meshes)

    # ---- the goals
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

    def goals(self):
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

    @staticmethod
    def listed(ways):
        return ", ".join(f"`{way}`" for way in ways) if ways else "none"

    def goal_upkeep(self):
        met = [way for way in WAYS if self.upkeep(way, "split") and max(self.upkeep(way, "split")) <= UPKEEP_GOAL]
        down = [way for way in WAYS if self.upkeep(way, "collapse") and max(self.upkeep(way, "collapse")) <= UPKEEP_GOAL]
        hot = times(self.r.ratio("operation/local", "split_ns", "split_bare_ns"))
        return (f"Met on every mesh for splits by {self.listed(met)}, for collapses by {self.listed(down)}. In the best case, all in cache "
                f"and the spokes known before, a `local` split takes {hot} the bare update (below)")

    def goal_move(self):
        def met(other):
            return [way for way in WAYS if self.all_cheaper(way, other) and min(self.all_cheaper(way, other)) >= MOVE_GOAL
                    and min(self.fewer(way)) > 1]
        buffered = [way for way in met("meshopt_ordered") if min(self.with_buffer(way)) >= MOVE_GOAL]
        return (f"Met on every mesh and level by {self.listed(met('meshopt_ordered'))} if the time for the triangle order that its manual "
                f"asks for is included; by {self.listed(met('meshopt_order_given'))} if that order is given; by {self.listed(buffered)} if the "
                "order is included and we keep an index buffer in step")

    def goal_strips(self):
        met = [way for way in WAYS if self.fewer(way) and min(self.fewer(way)) > 1]
        return f"Fewer strips than `meshopt_stripify` leaves, on every mesh and level: {self.listed(met)}"

    # ---- tables
    def lookup(self):
        rows = []
        for family in self.r.parts(r"lookup/([^/]+)/hot/\d+"):
            name = f"lookup/{family}"
            hot, mixed = (self.r.nanoseconds(self.first(rf"({name}/{kind}/\d+)")) for kind in ("hot", "random"))
            cold = self.r.nanoseconds(f"{name}/cold", "real_time")
            rows.append([family, duration(hot), duration(mixed), duration(cold),
                         times(hot / self.r.nanoseconds(self.first(r"(lookup/split/hot/\d+)")))])
        return table(["family", "hot", "random keys", "cold", "hot, of a split"], rows)

    def first(self, pattern):
        return self.r.parts(pattern)[0]

    def parts(self):
        rows = []
        for what in ("split", "collapse"):
            cells = {part: self.r.median("parts", f"{what}_{part}_ns") for part in ("gather", "lookup", "scatter", "mesh")}
            kept = sum(cells.values()) - cells["mesh"]
            rows.append([what] + [duration(cells[part]) for part in ("gather", "lookup", "scatter")] +
                        [duration(kept), duration(cells["mesh"])])
        return table(["", "gather", "lookup", "scatter", "these three", "mesh update with the fan known"], rows)

    def operation(self):
        rows = []
        for way in ["rules"] + self.ways("operation"):
            cells = []
            for what in ("split", "split_from_vertices", "collapse", "flip"):
                name = f"operation/{way}"
                cells += [duration(self.r.median(name, f"{what}_ns")), times(self.r.ratio(name, f"{what}_ns", f"{what}_bare_ns"))]
            rows.append([f"`{way}`" if way != "rules" else "rules alone"] + cells)
        bare = [duration(self.r.median("operation/local", f"{what}_bare_ns"))
                for what in ("split", "split_from_vertices", "collapse", "flip")]
        rows.insert(0, ["bare mesh"] + [cell for time in bare for cell in (time, "1.00x")])
        return table(["", "split", "of bare", "split, spokes to be found", "of bare", "collapse", "of bare", "flip", "of bare"], rows)

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
        for mesh, percent in self.levels:
            stem = f"level/{mesh}/{percent}"
            for way in self.ways(stem) + list(RIVALS):
                name = f"{stem}/{way}"
                ours = way in WAYS
                buffer = self.r.median(name, "up_with_buffer_ns") if ours or way == "stripify_fast" else self.r.median(name, "up_ns")
                rows.append([mesh, f"{percent} %", f"{self.r.median(name, 'triangles'):,.0f}", f"`{way}`" if ours else RIVALS[way],
                             duration(self.r.median(name, "up_ns")),
                             times(self.cheaper(mesh, percent, way, "meshopt_ordered")),
                             duration(buffer) if way != "openmesh" else "",
                             f"{self.r.median(name, 'strips'):,.0f}", f"{self.r.median(name, 'indices_per_triangle'):.2f}"])
        return table(["mesh", "level", "triangles", "", "1 % up, or from scratch", "cheaper than ordering and `meshopt_stripify`",
                      "with an index buffer", "strips", "indices per triangle"], rows)

    def drawn(self):
        rows = []
        for mesh, percent in self.r.parts(r"draw/([^/]+)/(\d+)/local"):
            stem = f"draw/{mesh}/{percent}"
            for way in self.ways(stem) + [rival for rival in DRAWN if self.r.has(f"{stem}/{rival}")]:
                of = lambda field: self.r.median(f"{stem}/{way}", field)
                rows.append([mesh, f"{percent} %", f"`{way}`" if way in WAYS else DRAWN[way], duration(of("move_ns")),
                             times(of("move_ns") / self.r.median(f"{stem}/list", "move_ns")), f"{of('bytes') / 1000:,.1f}",
                             f"{4 * of('indices_per_triangle'):.2f}", f"{of('indices_per_triangle'):.3f}"] +
                            [f"{of(field):.2f}" for field in ("acmr_16", "acmr_32", "atvr_16", "atvr_32")])
        return table(["mesh", "level", "", "1 % up, or from scratch", "of the list", "kB to upload", "bytes a triangle", "indices a triangle",
                      "ACMR, 16", "32", "ATVR, 16", "32"], rows)

    def drawn_without(self):
        return "" if self.r.parts(r"draw/.*/(rm_tristripper)") else " rm_tristripper was not measured: `--tristripper` was not given."

    def buffer(self):
        rows = []
        for mesh, way, count in self.r.parts(r"buffer/([^/]+)/(\w+)/(\d+)"):
            name, whole = f"buffer/{mesh}/{way}/{count}", f"buffer/{mesh}/{way}/whole"
            rows.append([f"`{way}`", count, duration(self.r.median(name, "operation_ns")), duration(self.r.median(name, "upkeep_ns")),
                         plain(self.r.median(name, "bytes")), f"{self.r.median(name, 'ranges'):.2f}",
                         plain(self.r.median(whole, "bytes")), duration(self.r.median(whole, "whole_ns")),
                         times(self.r.median(whole, "whole_ns") / (self.r.median(name, "upkeep_ns") * int(count)))])
        return table(["", "operations an update", "operation", "buffer, an operation", "bytes rewritten, an operation",
                      "ranges, an operation", "whole buffer, bytes", "whole buffer, time", "an update cheaper than the whole"], rows)

    def buffer_mesh(self):
        return self.first(r"buffer/([^/]+)/local/1")

    def batch(self):
        rows = []
        for name, label in (("loop", "one by one"), ("checked_before/1", "batch, checked before, 1 thread"),
                            ("checked_before/2", "batch, checked before, 2 threads"), ("checking/1", "batch that checks, 1 thread"),
                            ("checking/2", "batch that checks, 2 threads")):
            cells = [label]
            for what in ("collapse_ns", "split_ns"):
                own = self.r.median(f"batch/{name}", what)
                alone = self.r.median("batch/" + re.sub(r"\d$", "1", name), what)
                cells += [duration(own), times(alone / own)]
            rows.append(cells)
        return table(["", "collapse", "of one thread's speed", "split", "of one thread's speed"], rows)

    # ---- scale
    def sizes(self):
        return [size for size in self.r.parts(r"scale/(\d+)/random/bare")]

    def of_scale(self, size, how, field):
        return self.r.median(f"scale/{size}/{how}", field)

    def scale(self):
        rows = []
        for size in self.sizes():
            cells = [f"{self.of_scale(size, 'random/bare', 'triangles'):,.0f}",
                     plain(self.of_scale(size, "random/bare", "mesh_bytes") *
                           self.of_scale(size, "random/bare", "triangles") / 2**20) + " MiB"]
            for how in ("side_by_side", "random"):
                bare, local = (self.of_scale(size, f"{how}/{way}", "split_ns") for way in ("bare", "local"))
                cells += [duration(bare), duration(local), times(local / bare)]
            cells += [duration(self.of_scale(size, f"random/{way}", "split_ns")) for way in ("linked", "quick", "full")]
            cells.append(duration(self.of_scale(size, "random/local", "collapse_ns")))
            rows.append(cells)
        return table(["triangles", "mesh", "side by side: bare", "`local`", "of bare", "at random: bare", "`local`", "of bare", "`linked`",
                      "`quick`", "`full`", "collapse, `local`"], rows)

    def memory(self):
        rows = []
        for size in self.sizes():
            rows.append([f"{self.of_scale(size, 'random/bare', 'triangles'):,.0f}",
                         plain(self.of_scale(size, "random/bare", "mesh_bytes")),
                         plain(self.of_scale(size, "random/quick", "keeper_bytes")),
                         plain(self.r.median(f"scale/{size}/buffer", "buffer_bytes")),
                         duration(self.of_scale(size, "random/bare", "build_ns")),
                         duration(self.of_scale(size, "random/bare", "stripify_ns"))])
        return table(["triangles", "mesh and colours", "index of `quick` and `full`", "`StripBuffer`, the index buffer included",
                      "building the mesh, a triangle", "strips from scratch, a triangle"], rows)

    def caches(self):
        """(triangles that fit, name) of the second- and third-level cache."""
        each = self.of_scale(self.sizes()[-1], "random/bare", "mesh_bytes")
        return [(c["size"] / each, f"L{c['level']} full") for c in self.r.context["scale"].get("caches", [])
                if c["level"] >= 2 and c["type"] != "Instruction"]

    def bends(self):
        sizes = self.sizes()
        grow = lambda how: self.of_scale(sizes[-1], how, "split_ns") / self.of_scale(sizes[0], how, "split_ns")
        steps = [(self.of_scale(b, "random/bare", "split_ns") / self.of_scale(a, "random/bare", "split_ns"), a, b)
                 for a, b in zip(sizes, sizes[1:])]
        steepest = max(steps)
        full = "; ".join(f"{name} at {plain(round(fits, -3))} triangles" for fits, name in self.caches())
        return (f"The mesh alone fills the caches like this: {full}. From {int(sizes[0]):,} to {int(sizes[-1]):,} triangles a bare split "
                f"becomes {times(grow('random/bare'))} as long at random places and {times(grow('side_by_side/bare'))} side by side, a `local` "
                f"one {times(grow('random/local'))} and {times(grow('side_by_side/local'))}, a `quick` one {times(grow('random/quick'))}, a "
                f"`full` one {times(grow('random/full'))}. The steepest step of the bare curve, {times(steepest[0])}, is that from "
                f"{int(steepest[1]):,} to {int(steepest[2]):,}.")

    # ---- programs
    def generator(self):
        rows = []
        before = None
        for k in self.r.parts(r"generator/(\d+)"):
            seconds, size = self.r.median(f"generator/{k}", "seconds"), self.r.median(f"generator/{k}", "certificate_bytes")
            rows.append([k, f"{seconds:.2f} s", times(seconds / before[0]) if before else "", f"{size:,.0f}",
                         times(size / before[1]) if before else ""])
            before = seconds, size
        return table(["largest k", "time", "of the row above", "bytes of certificates", "of the row above"], rows)

    def verifier(self):
        seconds = {}
        for family, claim in self.r.parts(r"verifier/([^/]+)/(.*)"):
            name = f"verifier/{family}/{claim}"
            own = seconds.setdefault(claim, [0.0, 0, []])
            own[0] += self.r.median(name, "seconds")
            own[1] += self.r.median(name, "cases")
            own[2].append(family)
        rows = [[claim, str(len(families)), f"{cases:,.0f}", f"{took:.2f} s"]
                for claim, (took, cases, families) in sorted(seconds.items(), key=lambda item: -item[1][0])]
        return table(["claim", "certificates", "cases", "time"], rows)

    def verifier_all(self):
        return f"{self.r.median('verifier/all', 'seconds'):.1f} s"

    def compilation(self):
        rows = []
        for compiler, header in self.r.parts(r"compile/([^/]+)/(.*)"):
            own, nothing, vector = (self.r.median(f"compile/{compiler}/{h}", "seconds") for h in (header, "nothing", "vector"))
            label = {"nothing": "an empty file", "vector": "`<vector>`"}.get(header, f"`{header}`")
            rows.append([compiler, label, f"{own:.2f} s", times(own / nothing), times(own / vector)])
        return table(["compiler", "header", "time", "of an empty file", "of `<vector>`"], rows)

    # ---- charts
    def scale_chart(self):
        line = lambda how: [(self.of_scale(s, how, "triangles"), self.of_scale(s, how, "split_ns")) for s in self.sizes()]
        series = [Series("full", "ours", 4, line("random/full")), Series("quick", "ours", 3, line("random/quick")),
                  Series("linked", "ours", 2, line("random/linked")), Series("local, at random", "ours", 0, line("random/local")),
                  Series("local, side by side", "ours", 1, line("side_by_side/local")),
                  Series("bare, at random", "scratch", 0, line("random/bare")),
                  Series("bare, side by side", "scratch", 1, line("side_by_side/bare"))]
        return standalone(line_plot(Axis("triangles", True), Axis("nanoseconds a split", True), series,
                                    "Time of a split against the size of the mesh", self.caches()))

    def chart_level(self):
        mesh = "bunny" if ("bunny", "100") in self.levels else self.levels[-1][0]
        return mesh, max((p for m, p in self.levels if m == mesh), key=int)

    def level_mesh(self):
        mesh, percent = self.chart_level()
        return f"{mesh} at {percent} %"

    def level_chart(self):
        stem = "level/{}/{}".format(*self.chart_level())
        spot = lambda way, name: (self.r.median(f"{stem}/{way}", "up_ns") / 1e3, self.r.median(f"{stem}/{way}", "strips"), name)
        names = {"meshopt_ordered": "meshopt, ordered", "meshopt_order_given": "meshopt, order given",
                 "meshopt_as_it_is": "meshopt, as it is", "openmesh": "OpenMesh", "stripify_fast": "stripify_fast"}
        series = [Series("ours, 1 % up", "ours", 0, [spot(way, way) for way in self.ways(stem)]),
                  Series("from scratch", "paper", 1, [spot(way, name) for way, name in names.items()])]
        return standalone(point_plot(Axis("microseconds to the next level (1 % more triangles)", True), Axis("strips there", True),
                                     series, "Strips of a level against the time to get there"))


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
    parser.add_argument("--json", type=Path, required=True, help="the folder of lookup.json, level.json, …")
    parser.add_argument("--out", type=Path, required=True, help="the folder that receives the page and its charts")
    given = parser.parse_args()
    page = Page(Results(given.json, PROGRAMS))
    text = fill((Path(__file__).parent / "performance.md.in").read_text(), page)
    charts = {"performance-scale.svg": page.scale_chart(), "performance-level.svg": page.level_chart()}
    given.out.mkdir(parents=True, exist_ok=True)
    for name, chart in charts.items():
        write_whole(given.out / name, chart)
    write_whole(given.out / "performance.md", wrapped(text))


if __name__ == "__main__":
    main()
