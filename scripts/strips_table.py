#!/usr/bin/env python3
"""Replays meshes under every policy and prints the table of docs/strips.md."""
import argparse
import json
import os
import subprocess
import sys
import tempfile

WAYS = ["local", "linked", "quick", "quick --tie-break indices", "full", "full --states 1024", "baked"]


def replay(program, mesh, way):
    options = ["--repeats", "3", "--json", "-"]
    if way != "baked":
        return json.loads(subprocess.check_output([program, "replay", mesh, "--base", "0.02", "--policy"] + way.split() + options))
    with tempfile.TemporaryDirectory() as folder:
        baked = os.path.join(folder, "mesh.baked")
        subprocess.check_call([program, "bake", mesh, "--base", "0.02", "-o", baked], stdout=subprocess.DEVNULL)
        return json.loads(subprocess.check_output([program, "replay", baked, "--policy", "baked"] + options))


def least(levels, above):
    per_strip = [level["triangles"] / level["strips"] for level in levels if level["triangles"] > above]
    return f"{min(per_strip):,.0f}" if per_strip else "–"


def row(mesh, way, report):
    up, down, top = report["levels"], report["levels_down"], report["levels"][-1]
    split, collapse = report["ns_per_operation"], report["ns_per_collapse"]
    cells = [
        os.path.basename(mesh),
        f"`{way}`",
        f"{top['strips']:,}",
        f"{top['triangles'] / top['strips']:,.1f}",
        f"{top['indices'] / top['triangles']:.3f}",
        f"{least(up, 20000)}, {least(down, 20000)}",
        f"{least(up, 5000)}, {least(down, 5000)}",
        f"{report['operations_isolating']}",
        f"{split / 1000:.2f}, {collapse / 1000:.2f}",
        f"{split / report['ns_per_operation_bare']:.1f}, {collapse / report['ns_per_collapse_bare']:.1f}",
        f"{report['buffer_bytes_written_per_operation']:,.0f} of {report['buffer_bytes'] / 1000:,.0f} k",
    ]
    if not report["valid"]:
        sys.exit(f"{mesh}, {way}: {report['faults']}")
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, epilog="Example: scripts/strips_table.py build/release/bin/restrip bunny.obj")
    parser.add_argument("program", help="restrip")
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--way", action="append", choices=WAYS, help="only this one; may be repeated")
    arguments = parser.parse_args()
    heads = ["mesh", "`--policy`", "strips at the top", "triangles per strip", "indices per triangle",
             "least above 20,000: up, down", "least above 5,000: up, down", "isolating splits", "µs a split, a collapse",
             "times the bare update", "bytes written a split"]
    print("| " + " | ".join(heads) + " |")
    print("|" + " --- |" * len(heads))
    for mesh in arguments.meshes:
        for way in arguments.way or WAYS:
            print(row(mesh, way, replay(arguments.program, mesh, way)), flush=True)


main()
