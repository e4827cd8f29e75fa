#!/usr/bin/env python3
"""Pictures as SVG: the patches of vertex splits, and a mesh coloured by strip.

As a program it draws what `restrip draw -o picture.json` writes: scripts/pictures.py picture.json picture.svg
"""
import json
import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # nothing but the picture is written, least of all into the source tree

from plots import escaped

PATCH_STYLE = """:root { --old: #e3f2fd; --new: #ffe082; --rim: #7a8794; --solid: #c2185b; --dashed: #6b7280; }
@media (prefers-color-scheme: dark) { :root { --old: #24405c; --new: #8a6414; --rim: #8d9aa8; --solid: #ff77b0;
  --dashed: #c3cad3; } }
.patch { width: 100%; max-width: 150px; height: auto; } .old { fill: var(--old); } .new { fill: var(--new); }
.old, .new { stroke: var(--rim); stroke-width: 1.5; } .solid, .dashed { fill: none; }
.solid { stroke: var(--solid); stroke-width: 9; stroke-linecap: round; }
.dashed { stroke: var(--dashed); stroke-width: 3; stroke-dasharray: 9 8; }
.node { fill: none; stroke: var(--solid); stroke-width: 17; stroke-linecap: round; }
"""


# ---- patches (docs/notation.md numbers their edges)

def _middle(*places):
    return sum(p[0] for p in places) / len(places), sum(p[1] for p in places) / len(places)


def _rim(k, a):
    """The rim of a fan, counter-clockwise as seen (y points down in a drawing), turned so that the first arc is below. It is
    closed: k + 1 places, the last one the first again, so that triangle i lies between places i and i + 1."""
    step = 2 * math.pi / k
    start = math.pi / 2 + step * a / 2
    places = [(200 + 150 * math.cos(start - step * i), 200 + 150 * math.sin(start - step * i)) for i in range(k)]
    return places + places[:1]


class _Patch:
    """Triangles with their dual graph on top, in a square of 400 units."""

    def __init__(self):
        self.faces, self.strokes, self.nodes = {"old": "", "new": ""}, {"dashed": "", "solid": ""}, []

    def add(self, a, b, c, style="old"):
        self.faces[style] += "M" + "L".join(f"{p[0]:.1f},{p[1]:.1f}" for p in (a, b, c)) + "z"
        self.nodes.append(_middle(a, b, c))
        return len(self.nodes) - 1

    def stroke(self, start, end, solid):
        self.strokes["solid" if solid else "dashed"] += f"M{start[0]:.1f},{start[1]:.1f}L{end[0]:.1f},{end[1]:.1f}"

    def join(self, i, j, across, solid):
        self.stroke(self.nodes[i], across, solid)
        self.stroke(across, self.nodes[j], solid)

    def port(self, i, a, b, solid):
        node, door = self.nodes[i], _middle(a, b)
        self.stroke(node, tuple(d + (d - n) * 0.7 for d, n in zip(door, node)), solid)

    def svg(self, description):
        nodes = "".join(f"M{x:.1f},{y:.1f}h0" for x, y in self.nodes)
        paths = {**self.faces, **self.strokes, "node": nodes}
        return (f'<svg class="patch" viewBox="5 5 390 390" role="img" aria-label="{escaped(description)}">' +
                "".join(f'<path class="{style}" d="{d}"/>' for style, d in paths.items() if d) + "</svg>")


def fan_picture(k, a, loop, ports, description):
    """The closed fan before a split, as triangles around a vertex."""
    places, center, patch = _rim(k, a), (200, 200), _Patch()
    for i in range(k):
        patch.add(center, places[i], places[i + 1])
    for i in range(k):
        patch.join(i, (i + 1) % k, _middle(center, places[i + 1]), loop >> i & 1)
        patch.port(i, places[i], places[i + 1], ports >> i & 1)
    return patch.svg(description)


def split_picture(k, a, inner, ports, description):
    """The ring with chord after it: the two ends of the new edge, the triangles A and D between the arcs."""
    places, patch = _rim(k, a), _Patch()

    def toward(first, last):  # v_s owns the first arc, v_t the second; each moves toward its own side
        x, y = _middle(*places[first:last + 1])
        return 200 + (x - 200) * 0.45, 200 + (y - 200) * 0.45

    v_s, v_t = toward(0, a), toward(a, k)
    for i in range(k):
        patch.add(v_s if i < a else v_t, places[i], places[i + 1])
    node_a = patch.add(v_s, v_t, places[0], "new")
    node_d = patch.add(v_t, v_s, places[a], "new")
    ring = [node_a, *range(a), node_d, *range(a, k)]
    for j in range(k + 2):
        first = j <= a
        across = _middle(v_s if first else v_t, places[j if first else j - 1])
        patch.join(ring[j], ring[(j + 1) % (k + 2)], across, inner >> j & 1)
    patch.join(node_a, node_d, _middle(v_s, v_t), inner >> (k + 2) & 1)
    for i in range(k):
        patch.port(i, places[i], places[i + 1], ports >> i & 1)
    return patch.svg(description)


