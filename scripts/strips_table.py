#!/usr/bin/env python3
"""Replays meshes and prints a table of one of the documents.

indices:    indices and times of each mesh, with the cost of indices (README.md)
baked:      the cost of baked strips (docs/how-to/baked-strips.md)
isolating:  splits that isolate a triangle under the paper's method, mesh by mesh (docs/explanation/paper.md)
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

INDEX_WAYS = ["local", "quick", "full"]
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
        """From 2 % of the triangles to all of them and back; a file of baked strips from its own base."""
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


def per_triangle(level):
    return level["indices"] / level["triangles"]


def times_bare(report):
    """A split and a collapse against the bare update."""
    return (report["ns_per_operation"] / report["ns_per_operation_bare"], report["ns_per_collapse"] / report["ns_per_collapse_bare"])


def line(cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def header(*heads):
    line(heads)
    print("|" + " --- |" * len(heads))


def indices_table(program, meshes, ways):
    header("kept by", "indices a triangle: strips", "live buffer", "most: up, down", "bytes an operation", "ns a split, a collapse", "times bare", "ns an update: without, with a history")
    for mesh in meshes:
        for way in ways or INDEX_WAYS:
            report = program.replay(mesh, way, "--cost", "indices")
            line([f"`{way}`", f"{per_triangle(report['levels'][-1]):.3f}", *of_buffer(report),
                  f"{report['ns_per_operation']:,.0f}, {report['ns_per_collapse']:,.0f}", "{:.1f}, {:.1f}".format(*times_bare(report)), of_update(report)])
        report = program.replay(mesh, "rules", "--buffer", "list")
        line(["a triangle list", "–", *of_buffer(report), f"{report['ns_per_operation_bare']:,.0f}, {report['ns_per_collapse_bare']:,.0f}", "1, 1", of_update(report)])
        report = program.run("stripify", mesh)
        made = 1e9 * sum(report[part] for part in ("seconds_to_build", "seconds", "seconds_to_order", "seconds_to_write"))
        line(["strips from scratch", f"{per_triangle(report):.3f}", "–", "–", f"{4 * report['indices']:,}", f"{made / 1e6:,.0f} ms", "–", "–"])


def of_update(report):
    """An update of the live buffer after each operation."""
    buffer = report["live_buffers"][0]
    return f"{buffer['ns_per_update']:,.0f}, {buffer['ns_per_update_with_history']:,.0f}"


def of_buffer(report):
    """Indices a triangle of the live buffer at the top and at most, and the bytes that an operation writes."""
    share = lambda level: level["buffer_indices"] / level["triangles"]
    most = (f"{max(share(level) for level in report[levels] if level['triangles'] > 1000):.3f}" for levels in ("levels", "levels_down"))
    return f"{share(report['levels'][-1]):.3f}", ", ".join(most), f"{report['live_buffers'][0]['bytes_per_operation']:,.0f}"


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


def isolating_table(program, meshes, _):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.check_call([program.path, "paper", "--out", folder, *meshes], stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
            counts = {(mesh["mesh"], run["policy"]): run for mesh in json.load(file)["meshes"] for run in mesh["policies"]}
    header("policy", "what happens at a split that is not of a 4-vertex", *map(name_of, meshes))
    for way, what in PAPER_WAYS.items():
        rows = [counts[os.path.basename(mesh), way] for mesh in meshes]
        line([f"`{way}`", what, *(f"{row['isolating']:,} of {row['splits']:,}, {100 * row['isolating'] / row['splits']:.2f} %" for row in rows)])


TABLES = {"indices": indices_table, "baked": baked_table, "isolating": isolating_table}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/strips_table.py indices build/release/bin/restrip bunny.obj")
    parser.add_argument("table", choices=TABLES)
    parser.add_argument("program", help="restrip")
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--way", action="append", help="indices: only this policy; may be repeated")
    parser.add_argument("--repeats", type=int, help="repetitions of each timing; default: that of restrip replay")
    arguments = parser.parse_args()
    TABLES[arguments.table](Program(arguments.program, arguments.repeats), arguments.meshes, arguments.way)


if __name__ == "__main__":
    main()
