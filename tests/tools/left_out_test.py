#!/usr/bin/env python3
"""Claims: what a mesh file holds and restrip does not read is reported, in text and JSON, or the file is refused: exactly as the
table "What is not read" of docs/reference/file-formats.md says. Each entry of the table has a file here that shows it, and each
file here an entry. In the table capitals stand for a word or number of the file.

    left_out_test.py restrip SCRATCH PAGE
"""
import json
import pathlib
import re
import struct
import sys

from gltf_maker import FLOAT, UBYTE, File
from program import Program

run, scratch, page = Program(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).read_text(encoding="utf-8")
scratch.mkdir(parents=True, exist_ok=True)
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
STL = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
BINARY_STL = b" " * 80 + struct.pack("<I12fH", 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
P = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]


def off(header="OFF", vertex="", face="", end=""):
    return f"{header}\n3 1 0\n" + "".join(f"{p} {vertex}\n" for p in ("0 0 0", "1 0 0", "0 1 0")) + f"3 0 1 2 {face}\n{end}"


def ply(vertex="", face="", more="", end="", encoding="ascii"):
    """`vertex` and `face`: further properties and their values."""
    properties = [" ".join(words.split()[:-1]) for words in vertex.split(";") if words]
    values = " ".join(words.split()[-1] for words in vertex.split(";") if words)
    of_face = [" ".join(words.split()[:-1]) for words in face.split(";") if words]
    head = (f"ply\nformat {encoding} 1.0\nelement vertex 3\n" + "".join(f"property {a}\n" for a in ("float x", "float y", "float z", *properties)) +
            "element face 1\nproperty list uchar int vertex_index\n" + "".join(f"property {a}\n" for a in of_face) + more + "end_header\n")
    if encoding != "ascii":
        return head.encode() + bytes(36) + bytes([3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]) + end
    return head + "".join(f"{p} {values}\n" for p in ("0 0 0", "1 0 0", "0 1 0")) + "3 0 1 2 " + " ".join(
        words.split()[-1] for words in face.split(";") if words) + "\n" + end


def gltf(edit=lambda doc, file: None, **attributes):
    """One triangle; the values of attributes are lists of tuples."""
    file = File()
    positions, indices = file.positions(P), file.indices([0, 1, 2])
    numbers = {name: file.accessor(values, {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}[len(values[0])],
                                   UBYTE if name.startswith("JOINTS") else FLOAT, stride=4 if name.startswith("JOINTS") else None)
               for name, values in attributes.items()}
    file.primitive(positions, indices, **numbers)
    file.doc["nodes"], file.doc["scenes"] = [{"mesh": 0}], [{"nodes": [0]}]
    edit(file.doc, file)
    return file.glb()


def first(doc):
    return doc["meshes"][0]["primitives"][0]


