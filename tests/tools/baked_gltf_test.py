#!/usr/bin/env python3
"""Claims: a baked mesh in a GLB is the baked file, byte by byte, after a mesh that draws the base as its strips; every
command that reads baked meshes reads it; a player written in Python after docs/reference/file-formats.md alone comes
from it to the triangles and strips that `restrip replay` writes; other commands take the finest level, with its strips;
and a file that is damaged, or draws another base, is refused with a sentence that names it.

    baked_gltf_test.py restrip SCRATCH
"""
import json
import pathlib
import struct
import sys

from baked_reader import Player, in_glb, with_payload
from gltf_maker import edited_glb
from program import Program
from strip_readers import RESTART, obj, parts_of_glb, ply, rotated, strips_between, triangles_of_strip

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])
scratch.mkdir(parents=True, exist_ok=True)


def at_points(points, triangles):
    return frozenset(rotated([points[v] for v in t]) for t in triangles)


def drawn(path):
    """The points, and the triangles of each strip or list, at their points."""
    doc, accessor = parts_of_glb(path)
    made, points = [], None
    for primitive in doc["meshes"][0]["primitives"]:
        points = list(zip(*[iter(accessor(primitive["attributes"]["POSITION"])[2])] * 3))
        _, width, indices = accessor(primitive["indices"])
        if primitive["mode"] == 5:
            made += [at_points(points, triangles_of_strip(strip)) for strip in strips_between(indices, RESTART[width])]
        else:
            made.append(at_points(points, [indices[i:i + 3] for i in range(0, len(indices), 3)]))
    return points, made


