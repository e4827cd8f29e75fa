#!/usr/bin/env python3
"""Claims: a progressive mesh goes into MANYFOLD_mesh_progressive and comes back with the same splits, every vertex where it
was but for rounding; a reader that follows the proposal's steps and nothing else draws the finest mesh; and what the
proposal has no record for, or what is not read, is refused with a sentence that says so.

    progressive_gltf_test.py restrip SCRATCH
"""
import json
import os
import pathlib
import struct
import sys

from gltf_maker import edited_glb
from program import Program
from strip_readers import obj, rotated

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])
scratch.mkdir(parents=True, exist_ok=True)
NAME = "MANYFOLD_mesh_progressive"


def pm(path):
    """Base vertices, faces, splits (position, v1, vl, vr) of OpenMesh's format."""
    data = path.read_bytes()
    assert data[:8] == b"ProgMesh"
    vertices, faces, splits = struct.unpack_from("<3I", data, 8)
    at = 20
    points = [struct.unpack_from("<3f", data, at + 12 * i) for i in range(vertices)]
    at += 12 * vertices
    base = [struct.unpack_from("<3I", data, at + 12 * i) for i in range(faces)]
    at += 12 * faces
    records = [struct.unpack_from("<3f3i", data, at + 24 * i) for i in range(splits)]
    assert len(data) == at + 24 * splits
    return points, base, [r[3:] for r in records], points + [r[:3] for r in records]


def refined(data):
    """Points and triangles after all splits, by the proposal's four steps: triangles that contain vs get vt between the edges
    that the two new ones have turned over."""
    (size,) = struct.unpack_from("<I", data, 12)
    doc, binary = json.loads(data[20:20 + size]), data[28 + size:]

    def values(number):
        about = doc["accessors"][number]
        view = doc["bufferViews"][about["bufferView"]]
        kind = {5123: "H", 5125: "I", 5126: "f"}[about["componentType"]] * {"SCALAR": 1, "VEC3": 3}[about["type"]]
        stride = view.get("byteStride", struct.calcsize("<" + kind))
        return [struct.unpack_from("<" + kind, binary, view.get("byteOffset", 0) + i * stride) for i in range(about["count"])]

    (primitive,) = doc["meshes"][0]["primitives"]
    extension = primitive["extensions"][NAME]
    points = [list(p) for p in values(primitive["attributes"]["POSITION"])]
    corners = [v for (v,) in values(primitive["indices"])]
    after = [{} for _ in points]  # of each vertex: the corner that follows on each triangle, by the one before
    base = [tuple(corners[i:i + 3]) for i in range(0, len(corners), 3)]
    for a, b, c in base:
        after[a][b], after[b][c], after[c][a] = c, a, b
    for (s, left, right), d in zip(values(extension["indices"]), values(extension["attributes"]["POSITION"])):
        t = len(points)
        points.append([x + y for x, y in zip(points[s], d)])
        points[s] = [x - y for x, y in zip(points[s], d)]
        after.append({})
        v = right  # the triangles from here on, to the left one, get t
        while v != left:
            w = after[s].pop(v)
            after[t][v] = w
            after[v][w], after[w][t] = t, v
            del after[w][s]
            v = w
        for a, b, c in ((s, t, left), (t, s, right)):
            after[a][b], after[b][c], after[c][a] = c, a, b
    triangles = sorted({rotated([a, b, c]) for a in range(len(points)) for b, c in after[a].items()})
    return points, triangles, len(doc["extensionsUsed"]) == 1 and "extensionsRequired" not in doc


def check(source, name):
    there, back = scratch / f"{name}.glb", scratch / f"{name}_back.pm"
    run("convert", source, "-o", there, "--gltf", "progressive")
    printed = run("convert", there, "-o", back).stdout
    _, base, splits, places = pm(source)
    _, base_back, splits_back, places_back = pm(back)
    assert (base_back, splits_back) == (base, splits) and str(len(splits)) in printed, printed
    size = max(abs(x) for p in places for x in p)
    most = max(abs(x - y) for p, q in zip(places, places_back) for x, y in zip(p, q))
    assert most < 1e-6 * size, (most, size)
    points, triangles, may_be_left_unknown = refined(there.read_bytes())
    assert may_be_left_unknown
    run("convert", source, "-o", scratch / f"{name}.obj")
    expected_points, expected = obj(scratch / f"{name}.obj")
    assert triangles == sorted(expected)
    assert all(abs(x - y) < 1e-5 * size for p, q in zip(points, expected_points) for x, y in zip(p, q))
    assert json.loads(run("stats", there, "--json", "-").stdout)["triangles"] == len(triangles)
    return there


