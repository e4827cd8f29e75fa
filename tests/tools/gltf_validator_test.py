#!/usr/bin/env python3
"""Claims: the Khronos validator finds neither error nor warning in the glTF files that `restrip stripify`, `simplify`,
`convert` and `bake` write, whatever primitives they have by default. Of primitive restart it knows nothing (version 2.0.0-dev.3.10): there it reports each restart value as two errors,
and nothing else; with the restarts taken out it reports nothing. Files damaged on purpose are refused. The validator is that
of npm, of the version and the checksum in gltf-validator/package-lock.json.

    gltf_validator_test.py restrip SCRATCH NODE NPM [--may-be-missing]
"""
import collections
import json
import math
import pathlib
import re
import shutil
import struct
import subprocess
import sys

from gltf_maker import BYTE, FLOAT, LETTER, SHORT, UBYTE, USHORT, cube, edited_glb, File, save, sphere
from program import Program
from strip_readers import RESTART, glb

run, scratch, node, npm = Program(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4]
may_be_missing = "--may-be-missing" in sys.argv[5:]
here = pathlib.Path(__file__).parent / "gltf-validator"
VERSION = json.loads((here / "package.json").read_text())["dependencies"]["gltf-validator"]
LEFT_OUT = 77  # expected by CTest


def install():
    """Once for each build folder."""
    folder = scratch / "npm"
    package = folder / "node_modules/gltf-validator/package.json"
    if package.exists() and json.loads(package.read_text())["version"] == VERSION:
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copyfile(here / name, folder / name)
    try:
        done = subprocess.run([npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund", "--prefer-offline"], cwd=folder,
                              capture_output=True, text=True, check=False, timeout=400)
        said = done.stdout + done.stderr
    except subprocess.TimeoutExpired:
        said = "npm did not answer"
    if package.exists() and json.loads(package.read_text())["version"] == VERSION:
        return folder
    print(said)
    asked = subprocess.run([npm, "view", f"gltf-validator@{VERSION}", "version"], cwd=folder, capture_output=True, text=True,
                           check=False, timeout=400)
    if asked.returncode == 0 and not may_be_missing:
        print(f"npm's registry has gltf-validator {VERSION}, but it could not be installed. Without it: configure with "
              "-DRESTRIP_ALLOW_MISSING=ON, and glTF files are not validated")
        sys.exit(1)
    print("left out: tools.gltf_validator, for which npm must reach its registry once")  # scripts/test.sh repeats it
    sys.exit(LEFT_OUT)


def validated(paths):
    done = subprocess.run([node, here / "validate.mjs", folder, *paths], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    reports = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(reports) == len(paths)
    for report in reports:
        assert report["version"] == VERSION and not report["truncated"]
    return reports


def edited(path, name, edit):
    """The GLB after edit(doc, binary)."""
    (scratch / name).write_bytes(edited_glb(path.read_bytes(), edit))
    return scratch / name


def indices_in(doc):
    """The first accessor of indices, where its values begin, and how they are packed."""
    accessor = doc["accessors"][doc["meshes"][0]["primitives"][0]["indices"]]
    view = doc["bufferViews"][accessor["bufferView"]]
    return (accessor, view.get("byteOffset", 0) + accessor.get("byteOffset", 0),
            "<H" if accessor["componentType"] == 5123 else "<I")


def without_restarts(doc, binary):
    """Each restart becomes the index before it: more triangles without an area, and no extension."""
    accessor, begin, letter = indices_in(doc)
    width = struct.calcsize(letter)
    for i in range(1, accessor["count"]):
        if struct.unpack_from(letter, binary, begin + i * width)[0] == RESTART[width]:
            struct.pack_into(letter, binary, begin + i * width,
                             struct.unpack_from(letter, binary, begin + (i - 1) * width)[0])
    del doc["extensionsUsed"], doc["extensionsRequired"]


scratch.mkdir(parents=True, exist_ok=True)
folder = install()
plain, with_restarts = [], []
for name, triangles in (("small", 600), ("large", 140_000)):  # indices of 16 and of 32 bits
    source = scratch / f"{name}.obj"
    run("make-mesh", "-o", source, "--triangles", triangles)
    for mode in ("restart", "strips", "list", "stitched"):
        written = scratch / f"{name}-{mode}.glb"
        run("stripify", source, "-o", written, "--gltf", mode)
        converted = scratch / f"{name}-{mode}-converted.glb"
        run("convert", scratch / f"{name}-restart.glb", "-o", converted, "--gltf", mode)
        (with_restarts if mode == "restart" else plain).extend([written, converted])
    run("convert", source, "-o", scratch / f"{name}-bare.glb")
    # With the default options.
    run("stripify", source, "-o", scratch / f"{name}-default.glb")
    run("simplify", source, "--base", 0.4, "-o", scratch / f"{name}-level.glb")
    run("stripify", source, "-o", scratch / f"{name}-batches.glb", "--batch-vertices", 60)
    run("stripify", source, "-o", scratch / f"{name}-wide.glb", "--index", "32")
    plain.extend(scratch / f"{name}-{kind}.glb" for kind in ("bare", "default", "level", "batches", "wide"))
for name, shape in (("cube", cube()), ("sphere", sphere())):  # with attributes
    source = save(shape, scratch / f"{name}.glb")
    for mode in ("restart", "strips", "list", "stitched"):
        written = scratch / f"{name}-{mode}.glb"
        run("stripify", source, "-o", written, "--gltf", mode)
        (with_restarts if mode == "restart" else plain).append(written)
# Normals, texture coordinates and colours after conversion through other formats.
for end in ("obj", "ply"):
    run("convert", scratch / "cube.glb", "-o", scratch / f"cube.{end}")
    run("convert", scratch / f"cube.{end}", "-o", scratch / f"cube-{end}.glb")
    plain.append(scratch / f"cube-{end}.glb")
# Every attribute that can be read from every format, with values that glTF allows and others.
P, UP = [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 0, 1)] * 3
UV, SIDE = [(0, 0), (1, 0), (0, 1)], [(1, 0, 0, 1)] * 3
SHADES = {FLOAT: 1, UBYTE: 255, USHORT: 65535}


def every_file():
    for type_, most in SHADES.items():
        normalized = {} if type_ == FLOAT else {"normalized": True}
        for components in (3, 4):
            for value in (0, most):
                yield "glb", {"COLOR_0": ([(value,) * components] * 3, type_, normalized), "COLOR_1": ([(most,) * components] * 3, type_, normalized)}
        yield "glb", {f"TEXCOORD_{i}": ([(most * u, most * v) for u, v in UV], type_, normalized) for i in range(12)}
        yield "glb", {"COLOR_0": ([(most, 0, 0)] * 3, type_, {})}  # whole numbers as they are
    for type_ in (BYTE, SHORT):
        most = 127 if type_ == BYTE else 32767
        yield "glb", {"NORMAL": ([(0, -most, 0)] * 3, type_, {"normalized": True}), "TANGENT": ([(most, 0, 0, most)] * 3, type_, {"normalized": True})}
    for type_ in (BYTE, UBYTE, SHORT, USHORT, FLOAT):
        yield "glb", {f"_OWN_{n}": ([(1,) * n] * 3, type_, {}) for n in (1, 2, 3, 4)}
    for up in (1, 0, 2, 1e-30, 1e30, math.nan, math.inf):
        yield "glb", {"NORMAL": ([(0, 0, up)] * 3, FLOAT, {}), "TANGENT": (SIDE, FLOAT, {})}
        yield "glb", {"NORMAL": (UP, FLOAT, {}), "TANGENT": ([(up, 0, 0, -1)] * 3, FLOAT, {})}
        yield "glb", {"NORMAL": (UP, FLOAT, {}), "TANGENT": ([(1, 0, 0, up)] * 3, FLOAT, {})}
        yield "glb", {"TEXCOORD_0": ([(up, -up)] * 3, FLOAT, {}), "TEXCOORD_1": (UV, FLOAT, {}), "COLOR_0": ([(0, 0, up)] * 3, FLOAT, {}), "COLOR_1": ([(0, 0, 1)] * 3, FLOAT, {})}
        yield "glb", {"_OWN": ([(up,)] * 3, FLOAT, {})}
        yield "obj", "".join(f"v {x} {y} {z} 1 {c} 0\nvn 0 0 {up}\nvt {up} {y}\n" for (x, y, z), c in zip(P, (0, 1, up))) + "f 1/1/1 2/2/2 3/3/3\n"
    yield "glb", {"TANGENT": (SIDE, FLOAT, {})}
    yield "glb", {"TEXCOORD_1": (UV, FLOAT, {}), "COLOR_2": ([(0, 0, 1)] * 3, FLOAT, {}), "JOINTS_0": ([(0, 0, 0, 0)] * 3, UBYTE, {}),
                  "WEIGHTS_0": ([(1, 0, 0, 0)] * 3, FLOAT, {}), "TEXCOORD_01": (UV, FLOAT, {}), "lower": ([(1,)] * 3, FLOAT, {})}
    for kind, most in (("uchar", 255), ("ushort", 65535), ("float", 1), ("float", 255), ("double", 1), ("double", -1), ("float", math.nan)):
        for channels in (("red", "green", "blue"), ("red", "green", "blue", "alpha"), ("diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha")):
            names = [("float", name) for name in ("x", "y", "z", "nx", "ny", "nz", "s", "t")] + [(kind, name) for name in channels]
            yield "ply", ("ply\nformat ascii 1.0\nelement vertex 3\n" + "".join(f"property {kind} {name}\n" for kind, name in names) +
                          "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + "".join(
                              f"{x} {y} {z} 0 {most} 0 {x} {y}" + f" {most}" * len(channels) + "\n" for x, y, z in P) + "3 0 1 2\n")


