#!/usr/bin/env python3
"""Claims: restrip-verify-bound accepts a bound that its certificate proves and tells what it read; it refuses every
certificate that is damaged or claims more, by line and reason, and every file that is no mesh of triangles. The
certificates are written by hand here, the octahedron's is the example of docs/bound.md.

    bound_test.py restrip-verify-bound PAGE SCRATCH
"""
import itertools
import pathlib
import subprocess
import sys

program, page, scratch = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
scratch.mkdir(parents=True, exist_ok=True)
OCTAHEDRON = [(1, 2, 3), (1, 3, 4), (1, 4, 5), (1, 5, 2), (6, 3, 2), (6, 4, 3), (6, 5, 4), (6, 2, 5)]


def obj(triangles, vertices):
    return "".join(f"v 0 0 {v}\n" for v in range(vertices)) + "".join("f {} {} {}\n".format(*t) for t in triangles)


def digest(triangles):
    value = 0xCBF29CE484222325
    for corner in itertools.chain(*triangles):
        for byte in (corner - 1).to_bytes(4, "little"):
            value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def verify(mesh, certificate):
    mesh_file, certificate_file = scratch / "mesh.obj", scratch / "bound.txt"
    mesh_file.write_text(mesh)
    certificate_file.write_text(certificate)
    run = subprocess.run([program, mesh_file, certificate_file], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


example = page.read_text().split("```\nrestrip-bound 1\n")[1].split("```")[0]
good = "restrip-bound 1\n" + example
assert f"digest {digest(OCTAHEDRON)}\n" in good, f"the page's digest is not {digest(OCTAHEDRON)}"
mesh = obj(OCTAHEDRON, 6)

code, said = verify(mesh, good)
last = said.splitlines()[-1]
assert code == 0, said
assert last.startswith("verified: no index buffer of 8 triangles has fewer than 12 indices, 1.5000 per triangle; read: "), last
assert last.endswith(f"{scratch / 'mesh.obj'} and 6 cuts of {scratch / 'bound.txt'}"), last
# The same mesh, written otherwise: blanks, corners of all kinds, other lines, a triangle that is left out.
other = "# by hand\r\n" + mesh.replace("f 1 2 3\n", "f\t1/7 2//3   -4/5/6 \r\nvn 0 0 1\nf 2 2 3\n")
code, said = verify(other, good)
assert code == 0 and "left out 1 triangle with a corner twice" in said, said
# Fewer cuts and smaller multipliers prove less, and no more is claimed.
code, said = verify(mesh, good.replace("cuts 6", "cuts 1").replace("".join(f"cut 2 {v}\n" for v in range(1, 6)), "")
                    .replace("arrows 4", "arrows 1").replace("indices 12", "indices 9"))
assert code == 0 and "fewer than 9 indices" in said, said
# Two components that share a vertex are one, of which no restart is counted.
bow_tie = [(1, 2, 3), (1, 4, 5)]
text = (f"restrip-bound 1\nvertices 5\ntriangles 2\ndigest {digest(bow_tie)}\ndenominator 1\ncuts 0\narrows 0\n"
        "components 1\nindices 2\nend\n")
assert verify(obj(bow_tie, 5), text)[0] == 0
code, said = verify(obj(bow_tie, 5), text.replace("components 1\nindices 2", "components 2\nindices 3"))
assert code == 1 and ":8: claims 2 components, but the mesh has 1" in said, said

refused = 0


def refuse(damaged, code, line, reason, read=mesh):
    global refused
    assert damaged != good or read != mesh
    found, said = verify(read, damaged)
    assert found == code and f"{line}: " in said and reason in said, (damaged, found, said)
    assert "verified:" not in said.replace("NOT verified:", ""), said
    refused += 1


def changed(before, after):
    assert good.count(before) == 1, before
    return good.replace(before, after)


# Claims that are not so.
refuse(changed("vertices 6", "vertices 7"), 1, "bound.txt:2", "claims 7 vertices, but the mesh has 6")
refuse(changed("triangles 8", "triangles 9"), 1, "bound.txt:3", "claims 9 triangles, but the mesh has 8")
refuse(changed("digest " + digest(OCTAHEDRON), "digest " + "0" * 16), 1, "bound.txt:4", "that of another")
refuse(changed("cut 2 5", "cut 3 5"), 1, "bound.txt:12", "loaded by more than the denominator")
refuse(changed("cut 2 5", "cut 2 4"), 1, "bound.txt:12", "loaded by more than the denominator")
refuse(changed("denominator 3", "denominator 2"), 1, "bound.txt:8", "loaded by more than the denominator")
refuse(changed("cut 2 5", "cut 1 1 2 3"), 1, "bound.txt:12", "have 12 triangles, a multiple of three")
refuse(changed("cut 2 5", "cut 1 0 5 1"), 2, "bound.txt:12", "ascending order")
refuse(changed("arrows 4", "arrows 5"), 1, "bound.txt:13", "claims 5 arrows, but the multipliers prove 4")
refuse(changed("arrows 4", "arrows 3"), 1, "bound.txt:13", "claims 3 arrows, but the multipliers prove 4")
refuse(changed("cut 2 5\n", "cut 1 5\n").replace("denominator 3", "denominator 4"), 1, "bound.txt:13", "but the multipliers prove 3")
refuse(changed("components 1", "components 2"), 1, "bound.txt:14", "claims 2 components, but the mesh has 1")
refuse(changed("indices 12", "indices 13"), 1, "bound.txt:15", "claims 13 indices, but triangles, arrows and restarts are 12")
# Another mesh of as many triangles and vertices.
refuse(good, 1, "bound.txt:4", "that of another", obj(OCTAHEDRON[1:] + OCTAHEDRON[:1], 6))
refuse(good, 1, "bound.txt:3", "the mesh has 7", obj(OCTAHEDRON[1:], 6))

# What is not of the format.
refuse(changed("restrip-bound 1", "restrip-bound 2"), 2, "bound.txt:1", 'expected "restrip-bound 1"')
for line, (before, after) in enumerate([("vertices 6", "vertexes 6"), ("triangles 8", "triangles 08"),
                                        ("digest ", "digest  "), ("denominator 3", "denominator 0"),
                                        ("cuts 6", "cuts -6")], 2):
    refuse(changed(before, after), 2, f"bound.txt:{line}", "expected")
refuse(changed("denominator 3", "denominator 4294967296"), 2, "bound.txt:5", "expected a number from 1 to 4294967295")
refuse(changed("cuts 6", "cuts 5"), 2, "bound.txt:12", 'expected "arrows" and a number, found "cut 2 5"')
refuse(changed("cuts 6", "cuts 7"), 2, "bound.txt:13", 'expected "cut"')
refuse(changed("cut 2 5", "cut 2"), 2, "bound.txt:12", 'expected "cut", a multiplier and vertices')
refuse(changed("cut 2 5", "cut 0 5"), 2, "bound.txt:12", "expected a number from 1 to 3")
refuse(changed("cut 2 5", "cut 4 5"), 2, "bound.txt:12", "expected a number from 1 to 3")
refuse(changed("cut 2 5", "cut 2 6"), 2, "bound.txt:12", "expected a number from 0 to 5")
refuse(changed("cut 2 5", "cut 2 5 5"), 2, "bound.txt:12", "ascending order, each once")
refuse(changed("cut 2 5", "cut 2 five"), 2, "bound.txt:12", "expected a decimal number")
refuse(changed("end\n", "end"), 2, "bound.txt:16", "unfinished line")
refuse(good + "end\n", 2, "bound.txt:16", 'nothing behind "end"')
lines = good.splitlines(keepends=True)
for count in range(len(lines)):
    refuse("".join(lines[:count]), 2, f"bound.txt:{count + 1}", "found the end of the file")
for place in range(len(lines)):  # a line is missing
    found, said = verify(mesh, "".join(lines[:place] + lines[place + 1:]))
    assert found in (1, 2) and "bound.txt:" in said, (place, said)
    refused += 1
# Any digit of a claim or a cut altered. A digest has its own digits, and smaller multipliers may prove as much.
for place, letter in enumerate(good):
    line = good[:place].count("\n")
    if not letter.isdigit() or line == 3:
        continue
    for digit in "0123456789":
        if digit == letter or (lines[line].startswith("cut ") and digit < letter and good[place - 4:place] == "cut "):
            continue
        found, said = verify(mesh, good[:place] + digit + good[place + 1:])
        assert found in (1, 2) and "bound.txt:" in said, (place, digit, said)
        refused += 1

# Files that are no mesh of triangles.
refuse(good, 2, "mesh.obj:7", "found a face of 4 corners", mesh.replace("f 1 2 3", "f 1 2 3 4"))
refuse(good, 2, "mesh.obj:7", "found a face of 2 corners", mesh.replace("f 1 2 3", "f 1 2"))
for corner in ("7", "0", "-7", "x", "1x", "4294967297", "99999999999999999999", "/1"):
    refuse(good, 2, "mesh.obj:7", "expected one of the 6 vertices above", mesh.replace("f 1 2 3", f"f {corner} 2 3"))
refuse(good, 2, "mesh.obj", "expected triangles, found none", "v 0 0 0\n")
for missing in ([scratch / "none.obj", scratch / "bound.txt"], [scratch / "mesh.obj", scratch / "none.txt"], []):
    run = subprocess.run([program, *missing], capture_output=True, text=True)
    assert run.returncode == 2 and (run.stderr or run.stdout), missing
print(f"{refused} refused")
assert refused > 100
