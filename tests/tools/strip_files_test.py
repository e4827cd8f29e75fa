#!/usr/bin/env python3
"""Claims: `restrip stripify -o` writes, in every format, the oriented triangles of its input, as the strips that it reports;
strips come back as they were, also through `restrip convert`; `simplify` and `replay` write the levels that they are asked
for; --weld and --orient do what they say and nothing else. The files are taken apart here by their formats' definitions,
with no code of restrip's.

    strip_files_test.py restrip SCRATCH
"""
import json
import pathlib
import struct
import subprocess
import sys

from program import Program
from strip_readers import RESTART, drawn, glb, obj, parts_of_glb, ply, rotated, strips_between, triangles_of_strip

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])


def required(path):
    return parts_of_glb(path)[0].get("extensionsRequired")


def read_bin(path, form, width, in_batches):
    """The draw calls of a .bin: lists of indices."""
    data, at = path.read_bytes(), 0

    def table():
        nonlocal at
        (count,) = struct.unpack_from("<I", data, at)
        values = struct.unpack_from(f"<{count}I", data, at + 4)
        at += 4 + 4 * count
        return values

    batches = table() if in_batches else None
    lengths = table() if form == "lengths" else None
    indices = [index for (index,) in struct.iter_unpack("<H" if width == 2 else "<I", data[at:])]
    calls = []
    for length in lengths or batches or [len(indices)]:
        calls.append(indices[:length])
        del indices[:length]
    assert not indices and sum(batches or ()) == (sum(map(len, calls)) if batches else 0)
    return calls


def triangles_of_calls(calls, form, width):
    if form == "list":
        return sorted(rotated(call[i:i + 3]) for call in calls for i in range(0, len(call), 3))
    return drawn([strip for call in calls for strip in (strips_between(call, RESTART[width]) if form == "restart" else [call])])


def check_forms(name, source, expected, width):
    """Every form and width of .bin, whole and in batches; batches of .glb are primitives."""
    for form in ("restart", "stitched", "lengths", "list"):
        for index in ("auto", "32") if width == 2 else ("auto",):
            bytes_each = 4 if index == "32" else width
            for limit in ((), ("--batch-vertices", 40), ("--batch-indices", 30)) if width == 2 else ((),):
                out = scratch / f"{name}-form.bin"
                about = json.loads(run("stripify", source, "-o", out, "--form", form, "--index", index, *limit, "--json", "-").stdout)
                calls = read_bin(out, form, bytes_each, bool(limit))
                assert triangles_of_calls(calls, form, bytes_each) == expected, (form, index, limit)
                printed = about["file"]
                assert (printed["form"], printed["index_bits"], printed["indices"]) == (form, 8 * bytes_each, sum(map(len, calls)))
                if limit and form != "lengths":
                    assert printed["batches"] == len(calls) > 1
                for call in calls if limit else ():
                    used = len(call) if "--batch-indices" in limit else len(set(call) - {RESTART[bytes_each]})
                    assert used <= limit[1], (form, limit)
    if width == 2:
        out = scratch / f"{name}-batches.glb"
        run("stripify", source, "-o", out, "--batch-vertices", 40)
        _, primitives = glb(out)
        assert len(primitives) > 1 and all(mode == 5 and len(set(strip)) <= 40 for mode, strip, _ in primitives)
        assert drawn([strip for _, strip, _ in primitives]) == expected
    else:
        refused = run("stripify", source, "-o", scratch / "wide.bin", "--index", "16", code=2).stderr
        assert "wide.bin: the mesh" in refused and "16 bits" in refused and "--index auto" in refused and "split the mesh" in refused and not (scratch / "wide.bin").exists(), refused