run("make-mesh", "--triangles", 2000, "-o", scratch / "torus.obj")
run("simplify", scratch / "torus.obj", "--base", 0.05, "-o", scratch / "torus.pm")
made = check(scratch / "torus.pm", "torus").read_bytes()
meshes = os.environ.get("RESTRIP_MESHES")
if meshes:
    run("convert", pathlib.Path(meshes) / "om_bunny.pm", "-o", scratch / "bunny.pm")  # vertices in order of appearance
    check(scratch / "bunny.pm", "bunny")
else:
    print("left out: the bunny, for which RESTRIP_MESHES must name its folder")

# Directly from a mesh, and from a baked one.
run("simplify", scratch / "torus.obj", "--base", 0.05, "-o", scratch / "straight.glb", "--gltf", "progressive")
assert refined((scratch / "straight.glb").read_bytes())[1] == refined(made)[1]
run("bake", scratch / "torus.pm", "-o", scratch / "torus.baked")
run("convert", scratch / "torus.baked", "-o", scratch / "baked.glb", "--gltf", "progressive")
assert refined((scratch / "baked.glb").read_bytes())[1] == refined(made)[1]

(scratch / "square.obj").write_text("".join(f"v {i} {j} 0\n" for i in range(4) for j in range(4))
                                    + "".join(f"f {a} {a + 4} {a + 5}\nf {a} {a + 5} {a + 1}\n" for a in (1, 2, 3, 5, 6, 7, 9, 10, 11)))
run("simplify", scratch / "square.obj", "--base", 0.2, "-o", scratch / "square.pm")
for arguments, words in (((scratch / "square.pm",), "is at a boundary, for which MANYFOLD_mesh_progressive has no record"),
                         ((scratch / "torus.obj",), "has no levels; restrip simplify makes some")):
    said = run("convert", *arguments, "-o", scratch / "never.glb", "--gltf", "progressive", code=2).stderr
    assert words in said and arguments[0].name in said and not (scratch / "never.glb").exists(), said
# A split of an unused vertex, found by fuzzing.
corners = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))
(scratch / "unused.pm").write_bytes(b"ProgMesh" + struct.pack("<3I15f", 5, 4, 1, *[0.0] * 3, 1, 0, 0, 0, 1, 0, 0, 0, 1, 9, 9, 9)
                                    + b"".join(struct.pack("<3I", *c) for c in corners) + struct.pack("<3f3i", 1, 1, 1, 4, 1, 0))
for out in ("never.glb", "never.pm"):
    said = run("convert", scratch / "unused.pm", "-o", scratch / out, *(("--gltf", "progressive") if out.endswith("glb") else ()),
               code=2).stderr
    assert "unused.pm: split 0 (4 -> 5) is not possible" in said and not (scratch / out).exists(), said
said = run("convert", scratch / "torus.obj", "-o", scratch / "never.pm", code=2).stderr
assert "has no levels; restrip simplify makes some" in said, said


def extension(doc):
    return doc["meshes"][0]["primitives"][0]["extensions"][NAME]


def refused(edit, words):
    (scratch / "bad.glb").write_bytes(edited_glb(made, edit))
    said = run("stats", scratch / "bad.glb", code=2).stderr
    assert "bad.glb" in said and words in said, (words, said)


def second(doc, _):
    doc["meshes"].append(doc["meshes"][0])


def bad_record(doc, binary):
    struct.pack_into("<H", binary, doc["bufferViews"][2]["byteOffset"], 60000)


refused(lambda doc, _: extension(doc)["attributes"].update(TEXCOORD_0=3), "TEXCOORD_0: is not read")
refused(lambda doc, _: extension(doc)["attributes"].clear(), 'expected a member "POSITION"')
refused(lambda doc, _: extension(doc).pop("indices"), 'expected a member "indices"')
refused(lambda doc, _: doc["accessors"][2].update(count=3), "records and")
refused(lambda doc, _: doc["accessors"][2].update(type="SCALAR"), "is not VEC3, as three indices are")
refused(lambda doc, _: doc["nodes"][0].update(scale=[2, 2, 2]), "belongs to a mesh that nodes move")
refused(second, "is the second one")
refused(bad_record, "split 0 refers to vertices 60000")
refused(lambda doc, binary: struct.pack_into("<H", binary, doc["bufferViews"][2]["byteOffset"] + 2, 0), "split 0")
# Its author's program puts the extension in the mesh.
moved = edited_glb(made, lambda doc, _: doc["meshes"][0].update(extensions=doc["meshes"][0]["primitives"][0].pop("extensions")))
(scratch / "moved.glb").write_bytes(moved)
run("convert", scratch / "moved.glb", "-o", scratch / "moved.pm")
assert (scratch / "moved.pm").read_bytes() == (scratch / "torus_back.pm").read_bytes()
print("progressive glTF: all hold")
