#!/usr/bin/env python3
"""Claims: a progressive mesh in Hoppe's format leads to the mesh that its records describe, with and without boundary, whatever
attributes it carries; and a damaged one is refused with a sentence that names it. The files are made here, from random
splits of face lists, by the format's definition alone.

    hoppe_pm_test.py restrip SCRATCH
"""
import pathlib
import random
import struct
import sys

from program import Program
from strip_readers import obj, rotated

run, scratch = Program(sys.argv[1]), pathlib.Path(sys.argv[2])
S_LEFT, S_RIGHT, S_CENTRE = 1 << 4, 1 << 5, 1 << 6
T_LEFT, T_RIGHT, T_CENTRE = 1 << 7, 1 << 8, 1 << 9
L_NEW, R_NEW = 1 << 11, 1 << 13


def f32(x):
    return struct.unpack(">f", struct.pack(">f", x))[0]


class Mesh:
    def __init__(self, rng, faces, rgb, uv, resid, wad2):
        self.rng, self.faces, self.splits = rng, [list(f) for f in faces], []
        self.rgb, self.uv, self.resid, self.wad2 = rgb, uv, resid, wad2
        # Multiples of 1/64, so that sums are exact.
        self.points = [self.place() for _ in range(1 + max(map(max, faces)))]
        self.base = self.base_bytes()

    def place(self):
        return [self.rng.randrange(-4096, 4096) / 64 for _ in range(3)]

    def attributes(self):
        return b"".join(struct.pack(">f", self.rng.uniform(-1, 1)) for _ in range(3 + 3 * self.rgb + 2 * self.uv))

    def base_bytes(self):
        wedges = list(range(len(self.points))) + [self.rng.randrange(len(self.points)) for _ in range(3)]
        text = f"nmaterials=2\nmatid=0\na material\nnvertices={len(self.points)} nwedges={len(wedges)} nfaces={len(self.faces)}\n"
        data = text.encode() + b"".join(struct.pack(">3f", *p) for p in self.points)
        data += b"".join(struct.pack(">i", v) + self.attributes() for v in wedges)
        for face in self.faces:
            data += struct.pack(">3i", *(self.rng.choice([w for w, of in enumerate(wedges) if of == v]) for v in face))
            data += struct.pack(">H", self.rng.randrange(2))
        return data

    def fan(self, v):
        """The faces around v, clockwise, and whether v lies on the boundary; then the first has no one before it."""
        after = {}  # the face whose edge v -> w is shared with the one that has w -> v
        faces = [f for f, face in enumerate(self.faces) if v in face]
        leaves = {self.faces[f][(self.faces[f].index(v) + 1) % 3]: f for f in faces}
        enters = {self.faces[f][(self.faces[f].index(v) + 2) % 3]: f for f in faces}
        for w, f in leaves.items():
            if w in enters:
                after[f] = enters[w]
        first = [f for f in faces if f not in after.values()]
        fan = [first[0] if first else self.rng.choice(faces)]
        while after.get(fan[-1], fan[0]) != fan[0]:
            fan.append(after[fan[-1]])
        return fan, bool(first)

    def split(self):
        rng = self.rng
        while True:
            v_s = rng.randrange(len(self.points))
            fan, boundary = self.fan(v_s)
            kind = rng.choice("two two one none".split()) if boundary else "two"
            if kind == "none":
                named, moved, turn = fan[-1], [], 0
            elif kind == "one" and len(fan) > 1:
                first = rng.randrange(1, len(fan))
                named, moved, turn = fan[first], fan[first:], 1
            elif kind == "two" and len(fan) > 1 + boundary:
                first = 1 if boundary else 0
                end = rng.randrange(first + 1, len(fan))
                first = rng.randrange(first, end)
                named, moved, turn = fan[first], fan[first:end], end - first + 1
            else:
                continue
            break
        v_t, face = len(self.points), self.faces[named]
        corner = face.index(v_s)
        v_l = face[(corner + (1 if turn == 0 else 2)) % 3]
        new = [[v_s, v_t, v_l]]
        if turn > 1:
            last = self.faces[moved[-1]]
            new.append([v_s, last[(last.index(v_s) + 1) % 3], v_t])
        for f in moved:
            self.faces[f] = [v_t if v == v_s else v for v in self.faces[f]]
        self.faces += new

        centre, large, small = rng.randrange(3), self.place(), self.place()
        old = self.points[v_s]
        middle = [a + b for a, b in zip(old, small)]
        far = [a + b for a, b in zip(old, large)]
        self.points[v_s], t = {2: (middle, far), 0: (far, middle), 1: (
            [a - b for a, b in zip(middle, large)], [a + b for a, b in zip(middle, large)])}[centre]
        self.points.append(t)

        code = rng.getrandbits(14) & ~0xF & ~(1 << 10) & ~(1 << 12)
        if turn < 2:
            code = (code | S_RIGHT | T_RIGHT) & ~(S_CENTRE | T_CENTRE | R_NEW)
        wedges = 2 if not code & (S_LEFT | T_LEFT) else 1
        if turn > 1:
            s_new, t_new = not code & S_CENTRE, not code & T_CENTRE
            wedges += s_new + t_new if not code & (S_RIGHT | T_RIGHT) else (s_new, s_new or t_new, t_new)[centre]
        wedges += bool(code & L_NEW) + bool(code & R_NEW)
        materials = rng.choice((0, 0, 1 << 14, 1 << 15, 3 << 14)) if turn > 1 else 0
        data = struct.pack(">iHH", named, turn, code | materials | centre << 2 | corner)
        data += struct.pack(">2H", 1, 1) if materials else b""
        data += struct.pack(">6f", *large, *small)
        data += b"".join(self.attributes() for _ in range(2 if self.wad2 else wedges))
        self.splits.append(data + (struct.pack(">2f", 1, 2) if self.resid else b""))

    def bytes(self, version=2):
        text = f"# by a test\nPM\nversion={version}\nnvsplits={len(self.splits)} nvertices={len(self.points)} nwedges=0 " \
               f"nfaces={len(self.faces)}\nbbox 0 0 0  1 1 1\nhas_rgb={self.rgb}\nhas_uv={self.uv}\nhas_resid={self.resid}\n"
        text += "has_wad2=1\n" if self.wad2 else ""
        return text.encode() + b"PM base mesh:\n" + self.base + b"".join(self.splits) + b"\xFFEnd of PM\n"