def check(name, width):
    source = scratch / f"{name}.obj"
    run("make-mesh", "-o", source, "--triangles", 600)
    points, expected = obj(source)
    if width == 4:  # behind vertices that no triangle has
        points, expected = [(0.0, 0.0, 0.0)] * 65_536 + points, [tuple(v + 65_536 for v in t) for t in expected]
        source.write_text("".join("v {!r} {!r} {!r}\n".format(*p) for p in points) +
                          "".join("f {} {} {}\n".format(*(v + 1 for v in t)) for t in expected))
    printed = None
    for out, *form in ((f"{name}.ply",), (f"{name}.bin",), (f"{name}-list.obj",), (f"{name}-default.glb",),
                       (f"{name}.glb", "--gltf", "strips")):
        report = run("stripify", source, "--cost", "indices", "-o", scratch / out, *form, "--json", "-").stdout
        printed = json.loads(report)
        assert printed["triangles"] == len(expected) and printed["left_out"] == 0

    ply_points, strips = ply(scratch / f"{name}.ply")
    assert ply_points == points and len(strips) == printed["strips"] and drawn(strips) == expected
    assert sum(map(len, strips)) + len(strips) - 1 == printed["indices"]

    indices = [index for (index,) in struct.iter_unpack("<H" if width == 2 else "<I", (scratch / f"{name}.bin").read_bytes())]
    assert len(indices) == printed["indices"] and strips_between(indices, RESTART[width]) == strips
    assert obj(scratch / f"{name}-list.obj") == (points, expected)

    # By default every viewer can open the file; if a viewer needs a proposed extension, the report says so.
    assert "required_extensions" not in printed and required(scratch / f"{name}.glb") is None
    assert glb(scratch / f"{name}.glb") == (points, [(5, strip, width) for strip in strips])
    # The default form is one draw call: one stitched strip, without restarts.
    glb_points, ((mode, stitched, stitched_width),) = glb(scratch / f"{name}-default.glb")
    assert (glb_points, mode, stitched_width) == (points, 5, width) and RESTART[width] not in stitched
    assert drawn([stitched]) == expected and len(stitched) <= printed["indices"] + printed["strips"]
    check_forms(name, source, expected, width)
    restart = ("stripify", source, "--cost", "indices", "-o", scratch / f"{name}-restart.glb", "--gltf", "restart")
    assert "requires KHR_mesh_primitive_restart, a proposal" in run(*restart).stdout
    assert json.loads(run(*restart, "--json", "-").stdout)["required_extensions"] == required(scratch / f"{name}-restart.glb")
    glb_points, primitives = glb(scratch / f"{name}-restart.glb")
    assert glb_points == points and [(mode, w) for mode, _, w in primitives] == [(5, width)]
    assert strips_between(primitives[0][1], RESTART[width]) == strips
    run("stripify", source, "--cost", "indices", "-o", scratch / f"{name}-list.glb", "--gltf", "list")
    _, ((mode, flat, list_width),) = glb(scratch / f"{name}-list.glb")
    assert (mode, list_width) == (4, width)
    assert sorted(rotated(flat[i:i + 3]) for i in range(0, len(flat), 3)) == expected

    # Read back: the same oriented triangles, whatever their strips, and the same strips on request.
    every = (f"{name}.ply", f"{name}.glb", f"{name}-restart.glb", f"{name}-default.glb")
    for back in every if width == 2 else [f"{name}.glb"]:
        run("stripify", scratch / back, "-o", scratch / f"{name}-again.obj")
        assert obj(scratch / f"{name}-again.obj") == (points, expected), back
        report = run("stripify", scratch / back, "--effort", "file", "-o", scratch / f"{name}-kept.ply", "--json", "-").stdout
        kept = json.loads(report)
        assert (kept["strips"], kept["cut_strips"], kept["valid"]) == (printed["strips"], 0, True), (back, kept)
        assert sorted(sorted(triangles_of_strip(strip)) for strip in ply(scratch / f"{name}-kept.ply")[1]) == \
            sorted(sorted(triangles_of_strip(strip)) for strip in strips), back
        about = json.loads(run("stats", scratch / back, "--json", "-").stdout)
        assert (about["strips"], about["cut_strips"]) == (printed["strips"], 0), about
        # Converted, the index buffer is identical; stitched strips are separated.
        run("convert", scratch / back, "-o", scratch / f"{name}-converted.ply")
        if "default" in back:
            converted_points, converted = ply(scratch / f"{name}-converted.ply")
            assert (converted_points, len(converted), drawn(converted)) == (points, printed["strips"], expected)
            continue
        assert about["strip_indices"] == printed["indices"], about
        assert ply(scratch / f"{name}-converted.ply") == (points, strips), back
        run("convert", scratch / back, "-o", scratch / f"{name}-converted.bin")
        assert (scratch / f"{name}-converted.bin").read_bytes() == (scratch / f"{name}.bin").read_bytes(), back
        run("convert", scratch / back, "-o", scratch / f"{name}-converted.glb", "--gltf", "strips")
        assert glb(scratch / f"{name}-converted.glb") == (points, [(5, strip, width) for strip in strips]), back

    # A list stays a list.
    if width == 4:
        return
    run("convert", scratch / f"{name}-list.glb", "-o", scratch / f"{name}-converted.obj")
    assert obj(scratch / f"{name}-converted.obj") == (points, expected)
    run("convert", source, "-o", scratch / f"{name}-converted.glb")
    _, ((mode, flat, _),) = glb(scratch / f"{name}-converted.glb")
    assert mode == 4 and sorted(rotated(list(flat[i:i + 3])) for i in range(0, len(flat), 3)) == expected


