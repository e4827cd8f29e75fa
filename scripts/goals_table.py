#!/usr/bin/env python3
"""Measures meshes under the index cost and prints what was aimed at beside what was reached (docs/strips.md).

Figures are indices per triangle unless the row says otherwise. Rows with rm_tristripper need its sources: --tristripper FOLDER
(include/ and src/); without it they are left out. Times are ratios of two times of one run.
"""
import argparse
import os
import sys
import tempfile

sys.dont_write_bytecode = True
from scratch_table import Fast, Tristripper, list_to_buffer, ours  # noqa: E402
from strips_table import Program, bake_and_play, header, line, name_of, per_triangle, times_bare  # noqa: E402

# Strips from scratch by annealing, measured before anything was built: what `full` and `best` are compared with.
ANNEALED = {"bunny": 1.104, "rocker-arm": 1.235, "fandisk": 1.093, "nefertiti": 1.243, "soccerball_g31": 1.311}
# Policy: the most at any level above 1,000 triangles, and the most of the bare update.
POLICIES = {"local": (1.42, 4), "linked": (1.38, 7), "quick": (1.34, 15), "full": (1.29, 80), "best": (1.275, 500)}


class Table:
    """Rows of a goal and what each mesh reaches; `met` says of a figure whether it is good enough."""

    def __init__(self, meshes):
        self.meshes, self.rows = meshes, {}

    def add(self, mesh, what, goal, figure, met):
        self.rows.setdefault((what, goal), {})[mesh] = (figure, met)

    def at_most(self, mesh, what, limit, figure, digits=3):
        self.add(mesh, what, f"at most {limit}", f"{figure:.{digits}f}", figure <= limit)

    def print(self):
        header("", "aimed at", *map(name_of, self.meshes), "missed")
        for (what, goal), cells in self.rows.items():
            figures = [cells.get(mesh, ("–", True)) for mesh in self.meshes]
            missed = sum(not met for _, met in figures)
            line([what, goal, *(figure if met else f"*{figure}*" for figure, met in figures), str(missed) if missed else ""])


def from_scratch(table, program, mesh, own, tristripper):
    fast, full, best = (ours(program.path, mesh, effort) for effort in ("fast", "full", "best"))
    if tristripper:
        checked, trusted, [(indices, seconds)] = list_to_buffer(mesh, own, [tristripper])
        rival = indices / (fast["triangles"] + fast["left_out"])
        table.add(mesh, "from scratch, `fast`", "fewer than rm_tristripper", f"{per_triangle(fast):.3f} against {rival:.3f}",
                  per_triangle(fast) < rival)
        if trusted:
            table.at_most(mesh, "the same, list to buffer, list trusted: of its time", 1, trusted[1] / seconds, 2)
        table.at_most(mesh, "the same, with all checks: of its time", 1.3, checked[1] / seconds, 2)
    goal = ANNEALED.get(name_of(mesh))
    if goal:
        table.add(mesh, "from scratch, `full`", "within 2 % of annealing", f"{per_triangle(full):.3f} against {goal}",
                  per_triangle(full) <= 1.02 * goal)
        table.add(mesh, "from scratch, `best`", "below annealing", f"{per_triangle(best):.3f} against {goal}", per_triangle(best) < goal)
    bound = best["indices"] / best["lower_bound_indices"]
    table.at_most(mesh, "`best` against the lower bound", 1.05, bound)


def policies(table, program, mesh, ways):
    for way in ways:
        most, times = POLICIES[way]
        report = program.replay(mesh, way, "--cost", "indices")
        levels = [level for level in report["levels"] + report["levels_down"] if level["triangles"] > 1000]
        table.at_most(mesh, f"`{way}`, the most at any level", most, max(map(per_triangle, levels)))
        table.at_most(mesh, f"`{way}`, times the bare update", times, max(times_bare(report)), 1)
        buffer = max(level["buffer_indices"] / level["indices"] for level in levels)
        table.at_most(mesh, f"`{way}`, live buffer against its strips", 1.10, buffer, 2)
        worst = max(level["buffer_indices"] / level["triangles"] for level in report["levels"] + report["levels_down"])
        table.at_most(mesh, f"`{way}`, live buffer, at any level however coarse", 3, worst, 2)
        table.at_most(mesh, f"`{way}`, bytes rewritten an operation", 300, report["buffer_bytes_written_per_operation"], 0)
        if way == "local":
            update = report["ns_per_buffer_update"] / report["ns_per_operation"]
            table.at_most(mesh, "`local`, an update of the live buffer, of the operation", 2, update, 1)


def baked(table, program, mesh):
    report, replay = bake_and_play(program, mesh, ["--cost", "indices"], [])
    levels = [level for level in replay["levels"] + replay["levels_down"] if level["triangles"] > 1000]
    table.at_most(mesh, "baked, the most at any level", 1.27, max(map(per_triangle, levels)))
    table.at_most(mesh, "baked, times the bare update", 2.2, max(times_bare(replay)), 1)
    table.at_most(mesh, "baked, bytes a record", 30, report["bytes_per_record"], 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/goals_table.py build/release/bin/restrip bunny.obj")
    parser.add_argument("program", help="restrip")
    parser.add_argument("meshes", nargs="+", metavar="MESH.obj")
    parser.add_argument("--tristripper", metavar="FOLDER", default=os.environ.get("RM_TRISTRIPPER"))
    parser.add_argument("--way", action="append", choices=POLICIES, help="only this policy; may be repeated")
    parser.add_argument("--repeats", type=int, help="how often times are measured; default: as restrip replay does")
    given = parser.parse_args()
    if not given.tristripper:
        print("rm_tristripper is left out: --tristripper FOLDER names its sources", file=sys.stderr)
    program = Program(given.program, given.repeats)
    table = Table(given.meshes)
    with tempfile.TemporaryDirectory() as scratch:
        tristripper = Tristripper(given.tristripper, scratch) if given.tristripper else None
        own = Fast(scratch) if given.tristripper else None
        for mesh in given.meshes:
            from_scratch(table, program, mesh, own, tristripper)
            policies(table, program, mesh, given.way or POLICIES)
            baked(table, program, mesh)
    table.print()


if __name__ == "__main__":
    main()