def at_places(points, triangles):
    return sorted(rotated([tuple(points[v]) for v in t]) for t in triangles)


def check(name, mesh):
    (scratch / name).write_bytes(mesh.bytes())
    run("replay", scratch / name, "--repeats", 0, "-o", scratch / "top.obj", "--json", scratch / "replay.json")
    wanted = at_places([[f32(x) for x in p] for p in mesh.points], mesh.faces)
    assert at_places(*obj(scratch / "top.obj")) == wanted, name
    printed = run("stats", scratch / name).stdout
    left_out = ["colours"] * mesh.rgb + ["texture coordinates"] * mesh.uv
    assert "left out: " + ", ".join(["normals", "materials", *left_out]) + "\n" in printed, printed


scratch.mkdir(parents=True, exist_ok=True)
TETRAHEDRON = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
PATCH = [(0, 1, 2), (2, 1, 3), (2, 3, 4)]
for seed in range(12):
    rng = random.Random(seed)
    mesh = Mesh(rng, PATCH if seed % 2 else TETRAHEDRON, *(rng.randrange(2) for _ in range(4)))
    for _ in range(60):
        mesh.split()
    check(f"mesh-{seed}.pm", mesh)


def refused(data, *words):
    (scratch / "bad.pm").write_bytes(data)
    message = run("stats", scratch / "bad.pm", code=2).stderr
    assert "bad.pm" in message and all(w in message for w in words), (words, message)


mesh = Mesh(random.Random(99), PATCH, 1, 0, 1, 0)
for _ in range(5):
    mesh.split()
good = mesh.bytes()
(scratch / "good.pm").write_bytes(good)
run("stats", scratch / "good.pm")
for size in range(1, len(good) - 10, 31):
    refused(good[:size])
refused(mesh.bytes(version=1), "version 1; only 2 is read")
for old, new, words in ((b"nvsplits=5", b"nvsplits=6", "ends among its records"), (b"nvsplits=5", b"nvsplits=4", "does not end after"),
                        (b"nvsplits=5", b"nvsplits=4000000000", "more than its remaining"),
                        (b"nvsplits=5", b"nvsplits=x", "no number nvsplits"), (b"nwedges=8", b"nwedges=900000", "900000 wedges"),
                        (b"nvertices=5", b"nvertices=4", ""), (b"nmaterials=2", b"nmaterials=9999", "inside its header"),
                        (b"has_rgb=1", b"has_rgb=0", "")):
    assert old in good
    refused(good.replace(old, new), words)
for at, value, words in ((0, struct.pack(">i", 99), "split 1 (counted from 0) names no corner of a face"),
                         (4, struct.pack(">H", 40), "split 1 (counted from 0) turns further"),
                         (6, struct.pack(">H", 3), "split 1 (counted from 0) names no corner")):
    begin = good.index(mesh.splits[1]) + at
    refused(good[:begin] + value + good[begin + len(value):], words)
# Two tetrahedra that share a vertex: not manifold there, so its split is not supported.
pinched = Mesh(random.Random(5), TETRAHEDRON + [(3, 4, 5), (3, 5, 6), (3, 6, 4), (4, 6, 5)], 0, 0, 0, 0)
pinched.splits.append(struct.pack(">iHH6f3f", 1, 2, 2 | 2 << 2 | 0x3F0, *[1] * 9))
refused(pinched.bytes(), "split 0 (counted from 0) cannot be done", "not a manifold")
print("Hoppe's progressive meshes: all hold")
