#!/usr/bin/env python3
"""Claims about `restrip draw`, tested on a level that `restrip replay` writes and by readers that share no code with restrip:
a PNG is decoded here by zlib alone. Every pixel that is not at an edge shows the nearest triangle in the colour of its strip,
or the background; strips have different colours, in the number that the report says; SVG is XML with a polygon for each triangle that
faces the camera, in an order that shows in 98 % of those pixels what the depth buffer shows; from the other side all other
triangles are seen. Bad options are refused, and nothing is written then.

    draw_test.py restrip FOLDER
"""
import json
import math
import pathlib
import struct
import sys
import zlib
from xml.etree import ElementTree

from program import Program
from strip_readers import glb, rotated, triangles_of_strip

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])
WIDTH, HEIGHT = 240, 180
BACKGROUND, EDGE = (255, 255, 255), (48, 52, 58)
LEVEL = ("--base", "0.2", "--policy", "quick", "--triangles", "300")


def png(path):
    """Rows of pixels, of a picture in plain red, green, blue."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, head = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack_from(">I", data, at + 8 + length)[0]
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    assert kind == b"IEND" and head[2:] == (8, 2, 0, 0, 0), head
    width, height, stride = head[0], head[1], 3 * head[0]
    raw = zlib.decompress(packed)
    assert len(raw) == height * (1 + stride)
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, row = raw[y * (1 + stride)], bytearray(raw[y * (1 + stride) + 1:(y + 1) * (1 + stride)])
        for i in range(stride):
            left, up, corner = (row[i - 3] if i > 2 else 0), above[i], (above[i - 3] if i > 2 else 0)
            guess = left + up - corner
            row[i] = (row[i] + (0, left, up, (left + up) // 2,
                                min((left, up, corner), key=lambda value: abs(guess - value)))[kind]) % 256
        rows.append([tuple(row[i:i + 3]) for i in range(0, stride, 3)])
        above = row
    assert len(rows[0]) == width
    return rows


def seen_from(points, azimuth, elevation):
    """The mesh is turned before the camera, first around y, then around x; then it is fitted."""
    azimuth, elevation = math.radians(azimuth), math.radians(elevation)
    turned = []
    for x, y, z in points:
        x, z = x * math.cos(azimuth) - z * math.sin(azimuth), x * math.sin(azimuth) + z * math.cos(azimuth)
        y, z = y * math.cos(elevation) - z * math.sin(elevation), y * math.sin(elevation) + z * math.cos(elevation)
        turned.append((x, y, z))
    (left, low), (right, high) = (tuple(limit(p[i] for p in turned) for i in (0, 1)) for limit in (min, max))
    margin = min(WIDTH, HEIGHT) / 40
    scale = min((WIDTH - 2 * margin) / (right - left), (HEIGHT - 2 * margin) / (high - low))
    return [(WIDTH / 2 + scale * (x - (left + right) / 2), HEIGHT / 2 - scale * (y - (low + high) / 2), scale * z)
            for x, y, z in turned]


def facing(t):
    (ax, ay, _), (bx, by, _), (cx, cy, _) = t
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0  # y points down


def to_segment(p, q, x, y):
    dx, dy = q[0] - p[0], q[1] - p[1]
    share = max(0, min(1, ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy or 1)))
    return math.hypot(x - p[0] - share * dx, y - p[1] - share * dy)


def pixels_of(t):
    """(column, row, depth, distance from the outline) of the pixels in a triangle, or less than 2 away from it."""
    (ax, ay, az), (bx, by, bz), (cx, cy, cz) = t
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    for row in range(max(0, int(min(ay, by, cy)) - 3), min(HEIGHT, int(max(ay, by, cy)) + 4)):
        for column in range(max(0, int(min(ax, bx, cx)) - 3), min(WIDTH, int(max(ax, bx, cx)) + 4)):
            x, y = column + 0.5, row + 0.5
            of_c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
            of_a = ((cx - bx) * (y - by) - (cy - by) * (x - bx)) / area
            of_b = 1 - of_a - of_c
            off = min(to_segment(p, q, x, y) for p, q in zip(t, t[1:] + t[:1]))
            inside = min(of_a, of_b, of_c) >= 0
            if inside or off < 2:
                yield column, row, (of_a * az + of_b * bz + of_c * cz if inside else None), off


def svg(path):
    root = ElementTree.parse(path).getroot()
    space = "{http://www.w3.org/2000/svg}"
    assert root.tag == space + "svg" and root.get("viewBox") == f"0 0 {WIDTH} {HEIGHT}"
    group = root.find(space + "g")
    return [(tuple(tuple(map(float, at.split(","))) for at in p.get("points").split()), p.get("fill"))
            for p in group.findall(space + "polygon")]


def rgb(word):
    return tuple(bytes.fromhex(word[1:]))


def draw(out, *options):
    return json.loads(run("draw", mesh, *LEVEL, "--size", f"{WIDTH},{HEIGHT}", *options, "-o", scratch / out, "--json", "-").stdout)


def near(a, b):
    return all(math.dist(p[:2], q[:2]) < 0.02 for p, q in zip(a, b))


def check(azimuth, elevation):
    """From that camera; returns the triangles seen, each as (strip, its number in the strip)."""
    camera = ("--camera", f"{azimuth},{elevation}")
    report, report_of_svg = draw("a.png", *camera), draw("a.svg", *camera)
    places = seen_from(points, azimuth, elevation)
    front = {(s, i): [places[v] for v in t] for s, strip in enumerate(strips) for i, t in enumerate(strip)
             if facing([places[v] for v in t])}
    assert report["triangles"] == sum(map(len, strips)) and report["strips"] == len(strips), report
    assert report["triangles_drawn"] == report_of_svg["triangles_drawn"] == len(front), (report, len(front))

    # SVG: those triangles, each once, in a colour for each strip.
    polygons = svg(scratch / "a.svg")
    assert len(polygons) == len(front)
    colors, order = {}, []
    for corners, fill in polygons:
        found = [name for name, t in front.items() if any(near(corners, t[i:] + t[:i]) for i in range(3))]
        assert len(found) == 1, (corners, found)
        order.append(found[0])
        assert colors.setdefault(found[0][0], rgb(fill)) == rgb(fill)
    assert sorted(order) == sorted(front)
    assert len(set(colors.values()) | {BACKGROUND, EDGE}) == len(colors) + 2
    assert report_of_svg["strips_shown"] == len(colors) == len({s for s, _ in front})

    # PNG: what is nearest, wherever no outline is near.
    nearest, painted, unclear = {}, {}, set()
    for name in order:
        for column, row, depth, off in pixels_of(front[name]):
            if off < 2:
                unclear.add((column, row))
            if depth is not None:
                painted[column, row] = name
                nearest[column, row] = max(nearest.get((column, row), (-math.inf, None)), (depth, name))
    picture = png(scratch / "a.png")
    assert len(picture) == HEIGHT and len(picture[0]) == WIDTH
    empty, filled, covered = 0, 0, 0
    for row in range(HEIGHT):
        for column in range(WIDTH):
            if (column, row) in unclear:
                continue
            if (column, row) not in nearest:
                assert picture[row][column] == BACKGROUND, (column, row)
                empty += 1
                continue
            name = nearest[column, row][1]
            assert picture[row][column] == colors[name[0]], (column, row, name)
            filled += 1
            covered += painted[column, row] != name
    assert empty > 2000 and filled > 2000 and covered < filled / 50, (empty, filled, covered)
    used = {pixel for row in picture for pixel in row}
    assert used <= set(colors.values()) | {BACKGROUND, EDGE}
    assert len(used - {BACKGROUND, EDGE}) == report["strips_shown"], (len(used), report)
    return set(front)


scratch.mkdir(parents=True, exist_ok=True)
mesh = scratch / "mesh.obj"
run("make-mesh", "-o", mesh, "--triangles", 600)
run("replay", mesh, "--repeats", 0, *LEVEL, "-o", scratch / "level.glb", "--gltf", "strips")
points, primitives = glb(scratch / "level.glb")
strips = [triangles_of_strip(list(strip)) for _, strip, _ in primitives]
assert len(strips) > 3 and 300 <= sum(map(len, strips)) <= 301

one = check(40, 35)
other = check(220, -35)  # from the opposite place
assert not one & other and len(one | other) == sum(map(len, strips)), "each triangle is seen from one side"
assert check(-75, 0) not in (one, other)

# What is the same: again, and through a progressive mesh. What differs: the level, the policy.
draw("a.png")
first = (scratch / "a.png").read_bytes()
draw("b.png", "--camera", "30,20")
assert (scratch / "b.png").read_bytes() == first
size = ("--size", f"{WIDTH},{HEIGHT}", "-o", scratch / "b.png")
run("simplify", mesh, "--base", "0.2", "-o", scratch / "mesh.pm")
run("draw", scratch / "mesh.pm", *LEVEL[2:], *size)
assert (scratch / "b.png").read_bytes() == first
for policy in ("local", "full"):
    run("draw", scratch / "mesh.pm", "--policy", policy, "--triangles", 300, *size)
    assert (scratch / "b.png").read_bytes() != first, policy

# A file that has strips is drawn with them, cut nowhere; asked for others it is drawn as one that has none.
strips_in_file = [sorted(rotated(list(t)) for t in triangles_of_strip(strip)) for _, strip, _ in glb(scratch / "level.glb")[1]]
report = json.loads(run("draw", scratch / "level.glb", "-o", scratch / "own.json", "--json", "-").stdout)
shown = json.loads((scratch / "own.json").read_text())["strips"]
assert sorted(sorted(rotated(t) for t in strip) for strip in shown) == sorted(strips_in_file) and report["strips"] == len(strips_in_file)
assert json.loads(run("draw", scratch / "level.glb", *size, "--json", "-").stdout)["policy"] == "file"
run("draw", scratch / "level.glb", "--policy", "local", "-o", scratch / "local.json")
assert len(json.loads((scratch / "local.json").read_text())["strips"]) != len(strips_in_file)
report = json.loads(run("draw", "-o", scratch / "torus.png", "--json", "-").stdout)
assert (report["width"], report["height"]) == (800, 600) and len(png(scratch / "torus.png")) == 600

for arguments, words in (
        ((mesh, "-o", scratch / "x.gif"), "name a file that ends so"),
        ((mesh, "-o", scratch / "x.png", "--camera", "1"), "--camera"),
        ((mesh, "-o", scratch / "x.png", "--camera", "1,91"), "--camera"),
        ((mesh, "-o", scratch / "x.png", "--camera", "nan,1"), "--camera"),
        ((mesh, "-o", scratch / "x.png", "--size", "15,100"), "--size"),
        ((mesh, "-o", scratch / "x.png", "--size", "100,8193"), "--size"),
        ((mesh, "-o", scratch / "x.png", "--size", "100x100"), "--size"),
        ((mesh, "-o", scratch / "x.png", "--size", "100,-1"), "--size"),
        ((mesh, "-o", scratch / "x.png", "--triangles", "0"), "--triangles"),
        ((mesh, "-o", scratch / "x.png", "--policy", "nice"), "--policy"),
        ((mesh, "-o", scratch / "x.png", "--policy", "baked", "--cost", "bytes"), "--cost"),
        ((scratch / "mesh.pm", "-o", scratch / "x.png", "--base", "0.5"), "--base"),
        ((scratch / "none.obj", "-o", scratch / "x.png"), "no such file"),
        ((scratch / "none.obj", "-o", scratch / "none" / "x.png"), "does not exist; make it first"),
        ((mesh, "-o", scratch / "x.json", "--camera", "1,2"), "--camera")):
    refused = run("draw", *arguments, code=2).stderr
    assert words in refused, refused
    assert not any((scratch / f"x.{extension}").exists() for extension in ("gif", "png", "json"))
print("pictures: all hold")
