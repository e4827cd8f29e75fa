#!/usr/bin/env python3
"""Replays meshes and prints a table of one of the documents.

levels:     strips, indices and times of each mesh under every policy (docs/reference/policies.md)
indices:    indices and times of each mesh where indices are the cost (docs/reference/policies.md)
brief:      the same of one mesh in a few columns (README.md)
cycles:     strips at the top of one mesh after many ways down and up (docs/reference/policies.md)
baked:      what baked strips cost (docs/how-to/baked-strips.md)
baked-indices:  the same where indices are the cost (docs/how-to/baked-strips.md)
gltf:       the sizes of strips as glTF files (docs/how-to/own-mesh.md)
isolating:  splits that isolate a triangle under the paper's method, mesh by mesh (docs/explanation/paper.md)
"""
import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile

WAYS = ["local", "linked", "quick", "full", "best", "baked"]
INDEX_WAYS = ["local", "linked", "quick", "full", "best"]
BRIEF_WAYS = ["local", "linked", "quick", "full", "baked"]
CYCLE_WAYS = ["linked", "quick", "full"]
SHOWN_CYCLES = [1, 2, 50, 100]
PAPER_WAYS = {
    "paper": "both halves of a cut edge inherit its colour; the two new triangles join when both are isolated",
    "paper-tunnel": "the same, with tunnelling while more than a tenth of the strips are isolated triangles",
    "paper-alone-tunnel": "as before, but the two new triangles never join",
    "paper-alone": "never join, no tunnelling",
    "local": "its rule",
}


class Program:
    def __init__(self, path, repeats):
        self.path, self.repeats = path, repeats

    def run(self, *arguments):
        return json.loads(subprocess.check_output([self.path, *arguments, "--json", "-"]))

    def replay(self, mesh, way, *options, repeats=None):
        """From 2 % of the triangles to all of them and back; a file of baked strips is played as it is."""
        base = [] if mesh.endswith(".baked") else ["--base", "0.02"]
        repeats = self.repeats if repeats is None else repeats
        timing = [] if repeats is None else ["--repeats", str(repeats)]
        cost = [] if "--cost" in options or mesh.endswith(".baked") else ["--cost", "strips"]
        report = self.run("replay", mesh, *base, "--policy", *way.split(), *cost, *timing, *options)
        if not report["valid"]:
            sys.exit(f"{mesh}, {way}: {report['faults']}")
        return report


def name_of(mesh):
    return os.path.splitext(os.path.basename(mesh))[0]


def per_strip(level):
    return level["triangles"] / level["strips"]


def least(levels, above):
    lengths = [per_strip(level) for level in levels if level["triangles"] > above]
    return f"{min(lengths):,.0f}" if lengths else "–"


def per_triangle(level):
    return level["indices"] / level["triangles"]


def most_indices(levels, above):
    return f"{max(per_triangle(level) for level in levels if level['triangles'] > above):.3f}"


def nearest(levels, triangles):
    """The level with about this many triangles."""
    return min(levels, key=lambda level: abs(level["triangles"] - triangles))


def times_bare(report):
    """A split and a collapse against the bare update."""
    return (report["ns_per_operation"] / report["ns_per_operation_bare"], report["ns_per_collapse"] / report["ns_per_collapse_bare"])


