"""Readers of the files that restrip writes, by their formats' definitions, with no code of restrip's; and what strips draw."""
import json
import struct

RESTART = {2: 0xFFFF, 4: 0xFFFFFFFF}


def rotated(corners):
    at = corners.index(min(corners))
    return tuple(corners[at:] + corners[:at])


def triangles_of_strip(strip):
    made = []
    for i in range(len(strip) - 2):
        a, b, c = strip[i:i + 3]
        if len({a, b, c}) == 3:
            made.append(rotated([a, b, c] if i % 2 == 0 else [b, a, c]))
    return made


def strips_between(indices, restart):
    strips = [[]]
    for index in indices:
        if index == restart:
            strips.append([])
        else:
            strips[-1].append(index)
    return strips


def drawn(strips):
    return sorted(t for strip in strips for t in triangles_of_strip(strip))


def obj(path):
    points, triangles = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(struct.unpack("<3f", struct.pack("<3f", *map(float, words[1:]))))
        elif words[:1] == ["f"]:
            triangles.append(rotated([int(word) - 1 for word in words[1:]]))
    return points, sorted(triangles)


def drawn_obj(path):
    """Triangles by corners; a corner is the values of its `v` (with colours), `vt` (turned, as glTF counts) and `vn`. And how
    many lines of each there are."""
    lists, triangles = {"v": [], "vt": [], "vn": []}, []
    for line in path.read_text().splitlines():
        keyword, *words = line.split()
        if keyword == "f":
            triangles.append([[lists[name][int(part) - 1] if part else None
                               for name, part in zip(lists, (word + "//").split("/"))] for word in words])
        else:
            lists[keyword].append(tuple(map(float, words)))
    made = []
    for corners in triangles:
        made.append([{name: value for name, value in (
            ("POSITION", v[:3]), ("COLOR_0", v[3:]), ("TEXCOORD_0", vt and (vt[0], 1 - vt[1])), ("NORMAL", vn)) if value}
            for v, vt, vn in corners])
    return made, {name: len(values) for name, values in lists.items()}


PLY_TYPES = {"uchar": "B", "ushort": "H", "float": "f", "int": "i", "uint": "I"}