def arc_picture(word, links, description):
    """An arc of a fan (docs/automaton.md): a triangle for each letter but `b`, the mesh boundary, which is a gap. Behind a
    solid port the strip goes on about the corner at the left (l, L) or at the right (r, R), or ends (s, S)."""
    hub, width = (200, 100), math.radians(min(40, 110 / len(word)))
    start = math.pi / 2 + width * len(word) / 2
    rim = [(200 + 200 * math.cos(start - width * i), 100 + 200 * math.sin(start - width * i)) for i in range(len(word) + 1)]
    patch, nodes = _Patch(), {}
    for i, letter in enumerate(word):
        if letter != "b":
            nodes[i] = patch.add(hub, rim[i], rim[i + 1])
    for i, solid in enumerate(links):
        across = _middle(hub, rim[i], rim[i])
        angle = start - width * i
        for at, side in ((i - 1, 1), (i, -1)):  # the triangle before the link, and the one behind it
            if at not in nodes:
                continue
            patch.stroke(patch.nodes[nodes[at]], across, solid)
            if (i - 1 if at == i else i) not in nodes:  # the link leaves the arc
                patch.stroke(across, (across[0] + side * 22 * math.sin(angle), across[1] - side * 22 * math.cos(angle)), solid)
    for i, letter in enumerate(word):
        if letter == "b":
            continue
        patch.port(nodes[i], rim[i], rim[i + 1], letter != "d")
        if letter in "lLrR":
            node, door = patch.nodes[nodes[i]], _middle(rim[i], rim[i + 1])
            behind = tuple(d + (d - n) * 0.7 for d, n in zip(door, node))
            corner = rim[i] if letter in "lL" else rim[i + 1]
            patch.stroke(behind, tuple(b + (c - d) * 0.7 for b, c, d in zip(behind, corner, door)), True)
    return patch.svg(description)


# ---- a mesh

SIZE, CAPTION = 400, 40  # of a square picture, and below it
PICTURE_STYLE = """svg { --surface: #ffffff; --ink: #222222; --edge: #444444; }
@media (prefers-color-scheme: dark) { svg { --surface: #0d1117; --ink: #e6edf3; --edge: #000000; } }
text { fill: var(--ink); font: 17px sans-serif; } .mesh { stroke: var(--edge); stroke-width: 0.7; }
"""


def _seen(point):
    """From above and in front; the depth decides what hides what."""
    tilt = 0.9
    x, y, z = point
    return x, y * math.cos(tilt) - z * math.sin(tilt), y * math.sin(tilt) + z * math.cos(tilt)


def _strip_color(strip):
    """Colours that differ from one strip to the next: hues by the golden ratio."""
    return f"hsl({360 * (0.618033988749895 * (strip + 1) % 1):.0f} 65% {55 + 12 * (strip % 3)}%)"


def mesh_picture(points, strips, description):
    """The triangles that face the viewer, far ones first, each strip in a colour of its own."""
    seen = [_seen(point) for point in points]
    used = [seen[v] for strip in strips for corners in strip for v in corners]
    left, right, low, high = (limit(p[axis] for p in used) for axis in (0, 1) for limit in (min, max))
    scale = (SIZE - 20) / max(right - left, high - low, 1e-30)

    def place(at):
        return f"{SIZE / 2 + (at[0] - (left + right) / 2) * scale:.1f},{SIZE / 2 - (at[1] - (low + high) / 2) * scale:.1f}"

    faces = []
    for number, strip in enumerate(strips):
        for corners in strip:
            p, q, r = (seen[v] for v in corners)
            if (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0:
                faces.append((p[2] + q[2] + r[2], corners, number, " ".join(map(place, (p, q, r)))))
    polygons = "".join(f'<polygon points="{at}" fill="{_strip_color(number)}"/>\n' for _, _, number, at in sorted(faces))
    return (f'<svg class="mesh" viewBox="0 0 {SIZE} {SIZE}" role="img" aria-label="{escaped(description)}">\n{polygons}</svg>')


def side_by_side(panels, style):
    """Pictures with captions: a whole SVG file."""
    width = SIZE * len(panels)
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {SIZE + CAPTION}">\n<style>\n{style}</style>\n'
           '<rect width="100%" height="100%" fill="var(--surface)"/>\n')
    for i, (picture, caption) in enumerate(panels):
        svg += (f'<svg x="{SIZE * i}" width="{SIZE}" height="{SIZE}">{picture}</svg>\n'
                f'<text x="{SIZE * i + SIZE // 2}" y="{SIZE + CAPTION // 2 + 2}" text-anchor="middle">{escaped(caption)}</text>\n')
    return svg + "</svg>\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    facts = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    rule = facts["rule"]
    mesh, fan = "a mesh coloured by strip", f"a {rule['k']}-vertex; solid: strip, dashed: no strip"
    after = "split, and repaired by its rule"
    svg = side_by_side([(mesh_picture(facts["points"], facts["strips"], mesh), mesh),
                        (fan_picture(rule["k"], rule["a"], rule["loop"], rule["ports"], fan), fan),
                        (split_picture(rule["k"], rule["a"], rule["inner"], rule["ports"], after), after)],
                       PATCH_STYLE.replace(".patch { width: 100%; max-width: 150px; height: auto; } ", "") + PICTURE_STYLE)
    Path(sys.argv[2]).write_text(svg, encoding="utf-8")


if __name__ == "__main__":
    main()
