#!/usr/bin/env python3
"""Claims: a glTF file arrives triangle by triangle, whatever its encoding: text and binary, buffers inside and outside,
lists, strips and fans, indices of every width and none, strides, sparse accessors, primitive restart, nodes that move, turn
and mirror; and a damaged one is refused with a sentence that names it. The files are made here, by the specification.

    gltf_files_test.py restrip SCRATCH
"""
import itertools
import json
import pathlib
import struct
import sys

from gltf_maker import FLOAT, File
from program import Program
from strip_readers import obj, rotated

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])


def read(name, data):
    (scratch / name).write_bytes(data)
    run("convert", scratch / name, "-o", scratch / "out.obj")
    return obj(scratch / "out.obj")


def expect(file, points, triangles, name):
    wanted = [tuple(map(float, p)) for p in points], sorted(rotated(list(t)) for t in triangles)
    for number, data in enumerate((file.glb(), file.gltf(), file.gltf("the%20buffer.bin"))):
        (scratch / "the buffer.bin").write_bytes(file.binary + b"more")
        assert read("in.glb" if number == 0 else "in.gltf", data) == wanted, (name, number)


scratch.mkdir(parents=True, exist_ok=True)
P = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0.5), (0, 2, 0), (1, 2, -0.25)]
STRIP = [(0, 1, 2), (2, 1, 3), (2, 3, 4), (4, 3, 5)]  # what a strip of 0 to 5 draws
FAN = [(0, i, i + 1) for i in range(1, 5)]

# Modes by encodings of indices by strides.
for (mode, drawn), width, stride in itertools.product(
        ((None, [(0, 1, 2), (3, 4, 5)]), (4, [(0, 1, 2), (3, 4, 5)]), (5, STRIP), (6, FAN)),
        (None, 5121, 5123, 5125), (None, 16)):
    file = File()
    positions = file.positions(P, stride=stride, before=stride or 0)
    order = [5, 4, 3, 2, 1, 0] if width else [0, 1, 2, 3, 4, 5]
    indices = file.indices(order, width) if width else None
    file.primitive(positions, indices, mode)
    expect(file, P, [tuple(order[c] for c in t) for t in drawn], (mode, width, stride))

# Primitive restart, of each width and mode, and swaps.
for width, restart in ((5121, 0xFF), (5123, 0xFFFF), (5125, 0xFFFFFFFF)):
    for mode, indices, drawn in ((5, [0, 1, 2, 3, restart, 2, 3, 4], STRIP[:2] + [(2, 3, 4)]),
                                 (5, [0, 1, 2, 1, 3, restart, restart], STRIP[:2]),
                                 (6, [0, 1, 2, 3, restart, 3, 4, 5], FAN[:2] + [(3, 4, 5)])):
        file = File(["KHR_mesh_primitive_restart"])
        file.primitive(file.positions(P), file.indices(indices, width), mode)
        expect(file, P, drawn, (width, mode, indices))