UP, UV, RED = [(0, 0, 1)] * 3, [(0, 0), (1, 0), (0, 1)], [(1, 0, 0)] * 3
extension = {"extensionsUsed": ["EXT_mesh_gpu_instancing"]}
# By format and entry: the files that show it. All are converted to a .glb, which holds every attribute.
LEFT_OUT = {
    "all": {
        "texture coordinates": [(".obj", OBJ + "vt 0 0\nf 1/1 2/1 3/0\n"), (".obj", OBJ + "vt 0 0\n"), (".off", off("STOFF", "0 0")),
                                (".ply", ply("int s 0;int t 0")), (".glb", gltf(TEXCOORD_0=[(0, float("nan"))] * 3))],
        "normals": [(".obj", OBJ + "vn 0 0 1\nf 1//1 2//1 3//1\n"), (".obj", OBJ + "vn 0 nan 1\n"), (".off", off("NOFF", "0 0 1")),
                    (".ply", ply("float nx 0;float ny 0")), (".ply", ply("float nx 0;float ny 0;float nz nan")),
                    (".glb", gltf(lambda doc, _: doc["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}}), NORMAL=UP))],
        "colours": [(".obj", OBJ + "v 0 0 0 1 1 1\n"), (".off", off(vertex="255 0 0 255")), (".ply", ply("int red 1;int green 1;int blue 1")),
                    (".stl", BINARY_STL[:-2] + b"\1\1"),
                    (".glb", gltf(lambda doc, _: doc["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0}}), COLOR_0=RED))]},
    ".obj": {
        "lines": OBJ + "l 1 2\n", "points": OBJ + "p 1\n", "materials": [OBJ + "usemtl a\n", "mtllib a.mtl\n" + OBJ],
        "groups": [OBJ + "g a\ng b\n", OBJ + "o a\no b\n"], "smoothing groups": OBJ + "s 1\n",
        "curves and surfaces": [OBJ + "curv 0 1 1 2\n", OBJ + "vp 1 2\n", OBJ + "surf 0 1 0 1 1\n"],
        "display attributes": OBJ + "bevel on\n", "lines `WORD`": [OBJ + "wobble 1\n", OBJ + "n 0 0 1\n"],
        "other numbers of vertices": ["v 9 9 9 0.5\n" + OBJ.replace("f 1 2 3", "f 2 3 4"), "v 9 9 9 1 1\n" + OBJ],
        "third texture coordinates": OBJ + "vt 0 0 0.5\nf 1/1 2/1 3/1\n"},
    ".off": {
        "colours of faces": off(face="1 0 0"), "text after the last face": off(end="3 2 1 0\n")},
    ".ply": {
        "elements `WORD`": ply(more="element edge 1\nproperty int vertex1\n", end="0\n"),
        "property `WORD` of `WORD`": [ply("float quality 1"), ply(face="int flags 3"), ply("int near 1;uchar far 2")],
        "colours of `WORD`": [ply(face="uchar red 1;uchar green 1;uchar blue 1"), ply("uchar blue 1")],
        "normals of `WORD`": ply(face="float nx 0;float ny 0;float nz 1"),
        "texture coordinates of `WORD`": ply(face="float u 1;float v 1"),
        "text after the last element": ply(end="1 2 3\n"),
        "N bytes after the last element": ply(encoding="binary_little_endian", end=b"12345")},
    ".stl": {
        "N bytes after the facets": BINARY_STL + b"more",
        "`WORD`": STL.replace("endloop", "color 1 0 0 endloop")},
    ".gltf, .glb": {
        "points": gltf(lambda doc, _: doc["meshes"][0]["primitives"].append(first(doc) | {"mode": 0})),
        "lines": [gltf(lambda doc, _, mode=mode: doc["meshes"][0]["primitives"].append(first(doc) | {"mode": mode})) for mode in (1, 2, 3)],
        "primitives without positions": gltf(lambda doc, _: doc["meshes"][0]["primitives"].append({"attributes": {"NORMAL": 0}})),
        "morph targets": gltf(lambda doc, _: first(doc).update(targets=[{"POSITION": 0}])),
        "skins": gltf(lambda doc, _: doc["nodes"][0].update(skin=0)),
        "skin weights": gltf(JOINTS_0=[(0, 0, 0, 0)] * 3, WEIGHTS_0=[(1, 0, 0, 0)] * 3),
        "instances (WORD)": [gltf(lambda doc, _: doc.update(extension)),
                             gltf(lambda doc, _: doc["nodes"][0].update(extensions={"EXT_mesh_gpu_instancing": {}}))],
        "materials": gltf(lambda doc, _: (first(doc).update(material=0), doc.update(materials=[{}]))),
        "animations": gltf(lambda doc, _: doc.update(animations=[{}])), "cameras": gltf(lambda doc, _: doc["nodes"][0].update(camera=0)),
        "meshes outside the scene": gltf(lambda doc, _: doc["nodes"].append({"mesh": 0})),
        "extension WORD": [gltf(lambda doc, _: doc.update(extensionsUsed=["KHR_lights_punctual"])),
                           gltf(lambda doc, _: first(doc).update(extensions={"KHR_materials_variants": {}}))],
        "lengths of rotations other than 1": [gltf(lambda doc, _: doc["nodes"][0].update(rotation=[0, 0, 0, w])) for w in (2, -0.5)],
        "tangents": gltf(lambda doc, _: doc["meshes"][0]["primitives"].append({"attributes": {"POSITION": 0, "NORMAL": 2}}),
                         NORMAL=UP, TANGENT=[(1, 0, 0, 1)] * 3),
        "WORD": gltf(**{"temperature": [(20,)] * 3})},
    "written as .glb": {
        "normals (of length 0)": ["v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n", gltf(NORMAL=[(0, 0, 1), (0, 0, 0), (0, 0, 1)])],
        "tangents (without normals)": gltf(TANGENT=[(1, 0, 0, 1)] * 3),
        "colours (outside 0 to 1)": [OBJ.replace("0\nv", "0 255 255 255\nv").replace("1 0\nf", "1 0 0 0 0\nf"), gltf(COLOR_0=[(0, 0, 1.5)] * 3),
                                     ply("float red 255;float green 0;float blue 0"), gltf(COLOR_0=[(0, 0, -0.5, 1)] * 3)],
        "texture coordinates (without the set before)": gltf(TEXCOORD_1=UV)}}

matrix = [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
# By format and entry: files, and words of the message.
REFUSED = {
    "all": {
        "an infinite coordinate or NaN in a triangle": [(".obj", OBJ.replace("1 0 0", "1 nan 0")), (".ply", ply().replace("1 0 0", "1 inf 0")),
                                                                        (".off", off().replace("1 0 0", "1e300 0 0")), (".stl", STL.replace("1 0 0", "nan 0 0"))],
        "a missing vertex": [(".obj", OBJ + "f 1 2 4\n"), (".obj", OBJ + "f 0 1 2\n"), (".off", off().replace("3 0 1 2", "3 0 1 3")),
                                         (".ply", ply().replace("3 0 1 2", "3 0 1 9")), (".glb", gltf(lambda doc, _: doc["accessors"][0].update(count=2)))],
        "no triangles": [(".obj", OBJ.replace("f 1 2 3", "l 1 2")), (".glb", gltf(lambda doc, _: first(doc).update(mode=1)))],
        "a file that ends too early": [(".ply", ply()[:-9]), (".off", off().replace("3 1 0", "3 2 0")), (".stl", STL[:STL.index("endloop") - 20]), (".glb", gltf()[:-4])]},
    ".off": {"binary OFF": "OFF BINARY\n", "points not of three dimensions": off("nOFF 4"), "a fourth coordinate other than 1": off("4OFF", "2")},
    ".ply": {"whole numbers as colours outside their range": ply("uchar red 256;uchar green 0;uchar blue 0")},
    ".stl": {"a facet without three vertices": STL.replace("vertex 0 1 0\n", "vertex 0 1 0\nvertex 1 1 0\n")},
    ".gltf, .glb": {
        "a version other than 2": gltf(lambda doc, _: doc["asset"].update(version="1.0")),
        "a required extension that may change the triangles": [gltf(lambda doc, _, name=name: doc.update(extensionsRequired=[name])) for name in (
            "KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing", "KHR_node_visibility")],
        "a buffer outside the folder of the file": gltf(lambda doc, _: doc["buffers"][0].update(uri="../a.bin")),
        "a last row of a matrix other than 0 0 0 1": gltf(lambda doc, _: doc["nodes"][0].update(matrix=matrix)),
        "a node that occurs twice": gltf(lambda doc, _: doc["nodes"][0].update(children=[0])),
        "an attribute of a wrong kind": gltf(NORMAL=UV)}}

# Nothing is reported of files that have nothing else. Each format of faces has one.
PLAIN = ((".obj", OBJ), (".off", off()), (".ply", ply()), (".stl", STL), (".stl", BINARY_STL), (".glb", gltf(NORMAL=UP, TEXCOORD_0=UV, COLOR_0=RED)))


def write(end, data):
    path = scratch / f"sample{end}"
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    return path


def ending(data):
    if isinstance(data, bytes):
        return ".glb" if data.startswith(b"glTF") else ".ply" if data.startswith(b"ply") else ".stl"
    return ".ply" if data.startswith("ply") else ".obj"


def samples(all_of):
    return all_of if isinstance(all_of, list) else [all_of]


# The table.
(text,) = re.findall(r"## What is not read\n(.*?)\n## ", page, re.S)
rows = [[cell.strip() for cell in line.strip("|").split(" | ")] for line in text.splitlines() if line.startswith("| ")][2:]
table = {name.replace("`", ""): [[entry for entry in cell.split("; ") if entry != "–"] for cell in cells] for name, *cells in rows}
# Every format that is read has a row, or is in the sentence below the table.
read_at_all = re.findall(r"^\| ((?:`\.[a-z]+`(?:, )?)+) \| (?!–)", page, re.M)
extensions = re.findall(r"`(\.[a-z]+)`", " ".join(read_at_all))
assert {".obj", ".glb", ".pm"} <= set(extensions)
for extension in extensions:
    assert any(extension in name.split(", ") for name in table) or f"`{extension}`" in text.splitlines()[-2] + text.splitlines()[-3], extension
assert {end for end, _ in PLAIN} == set(extensions) - {".gltf", ".pm", ".baked"}, extensions
for column, known in enumerate((LEFT_OUT, REFUSED)):
    for name in table.keys() | known.keys():
        listed, shown = table.get(name, [[], []])[column], known.get(name, {})
        assert sorted(listed) == sorted(shown), (name, set(listed) ^ set(shown))

for name, entries in LEFT_OUT.items():
    for entry, files in entries.items():
        pattern = re.sub(r"\b(WORD|N)\b", r"[^ ,`]+", re.escape(entry).replace(r"\ ", " "))
        for sample in samples(files):
            end, data = sample if isinstance(sample, tuple) else (
                {".gltf, .glb": ".glb", "written as .glb": ending(sample)}.get(name, name), sample)
            path = write(end, data)
            printed = run("convert", path, "-o", scratch / "out.glb").stdout
            (line,) = [line for line in printed.splitlines() if line.startswith("left out: ")] or [""]
            assert re.search(f"(: |, ){pattern}( \\(|,|$)", line), (name, entry, printed)
            report = json.loads(run("convert", path, "-o", scratch / "out.glb", "--json", "-").stdout)
            assert report["left_out_content"], report
            if name != "written as .glb":  # every command says so
                for command in (("stats", path), ("stripify", path)):
                    assert "left out: " in run(*command).stdout, (command, entry)
for name, entries in REFUSED.items():
    for entry, files in entries.items():
        for sample in samples(files):
            end, data = sample if isinstance(sample, tuple) else (".glb" if name == ".gltf, .glb" else name, sample)
            message = run("convert", write(end, data), "-o", scratch / "out.obj", code=2).stderr
            assert f"sample{end}" in message and len(message.splitlines()) == 1, (entry, message)
for end, data in PLAIN:
    assert "left out" not in run("convert", write(end, data), "-o", scratch / "out.glb").stdout, data
print("what readers leave out: all hold")
