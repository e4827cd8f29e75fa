#!/usr/bin/env python3
"""What the order of strips does for a vertex cache, as a table: restrip stripify with both orders.

  scripts/order_table.py build/release/bin/restrip MESH.obj ...
"""
import json
import subprocess
import sys


def report(program, mesh, cost, effort, order):
    command = [program, "stripify", mesh, "--cost", cost, "--effort", effort, "--order", order, "--json", "-"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, meshes = sys.argv[1], sys.argv[2:]
    print("| mesh | `--cost` | `--effort` | indices per triangle | ACMR, 16: by triangle | for the cache "
          "| ACMR, 32: by triangle | for the cache |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for mesh in meshes:
        for cost in ("strips", "indices"):
            for effort in ("fast", "full"):
                plain, ordered = (report(program, mesh, cost, effort, order) for order in ("triangles", "cache"))
                for key in ("triangles", "strips", "indices"):
                    if plain[key] != ordered[key]:
                        sys.exit(f"{mesh}: {key} depend on the order: {plain[key]} and {ordered[key]}")
                name = mesh.rsplit("/", 1)[-1].rsplit(".", 1)[0]
                print(f"| {name} | `{cost}` | `{effort}` | {plain['indices'] / plain['triangles']:.3f} "
                      f"| {plain['acmr']:.3f} | {ordered['acmr']:.3f} "
                      f"| {plain['acmr_32']:.3f} | {ordered['acmr_32']:.3f} |")


if __name__ == "__main__":
    main()
