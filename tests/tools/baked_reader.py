"""A player of baked meshes by docs/reference/file-formats.md, with no code of restrip's, and the baked mesh in a GLB."""
import struct

from strip_readers import parts_of_glb

PRIME, OFFSET = 0x100000001B3, 0xCBF29CE484222325


def fnv1a(data):
    value = OFFSET
    for byte in data:
        value = (value ^ byte) * PRIME & (1 << 64) - 1
    return value


def sealed(data):
    """With the checksum that belongs to all bytes but the last eight."""
    return data[:-8] + struct.pack("<Q", fnv1a(data[:-8]))


def with_payload(data, each):
    """Version 2, with `each` bytes for a record."""
    assert struct.unpack_from("<I", data, 8) == (1,)
    (records,) = struct.unpack_from("<I", data, 20)
    payload = bytes(i * 7 % 251 for i in range(each * records))
    return sealed(data[:8] + struct.pack("<I", 2) + data[12:24] + struct.pack("<I", each) + data[24:-8] + payload + bytes(8))


def in_glb(path):
    """The bytes of the baked mesh in a GLB; and checks that other programs would show its base."""
    doc, _ = parts_of_glb(path)
    assert "RESTRIP_baked_strips" in doc["extensionsUsed"] and "RESTRIP_baked_strips" not in doc.get("extensionsRequired", [])
    (mesh,) = doc["meshes"]
    view = doc["bufferViews"][mesh["extensions"]["RESTRIP_baked_strips"]["bufferView"]]
    assert "target" not in view and "byteStride" not in view
    data = path.read_bytes()
    (size,) = struct.unpack_from("<I", data, 12)
    begin = 28 + size + view["byteOffset"]
    return data[begin:begin + view["byteLength"]]


class Player:
    """A mesh at its base, in its colours. `solid` has mesh edges, each a set of two vertices."""

    def __init__(self, data):
        assert data[:8] == b"RestripB" and struct.unpack("<Q", data[-8:]) == (fnv1a(data[:-8]),)
        version, points, triangles, self.records = struct.unpack_from("<4I", data, 8)
        self.at = 24 if version == 1 else 28
        (each,) = (0,) if version == 1 else struct.unpack_from("<I", data, 24)
        self.data = data[:len(data) - 8 - each * self.records]
        self.points = [self.take("<3f") for _ in range(points)]
        self.triangles = [list(self.take("<3I")) for _ in range(triangles)]
        self.beyond = {}  # of a directed edge the triangle to its left
        for t in range(triangles):
            self.enter(t)
        self.solid = set()
        for t in range(triangles):
            (colors,) = self.take("<B")
            for s in range(3):
                u, v = self.side(t, s)
                if colors >> s & 1:
                    assert (v, u) in self.beyond
                    self.solid.add(frozenset((u, v)))

    def take(self, form):
        found = struct.unpack_from(form, self.data, self.at)
        self.at += struct.calcsize(form)
        return found

    def number(self):
        value, shift = 0, 0
        while True:
            (byte,) = self.take("<B")
            value |= (byte & 127) << shift
            if byte < 128:
                return value
            shift += 7

    def ascending(self, count):
        found, least = [], 0
        for _ in range(count):
            found.append(least + self.number())
            least = found[-1] + 1
        return found

    def side(self, t, s):
        return self.triangles[t][s], self.triangles[t][(s + 1) % 3]

    def enter(self, t):
        for s in range(3):
            assert self.side(t, s) not in self.beyond
            self.beyond[self.side(t, s)] = t

    def third(self, u, v):
        (w,) = set(self.triangles[self.beyond[u, v]]) - {u, v}
        return w

    def neighbors(self, v):
        found = {w for t in self.triangles if v in t for w in t}
        return sorted(found - {v})

    def split(self):
        """Plays the next record."""
        self.points.append(self.take("<3f"))
        t, s = len(self.points) - 1, self.number()
        ring = self.neighbors(s)
        apexes = divmod(self.number(), len(ring) + 1)
        left, right = (ring[place - 1] if place else None for place in apexes)
        moved = []  # counter-clockwise from right to left
        if right is not None:
            w = right
            while w != left and (s, w) in self.beyond:
                moved.append(self.beyond[s, w])
                w = self.third(s, w)
            assert w == left or left is None
        else:
            w = left
            while (w, s) in self.beyond:
                moved.append(self.beyond[w, s])
                w = self.third(w, s)
        for f in moved:
            for side in range(3):
                del self.beyond[self.side(f, side)]
        # A moved edge keeps its colour; the edge of an apex is cut, and both halves have it.
        for w in {w for f in moved for w in self.triangles[f]} - {s}:
            if frozenset((s, w)) in self.solid:
                self.solid.add(frozenset((t, w)))
                if w not in (left, right):
                    self.solid.remove(frozenset((s, w)))
        for f in moved:
            self.triangles[f] = [t if v == s else v for v in self.triangles[f]]
            self.enter(f)
        for new in ([s, t, left], [t, s, right]):
            if None not in new:
                self.triangles.append(new)
                self.enter(len(self.triangles) - 1)
        added = [f for f in (len(self.triangles) - 2, len(self.triangles) - 1) if {s, t} <= set(self.triangles[f])]
        self.flip(added)

    def flip(self, first):
        head = self.number()
        near = self.ascending(head // 2)
        edges, met, at = [], list(first), 0
        while near and len(edges) <= near[-1]:
            for s in range(3):
                u, v = self.side(met[at], s)
                if (v, u) in self.beyond:
                    if {u, v} not in edges:
                        edges.append({u, v})
                    if self.beyond[v, u] not in met:
                        met.append(self.beyond[v, u])
            at += 1
        flips = [frozenset(edges[i]) for i in near]
        if head % 2:
            flips += [frozenset(self.side(i // 3, i % 3)) for i in self.ascending(self.number())]
        assert len(set(flips)) == len(flips)
        self.solid ^= set(flips)

    def strips(self):
        """The sets of triangles that solid edges join."""
        left, found = set(range(len(self.triangles))), []
        while left:
            strip, open_ones = set(), [min(left)]
            while open_ones:
                f = open_ones.pop()
                if f in strip:
                    continue
                strip.add(f)
                for s in range(3):
                    u, v = self.side(f, s)
                    if frozenset((u, v)) in self.solid:
                        open_ones.append(self.beyond[v, u])
            left -= strip
            found.append(strip)
        return found
