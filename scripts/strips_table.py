#!/usr/bin/env python3
"""Replays meshes under every policy and prints a table: all of it for docs/strips.md, --brief for the README."""
import argparse
import json
import os
import subprocess
import sys

WAYS = ["local", "linked", "quick", "quick --tie-break indices", "full", "full --states 1024", "baked"]
BRIEF_WAYS = ["local", "linked", "quick", "full", "baked"]


def run(*command):
    return json.loads(subprocess.check_output(command))


def replay(program, mesh, way):
    return run(program, "replay", mesh, "--base", "0.02", "--policy", *way.split(), "--repeats", "3", "--json", "-")


def per_strip(level):
    return level["triangles"] / level["strips"]


def least(levels, above):
    lengths = [per_strip(level) for level in levels if level["triangles"] > above]
    return f"{min(lengths):,.0f}" if lengths else "–"


def nearest(levels, triangles):
    """The level with about so many triangles."""
    return min(levels, key=lambda level: abs(level["triangles"] - triangles))


def line(cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def header(heads):
    line(heads)
    print("|" + " --- |" * len(heads))


def checked(report, what):
    if not report["valid"]:
        sys.exit(f"{what}: {report['faults']}")
    return report


def full_table(program, meshes, ways):
    header(["mesh", "`--policy`", "strips at the top", "triangles per strip", "indices per triangle",
            "least above 20,000: up, down", "least above 5,000: up, down", "isolating splits", "µs a split, a collapse",
            "times the bare update", "bytes written a split"])
    for mesh in meshes:
        for way in ways:
            report = checked(replay(program, mesh, way), f"{mesh}, {way}")
            up, down, top = report["levels"], report["levels_down"], report["levels"][-1]
            split, collapse = report["ns_per_operation"], report["ns_per_collapse"]
            line([
                os.path.basename(mesh),
                f"`{way}`",
                f"{top['strips']:,}",
                f"{per_strip(top):,.1f}",
                f"{top['indices'] / top['triangles']:.3f}",
                f"{least(up, 20000)}, {least(down, 20000)}",
                f"{least(up, 5000)}, {least(down, 5000)}",
                f"{report['operations_isolating']}",
                f"{split / 1000:.2f}, {collapse / 1000:.2f}",
                f"{split / report['ns_per_operation_bare']:.1f}, {collapse / report['ns_per_collapse_bare']:.1f}",
                f"{report['buffer_bytes_written_per_operation']:,.0f} of {report['buffer_bytes'] / 1000:,.0f} k",
            ])


def brief_table(program, mesh, ways):
    reports = {way: checked(replay(program, mesh, way), f"{mesh}, {way}") for way in ways}
    stops = next(iter(reports.values()))["levels"]
    middle, low = (nearest(stops, stops[-1]["triangles"] * share)["triangles"] for share in (0.5, 0.1))
    header(["policy", "triangles per strip at the top", f"on the way down, at {middle:,}", f"at {low:,}",
            "splits that isolate a triangle", "a split, a collapse, against the bare update"])
    for way, report in reports.items():
        down = report["levels_down"]
        line([
            f"`{way}`",
            f"{per_strip(report['levels'][-1]):,.1f}",
            f"{per_strip(nearest(down, middle)):,.1f}",
            f"{per_strip(nearest(down, low)):,.1f}",
            f"{report['operations_isolating']}",
            f"{report['ns_per_operation'] / report['ns_per_operation_bare']:.1f}x, "
            f"{report['ns_per_collapse'] / report['ns_per_collapse_bare']:.1f}x",
        ])
    for effort in ("fast", "full"):
        report = run(program, "stripify", mesh, "--effort", effort, "--json", "-")
        line([f"from scratch, `stripify --effort {effort}`", f"{per_strip(report):,.1f}", "–", "–", "–", "–"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, epilog="Example: scripts/strips_table.py build/release/bin/restrip bunny.obj")
    parser.add_argument("program", help="restrip")
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--way", action="append", choices=WAYS, help="only this one; may be repeated")
    parser.add_argument("--brief", action="store_true", help="the table of the README, for one mesh")
    arguments = parser.parse_args()
    if arguments.brief:
        if len(arguments.meshes) != 1:
            parser.error("--brief takes one mesh")
        brief_table(arguments.program, arguments.meshes[0], arguments.way or BRIEF_WAYS)
    else:
        full_table(arguments.program, arguments.meshes, arguments.way or WAYS)


main()