def line(cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def header(*heads):
    line(heads)
    print("|" + " --- |" * len(heads))


def levels_table(program, meshes, ways):
    header("mesh", "`--policy`", "strips at the top", "triangles per strip", "indices per triangle",
           "least above 20,000: up, down", "least above 5,000: up, down", "isolating splits", "µs a split, a collapse",
           "times the bare update", "bytes written a split")
    for mesh in meshes:
        for way in ways or WAYS:
            report = program.replay(mesh, way)
            up, down, top = report["levels"], report["levels_down"], report["levels"][-1]
            line([
                name_of(mesh),
                f"`{way}`",
                f"{top['strips']:,}",
                f"{per_strip(top):,.1f}",
                f"{top['indices'] / top['triangles']:.3f}",
                f"{least(up, 20000)}, {least(down, 20000)}",
                f"{least(up, 5000)}, {least(down, 5000)}",
                f"{report['operations_isolating']}",
                f"{report['ns_per_operation'] / 1000:.2f}, {report['ns_per_collapse'] / 1000:.2f}",
                "{:.1f}, {:.1f}".format(*times_bare(report)),
                f"{report['buffer_bytes_written_per_operation']:,.0f} of {report['buffer_bytes'] / 1000:,.0f} k",
            ])


def indices_table(program, meshes, ways):
    header("mesh", "`--policy`", "strips at the top", "indices per triangle at the top", "most above 1,000: up, down",
           "ns a split, a collapse", "times the bare update")
    for mesh in meshes:
        for way in ways or INDEX_WAYS:
            report = program.replay(mesh, way, "--cost", "indices")
            up, down, top = report["levels"], report["levels_down"], report["levels"][-1]
            line([
                name_of(mesh),
                f"`{way}`",
                f"{top['strips']:,}",
                f"{per_triangle(top):.3f}",
                f"{most_indices(up, 1000)}, {most_indices(down, 1000)}",
                f"{report['ns_per_operation']:,.0f}, {report['ns_per_collapse']:,.0f}",
                "{:.1f}, {:.1f}".format(*times_bare(report)),
            ])


def brief_table(program, meshes, ways):
    reports = {way: program.replay(meshes[0], way) for way in ways or BRIEF_WAYS}
    stops = next(iter(reports.values()))["levels"]
    middle, low = (nearest(stops, stops[-1]["triangles"] * part)["triangles"] for part in (0.5, 0.1))
    header("policy", "triangles per strip at the top", f"on the way down, at {middle:,}", f"at {low:,}",
           "splits that isolate a triangle", "a split, a collapse, against the bare update")
    for way, report in reports.items():
        down = report["levels_down"]
        line([
            f"`{way}`",
            f"{per_strip(report['levels'][-1]):,.1f}",
            f"{per_strip(nearest(down, middle)):,.1f}",
            f"{per_strip(nearest(down, low)):,.1f}",
            f"{report['operations_isolating']}",
            "{:.1f}x, {:.1f}x".format(*times_bare(report)),
        ])
    for effort in ("fast", "full"):
        report = program.run("stripify", meshes[0], "--cost", "strips", "--effort", effort)
        line([f"from scratch, `stripify --effort {effort}`", f"{per_strip(report):,.1f}", "–", "–", "–", "–"])


def cycles_table(program, meshes, ways):
    header("policy", *(str(cycle) for cycle in SHOWN_CYCLES), "operations that isolated a triangle")
    for way in ways or CYCLE_WAYS:
        cycles = program.replay(meshes[0], way, "--cycles", str(SHOWN_CYCLES[-1]), repeats=0)["cycles"]
        isolating = sum(cycle["isolating"] for cycle in cycles)
        line([f"`{way}`", *(f"{cycles[cycle - 1]['top_strips']:,}" for cycle in SHOWN_CYCLES), f"{isolating}"])


def bake_and_play(program, mesh, bake_options, replay_options):
    """The reports of `bake` and of a replay of its file."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "mesh.baked")
        baked = program.run("bake", mesh, *bake_options, "-o", file)
        report = program.replay(file, "baked", *replay_options)
    if not report["baked"]["levels_compared"]:
        sys.exit(f"{mesh}: no level was compared")
    return baked, report


def baking_cost(baked):
    return [f"{baked['flips_per_record']:.1f}", f"{baked['bytes_per_record']:.1f}", f"{baked['seconds']:.1f}"]


BAKING_COST = ("flips a record", "bytes a record", "bake, s")


def baked_table(program, meshes, _):
    header("mesh", "connected components", "triangles", "strips at the reported levels, coarse to fine, up and down",
           "most of all levels", "needed at least at the top", *BAKING_COST, "split: ns, bare, times", "collapse: ns, bare, times")
    for mesh in meshes:
        baked, report = bake_and_play(program, mesh, [], ["--cycles", "2"])
        strips = [level["strips"] for level in report["levels"]]
        split, collapse = times_bare(report)
        line([
            name_of(mesh),
            f"{baked['components']}",
            f"{baked['base_triangles']:,} to {baked['triangles']:,}",
            f"{strips[0]} at each of the {len(strips)}" if len(set(strips)) == 1 else ", ".join(map(str, strips)),
            f"{baked['most_strips']}",
            f"{baked['top_at_least']}",
            *baking_cost(baked),
            f"{report['ns_per_operation']:.0f}, {report['ns_per_operation_bare']:.0f}, {split:.2f}",
            f"{report['ns_per_collapse']:.0f}, {report['ns_per_collapse_bare']:.0f}, {collapse:.2f}",
        ])


def baked_indices_table(program, meshes, _):
    header("mesh", "triangles", "strips at the top", "indices per triangle at the top", "most above 1,000", *BAKING_COST,
           "split, collapse: times bare")
    for mesh in meshes:
        baked, report = bake_and_play(program, mesh, ["--cost", "indices"], [])
        top = report["levels"][-1]
        line([
            name_of(mesh),
            f"{baked['base_triangles']:,} to {baked['triangles']:,}",
            f"{top['strips']:,}",
            f"{per_triangle(top):.3f}",
            most_indices(report["levels"] + report["levels_down"], 1000),
            *baking_cost(baked),
            "{:.2f}, {:.2f}".format(*times_bare(report)),
        ])


def isolating_table(program, meshes, _):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.check_call([program.path, "paper", "--out", folder, *meshes], stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "isolating.csv"), encoding="utf-8") as file:
            counts = {(row["mesh"], row["policy"]): row for row in csv.DictReader(file)}
    header("policy", "what happens at a split that is not of a 4-vertex", *map(name_of, meshes))
    for way, what in PAPER_WAYS.items():
        rows = [counts[os.path.basename(mesh), way] for mesh in meshes]
        line([f"`{way}`", what, *(f"{int(row['isolating']):,} of {int(row['splits']):,}, {row['percent']} %" for row in rows)])


def gltf_table(program, meshes, _):
    header("mesh", "cost", "strips", "bytes as `stitched`", "as `list`", "as `strips`", "as `restart`")
    with tempfile.TemporaryDirectory() as folder:
        written = os.path.join(folder, "strips.glb")
        for mesh in meshes:
            for cost in ("strips", "indices"):
                sizes = []
                for how in ("stitched", "list", "strips", "restart"):
                    report = program.run("stripify", mesh, "--cost", cost, "--gltf", how, "-o", written)
                    sizes.append(f"{os.path.getsize(written):,}")
                line([name_of(mesh), cost, f"{report['strips']:,}", *sizes])


TABLES = {"levels": levels_table, "indices": indices_table, "brief": brief_table, "cycles": cycles_table,
          "baked": baked_table, "baked-indices": baked_indices_table, "gltf": gltf_table, "isolating": isolating_table}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/strips_table.py brief build/release/bin/restrip bunny.obj")
    parser.add_argument("table", choices=TABLES)
    parser.add_argument("program", help="restrip")
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--way", action="append", help="levels, brief, cycles: only this policy; may be repeated")
    parser.add_argument("--repeats", type=int, help="how often times are measured; default: as restrip replay does")
    arguments = parser.parse_args()
    if arguments.table in ("brief", "cycles") and len(arguments.meshes) != 1:
        parser.error(f"{arguments.table} takes one mesh")
    TABLES[arguments.table](Program(arguments.program, arguments.repeats), arguments.meshes, arguments.way)


if __name__ == "__main__":
    main()
