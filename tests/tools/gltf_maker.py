"""glTF files made by the specification, and textured shapes in them, with no code of restrip's."""
import base64
import copy
import itertools
import json
import math
import struct

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
LETTER = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f"}


def glb_bytes(doc, binary):
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    binary = bytes(binary) + b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def edited_glb(data, edit):
    """The bytes of a GLB after edit(doc, binary)."""
    (size,) = struct.unpack_from("<I", data, 12)
    doc, binary = json.loads(data[20:20 + size]), bytearray(data[28 + size:])
    edit(doc, binary)
    return glb_bytes(doc, binary)


class File:
    """A document and the buffer that it grows."""

    def __init__(self, required=()):
        self.binary = b""
        self.doc = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": 0}], "bufferViews": [], "accessors": [],
                    "meshes": [{"primitives": []}]}
        if required:
            self.doc |= {"extensionsUsed": list(required), "extensionsRequired": list(required)}

    def view(self, data, stride=None):
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.doc["bufferViews"].append(view | ({"byteStride": stride} if stride else {}))
        self.binary += data
        self.doc["buffers"][0]["byteLength"] = len(self.binary)
        return len(self.doc["bufferViews"]) - 1

    def accessor(self, values, kind, component, stride=None, before=0, **more):
        rows = [struct.pack(f"<{len(row)}{LETTER[component]}", *row) for row in values]
        data = b"".join(row.ljust(stride or 0, b"\xAA") for row in rows)
        view = self.view(b"\xBB" * before + data, stride)
        about = {"bufferView": view, "componentType": component, "count": len(values), "type": kind} | more
        self.doc["accessors"].append(about | ({"byteOffset": before} if before else {}))
        return len(self.doc["accessors"]) - 1

    def positions(self, points, **more):
        return self.accessor(points, "VEC3", 5126, **more)

    def indices(self, indices, component=5123):
        return self.accessor([[i] for i in indices], "SCALAR", component)

    def primitive(self, positions, indices=None, mode=None, mesh=0, **attributes):
        about = {"attributes": {"POSITION": positions} | attributes}
        about |= {} if indices is None else {"indices": indices}
        self.doc["meshes"][mesh]["primitives"].append(about | ({} if mode is None else {"mode": mode}))

    def glb(self):
        return glb_bytes(self.doc, self.binary)

    def gltf(self, uri=None):
        doc = copy.deepcopy(self.doc)
        doc["buffers"][0]["uri"] = uri or "data:application/octet-stream;base64," + base64.b64encode(self.binary).decode()
        return json.dumps(doc).encode()


# ---- textured shapes
N = 6  # squares along an edge of the cube


def cross(a, b):
    return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def squares(columns, rows, first):
    """The triangles of a grid of (columns + 1) x (rows + 1) vertices."""
    for i, j in itertools.product(range(columns), range(rows)):
        a = first + i * (rows + 1) + j
        b = a + rows + 1
        yield from ((a, b, b + 1), (a, b + 1, a + 1))


def cube(normal_type=FLOAT):
    """Six grids: hard normals, a texture for each side, colours in bytes, a custom attribute."""
    points, normals, tangents, places, colors, own, triangles = [], [], [], [], [], [], []
    for axis, side in itertools.product(range(3), (-1, 1)):
        normal = tuple(side if i == axis else 0 for i in range(3))
        along = tuple(1 if i == (axis + 1) % 3 else 0 for i in range(3))
        across = cross(normal, along)
        triangles += squares(N, N, len(points))
        for i, j in itertools.product(range(N + 1), range(N + 1)):
            u, v = i / N, j / N
            points.append(tuple(normal[c] + (2 * u - 1) * along[c] + (2 * v - 1) * across[c] for c in range(3)))
            normals.append(tuple(127 * c for c in normal) if normal_type == BYTE else normal)
            tangents.append((*along, 1))
            places.append((round(65535 * u), round(65535 * v)))
            colors.append((40 * axis + 10, 100 + side, i * 9, 255))
            own.append((side * (axis + 1) * 1000,))
    made = File(["KHR_mesh_quantization"] if normal_type == BYTE else [])
    made.primitive(made.positions(points), made.indices([c for t in triangles for c in t]),
                   NORMAL=made.accessor(normals, "VEC3", normal_type, stride=4 if normal_type == BYTE else None,
                                        **({"normalized": True} if normal_type == BYTE else {})),
                   TANGENT=made.accessor(tangents, "VEC4", FLOAT),
                   TEXCOORD_0=made.accessor(places, "VEC2", USHORT, normalized=True),
                   TEXCOORD_1=made.accessor([(p[0] * 0.5, p[1] + 3) for p in points], "VEC2", FLOAT, stride=12),
                   COLOR_0=made.accessor(colors, "VEC4", UBYTE, normalized=True), _ROOM=made.accessor(own, "SCALAR", SHORT, stride=4))
    return made


def sphere(columns=14, rows=9):
    """Smooth but for the seam of its texture; at the poles triangles of one place are left out."""
    points, places, triangles = [], [], []
    for i, j in itertools.product(range(columns + 1), range(rows + 1)):
        turn, height = 2 * math.pi * (i % columns) / columns, math.pi * (j / rows - 0.5)
        flat = 0 if j in (0, rows) else math.cos(height)
        points.append((flat * math.cos(turn), flat * math.sin(turn), math.sin(height)))
        places.append((i / columns, 1 - j / rows))
    triangles = [t for t in squares(columns, rows, 0) if len({points[v] for v in t}) == 3]
    made = File()
    made.primitive(made.positions(points), made.indices([c for t in triangles for c in t]),
                   NORMAL=made.positions([unit(p) for p in points]), TEXCOORD_0=made.accessor(places, "VEC2", FLOAT),
                   COLOR_0=made.accessor([(j % 10, 7, 255) for j in range(len(points))], "VEC3", UBYTE, stride=4, normalized=True))
    return made


def save(file, path):
    """As strip_readers wants it: with a scene."""
    doc = file.doc
    doc |= {"scene": 0, "scenes": [{"nodes": [0]}], "nodes": doc.get("nodes", [{"mesh": 0}])}
    path.write_bytes(file.glb())
    return path
