#!/usr/bin/env python3
"""A height field that is refined where it is steep, drawn from a buffer that follows the mesh. The device is an array here."""
import numpy as np

import restrip

N = 24
place = np.arange(N * N, dtype=np.uint32).reshape(N, N)
a, b, c, d = (part.ravel() for part in (place[:-1, :-1], place[:-1, 1:], place[1:, 1:], place[1:, :-1]))
faces = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
points = [(x, y, np.exp(-((x - 12) ** 2 + (y - 12) ** 2) / 30.0)) for y in range(N) for x in range(N)]

indices = restrip.strips_of(faces, "indices")
print(f"{len(faces)} triangles, {len(indices)} indices in {len(restrip.strips_of(faces, 'indices', 'strips'))} strips, {indices.dtype}")

mesh = restrip.LiveMesh(faces, policy="quick", effort="full")
mesh.begin_buffer("restart", index=16)
device = None
written = 0


def draw():
    """Copies what changed, and counts the triangles that the device draws."""
    global device, written
    parts = mesh.update()
    if mesh.outgrown:  # also the first time
        device = np.zeros(mesh.room, np.uint16)
    for first, part in parts:
        device[first:first + len(part)] = part
        written += part.nbytes
    return len(restrip.faces_of(device[:mesh.index_count]))


print(f"at first: {draw()} triangles in {mesh.strip_count} strips, {written} bytes written")
written = 0
for _ in range(200):
    sides = (4 * np.arange(mesh.triangle_bound)[:, None] + np.arange(3)).ravel()
    longest = max(sides[mesh.check_each("bisect", sides) == 0], key=lambda h: abs(points[mesh.ends(h)[0]][2] - points[mesh.ends(h)[1]][2]))
    v, w = mesh.ends(longest)
    points.append(tuple((p + q) / 2 for p, q in zip(points[v], points[w])))
    new = mesh.bisect(longest)
    assert mesh.ends(new.halfedge)[1] == len(points) - 1
    draw()
print(f"after 200 bisections: {draw()} triangles in {mesh.strip_count} strips, {written // 200} bytes written for each")
mesh.improve(100_000)
print(f"after improving: {draw()} triangles in {mesh.strip_count} strips; valid: {mesh.check().valid}")