def check(name, mode_of_bake, mesh, *options):
    baked, glb, back = (scratch / f"{name}{end}" for end in (".baked", ".glb", "-back.baked"))
    run("bake", mesh, "-o", baked, *options)
    data = baked.read_bytes()
    run("bake", mesh, "-o", scratch / "made.glb", *mode_of_bake, *options)
    run("convert", baked, "-o", glb, *mode_of_bake)
    assert (scratch / "made.glb").read_bytes() == glb.read_bytes(), "baking is the same"
    for mode in ("restart", "strips", "list", "stitched"):
        run("convert", baked, "-o", glb, "--gltf", mode)
        assert in_glb(glb) == data
        run("convert", glb, "-o", back)
        assert back.read_bytes() == data
        required = json.loads(glb.read_bytes()[20:20 + struct.unpack_from("<I", glb.read_bytes(), 12)[0]]).get("extensionsRequired")
        player = Player(in_glb(glb))
        strips = [frozenset(at_points(player.points, [player.triangles[f] for f in strip])) for strip in player.strips()]
        points, made = drawn(glb)
        assert points == player.points
        assert set(made) == ({frozenset().union(*strips)} if mode in ("list", "stitched") else set(strips))
        assert required == (["KHR_mesh_primitive_restart"] if mode == "restart" and len(strips) > 1 else None), (mode, required)

    # Plain glTF 2.0 unless asked for: then `convert` and `bake` write strips.
    run("convert", baked, "-o", glb)
    assert "extensionsRequired" not in parts_of_glb(glb)[0]

    # Every level, by an independent player.
    player = Player(in_glb(glb))
    levels = {0, 1, player.records // 3, player.records}
    for record in range(player.records + 1):
        if record in levels:
            run("replay", glb, "--repeats", 0, "-o", scratch / "level.ply", "--triangles", len(player.triangles))
            points, strips = ply(scratch / "level.ply")
            written = {at_points(points, triangles_of_strip(strip)) for strip in strips}
            assert written == {at_points(player.points, [player.triangles[f] for f in strip]) for strip in player.strips()}
        if record < player.records:
            player.split()
    assert player.at == len(player.data)
    return glb


torus = scratch / "torus.obj"
run("make-mesh", "-o", torus, "--triangles", 900)
sheet = scratch / "sheet.obj"  # with a boundary, where one apex is missing
sheet.write_text("".join(f"v {x} {y} {(x * 7 + y * 5) % 3 / 4}\n" for x in range(13) for y in range(13)) + "".join(
    f"f {a} {a + 13} {a + 14}\nf {a} {a + 14} {a + 1}\n" for a in (13 * x + y + 1 for x in range(12) for y in range(12))))
check("sheet", ("--gltf", "list"), sheet, "--base", 0.3, "--boundary", "move")
check("indices", ("--gltf", "restart"), torus, "--base", 0.2, "--cost", "indices")
glb = check("torus", (), torus, "--base", 0.1)
doc, accessor = parts_of_glb(glb)
base = accessor(doc["meshes"][0]["primitives"][0]["indices"])

# Every command that reads baked meshes.
plain = scratch / "torus.baked"
for arguments in (("stats",), ("replay", "--repeats", 0, "--levels", 3)):
    printed = [json.loads(run(arguments[0], mesh, *arguments[1:], "--json", "-").stdout) for mesh in (glb, plain)]
    for report in printed:
        report.pop("mesh", None)
        report.pop("name", None)
    assert printed[0].keys() == printed[1].keys()
    if arguments[0] == "stats":
        assert printed[0] == printed[1]
    else:
        assert printed[0]["policy"] == printed[1]["policy"] == "baked", printed
for mesh, out in ((glb, "glb.svg"), (plain, "plain.svg")):
    run("draw", mesh, "-o", scratch / out, "--triangles", 400)
assert (scratch / "glb.svg").read_bytes() == (scratch / "plain.svg").read_bytes()
for mesh, out in ((glb, "glb-again.baked"), (plain, "plain-again.baked")):
    run("bake", mesh, "-o", scratch / out)
assert (scratch / "glb-again.baked").read_bytes() == (scratch / "plain-again.baked").read_bytes()

# A payload is kept.
(scratch / "payload.baked").write_bytes(with_payload(plain.read_bytes(), 5))
run("convert", scratch / "payload.baked", "-o", scratch / "payload.glb")
assert in_glb(scratch / "payload.glb") == (scratch / "payload.baked").read_bytes() != plain.read_bytes()
run("bake", scratch / "payload.glb", "-o", scratch / "payload-again.glb")
assert struct.unpack_from("<I", in_glb(scratch / "payload-again.glb"), 8) == (2,)

# The others use the finest level, with its strips.
finest = Player(in_glb(glb))
for record in range(finest.records):
    finest.split()
all_triangles = at_points(finest.points, finest.triangles)
strips = {at_points(finest.points, [finest.triangles[f] for f in strip]) for strip in finest.strips()}
for mesh in (glb, plain):
    run("stripify", mesh, "-o", scratch / "finest.obj")
    points, triangles = obj(scratch / "finest.obj")
    assert at_points(points, triangles) == all_triangles
    printed = json.loads(run("stripify", mesh, "--effort", "file", "--json", "-").stdout)
    assert (printed["strips"], printed["cut_strips"]) == (len(strips), 0), printed
    run("convert", mesh, "-o", scratch / "finest.ply")
    points, indices = ply(scratch / "finest.ply")
    assert {at_points(points, triangles_of_strip(strip)) for strip in indices} == strips
    run("simplify", mesh, "--base", 0.5, "-o", scratch / "again.pm")
    assert json.loads(run("stats", scratch / "again.pm", "--json", "-").stdout)["triangles"] == len(finest.triangles)
printed = run("convert", scratch / "payload.baked", "-o", scratch / "finest.ply").stdout
assert "left out: payload" in printed, printed

# Impossible requests are refused with a reason.
for arguments, words in (((glb, "-o", scratch / "never.baked", "--weld"), "is taken as it is"),
                         ((torus, "-o", scratch / "never.baked"), "is not a baked mesh; restrip bake makes one")):
    assert words in run("convert", *arguments, code=2).stderr, words
    assert not arguments[2].exists()


# Damage.
def refused(edit, words):
    (scratch / "bad.glb").write_bytes(edited_glb(glb.read_bytes(), edit))
    for command in (("stats",), ("replay", "--repeats", 0), ("convert", "-o", scratch / "never.baked")):
        message = run(command[0], scratch / "bad.glb", *command[1:], code=2).stderr
        assert "bad.glb" in message and words in message, (words, message)
    assert not (scratch / "never.baked").exists()


def extension(doc):
    return doc["meshes"][0]["extensions"]["RESTRIP_baked_strips"]


def view(doc):
    return doc["bufferViews"][extension(doc)["bufferView"]]


def alter(number):
    def edit(doc, binary):
        binary[view(doc)["byteOffset"] + number * (view(doc)["byteLength"] - 1) // 6] ^= 0x10
    return edit


refused(alter(0), "does not begin with 'RestripB'")
for number in range(1, 7):
    refused(alter(number), "its checksum does not fit")
refused(lambda doc, _: view(doc).update(byteLength=view(doc)["byteLength"] - 1), "its checksum does not fit")
refused(lambda doc, _: view(doc).update(byteLength=1 << 30), "reaches beyond its buffer")
refused(lambda doc, _: extension(doc).pop("bufferView"), 'meshes[0].extensions.RESTRIP_baked_strips: expected a member "bufferView"')
refused(lambda doc, _: extension(doc).update(bufferView=99), "bufferViews")
refused(lambda doc, _: extension(doc).update(bufferView="0"), "bufferView")
refused(lambda doc, _: doc["meshes"].append(doc["meshes"][0]), "is the second one")
refused(lambda doc, _: doc["nodes"][0].update(translation=[0, 0, 1]), "draws something other than the base")
refused(lambda doc, binary: struct.pack_into("<f", binary, 0, 99.5), "draws something other than the base")
refused(lambda doc, _: doc["accessors"][-1].update(count=doc["accessors"][-1]["count"] - 1), "draws something other than the base")
print("baked meshes in glTF: all hold")
