#!/usr/bin/env python3
"""Makes strips of meshes from scratch with every effort and prints a table: indices per triangle and time from triangle list to
index buffer.

rm_tristripper and meshoptimizer are compared with ours if given: --tristripper names a folder with the sources of
rm_tristripper (include/ and src/), which are compiled into a temporary folder; --meshoptimizer names its shared library. A column
without its library says so. Meshes are .obj files.

`fast`, rm_tristripper and meshoptimizer are called by turns, as libraries: a list in memory in, indices in memory out. Times are the
least of N calls, in the processor time of one thread. `fast` is measured twice: on a list that is trusted to be an oriented
manifold, if it is one, and with all checks. The other efforts come from one run of the program.
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

sys.dont_write_bytecode = True
from strips_table import header, line  # noqa: E402

WAYS = ["fast", "full", "best"]
RUNS = 50
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


def least_times(runs):
    """For each function what it returns and the least time that it took. They run by turns, so that what else the machine does
    meets all of them."""
    times, results = [float("inf")] * len(runs), [None] * len(runs)
    for _ in range(RUNS):
        for i, run in enumerate(runs):
            start = time.thread_time()
            results[i] = run()
            times[i] = min(times[i], time.thread_time() - start)
    return list(zip(results, times))


def indices_of(corners):
    return (ctypes.c_uint32 * len(corners))(*corners), (ctypes.c_uint32 * (2 * len(corners) + 4))()


class Fast:
    """strips_of() with effort `fast`, compiled as rm_tristripper is."""

    def __init__(self, scratch):
        root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
        library = os.path.join(scratch, "strips_of.so")
        subprocess.run(["c++", "-std=c++20", "-O3", "-march=native", "-DNDEBUG", "-shared", "-fPIC",
                        "-I", os.path.join(root, "runtime/include"), "-I", os.path.join(root, "tables/include"),
                        os.path.join(root, "bench/strips_of.cpp"), "-o", library], check=True)
        self.library = ctypes.CDLL(library)
        self.library.restrip_bench_strips.restype = ctypes.c_size_t

    def is_manifold(self, vertices, corners):
        ids, _ = indices_of(corners)
        return self.library.restrip_bench_is_manifold(ids, ctypes.c_size_t(len(corners)), ctypes.c_size_t(vertices)) != 0

    def run(self, vertices, corners, trust):
        ids, out = indices_of(corners)
        count = ctypes.c_size_t(len(corners))
        return lambda: self.library.restrip_bench_strips(ids, count, ctypes.c_size_t(vertices), ctypes.c_int(trust), out)


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

    def run(self, vertices, corners):
        ids, out = indices_of(corners)
        return lambda: self.strip(ids, len(corners), out)


class Meshoptimizer:
    """meshopt_optimizeVertexCacheStrip, as its manual asks for, then meshopt_stripify."""

    def __init__(self, library):
        self.library = ctypes.CDLL(library)
        self.library.meshopt_stripify.restype = ctypes.c_size_t

    def run(self, vertices, corners):
        count, size = len(corners), ctypes.c_size_t
        ids, out = indices_of(corners)
        ordered = (ctypes.c_uint32 * count)()

        def run():
            self.library.meshopt_optimizeVertexCacheStrip(ordered, ids, size(count), size(vertices))
            return self.library.meshopt_stripify(out, ordered, size(count), size(vertices), ctypes.c_uint32(RESTART))

        return run


def ours(program, mesh, effort):
    """The report of a run of the program."""
    # The others know positions alone.
    command = [program, "stripify", mesh, "--no-attributes", "--bound", "--cost", "indices", "--effort", effort, "--json", "-"]
    report = json.loads(subprocess.check_output(command))
    if not report["valid"]:
        sys.exit(f"scratch_table.py: {mesh}, {effort}: the colouring is not valid")
    report["list_to_buffer"] = report["seconds_to_build"] + report["seconds"] + report["seconds_to_write"]
    return report


def list_to_buffer(mesh, fast, others):
    """Of `fast` with all checks, of `fast` on trusted input (None if it is not a manifold) and of each other program: indices, and
    the time it took."""
    vertices, corners = read_obj(mesh)
    trusted = fast.is_manifold(vertices, corners)
    runs = [fast.run(vertices, corners, False)] + ([fast.run(vertices, corners, True)] if trusted else [])
    measured = least_times(runs + [other.run(vertices, corners) for other in others])
    return measured[0], measured[1] if trusted else None, measured[len(runs):]


def in_words(seconds):
    return f"{1000 * seconds:,.1f} ms" if seconds < 1 else f"{seconds:,.1f} s"


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
        fast = Fast(scratch)
        heads = ["mesh", "triangles", "bound"] + [f"`{way}`" for way in ways] + [f"`{ways[-1]}` against the bound"]
        heads += list(others) + ["ACMR of " + f"`{ways[0]}`"]
        if "fast" in ways:
            heads += [f"time of `fast` against {name}, trusted, checked" for name in others]
        header(*heads)
        for mesh in given.meshes:
            checked, trusted, rivals = list_to_buffer(mesh, fast, others.values())
            reports = {way: ours(given.program, mesh, way) for way in ways}
            one, most = reports[ways[0]], reports[ways[-1]]
            triangles = one["triangles"] + one["left_out"]
            bound = max(report["lower_bound_indices"] for report in reports.values())
            if "fast" in ways:
                if reports["fast"]["indices"] != checked[0]:
                    sys.exit(f"scratch_table.py: {mesh}: the program and the library make other strips")
                reports["fast"]["list_to_buffer"] = (trusted or checked)[1]
            cells = [os.path.basename(mesh), f"{one['triangles']:,}", f"{bound / one['triangles']:.3f}"]
            cells += [f"{r['indices'] / r['triangles']:.3f} in {in_words(r['list_to_buffer'])}" for r in reports.values()]
            cells += [f"{most['indices'] / bound:.3f}x"]
            cells += [f"{count / triangles:.3f} in {in_words(seconds)}" for count, seconds in rivals]
            cells += [f"{one['acmr']:.3f}"]
            if "fast" in ways:
                cells += [", ".join(f"{ours_[1] / seconds:.2f}x" if ours_ else "–" for ours_ in (trusted, checked))
                          for _, seconds in rivals]
            line(cells)


if __name__ == "__main__":
    main()