# In a list the largest value is an index like any other.
for count, width in ((256, 5121), (65536, 5123)):
    file = File()
    many = [(i % 1000, i // 1000, 0) for i in range(count)]
    file.primitive(file.positions(many), file.indices([0, 1, count - 1, 2, count - 1, 1000 % count], width))
    expect(file, many, [(0, 1, count - 1), (2, count - 1, 1000 % count)], count)

# Sparse accessors: with a buffer view below, and without (zeros).
file = File()
positions = file.positions(P)
indices = file.indices([0, 1, 2])
file.doc["accessors"][positions]["sparse"] = {
    "count": 2, "indices": {"bufferView": file.view(struct.pack("<2H", 1, 4)), "componentType": 5123},
    "values": {"bufferView": file.view(struct.pack("<6f", 7, 8, 9, 1, 2, 3))}}
file.doc["accessors"][indices]["sparse"] = {
    "count": 1, "indices": {"bufferView": file.view(b"\2"), "componentType": 5121},
    "values": {"bufferView": file.view(struct.pack("<H", 5))}}
file.primitive(positions, indices)
expect(file, [P[0], (7, 8, 9), P[2], P[3], (1, 2, 3), P[5]], [(0, 1, 5)], "sparse")
file = File()
file.doc["accessors"].append({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {
    "count": 2, "indices": {"bufferView": file.view(struct.pack("<2I", 1, 2)), "componentType": 5125},
    "values": {"bufferView": file.view(struct.pack("<6f", 1, 0, 0, 0, 1, 0))}}})
file.primitive(0)
expect(file, P[:3], [(0, 1, 2)], "sparse alone")

# Quantized positions.
file = File(["KHR_mesh_quantization"])
file.primitive(file.accessor([(-128, 127, 0), (127, 0, 0), (0, 0, 127)], "VEC3", 5120, stride=4, normalized=True))
expect(file, [(-1, 1, 0), (1, 0, 0), (0, 0, 1)], [(0, 1, 2)], "normalized bytes")
file = File(["KHR_mesh_quantization"])
file.primitive(file.accessor([(-300, 0, 1), (9, 0, 0), (0, 9, 0)], "VEC3", 5122, stride=8))
expect(file, [(-300, 0, 1), (9, 0, 0), (0, 9, 0)], [(0, 1, 2)], "shorts")

# Several primitives: one accessor is one set of vertices, another accessor another one. Points and lines are left out.
file = File()
shared, other = file.positions(P), file.positions(P[:3])
file.primitive(shared, file.indices([0, 1, 2]))
file.primitive(other)
file.primitive(shared, file.indices([0, 1]), 1)
file.primitive(shared, file.indices([2, 3, 4, 5]), 5)
expect(file, P + P[:3], [(0, 1, 2), (6, 7, 8), (2, 3, 4), (4, 3, 5)], "primitives")

# Nodes: a tree of moves, a quaternion, a matrix; a mirror turns triangles over; the scene says which are drawn.
file = File()
file.primitive(file.positions(P), None, 5)
file.doc |= {"scene": 1, "scenes": [{"nodes": [3]}, {"nodes": [0, 2]}], "nodes": [
    {"translation": [10, 0, 0], "scale": [2, 1, 1], "children": [1]}, {"mesh": 0, "rotation": [0, 0, 1, 0]},
    {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1]}, {"mesh": 0}]}
expect(file, [(10 - 2 * x, -y, z) for x, y, z in P] + [(-x, y, z + 5) for x, y, z in P],
       STRIP + [(c + 6, b + 6, a + 6) for a, b, c in STRIP], "nodes")
strips = json.loads(run("stripify", scratch / "in.gltf", "--effort", "file", "--json", "-").stdout)
assert (strips["strips"], strips["cut_strips"], strips["valid"]) == (2, 0, True), strips
del file.doc["scenes"], file.doc["scene"], file.doc["nodes"][3]
expect(file, [(10 - 2 * x, -y, z) for x, y, z in P] + [(-x, y, z + 5) for x, y, z in P],
       STRIP + [(c + 6, b + 6, a + 6) for a, b, c in STRIP], "roots without scenes")


# A skin decides where its mesh is, not its node; the nodes below move as ever.
file = File()
file.primitive(file.positions(P), None, 5)
file.doc |= {"scenes": [{"nodes": [0]}], "skins": [{"joints": [1]}], "nodes": [
    {"mesh": 0, "skin": 0, "translation": [10, 0, 0], "children": [1]}, {"mesh": 0, "scale": [-1, 1, 1]}]}
expect(file, P + [(10 - x, y, z) for x, y, z in P], STRIP + [(c + 6, b + 6, a + 6) for a, b, c in STRIP], "skin")
# Programs multiply matrices in single precision.
file.doc |= {"scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "matrix": [1, 0, 0, 1e-7, 0, 1, 0, -1e-7, 0, 0, 1, 0, 3, 0, 0, 0.9999999]}]}
expect(file, [(x + 3, y, z) for x, y, z in P], STRIP, "matrix")
# Buffers in folders below, and names with percent signs.
(scratch / "below" / "further").mkdir(parents=True, exist_ok=True)
file = File(["KHR_texture_basisu", "KHR_xmp_json_ld", "EXT_structural_metadata", "KHR_animation_pointer", "MSFT_texture_dds", "VRMC_vrm"])
file.primitive(file.positions(P), None, 5)
for uri, place in (("./a.bin", "a.bin"), ("below/a.bin", "below/a.bin"), ("./below/./further/a%20b.bin", "below/further/a b.bin"),
                   ("10%.bin", "10%.bin"), ("10%zz.bin", "10%zz.bin"), ("%41%2fa.bin".replace("%41", "below"), "below/a.bin"),
                   ("..a..bin", "..a..bin"), ("100%25.bin", "100%.bin")):
    (scratch / place).write_bytes(file.binary)
    assert len(read("in.gltf", file.gltf(uri))[1]) == 4, uri
    (scratch / place).unlink()


# ---- damaged files
def whole():
    made = File()
    made.primitive(made.positions(P), made.indices([0, 1, 2, 3, 4, 5]), 5)
    made.doc["nodes"] = [{"mesh": 0}]
    made.doc["scenes"] = [{"nodes": [0]}]
    return made


def sparse(made, places, count=None):
    made.doc["accessors"][0]["sparse"] = {
        "count": len(places) if count is None else count,
        "indices": {"bufferView": made.view(bytes(places)), "componentType": 5121},
        "values": {"bufferView": made.view(bytes(12 * len(places)))}}


def set_at(*path_and_value):
    def edit(made):
        *path, last, value = path_and_value
        place = made.doc
        for step in path:
            place = place[step]
        place[last] = value
    return edit


PRIMITIVE = ("meshes", 0, "primitives", 0)
DAMAGED = (
    (set_at("asset", "version", "1.0"), "asset.version: is '1.0'"),
    (set_at("asset", {}), 'expected a member "version"'),
    (set_at("extensionsRequired", ["KHR_draco_mesh_compression"]), "extensionsRequired[0]: is KHR_draco"),
    (set_at(*PRIMITIVE, "mode", "5"), 'meshes[0].primitives[0].mode: expected a number, found "5"'),
    (set_at(*PRIMITIVE, "mode", 7), "mode: is 7"),
    (set_at(*PRIMITIVE, "indices", 9), "accessors: has no element 9"),
    (set_at(*PRIMITIVE, "indices", -1), "indices: expected a whole number"),
    (set_at(*PRIMITIVE, "indices", 0), "accessors[0].type: is not SCALAR"),
    (set_at(*PRIMITIVE, "attributes", {}), "no vertices (left out: primitives without positions)"),
    (set_at(*PRIMITIVE, "mode", 1), "no vertices (left out: lines)"),
    (set_at(*PRIMITIVE, "attributes", "POSITION", 1), "accessors[1].type: is not VEC3"),
    (set_at("accessors", 0, "count", 7), "accessors[0]: has 7 elements, which reach beyond"),
    (set_at("accessors", 0, "count", 1 << 52), "accessors[0].count: is too large"),
    (set_at("accessors", 0, "count", 5), "indices: have 5, and there are 5 positions"),
    (set_at("accessors", 1, "byteOffset", 2), "which reach beyond"),
    (set_at("accessors", 1, "componentType", 5126), "is not a type of an index"),
    (set_at("accessors", 0, "componentType", 5125), "is not a type of positions"),
    (set_at("accessors", 0, "normalized", 1), "normalized: expected true or false, found 1"),
    (set_at("bufferViews", 0, "byteStride", 4), "byteStride: is 4, not 12 to 252"),
    (set_at("bufferViews", 1, "byteLength", 1000), "bufferViews[1]: reaches beyond its buffer"),
    (set_at("bufferViews", 1, "buffer", 1), "buffers: has no element 1"),
    (set_at("buffers", 0, "byteLength", 1000), "buffers[0]: has "),
    (set_at("nodes", 0, "mesh", 3), "meshes: has no element 3"),
    (set_at("nodes", 0, "children", [0]), "nodes[0]: is in the scene twice"),
    (set_at("nodes", 0, "scale", [1, 1]), "nodes[0].scale: has 2 numbers, not 3"),
    (set_at("nodes", 0, "matrix", [1] * 16), "matrix: has a last row"),
    (set_at("nodes", 0, "translation", [1e39, 0, 0]), "vertex 0 has a coordinate that is infinite"),
    (set_at("scenes", 0, "nodes", 0), "scenes[0].nodes: expected a list, found 0"),
    (set_at("scene", 1), "scenes: has no element 1"),
    (set_at("meshes", [{"primitives": []}]), "no vertices"),
    (lambda made: made.doc.update(extras=json.loads("[" * 80 + "]" * 80)), "expected lists and objects at most 64 deep"),
    (lambda made: sparse(made, [3, 3]), "they must increase"),
    (lambda made: sparse(made, [6]), "be below 6"),
    (lambda made: sparse(made, [1], 7), "sparse.count: is 7"),
    (lambda made: sparse(made, [1], 2), "which reach beyond"),
    (lambda made: made.doc["accessors"][0].update(count=10 ** 9) or made.doc["accessors"][0].pop("bufferView"),
     "can mean"),
    (lambda made: (made.doc["meshes"][0]["primitives"][0].update(mode=4),
                   made.doc["accessors"][1].update(count=5)), "are 5, which is not a multiple of three"),
)


def refused(name, data, words):
    (scratch / name).write_bytes(data)
    message = run("stats", scratch / name, code=2).stderr
    assert name in message and words in message, (words, message)


for edit, words in DAMAGED:
    made = whole()
    edit(made)
    refused("bad.glb", made.glb(), words)
    if "byteLength" not in words:
        refused("bad.gltf", made.gltf(), words)


# Small files that draw much: values without bytes, one mesh in many nodes, and many members, each looked up.
def many_zeros():
    made = File()
    made.doc["accessors"] = [{"componentType": FLOAT, "count": 60_000, "type": "VEC3"}] * 300
    for i in range(300):
        made.primitive(i)
    made.doc["extras"] = " " * 60_000
    return made.glb()


def many_nodes():
    made = File()
    made.primitive(made.positions([(0, 0, 0), (1, 0, 0), (0, 1, 0)]), made.indices([0, 1, 2] * 1000))
    made.doc |= {"nodes": [{"mesh": 0}] * 4000, "scenes": [{"nodes": list(range(4000))}]}
    return made.glb()


def many_primitives():
    made = File()
    made.primitive(made.positions([]), made.indices([]))
    made.doc["meshes"][0]["primitives"] *= 1000
    made.doc |= {"nodes": [{"mesh": 0}] * 1000, "scenes": [{"nodes": list(range(1000))}]}
    return made.glb()


for made in (many_zeros(), many_nodes(), many_primitives()):
    refused("bomb.glb", made, "draws more than 8388608 vertices and indices, the limit for a file of its size")
made = whole()
made.doc["meshes"][0]["primitives"][0]["attributes"] |= {f"_{i}": 0 for i in range(300)}
refused("bomb.glb", made.glb(), "more than 256, the limit")
for uri in ("../outside.bin", "/etc/passwd", "https://host/a.bin", "%2e%2e%2fa.bin", "a/../../b.bin", "a/..", "a//b.bin", "a/", "", "C:/a.bin",
            "..\\a.bin", "a%00.bin"):
    refused("bad.gltf", whole().gltf(uri) if uri else whole().gltf("EMPTY").replace(b"EMPTY", b""), "only a file in the same folder or below")
for uri, words in (("data:,abc", "is not base64"), ("data:;base64,ab!=", "is not base64"), ("data:;base64,abc", "is not base64")):
    refused("bad.gltf", whole().gltf(uri), words)
(scratch / "lost.gltf").write_bytes(whole().gltf("none.bin"))
lost = run("stats", scratch / "lost.gltf", code=2)
assert "none.bin: no such file" in lost.stderr, lost.stderr
(scratch / "short.bin").write_bytes(b"1234")
refused("bad.gltf", whole().gltf("short.bin"), "buffers[0]: has 4 bytes of the 84")
no_buffer = whole()
no_buffer.doc["buffers"][0].pop("uri", None)
refused("bad.gltf", json.dumps(no_buffer.doc).encode(), "has neither")
good = whole().glb()
for size in [*range(1, len(good), 31), *range(len(good) - 4, len(good))]:
    refused("cut.glb", good[:size], "cut.glb")
refused("version.glb", good[:4] + b"\1\0\0\0" + good[8:], "a GLB of version 1")
refused("chunk.glb", good[:12] + b"\xFF\xFF\xFF\x7F" + good[16:], "more than are left")
refused("kind.glb", good[:16] + b"BIN\0" + good[20:], "its first chunk is not JSON")
print("glTF files: all hold")