def drawn_ply(path):
    """The same of a binary PLY with faces or strips; whole numbers of colours as they are. And the types of properties."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    lines = head.decode().splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    types, at = {}, 3
    while lines[at].startswith("property"):
        _, kind, name = lines[at].split()
        types[name] = kind
        at += 1
    row = struct.Struct("<" + "".join(PLY_TYPES[kind] for kind in types.values()))
    count = int(lines[2].removeprefix("element vertex "))
    vertices = []
    for values in row.iter_unpack(body[:row.size * count]):
        named = dict(zip(types, values, strict=True))
        groups = {"POSITION": "xyz", "NORMAL": ("nx", "ny", "nz"), "TEXCOORD_0": "st", "COLOR_0": ("red", "green", "blue", "alpha")}
        vertex = {group: tuple(named[name] for name in names if name in named) for group, names in groups.items()}
        if vertex["TEXCOORD_0"]:
            vertex["TEXCOORD_0"] = (vertex["TEXCOORD_0"][0], 1 - vertex["TEXCOORD_0"][1])
        vertices.append({group: value for group, value in vertex.items() if value})
    body = body[row.size * count:]
    if lines[at] == "element tristrips 1":
        (length,) = struct.unpack_from("<i", body)
        assert len(body) == 4 + 4 * length
        triangles = drawn(strips_between(struct.unpack_from(f"<{length}i", body, 4), -1))
    else:
        assert lines[at + 1] == "property list uchar uint vertex_indices" and len(body) % 13 == 0
        triangles = [face[1:] for face in struct.iter_unpack("<B3I", body)]
    return [[vertices[v] for v in t] for t in triangles], types


def ply(path):
    head, body = path.read_bytes().split(b"end_header\n", 1)
    lines = head.decode().splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"], lines
    assert lines[3:6] == [f"property float {axis}" for axis in "xyz"], lines
    assert lines[6:] == ["element tristrips 1", "property list int int vertex_indices"], lines
    count = int(lines[2].removeprefix("element vertex "))
    points = list(struct.iter_unpack("<3f", body[:12 * count]))
    (length,) = struct.unpack_from("<i", body, 12 * count)
    assert len(body) == 12 * count + 4 + 4 * length
    return points, strips_between(struct.unpack_from(f"<{length}i", body, 12 * count + 4), -1)


def parts_of_glb(path):
    """The JSON, and what gives an accessor by its number: its description, the width of a component, the flat values."""
    data = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    chunks, at = [], 12
    while at < len(data):
        size, kind = struct.unpack_from("<I4s", data, at)
        assert size % 4 == 0
        chunks.append((kind, data[at + 8:at + 8 + size]))
        at += 8 + size
    assert at == len(data) and [kind for kind, _ in chunks] == [b"JSON", b"BIN\0"]
    doc, binary = json.loads(chunks[0][1]), chunks[1][1]
    assert doc["asset"]["version"] == "2.0" and doc["scenes"][doc["scene"]]["nodes"] == [0]
    assert 0 <= len(binary) - doc["buffers"][0]["byteLength"] < 4

    def accessor(number):
        about = doc["accessors"][number]
        view = doc["bufferViews"][about["bufferView"]]
        letter, width = {5120: ("b", 1), 5121: ("B", 1), 5122: ("h", 2), 5123: ("H", 2), 5125: ("I", 4),
                         5126: ("f", 4)}[about["componentType"]]
        parts = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[about["type"]]
        offset = about.get("byteOffset", 0)
        stride = view.get("byteStride", width * parts)
        size = stride * (about["count"] - 1) + width * parts
        assert about["count"] > 0 and offset % width == 0 and offset + size <= view["byteLength"]
        begin = view.get("byteOffset", 0) + offset
        assert begin % width == 0 and view.get("byteOffset", 0) + view["byteLength"] <= doc["buffers"][0]["byteLength"]
        flat = [value for i in range(about["count"])
                for value in struct.unpack_from(f"<{parts}{letter}", binary, begin + i * stride)]
        return about, width, tuple(flat)

    return doc, accessor


def corners_of_glb(path):
    """The triangles that a GLB of one mesh draws, each from its smallest corner; a corner is the values of all attributes of
    its vertex, each with its encoding."""
    doc, accessor = parts_of_glb(path)
    triangles = []
    for primitive in doc["meshes"][0]["primitives"]:
        columns = []
        for name, number in sorted(primitive["attributes"].items()):
            about, _, flat = accessor(number)
            kind = (name, about["type"], about["componentType"], about.get("normalized", False))
            parts = len(flat) // about["count"]
            columns.append([(kind, *flat[i:i + parts]) for i in range(0, len(flat), parts)])
        vertices = list(zip(*columns, strict=True))
        _, width, indices = accessor(primitive["indices"])
        if primitive.get("mode", 4) == 5:
            made = drawn(strips_between(indices, RESTART[width]))
        else:
            made = [indices[i:i + 3] for i in range(0, len(indices), 3)]
        triangles += [rotated([vertices[v] for v in t]) for t in made]
    return sorted(triangles)


def glb(path):
    """The points, and (mode, indices, width) of each primitive; checks what the format demands of what is there."""
    doc, accessor = parts_of_glb(path)
    primitives = doc["meshes"][doc["nodes"][0]["mesh"]]["primitives"]
    about, _, flat = accessor(primitives[0]["attributes"]["POSITION"])
    points = list(zip(*[iter(flat)] * 3))
    for axis in range(3):
        for bound, of in ((about["min"], min), (about["max"], max)):
            stated = struct.unpack("<f", struct.pack("<f", bound[axis]))[0]
            assert stated == of(point[axis] for point in points)
    made = []
    for primitive in primitives:
        assert primitive["attributes"] == primitives[0]["attributes"]
        _, width, indices = accessor(primitive["indices"])
        made.append((primitive["mode"], list(indices), width))
    extensions = doc.get("extensionsRequired", [])
    assert extensions == doc.get("extensionsUsed", [])
    restarts = any(RESTART[width] in indices for _, indices, width in made)
    assert extensions == (["KHR_mesh_primitive_restart"] if restarts else [])
    return points, made
