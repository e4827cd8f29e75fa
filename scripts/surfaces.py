"""Patches as triangles in the plane. Where a file names no vertices, the triangles are laid so that they make a disc and one meets the
ports in ascending order along its rim."""
import itertools
import math

from operations import Refused

# Sides of a triangle: ("edge", n), ("port", n), ("rim", triangle, n) on the boundary of the mesh.


def orders(side, n):
    """The orders in which the sides of triangle n may follow each other."""
    there = [("edge", e) for e, ends in enumerate(side.edges) if n in ends] + [("port", p) for p, owner in enumerate(side.owners) if owner == n]
    if len(there) > 3:
        raise Refused("a triangle has more than three edges and ports")
    first, *rest = there + [("rim", n, i) for i in range(3 - len(there))]
    return [(first, *rest)] if len(there) < 2 else [(first, *rest), (first, *rest[::-1])]


def walks(side):
    """Each way to lay the triangles along one rim that has all ports in ascending order, as the orders of sides and the rim."""
    options = [orders(side, n) for n in range(len(side.names))]
    outside = len(side.owners) + sum(option[0].count(s) for option in options for s in option[0] if s[0] == "rim")

    def walk(chosen, n, at, rim):
        """From side `at` of triangle n, whose end is the next corner of the rim."""
        if n not in chosen:
            for option in options[n]:
                yield from walk({**chosen, n: option}, n, at, rim)
            return
        after = chosen[n][(chosen[n].index(at) + 1) % 3]
        if after[0] == "edge":
            u, v = side.edges[after[1]]
            yield from walk(chosen, v if u == n else u, after, rim)
        elif after == rim[0][1]:
            if len(rim) == outside:
                left = [m for m in range(len(options)) if m not in chosen]
                for more in itertools.product(*(options[m] for m in left)):
                    yield {**chosen, **dict(zip(left, more))}, rim
        elif after[0] == "rim" or after[1] == sum(s[0] == "port" for _, s in rim):
            yield from walk(chosen, n, after, rim + [(n, after)])

    return walk({}, side.owners[0], ("port", 0), [(side.owners[0], ("port", 0))])


class Surface:
    """A side with the three vertices of each triangle."""

    def __init__(self, side, corners, rim):
        self.side, self.corners, self.rim = side, corners, rim  # rim: (number of the port or None, start, end)
        self.vertices = list(dict.fromkeys(v for triangle in corners for v in triangle))

    @property
    def gaps(self):
        """By port, how many edges of the boundary follow it along the rim."""
        out = []
        for port, *_ in self.rim:
            if port is not None:
                out.append(0)
            else:
                out[-1] += 1
        return out


def laid(side, order, rim):
    """The surface of these orders of sides; none if it is not a disc."""
    corner = {(n, s): (n, s) for n, sides in order.items() for s in sides}  # where side s of triangle n starts

    def top(start):
        while corner[start] != start:
            start = corner[start]
        return start

    def end(n, s):
        return n, order[n][(order[n].index(s) + 1) % 3]

    for e, (u, v) in enumerate(side.edges):
        corner[top((u, ("edge", e)))] = top(end(v, ("edge", e)))
        corner[top((v, ("edge", e)))] = top(end(u, ("edge", e)))
    vertices = {start: i for i, start in enumerate(dict.fromkeys(top(start) for start in corner))}
    corners = tuple(tuple(vertices[top((n, s))] for s in order[n]) for n in range(len(order)))
    if len(vertices) - len(side.edges) - len(rim) + len(corners) != 1 or any(len(set(c)) < 3 for c in corners):
        return None
    ends = [(s[1] if s[0] == "port" else None, vertices[top((n, s))], vertices[top(end(n, s))]) for n, s in rim]
    return Surface(side, corners, ends)


def surfaces(sides):
    """A surface for each side, all with boundary beyond the same ports, and beyond as few as possible."""
    found = []
    for side in sides:
        every = [Surface(side, side.corners, side.rim)] if side.corners else [s for order, rim in walks(side) if (s := laid(side, order, rim))]
        found.append({})
        for surface in every:
            found[-1].setdefault(tuple(n > 0 for n in surface.gaps), surface)
    common = set.intersection(*(set(each) for each in found))
    if not common:
        raise Refused("is a graph only, which has no picture: no disc has its ports in order along the rim, before and after")
    least = min(common, key=lambda gaps: (sum(gaps), gaps))
    return [each[least] for each in found]


RADIUS, MIDDLE = 150, 200  # of the rim, in a picture of 400 units


def places(surface, gaps):
    """Where its vertices are: the rim on a circle, flatter along the boundary; the others each in the middle of their
    neighbours (Tutte: so no two triangles overlap). `gaps` is the part of the circle left to the boundary beyond each port."""
    step = 2 * math.pi / (len(gaps) + sum(gaps))
    widest = max(range(len(gaps)), key=gaps.__getitem__)  # is below
    angle = -math.pi / 2 - step * (sum(gaps[:widest + 1]) - gaps[widest] / 2 + widest + 1) if gaps[widest] else -math.pi / 2 - step / 2

    def on_circle(at):
        return MIDDLE + RADIUS * math.cos(at), MIDDLE - RADIUS * math.sin(at)

    at, out, rim = angle, {}, iter(surface.rim)
    for own, wide in zip(surface.gaps, gaps):
        _, start, _ = next(rim)
        out[start] = on_circle(at)
        at += step
        first, last = on_circle(at), on_circle(at + step * wide)
        for n in range(own):
            _, start, _ = next(rim)
            share = n / own
            out[start] = tuple((arc + p + (q - p) * share) / 2 for arc, p, q in zip(on_circle(at + step * wide * share), first, last))
        at += step * wide
    inside = [v for v in surface.vertices if v not in out]
    nearby = {v: {u for corners in surface.corners if v in corners for u in corners if u != v} for v in inside}
    out.update((v, (MIDDLE, MIDDLE)) for v in inside)
    for _ in range(200):
        for v in inside:
            out[v] = tuple(sum(out[u][axis] for u in sorted(nearby[v], key=str)) / len(nearby[v]) for axis in (0, 1))
    return out


def drawings(before, after):
    """What pictures are made of, for sides before an operation and after it, each as a dictionary: `corners`, places;
    `triangles`, three corners each and whether both sides have it; `edges`, two triangles and the two corners between them;
    `ports`, a triangle and two corners; `names` of corners and triangles."""
    found = surfaces([*before, *after])
    gaps = [max(column) for column in zip(*(surface.gaps for surface in found))]
    out = []
    for n, surface in enumerate(found):
        at, side, others = places(surface, gaps), surface.side, after if n < len(before) else before
        number = {v: i for i, v in enumerate(surface.vertices)}
        kept = {name for other in others for name in other.names}
        shared = [[number[v] for v in surface.corners[i] if v in surface.corners[j]] for i, j in side.edges]
        out.append({
            "corners": [[round(c, 1) for c in at[v]] for v in surface.vertices],
            "triangles": [[*(number[v] for v in corners), "old" if name in kept else "new"] for corners, name in zip(surface.corners, side.names)],
            "edges": [[*ends, *corners] for ends, corners in zip(side.edges, shared)],
            "ports": [[side.owners[port], number[start], number[end]] for port, start, end in surface.rim if port is not None],
            "names": [list(map(str, surface.vertices)) if side.corners else [], [str(i) for i in range(len(side.names))] if side.corners else list(side.names)]})
    return out[:len(before)], out[len(before):]
