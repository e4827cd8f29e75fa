#!/usr/bin/env python3
"""Writes the page's built-in mesh as an OBJ file: a hare, sitting. Some ellipsoids and tapered rods, blended into one
smooth closed surface, which is cut out of a grid by surface nets (Gibson 1998) and moved onto the surface.
shape.py OUT.obj [CELL]"""
import math
import sys

BLEND = 0.09  # how far the parts flow into each other


def ellipsoid(x, y, z, rx, ry, rz):
    smallest = min(rx, ry, rz)

    def distance(px, py, pz):
        return (math.sqrt(((px - x) / rx) ** 2 + ((py - y) / ry) ** 2 + ((pz - z) / rz) ** 2) - 1) * smallest
    return distance


def rod(ax, ay, az, bx, by, bz, ra, rb, flat=1.0):
    """From a to b, of radius ra at a and rb at b, `flat` times as thin sideways."""
    dx, dy, dz = bx - ax, by - ay, bz - az
    length = dx * dx + dy * dy + dz * dz

    def distance(px, py, pz):
        t = max(0.0, min(1.0, ((px - ax) * dx + (py - ay) * dy + (pz - az) * dz) / length))
        qx, qy, qz = px - ax - t * dx, py - ay - t * dy, (pz - az - t * dz) * flat
        return (math.sqrt(qx * qx + qy * qy + qz * qz) - ra - t * (rb - ra)) / flat
    return distance


def both(make, *arguments, side):
    """The part and its mirror image; `side`: the places of the arguments that are z."""
    yield make(*arguments)
    yield make(*[-a if i in side else a for i, a in enumerate(arguments)])


PARTS = [ellipsoid(-0.12, 0.02, 0, 0.60, 0.52, 0.43), ellipsoid(0.30, 0.18, 0, 0.36, 0.40, 0.33),
         ellipsoid(0.56, 0.62, 0, 0.27, 0.25, 0.22), ellipsoid(0.76, 0.54, 0, 0.14, 0.12, 0.13),
         ellipsoid(-0.70, -0.12, 0, 0.15, 0.14, 0.14),
         *both(rod, 0.46, 0.78, 0.10, 0.16, 1.42, 0.22, 0.115, 0.07, 1.25, side=(2, 5)),
         *both(ellipsoid, -0.26, -0.14, 0.30, 0.36, 0.33, 0.19, side=(2,)),
         *both(ellipsoid, 0.02, -0.44, 0.34, 0.32, 0.09, 0.12, side=(2,)),
         *both(rod, 0.44, -0.02, 0.17, 0.56, -0.44, 0.17, 0.13, 0.09, side=(2, 5)),
         *both(ellipsoid, 0.64, -0.47, 0.17, 0.15, 0.075, 0.095, side=(2,))]


def field(x, y, z):
    """Negative inside. Smooth union: the logarithm of a sum of exponentials."""
    distances = [part(x, y, z) for part in PARTS]
    least = min(distances)
    return least - BLEND / 2 * math.log(sum(math.exp((least - d) * 2 / BLEND) for d in distances))


def surface(cell):
    low, high = (-1.05, -0.75, -0.72), (1.05, 1.65, 0.72)
    size = [int((h - l) / cell) + 2 for l, h in zip(low, high)]
    nx, ny, nz = size

    def at(i, j, k):
        return (i * ny + j) * nz + k

    # The grid is off the plane of symmetry, so that no value is exactly zero.
    value = [field(low[0] + i * cell, low[1] + j * cell, low[2] + (k + 0.37) * cell)
             for i in range(nx) for j in range(ny) for k in range(nz)]
    corners = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    edges = [(a, b) for a in corners for b in corners if a < b and sum(x != y for x, y in zip(a, b)) == 1]
    number, points = {}, []
    for i in range(nx - 1):
        for j in range(ny - 1):
            for k in range(nz - 1):
                crossings = []
                inside = {c: value[at(i + c[0], j + c[1], k + c[2])] < 0 for c in corners}
                if all(inside.values()) or not any(inside.values()):
                    continue
                for a, b in edges:
                    if inside[a] != inside[b]:
                        va = value[at(i + a[0], j + a[1], k + a[2])]
                        vb = value[at(i + b[0], j + b[1], k + b[2])]
                        t = va / (va - vb)
                        crossings.append([a[n] + t * (b[n] - a[n]) for n in range(3)])
                mean = [sum(c[n] for c in crossings) / len(crossings) for n in range(3)]
                number[i, j, k] = len(points)
                points.append(project(low[0] + (i + mean[0]) * cell, low[1] + (j + mean[1]) * cell,
                                      low[2] + (k + 0.37 + mean[2]) * cell))
    triangles = []
    for i in range(1, nx - 1):
        for j in range(1, ny - 1):
            for k in range(1, nz - 1):
                here = value[at(i, j, k)] < 0
                for axis, (step, u, v) in enumerate((((1, 0, 0), (0, 1, 0), (0, 0, 1)), ((0, 1, 0), (0, 0, 1), (1, 0, 0)),
                                                     ((0, 0, 1), (1, 0, 0), (0, 1, 0)))):
                    there = value[at(i + step[0], j + step[1], k + step[2])] < 0
                    if here == there:
                        continue
                    quad = [number[i - a * u[0] - b * v[0], j - a * u[1] - b * v[1], k - a * u[2] - b * v[2]]
                            for a, b in ((1, 1), (0, 1), (0, 0), (1, 0))]
                    if not here:
                        quad.reverse()
                    # The shorter diagonal.
                    if math.dist(points[quad[0]], points[quad[2]]) > math.dist(points[quad[1]], points[quad[3]]):
                        quad = quad[1:] + quad[:1]
                    triangles += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return points, triangles


def project(x, y, z, h=1e-4):
    for _ in range(2):
        f = field(x, y, z)
        g = [(field(x + h, y, z) - f) / h, (field(x, y + h, z) - f) / h, (field(x, y, z + h) - f) / h]
        square = sum(c * c for c in g)
        x, y, z = x - f * g[0] / square, y - f * g[1] / square, z - f * g[2] / square
    return x, y, z


def main():
    points, triangles = surface(float(sys.argv[2]) if len(sys.argv) > 2 else 0.035)
    with open(sys.argv[1], "w", encoding="ascii") as out:
        for p in points:  # multiples of a power of two: floats with few bits, which compress
            out.write("v %.11f %.11f %.11f\n" % tuple(round(c * 2048) / 2048 for c in p))
        for a, b, c in triangles:
            out.write(f"f {a + 1} {b + 1} {c + 1}\n")


if __name__ == "__main__":
    main()
