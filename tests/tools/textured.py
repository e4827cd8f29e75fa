"""Textured shapes as glTF files, with no code of restrip's."""
import itertools
import math

from gltf_maker import BYTE, FLOAT, SHORT, UBYTE, USHORT, File

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
