#!/usr/bin/env python3
"""Claims: `restrip stripify` and `convert` draw the oriented triangles of a textured glTF file, each corner with all its
attributes in the encoding that it came in; `--weld` joins vertices that agree in everything and no others; nodes move normals
and tangents as they move the surface; what is left out is named, and a damaged attribute is refused. The files are made and
read here, with no code of restrip's.

    attributes_test.py restrip SCRATCH
"""
import itertools
import json
import math
import pathlib
import struct
import sys

from gltf_maker import BYTE, FLOAT, SHORT, UBYTE, USHORT, File
from program import Program
from strip_readers import corners_of_glb, glb, obj
from textured import N, cross, cube, save, sphere, unit

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b, strict=True))


def exploded(triangles):
    """The same corners, each a vertex of its own."""
    corners = [c for t in triangles for c in t]
    made = File()
    attributes = {}
    for kind, *_ in corners[0]:
        name, shape, component, normalized = kind
        rows = [next(value[1:] for value in corner if value[0] == kind) for corner in corners]
        width = {BYTE: 1, UBYTE: 1, SHORT: 2, USHORT: 2, FLOAT: 4}[component] * len(rows[0])
        attributes[name] = made.accessor(rows, shape, component, stride=width + -width % 4,
                                         **({"normalized": True} if normalized else {}))
    made.primitive(attributes.pop("POSITION"), **attributes)
    return made


scratch.mkdir(parents=True, exist_ok=True)
for name, file, places in (("cube", cube(), 6 * N * N + 2), ("sphere", sphere(), 14 * 8 + 2)):
    source = save(file, scratch / f"{name}.glb")
    expected = corners_of_glb(source)
    used = {c for t in expected for c in t}
    assert len({next(v for v in c if v[0][0] == "POSITION") for c in used}) == places < len(used), "there are seams"
    out = scratch / f"{name}-out.glb"
    for mode, weld in itertools.product(("restart", "strips", "list"), ((), ("--weld",))):
        told = run("stripify", source, "-o", out, "--gltf", mode, *weld).stdout
        assert corners_of_glb(out) == expected and "left out:" not in told, (name, mode, weld, told)
        assert f"{len(used) - places} vertices lie where others do and have other attributes" in told, told
    again = scratch / f"{name}-again.glb"
    run("stripify", source, "-o", out)
    for mode in ("restart", "strips", "list"):
        run("convert", out, "-o", again, "--gltf", mode)
        assert corners_of_glb(again) == expected, (name, mode)
    run("convert", source, "-o", again)
    assert corners_of_glb(again) == expected

    # Welding: everything agrees, or nothing is joined; and by places alone, when that is asked for.
    apart = save(exploded(expected), scratch / f"{name}-apart.glb")
    assert 3 * len(expected) > len(used)
    run("stripify", apart, "-o", out, "--weld")
    assert corners_of_glb(out) == expected and len(glb(out)[0]) == len(used), name
    told = run("stripify", source, "-o", out, "--weld", "--no-attributes").stdout
    assert len(glb(out)[0]) == places and "other attributes" not in told
    assert "left out: normals" in told and corners_of_glb(out) != expected

# Normals in bytes leave as floats: without an extension glTF has no others.
quantized, plain = save(cube(BYTE), scratch / "quantized.glb"), save(cube(), scratch / "cube.glb")
run("convert", quantized, "-o", scratch / "out.glb")
assert corners_of_glb(scratch / "out.glb") == corners_of_glb(plain)

# Moved by a node: of a side of the cube, which stays flat, the normal is that of its triangles as they are drawn, and the
# tangents run as the texture does.
for node in ({"rotation": [0.5, 0.5, -0.5, 0.5], "scale": [3, 0.25, 1], "translation": [5, 6, 7]},
             {"matrix": [-2, 0, 0, 0, 0.5, 1, 0, 0, 0.25, 0, 3, 0, 1, 2, 3, 1]}):
    file = cube()
    file.doc["nodes"] = [node | {"mesh": 0}]
    run("stripify", save(file, scratch / "moved.glb"), "-o", scratch / "out.glb")
    triangles = corners_of_glb(scratch / "out.glb")
    assert len(triangles) == 12 * N * N
    for t in triangles:
        p, n, tangents, uv = ([next(v[1:] for v in c if v[0][0] == name) for c in t]
                              for name in ("POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"))
        drawn = unit(cross(minus(p[1], p[0]), minus(p[2], p[0])))
        (a, b), (c, d) = minus(uv[1], uv[0]), minus(uv[2], uv[0])
        e, f = minus(p[1], p[0]), minus(p[2], p[0])
        along_u = tuple((d * x - b * y) / (a * d - b * c) for x, y in zip(e, f, strict=True))
        along_v = tuple((a * y - c * x) / (a * d - b * c) for x, y in zip(e, f, strict=True))
        for normal, tangent in zip(n, tangents, strict=True):
            assert max(map(abs, minus(normal, drawn))) < 1e-4, (node, normal, drawn)
            assert max(map(abs, minus(tangent[:3], unit(along_u)))) < 1e-4
            assert tangent[3] * dot(cross(normal, tangent[:3]), along_v) > 0