scratch.mkdir(parents=True, exist_ok=True)
check("small", 2)
check("large", 4)



def at_places(points, triangles):
    return sorted(rotated([points[v] for v in t]) for t in triangles)


def euler(triangles):
    edges = {frozenset(e) for a, b, c in triangles for e in ((a, b), (b, c), (c, a))}
    directed = {e for a, b, c in triangles for e in ((a, b), (b, c), (c, a))}
    assert len(directed) == 3 * len(triangles) == 2 * len(edges), "a closed oriented manifold"
    return len({v for t in triangles for v in t}) - len(edges) + len(triangles)


# Triangles without neighbours: a list has fewer indices than strips with restarts or stitches, so a list is written and
# reported.
with open(scratch / "islands.obj", "w") as file:
    file.write("".join(f"v {i} {i * i % 7} {i % 3}\n" for i in range(90)) + "".join(f"f {i} {i + 1} {i + 2}\n" for i in range(1, 91, 3)))
islands = [(i, i + 1, i + 2) for i in range(0, 90, 3)]
for out, *form in (("islands.glb",), ("islands.glb", "--gltf", "stitched"), ("islands.glb", "--gltf", "restart"), ("islands.ply",),
                   ("islands.bin",), ("islands.bin", "--form", "stitched")):
    said = run("stripify", scratch / "islands.obj", "-o", scratch / out, *form).stdout
    assert "a triangle list has fewer indices: 90" in said and "list; a list, because" in said, said
    if out.endswith(".glb"):
        _, ((mode, flat, _),) = glb(scratch / out)
        assert mode == 4 and triangles_of_calls([flat], "list", 2) == islands
    elif out.endswith(".bin"):
        assert triangles_of_calls(read_bin(scratch / out, "list", 2, False), "list", 2) == islands
    else:
        run("convert", scratch / out, "-o", scratch / "islands-back.obj")
        assert obj(scratch / "islands-back.obj")[1] == islands
assert "a triangle list has fewer indices" in run("stripify", scratch / "islands.obj").stdout
# --keep-strips writes them as strips all the same.
for form in ("restart", "stitched", "lengths"):
    printed = json.loads(run("stripify", scratch / "islands.obj", "-o", scratch / "islands.bin", "--form", form, "--keep-strips",
                             "--json", "-").stdout)["file"]
    assert printed["form"] == form and printed["indices"] >= 90 and "list_in_place_of" not in printed, printed
    assert triangles_of_calls(read_bin(scratch / "islands.bin", form, 2, False), form, 2) == islands
run("stripify", scratch / "islands.obj", "-o", scratch / "islands.ply", "--keep-strips")
assert drawn(ply(scratch / "islands.ply")[1]) == islands
run("stripify", scratch / "islands.obj", "-o", scratch / "islands.glb", "--keep-strips")
_, ((mode, strip, _),) = glb(scratch / "islands.glb")
assert mode == 5 and drawn([strip]) == islands

# Levels of detail: of the requested size, still a torus; the finest one is the mesh itself.
mesh = scratch / "small.obj"
points, expected = obj(mesh)
printed = json.loads(run("simplify", mesh, "--triangles", 100, "-o", scratch / "level.ply", "--json", "-").stdout)
_, strips = ply(scratch / "level.ply")
assert len(drawn(strips)) == printed["base_triangles"] == printed["wanted_base_triangles"] == 100 and euler(drawn(strips)) == 0
assert len(strips) == printed["strips"] and printed["stopped_short"] is False and "obstacles" not in printed
assert "strips of the file" not in run("stats", mesh).stdout and "strips of the file" in run("stats", scratch / "level.ply").stdout
# If nothing may collapse any more, the level is written, and three places report that it is larger than requested.
for out in ("short.ply", "short.pm"):
    short = run("simplify", mesh, "--triangles", 2, "-o", scratch / out, "--json", scratch / "short.json", code=1)
    printed = json.loads((scratch / "short.json").read_text())
    assert printed["stopped_short"] and 2 == printed["wanted_base_triangles"] < printed["base_triangles"], printed
    assert sum(o["edges"] for o in printed["obstacles"]) == 3 * printed["base_triangles"] // 2
    assert f"stopped at {printed['base_triangles']} triangles, but 2 were requested" in short.stderr, short.stderr
    assert all(f"{o['edges']}: {o['why']}" in short.stderr for o in printed["obstacles"])
