"""mypy --strict finds a misspelt policy, form, cost and format in a user's program, and none in a correct one.

    typing_test.py SOURCES
"""
import pathlib
import re
import subprocess
import sys
import tempfile

GOOD = """
import numpy as np
import restrip

faces = np.array([[0, 1, 2]])
from numpy.typing import NDArray

one: "NDArray[np.uint16] | NDArray[np.uint32]" = restrip.strips_of(faces, "strips", "stitched")
several: "list[NDArray[np.uint16] | NDArray[np.uint32]]" = restrip.strips_of(faces, format="strips")
cells: NDArray[np.int64] = restrip.strips_of(faces, "indices", "vtk")


def any_format(format: restrip.Format) -> object:
    return restrip.strips_of(faces, format=format)


numbers: NDArray[np.uint32] = restrip.faces_of(several[0]).astype(np.uint32)
records: NDArray[np.uint32] = np.zeros((0, 4), np.uint32)
with restrip.LiveMesh(faces, policy="quick", cost=(3, 1, 0)) as mesh:
    mesh.begin_buffer("list", 16)
    mesh.play(records)
    print(len(mesh), mesh.indices(index="auto"), one, several)
    codes, changes = mesh.apply_each("flip", mesh.find_each(faces[:, 0], faces[:, 1]))
    print(codes[0], changes["halfedge"], restrip.describe(int(mesh.check_each("bisect", [0])[0])))
    saved: bytes = mesh.save()
    again: restrip.LiveMesh = restrip.LiveMesh.load(saved, history=100)
"""
BAD = ['restrip.LiveMesh(faces, policy="quikc")', 'restrip.LiveMesh(faces, cost="turns")', 'restrip.LiveMesh(faces, effort="most")', 'mesh.begin_buffer("lists")',
       'mesh.indices(index=8)', 'mesh.keep("quikc")', 'mesh.apply_each("split", [0])', 'restrip.LiveMesh.load("saved")', 'restrip.strips_of(faces, format="fans")', 'wrong: np.ndarray = restrip.strips_of(faces, format="strips")', 'mesh.play(3, backward=True)', 'floats: NDArray[np.float64] = mesh.faces()']


def lines_with_faults(text):
    """The numbers of the lines that mypy refuses, and what it says."""
    with tempfile.TemporaryDirectory() as folder:
        user = pathlib.Path(folder) / "user.py"
        user.write_text(text, encoding="utf-8")
        done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", "--disable-error-code=type-arg", "--cache-dir", f"{folder}/cache", str(user)],
                              env={"MYPYPATH": str(pathlib.Path(sys.argv[1]).resolve()), "PATH": "/usr/bin:/bin"}, cwd=folder, stdout=subprocess.PIPE, text=True)
        return {int(line) for line in re.findall(r"user.py:(\d+): error: ", done.stdout)}, done.stdout


found, said = lines_with_faults(GOOD)
assert not found and "Success" in said, said
first = GOOD.count("\n") + 1
found, said = lines_with_faults(GOOD + "\n".join(BAD) + "\n")
assert found == set(range(first, first + len(BAD))), said
print(f"{len(BAD)} mistakes found")