# Several primitives: what all have is kept; one accessor of positions with two of an attribute is two sets of vertices.
file, P = File(), [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
points, up = file.positions(P), file.positions([(0, 0, 1)] * 3)
uv = [file.accessor([(x + s, y) for x, y, _ in P], "VEC2", FLOAT) for s in (0, 5)]
joints = file.accessor([(0, 0, 0, 0)] * 3, "VEC4", UBYTE)
colors = file.accessor([(1, 1, 1)] * 3, "VEC3", FLOAT)
file.primitive(points, file.indices([0, 1, 2]), NORMAL=up, TEXCOORD_0=uv[0], JOINTS_0=joints, COLOR_0=colors)
file.primitive(points, file.indices([2, 1, 0]), NORMAL=up, TEXCOORD_0=uv[1])
told = json.loads(run("convert", save(file, scratch / "two.glb"), "-o", scratch / "out.glb", "--json", "-").stdout)
assert told["left_out_attributes"] == ["JOINTS_0", "COLOR_0"] and told["vertices"] == 6, told
found = {tuple(sorted(v[1:] for c in t for v in c if v[0][0] == "TEXCOORD_0")) for t in corners_of_glb(scratch / "out.glb")}
assert found == {((0, 0), (0, 1), (1, 0)), ((5, 0), (5, 1), (6, 0))}, found
assert {v[0][0] for t in corners_of_glb(scratch / "out.glb") for c in t for v in c} == {"POSITION", "NORMAL", "TEXCOORD_0"}

# What is left out is named: by formats without attributes, and by everything that changes the mesh.
source = save(sphere(), scratch / "sphere.glb")
for arguments in (("convert", source, "-o", scratch / "out.obj"), ("stripify", source, "-o", scratch / "out.ply"),
                  ("simplify", source, "--weld", "--base", 0.5, "-o", scratch / "out.pm"),
                  ("bake", source, "--weld", "--base", 0.5, "-o", scratch / "out.baked"),
                  ("replay", source, "--weld", "--base", 0.5, "--repeats", 0)):
    (line,) = [line for line in run(*arguments).stdout.splitlines() if line.startswith("left out:")]
    assert sorted(line.removeprefix("left out: ").split(", ")) == ["colours", "normals", "texture coordinates"], line
    told = json.loads(run(*arguments, "--json", "-").stdout)
    assert sorted(told["left_out_attributes"]) == ["COLOR_0", "NORMAL", "TEXCOORD_0"], told
assert "left out:" not in run("stats", source).stdout
(scratch / "in.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n")
assert "left out: texture coordinates, normals\n" in run("convert", scratch / "in.obj", "-o", scratch / "out.glb").stdout
(scratch / "in.ply").write_text("ply\nformat ascii 1.0\nelement vertex 3\n" + "".join(
    f"property float {name}\n" for name in "x y z nx ny nz red green blue".split()) +
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 0 0 1 1 1 1\n1 0 0 0 0 1 1 1 1\n"
    "0 1 0 0 0 1 1 1 1\n3 0 1 2\n")
assert "left out: normals, colours\n" in run("convert", scratch / "in.ply", "-o", scratch / "out.obj").stdout
assert len(obj(scratch / "out.obj")[1]) == 1


# Damaged ones.
def refused(edit, words):
    file = cube()
    edit(file.doc["accessors"][file.doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]], file)
    message = run("convert", save(file, scratch / "bad.glb"), "-o", scratch / "never.glb", code=2).stderr
    assert "bad.glb" in message and words in message, message
    assert not (scratch / "never.glb").exists()


def spoil(about, file):
    at = file.doc["bufferViews"][about["bufferView"]]["byteOffset"] + 12
    file.binary = file.binary[:at] + struct.pack("<f", math.nan) + file.binary[at + 4:]


refused(lambda about, _: about.update(type="VEC2"), "is not VEC3, as normals are")
refused(lambda about, _: about.update(count=5), "has 5 values of NORMAL, and there are 294 positions")
refused(lambda about, _: about.update(count=500), "reach beyond")
refused(lambda about, _: about.update(componentType=5125), "no type of an attribute")
refused(spoil, "number 1, that is infinite or not a number")
print("attributes: all hold")
