#!/usr/bin/env python3
"""Claims: `restrip stripify` and `convert` draw the oriented triangles of a textured glTF file, each corner with all
its attributes in the encoding that it came in; through OBJ and PLY normals, texture coordinates and colours come back;
`--weld` joins vertices that agree in everything and no others; nodes move normals and tangents as they move the
surface; what is left out is named, and a damaged attribute is refused. The files are made and read here, with no code
of restrip's.

    attributes_test.py restrip SCRATCH
"""
import collections
import itertools
import json
import math
import pathlib
import struct
import sys

from gltf_maker import BYTE, FLOAT, N, SHORT, UBYTE, USHORT, cross, cube, File, save, sphere, unit
from program import Program
from strip_readers import corners_of_glb, drawn_obj, drawn_ply, glb, obj, parts_of_glb

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b, strict=True))


def exploded(triangles):
    """The same corners, each a separate vertex."""
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
        printed = run("stripify", source, "-o", out, "--gltf", mode, *weld).stdout
        assert corners_of_glb(out) == expected and "left out:" not in printed, (name, mode, weld, printed)
        assert f"{len(used) - places} vertices lie where others do and have other attributes" in printed, printed
    again = scratch / f"{name}-again.glb"
    run("stripify", source, "-o", out)
    for mode in ("restart", "strips", "list"):
        run("convert", out, "-o", again, "--gltf", mode)
        assert corners_of_glb(again) == expected, (name, mode)
    run("convert", source, "-o", again)
    assert corners_of_glb(again) == expected

    # Welding joins everything if all values agree, and nothing if they differ; on request it compares positions only.
    apart = save(exploded(expected), scratch / f"{name}-apart.glb")
    assert 3 * len(expected) > len(used)
    run("stripify", apart, "-o", out, "--weld")
    assert corners_of_glb(out) == expected and len(glb(out)[0]) == len(used), name
    printed = run("stripify", source, "-o", out, "--weld", "--no-attributes").stdout
    assert len(glb(out)[0]) == places and "other attributes" not in printed
    assert "left out: " in printed and "normals" in printed and corners_of_glb(out) != expected

# Normals in bytes become floats: glTF without extensions has only floats.
quantized, plain = save(cube(BYTE), scratch / "quantized.glb"), save(cube(), scratch / "cube.glb")
run("convert", quantized, "-o", scratch / "out.glb")
assert corners_of_glb(scratch / "out.glb") == corners_of_glb(plain)

# Moved by a node: on a flat side of the cube, the normal is the normal of its triangles as drawn, and the tangents
# follow the texture.
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