assert len(drawn(ply(scratch / "short.ply")[1])) == printed["base_triangles"]
assert "stopped at" in run("simplify", mesh, "-o", scratch / "short.pm").stderr  # the default share was not requested explicitly
for policy, size in (("local", 300), ("baked", 301), ("full", None)):
    run("replay", mesh, "--repeats", 0, "--policy", policy, *(("--triangles", size) if size else ()), "-o", scratch / "level.glb",
        "--gltf", "strips")
    level_points, primitives = glb(scratch / "level.glb")
    triangles = drawn([strip for _, strip, _ in primitives])
    assert (size or len(expected)) <= len(triangles) <= (size or len(expected)) + 1 and euler(triangles) == 0, (policy, size)
    if not size:
        assert at_places(level_points, triangles) == at_places(points, expected)
refused = run("replay", "--built-in", "-o", scratch / "x.ply", code=2).stderr
assert "--built-in" in refused, refused

# Welding and orienting: cut apart and turned over here, the mesh is restored.
with open(scratch / "apart.obj", "w") as file:
    for number, t in enumerate(expected):
        for v in t if number % 5 else t[::-1]:
            file.write("v {!r} {!r} {!r}\n".format(*points[v]))
        file.write(f"f {3 * number + 1} {3 * number + 2} {3 * number + 3}\n")
about = run("stats", scratch / "apart.obj").stdout
assert "--weld" in about, about
printed = json.loads(run("convert", scratch / "apart.obj", "--weld", "-o", scratch / "welded.obj", "--json", "-").stdout)
assert printed["mended"] == {"welded_vertices": 3 * len(expected) - len(points), "vanished_triangles": 0, "turned_triangles": 0}
about = run("stripify", scratch / "welded.obj").stdout
assert "--orient" in about and "--weld" not in about, about
about = run("stripify", scratch / "apart.obj", "--weld", "--orient", "--json", scratch / "mended.json",
            "-o", scratch / "mended.obj").stdout
turned = (len(expected) + 4) // 5
assert f"oriented: {turned} triangles turned" in about and "--orient" not in about, about
assert json.loads((scratch / "mended.json").read_text())["mended"]["turned_triangles"] == turned
mended_points, mended = obj(scratch / "mended.obj")
assert at_places(mended_points, mended) == at_places(points, expected) and len(mended_points) == len(points)
refused = run("stats", scratch / "apart.obj", "--weld", "--orient", "--json", scratch / "stats.json").stdout
assert json.loads((scratch / "stats.json").read_text())["genus"] == 1, refused

for arguments, words in (
        (("-o", scratch / "x.off"), "name a file that ends so"),
        (("-o", scratch / "x.ply", "--gltf", "list"), "--gltf"),
        (("--gltf", "list"), "--gltf"),
        (("-o", scratch / "x.ply", "--index", "16"), "--index"),
        (("-o", scratch / "x.glb", "--form", "list"), "for .glb use --gltf list"),
        (("-o", scratch / "x.glb", "--form", "lengths"), "for .glb use --gltf strips"),
        (("-o", scratch / "x.obj", "--keep-strips"), "--keep-strips"),
        (("-o", scratch / "x.bin", "--gltf", "list"), "--gltf"),
        (("-o", scratch / "x.bin", "--batch-vertices", "2"), "2 is not a whole number from 3 to 1000000000"),
        (("-o", scratch / "x.bin", "--batch-indices", "1e3"), "1e3 is not a whole number"),
        (("--effort", "file"), "has no strips"),
        (("-o", mesh), "small.obj")):
    before = mesh.read_bytes()
    refused = run("stripify", mesh, *arguments, code=2).stderr
    assert words in refused, refused
    assert mesh.read_bytes() == before and not (scratch / "x.ply").exists() and not (scratch / "x.off").exists()
refused = run("convert", scratch / "islands.bin", "-o", scratch / "x.obj", code=2).stderr
assert "islands.bin: a .bin file is only written" in refused, refused
for report in ((), ("-o", "-", "--to", "ply"), ("--json", "-")):  # with standard output closed
    done = subprocess.run(["sh", "-c", 'exec "$@" >&-', "sh", sys.argv[1], "stripify", mesh, *report], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 2 and "closed" in done.stderr, done
print("strip files: all hold")