for number, (end, content) in enumerate(every_file()):
    source, written = scratch / f"attributes-{number}.{end}", scratch / f"attributes-{number}-out.glb"
    if end == "glb":
        file = File()
        numbers = {name: file.accessor(values, ("SCALAR", "VEC2", "VEC3", "VEC4")[len(values[0]) - 1], type_,
                                       stride=-(-len(values[0]) * struct.calcsize(LETTER[type_]) // 4) * 4, **more)
                   for name, (values, type_, more) in content.items()}
        file.primitive(file.positions(P), file.indices([0, 1, 2]), **numbers)
        source.write_bytes(file.glb())
    else:
        source.write_text(content)
    run("convert", source, "-o", written)
    plain.append(written)
# A baked mesh: viewers need not know its extension.
for mode in ("stitched", "strips", "list"):
    written = scratch / f"baked-{mode}.glb"
    run("bake", scratch / "small.obj", "--cost", "indices", "--base", 0.3, "-o", written, "--gltf", mode)
    plain.append(written)
mended = [edited(path, f"{path.stem}-mended.glb", without_restarts) for path in with_restarts]

for path, report in zip([*plain, *mended], validated([*plain, *mended]), strict=True):
    counts = collections.Counter(message["code"] for message in report["messages"])
    print(f"{path.name}: {report['errors']} errors, {report['warnings']} warnings", dict(counts))
    assert (report["errors"], report["warnings"]) == (0, 0), report["messages"][:5]
    assert "baked" not in path.name or counts == {"UNSUPPORTED_EXTENSION": 1, "UNUSED_OBJECT": 1}, counts
for path, report in zip(with_restarts, validated(with_restarts), strict=True):
    ((_, indices, width),) = glb(path)[1]
    restarts = [i for i, index in enumerate(indices) if index == RESTART[width]]
    assert restarts and report["warnings"] == 0
    found = collections.Counter(message["code"] for message in report["messages"] if message["severity"] == 0)
    assert found == {"ACCESSOR_INDEX_OOB": len(restarts), "ACCESSOR_INDEX_PRIMITIVE_RESTART": len(restarts)}, found
    assert any(message["code"] == "UNSUPPORTED_EXTENSION" for message in report["messages"])
    places = {int(re.search(r"at index (\d+)", message["message"])[1]) for message in report["messages"]
              if message["code"].startswith("ACCESSOR_INDEX")}
    assert places == set(restarts)
    print(f"{path.name}: {len(restarts)} restarts, each two errors")


def beyond(doc, binary):
    _, begin, letter = indices_in(doc)
    struct.pack_into(letter, binary, begin, doc["accessors"][0]["count"])


damaged = [edited(plain[0], f"damaged-{i}.glb", edit) for i, edit in enumerate((
    beyond,
    lambda doc, _: doc["accessors"][0]["min"].__setitem__(0, 1e6),
    lambda doc, _: doc["bufferViews"][1].update(byteLength=1 << 30),
    lambda doc, _: doc["meshes"][0]["primitives"][0].update(mode=9),
    lambda doc, _: doc["asset"].pop("version")))]
for path, report in zip(damaged, validated(damaged), strict=True):
    assert report["errors"] > 0, path
print("glTF validator: all hold")