# Several primitives: attributes common to all are kept; one accessor of positions with two of an attribute gives two
# sets of vertices.
file, P = File(), [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
points, up = file.positions(P), file.positions([(0, 0, 1)] * 3)
uv = [file.accessor([(x + s, y) for x, y, _ in P], "VEC2", FLOAT) for s in (0, 5)]
joints = file.accessor([(0, 0, 0, 0)] * 3, "VEC4", UBYTE)
colors = file.accessor([(1, 1, 1)] * 3, "VEC3", FLOAT)
file.primitive(points, file.indices([0, 1, 2]), NORMAL=up, TEXCOORD_0=uv[0], JOINTS_0=joints, COLOR_0=colors)
file.primitive(points, file.indices([2, 1, 0]), NORMAL=up, TEXCOORD_0=uv[1])
printed = json.loads(run("convert", save(file, scratch / "two.glb"), "-o", scratch / "out.glb", "--json", "-").stdout)
assert printed["left_out_content"] == ["JOINTS_0", "COLOR_0"] and printed["vertices"] == 6, printed
found = {tuple(sorted(v[1:] for c in t for v in c if v[0][0] == "TEXCOORD_0")) for t in corners_of_glb(scratch / "out.glb")}
assert found == {((0, 0), (0, 1), (1, 0)), ((5, 0), (5, 1), (6, 0))}, found
assert {v[0][0] for t in corners_of_glb(scratch / "out.glb") for c in t for v in c} == {"POSITION", "NORMAL", "TEXCOORD_0"}

# Left-out attributes are reported, by formats without attributes and by every command that changes the mesh.
source = save(sphere(), scratch / "sphere.glb")
for arguments in (("convert", source, "-o", scratch / "out.off"), ("stripify", source, "-o", scratch / "out.bin"),
                  ("simplify", source, "--weld", "--base", 0.5, "-o", scratch / "out.pm"),
                  ("bake", source, "--weld", "--base", 0.5, "-o", scratch / "out.baked"),
                  ("replay", source, "--weld", "--base", 0.5, "--repeats", 0)):
    (line,) = [line for line in run(*arguments).stdout.splitlines() if line.startswith("left out:")]
    assert sorted(line.removeprefix("left out: ").split(", ")) == ["colours", "normals", "texture coordinates"], line
    printed = json.loads(run(*arguments, "--json", "-").stdout)
    assert sorted(printed["left_out_content"]) == ["COLOR_0", "NORMAL", "TEXCOORD_0"], printed
assert "left out: colours, normals, texture coordinates\n" in run("stats", source).stdout
# simplify reports it once, and how to keep them; or it keeps them: the remaining vertices are drawn vertices of the
# source, including all at seams.
done = run("simplify", source, "--base", 0.5, "-o", scratch / "out.glb")
assert done.stderr == "" and done.stdout.count("texture coordinates") == 1 and "with --attributes" in done.stdout, done
for shape, base in ((cube(), 0.5), (sphere(), 0.7)):
    source = save(shape, scratch / "seams.glb")
    done = run("simplify", source, "--attributes", "--base", base, "-o", scratch / "out.glb")
    assert done.stderr == "" and "left out:" not in done.stdout, done
    before, after = (corners_of_glb(path) for path in (source, scratch / "out.glb"))
    assert len(after) <= base * len(before)
    there, kept = ({c for t in corners for c in t} for corners in (before, after))
    at = collections.defaultdict(set)
    for corner in there:
        at[next(values for (name, *_), *values in corner if name == "POSITION").__repr__()].add(corner)
    seams = {corner for corners in at.values() if len(corners) > 1 for corner in corners}
    assert seams and seams <= kept < there, (len(seams), len(kept), len(there))
source = save(sphere(), scratch / "sphere.glb")

# Through OBJ and PLY.
MOST = {UBYTE: 255, USHORT: 65535}


def by_places(triangles):
    """By the places of their corners; the other values as tuples, by name."""
    made = {}
    for t in triangles:
        at = min(range(3), key=lambda i: t[i]["POSITION"])
        t = t[at:] + t[:at]
        places = tuple(struct.unpack("<3f", struct.pack("<3f", *c["POSITION"])) for c in t)
        assert places not in made
        made[places] = [{name: value for name, value in c.items() if name != "POSITION"} for c in t]
    return made


def meant(corners):
    """Triangles of corners_of_glb, whole numbers as the fractions that they stand for, without what only glTF has."""
    return [[{kind[0]: tuple(x / MOST[kind[2]] if kind[3] else x for x in values) for kind, *values in c
              if kind[0] in ("POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0")} for c in t] for t in corners]


def expect_near(found, wanted):
    """Within a 24th of a bit of single precision: both formats count texture coordinates from below."""
    assert found.keys() == wanted.keys()
    for places, corners in found.items():
        for one, other in zip(corners, wanted[places], strict=True):
            assert one.keys() == other.keys(), (one, other)
            for name, value in one.items():
                assert len(value) == len(other[name]) and max(map(abs, minus(value, other[name]))) < 2e-7, (name, value, other)


for name, file, places in (("cube", cube(), 6 * N * N + 2), ("sphere", sphere(), 14 * 8 + 2)):
    source = save(file, scratch / f"{name}.glb")
    corners = corners_of_glb(source)
    used, wanted = {c for t in corners for c in t}, by_places(meant(corners))
    doc, accessor = parts_of_glb(source)
    rows = [[flat[i:i + len(flat) // about["count"]] for i in range(0, len(flat), len(flat) // about["count"])]
            for about, _, flat in (accessor(doc["meshes"][0]["primitives"][0]["attributes"][n]) for n in ("POSITION", "COLOR_0"))]
    colors = set(zip(*rows, strict=True))
    others = {"cube": "left out: tangents, texture coordinates, _ROOM\n", "sphere": ""}[name]
    for command in ("convert", "stripify"):
        out = {end: scratch / f"{name}-{command}.{end}" for end in ("obj", "ply")}
        for path in out.values():
            printed = run(command, source, "-o", path).stdout
            assert others in printed and ("left out:" in printed) == bool(others), printed
        triangles, lines = drawn_obj(out["obj"])
        expect_near(by_places(triangles), wanted)
        # A position is one `v` for each of its colours, whatever the number of normals and texture coordinates.
        assert lines["v"] == len(colors) and lines["vn"] < len(rows[0]) >= lines["vt"]
        triangles, types = drawn_ply(out["ply"])
        kinds = {kind for t in corners for c in t for kind, *_ in c if kind[0] == "COLOR_0"}
        assert [types[c] for c in ("red", "green", "blue")] == ["uchar"] * 3
        assert ("alpha" in types) == (kinds == {("COLOR_0", "VEC4", UBYTE, True)}), kinds
        expect_near(by_places([[c | {"COLOR_0": tuple(x / 255 for x in c["COLOR_0"])} for c in t] for t in triangles]), wanted)

        # And back; further conversions change nothing.
        for end, path in out.items():
            back, again, third = (scratch / f"{name}-{end}-{i}.{e}" for i, e in ((1, "glb"), (2, end), (3, "glb")))
            for one, other in ((path, back), (back, again), (again, third)):
                assert "left out:" not in run(command, one, "-o", other).stdout
            expect_near(by_places(meant(corners_of_glb(back))), wanted)
            assert corners_of_glb(back) == corners_of_glb(third)
            assert {v for t in corners_of_glb(back) for c in t for v in c if v[0][0] == "COLOR_0"} == {
                v for t in corners for c in t for v in c if v[0][0] == "COLOR_0"} or end == "obj"
            assert len({c for t in corners_of_glb(back) for c in t}) == len(used)
            # By positions only the seams are gone, as in glTF.
            run("stripify", path, "--no-attributes", "--weld", "-o", scratch / "out.glb")
            assert len(glb(scratch / "out.glb")[0]) == places


def values(lines, end, *others):
    """The one triangle of a file, by names: the values of its three corners in a GLB."""
    (scratch / f"in.{end}").write_text(lines)
    printed = run("convert", scratch / f"in.{end}", "-o", scratch / "out.glb").stdout
    (line,) = [line for line in printed.splitlines() if line.startswith("left out:")] or [""]
    assert line == "".join(f"left out: {other}" for other in others), printed
    doc, accessor = parts_of_glb(scratch / "out.glb")
    found = {}
    for name, number in doc["meshes"][0]["primitives"][0]["attributes"].items():
        about, _, flat = accessor(number)
        assert about.get("normalized", False) == (about["componentType"] != FLOAT)
        found[name] = list(zip(*[iter(flat)] * (len(flat) // about["count"])))
    return found


P = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
V = "vt 0 0.25\nvt 1 0\nvt 0.5\nvn 0 0 2\nvn 1 0 0\n"
assert values(P + V + "f 1/1/1 2/2/2 3/3/1\n", "obj") == values(P + V + "f -3/-3/-2 -2/-2/-1 -1/-1/-2\n", "obj") == {
    "POSITION": [(0, 0, 0), (1, 0, 0), (0, 1, 0)], "NORMAL": [(0, 0, 1), (1, 0, 0), (0, 0, 1)],
    "TEXCOORD_0": [(0, 0.75), (1, 1), (0.5, 1)]}
# Other pairs of a `v` follow at the end.
assert values(P + V + "f 1/1 2/1 3/1\nf 1/2 2/2 3/1\n", "obj", "normals") == {
    "POSITION": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0), (1, 0, 0)],
    "TEXCOORD_0": [(0, 0.75)] * 3 + [(1, 1)] * 2}
assert values(P + V + "f 1//1 2//2 3//1\nf 3/1/1 2/1/1 1/1/1\n", "obj", "texture coordinates").keys() == {"POSITION", "NORMAL"}
assert values(P + V + "f 1/1 2 3/1\n", "obj", "texture coordinates, normals").keys() == {"POSITION"}
assert values("v 0 0 0 1 0 0.5\nv 1 0 0 0 1 0\nv 0 1 0 1 1 1\nf 1 2 3\n", "obj")["COLOR_0"] == [(1, 0, 0.5), (0, 1, 0), (1, 1, 1)]
assert values("v 0 0 0 1 0 0 0\nv 1 0 0 0 1 0 1\nv 0 1 0 1 1 1 0\nf 1 2 3\n", "obj")["COLOR_0"][0] == (1, 0, 0, 0)
assert values("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n", "obj").keys() == {"POSITION"}
assert values("v 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "obj", "colours").keys() == {"POSITION"}
assert values("v 0 0 0\nv 1 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n", "obj", "colours").keys() == {"POSITION"}


def ply_text(properties, rows, *others):
    return values("ply\nformat ascii 1.0\nelement vertex 3\n" + "".join(
        f"property {kind} {name}\n" for kind, names in (("float", "x y z"), *properties) for name in names.split()) +
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
        "".join(f"{place} {row}\n" for place, row in zip(("0 0 0", "1 0 0", "0 1 0"), rows)) + "3 0 1 2\n", "ply", *others)


assert ply_text([("double", "nx ny nz"), ("uchar", "red green blue")], ["0 0 3 1 2 3", "0 1 0 4 5 6", "1 0 0 7 8 255"]) == {
    "POSITION": [(0, 0, 0), (1, 0, 0), (0, 1, 0)], "NORMAL": [(0, 0, 1), (0, 1, 0), (1, 0, 0)],
    "COLOR_0": [(1, 2, 3), (4, 5, 6), (7, 8, 255)]}
for u, v in (("s", "t"), ("u", "v"), ("texture_u", "texture_v")):
    assert ply_text([("float", f"{u} {v}")], ["0 0", "1 0.25", "0 1"])["TEXCOORD_0"] == [(0, 1), (1, 0.75), (0, 0)]
assert ply_text([("ushort", "diffuse_red diffuse_green diffuse_blue diffuse_alpha")], ["0 1 2 3", "9 9 9 9", "1 1 1 65535"])[
    "COLOR_0"] == [(0, 1, 2, 3), (9, 9, 9, 9), (1, 1, 1, 65535)]
assert ply_text([("float", "nx ny nz")], ["0 0 1", "0 0 1", "0 0 inf"], "normals (infinite or not a number at vertex 2)").keys() == {"POSITION"}
for properties, said in (([("float", "nx ny")], "normals"), ([("int", "nx ny nz")], "normals"), ([("float", "s")], "texture coordinates"),
                         ([("uchar", "red green"), ("float", "blue")], "colours"), ([("int", "red green blue")], "colours")):
    row = " ".join(["1"] * sum(len(names.split()) for _, names in properties))
    assert ply_text(properties, [row] * 3, said).keys() == {"POSITION"}
for properties, row, words in (([("uchar", "red green blue")], "1 2 256", "vertex 0 has a colour 256, which is not from 0 to 255"),
                               ([("ushort", "red green blue")], "1 2 0.5", "vertex 0 has a colour 0.5")):
    try:
        ply_text(properties, [row] * 3)
    except AssertionError as refusal:
        assert words in str(refusal), refusal
    else:
        raise AssertionError(words)


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
refused(lambda about, _: about.update(componentType=5125), "is not a type of an attribute")
for edit in (lambda about, _: about.update(type="VEC2"), lambda about, _: about.update(count=5), lambda about, _: about.update(count=500)):
    refused(edit, "; --no-attributes reads the mesh without it")
    run("convert", scratch / "bad.glb", "--no-attributes", "-o", scratch / "out.obj")
file = cube()
spoil(file.doc["accessors"][file.doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]], file)
printed = run("convert", save(file, scratch / "bad.glb"), "-o", scratch / "out.obj").stdout
assert "normals (infinite or not a number at vertex 1)" in printed, printed
print("attributes: all hold")
