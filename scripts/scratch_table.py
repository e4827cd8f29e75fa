#!/usr/bin/env python3
"""Makes strips of meshes from scratch with every effort and prints a table: indices per triangle and time from triangle list to
index buffer.

rm_tristripper and meshoptimizer stand beside ours where they are given: --tristripper names a folder with the sources of
rm_tristripper (include/ and src/), which are compiled into a temporary folder; --meshoptimizer names its shared library. A column
without its library says so. Meshes are .obj files. Times are the least of seven runs in the processor time of one thread.
"""
import argparse
import ctypes
import glob
import json
import os
import subprocess
import sys
import tempfile
import time

WAYS = ["fast", "full", "best"]
RUNS = 7
RESTART = 0xFFFFFFFF


def read_obj(name):
    vertices, corners = 0, []
    with open(name, encoding="utf-8", errors="replace") as file:
        for line in file:
            words = line.split()
            if not words:
                continue
            if words[0] == "v":
                vertices += 1
            elif words[0] == "f":
                face = [int(word.split("/")[0]) - 1 for word in words[1:]]
                for i in range(2, len(face)):
                    corners += [face[0], face[i - 1], face[i]]
    if not corners:
        sys.exit(f"scratch_table.py: {name}: has no triangles")
    return vertices, corners


def least_time(run):
    times, result = [], None
    for _ in range(RUNS):
        start = time.thread_time()
        result = run()
        times.append(time.thread_time() - start)
    return result, min(times)


class Tristripper:
    """rm_tristripper's "stripify", winding kept, its strips joined into one index buffer with restarts."""

    SHIM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "bench", "tristripper.c")

    def __init__(self, folder, scratch):
        sources = sorted(glob.glob(os.path.join(folder, "src", "*.c")))
        if not sources:
            sys.exit(f"scratch_table.py: {folder}: no sources in src/; give a copy of rm_tristripper")
        library = os.path.join(scratch, "tristripper.so")
        subprocess.run(["cc", "-O3", "-march=native", "-ffast-math", "-std=gnu99", "-DLINUX", "-w", "-shared", "-fPIC", "-I",
                        os.path.join(folder, "include"), *sources, self.SHIM, "-o", library], check=True)
        self.strip = ctypes.CDLL(library).tristripper_indices
        self.strip.restype = ctypes.c_size_t
        self.strip.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_void_p]

    def __call__(self, vertices, corners):
        list_of_triangles = (ctypes.c_uint32 * len(corners))(*corners)
        out = (ctypes.c_uint32 * (2 * len(corners) + 4))()
        return least_time(lambda: self.strip(list_of_triangles, len(corners), out))


class Meshoptimizer:
    """meshopt_optimizeVertexCacheStrip, as its manual asks for, then meshopt_stripify."""

    def __init__(self, library):
        self.library = ctypes.CDLL(library)
        self.library.meshopt_stripify.restype = ctypes.c_size_t

    def __call__(self, vertices, corners):
        count, size = len(corners), ctypes.c_size_t
        list_of_triangles = (ctypes.c_uint32 * count)(*corners)
        ordered = (ctypes.c_uint32 * count)()
        out = (ctypes.c_uint32 * (2 * count))()

        def run():
            self.library.meshopt_optimizeVertexCacheStrip(ordered, list_of_triangles, size(count), size(vertices))
            return self.library.meshopt_stripify(out, ordered, size(count), size(vertices), ctypes.c_uint32(RESTART))

        return least_time(run)


def ours(program, mesh, effort):
    """The report of the fastest of some runs."""
    runs = RUNS if effort == "fast" else 1
    # The others know positions alone.
    command = [program, "stripify", mesh, "--no-attributes", "--cost", "indices", "--effort", effort, "--json", "-"]
    reports = [json.loads(subprocess.check_output(command)) for _ in range(runs)]
    for report in reports:
        if not report["valid"]:
            sys.exit(f"scratch_table.py: {mesh}, {effort}: the colouring is not valid")
        report["list_to_buffer"] = report["seconds_to_build"] + report["seconds"] + report["seconds_to_write"]
    return min(reports, key=lambda report: report["list_to_buffer"])


def in_words(seconds):
    return f"{1000 * seconds:,.1f} ms" if seconds < 1 else f"{seconds:,.1f} s"


def line(cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: scripts/scratch_table.py build/release/bin/restrip bunny.obj")
    parser.add_argument("program", help="restrip")
    parser.add_argument("meshes", nargs="+", metavar="MESH.obj")
    parser.add_argument("--tristripper", metavar="FOLDER", default=os.environ.get("RM_TRISTRIPPER"))
    parser.add_argument("--meshoptimizer", metavar="LIBRARY")
    parser.add_argument("--way", action="append", choices=WAYS, help="only this effort; may be repeated")
    given = parser.parse_args()
    ways = given.way or WAYS
    with tempfile.TemporaryDirectory() as scratch:
        others = {}
        if given.tristripper:
            others["rm_tristripper"] = Tristripper(given.tristripper, scratch)
        else:
            print("rm_tristripper is left out: --tristripper FOLDER names its sources", file=sys.stderr)
        if given.meshoptimizer:
            others["meshoptimizer"] = Meshoptimizer(given.meshoptimizer)
        else:
            print("meshoptimizer is left out: --meshoptimizer LIBRARY names it", file=sys.stderr)
        heads = ["mesh", "triangles", "bound"] + [f"`{way}`" for way in ways] + [f"`{ways[-1]}` against the bound"]
        heads += list(others) + ["ACMR of " + f"`{ways[0]}`"]
        if others and "fast" in ways:
            heads += [f"time of `fast` against {name}" for name in others]
        line(heads)
        print("|" + " --- |" * len(heads))
        for mesh in given.meshes:
            vertices, corners = read_obj(mesh)
            triangles = len(corners) // 3
            reports = {way: ours(given.program, mesh, way) for way in ways}
            rivals = {name: strip(vertices, corners) for name, strip in others.items()}
            one, most = reports[ways[0]], reports[ways[-1]]
            bound = max(report["lower_bound_indices"] for report in reports.values())
            cells = [os.path.basename(mesh), f"{one['triangles']:,}", f"{bound / one['triangles']:.3f}"]
            cells += [f"{r['indices'] / r['triangles']:.3f} in {in_words(r['list_to_buffer'])}" for r in reports.values()]
            cells += [f"{most['indices'] / bound:.3f}x"]
            cells += [f"{count / triangles:.3f} in {in_words(seconds)}" for count, seconds in rivals.values()]
            cells += [f"{one['acmr']:.3f}"]
            if "fast" in ways:
                cells += [f"{reports['fast']['list_to_buffer'] / seconds:.2f}x" for _, seconds in rivals.values()]
            line(cells)


if __name__ == "__main__":
    main()
