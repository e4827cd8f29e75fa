#!/usr/bin/env python3
"""Pictures as SVG: the patches of operations, and a mesh coloured by strip.

As a program it draws what `restrip draw -o picture.json` writes: scripts/pictures.py picture.json picture.svg
Of an operation file (docs/reference/operation-file.md) it draws the patch before and after, with the numbers of triangles, inner edges and
ports; with --certificate (docs/reference/certificate.md) its rules as well.
"""
import argparse
import json
import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # nothing but the picture is written, least of all into the source tree

from operations import Refused, certificate, configurations, pairs_of, positions_of, strips_added, strips_left
from plots import escaped
from surfaces import drawings

PATCH_STYLE = """:root { --old: #e3f2fd; --new: #ffe082; --rim: #7a8794; --solid: #c2185b; --dashed: #6b7280; }
@media (prefers-color-scheme: dark) { :root { --old: #24405c; --new: #8a6414; --rim: #8d9aa8; --solid: #ff77b0;
  --dashed: #c3cad3; } }
.patch { width: 100%; max-width: 150px; height: auto; } .old { fill: var(--old); } .new { fill: var(--new); }
.old, .new { stroke: var(--rim); stroke-width: 1.5; } .solid, .dashed { fill: none; }
.solid { stroke: var(--solid); stroke-width: 9; stroke-linecap: round; }
.dashed { stroke: var(--dashed); stroke-width: 3; stroke-dasharray: 9 8; }
.node { fill: none; stroke: var(--solid); stroke-width: 17; stroke-linecap: round; }
"""


# ---- patches (docs/reference/notation.md numbers their edges)

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
        self.faces, self.strokes, self.nodes, self.names = {"old": "", "new": ""}, {"dashed": "", "solid": ""}, [], ""

    def name(self, text, at):
        self.names += f'<text class="name" x="{at[0]:.1f}" y="{at[1]:.1f}">{escaped(text)}</text>'

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
                "".join(f'<path class="{style}" d="{d}"/>' for style, d in paths.items() if d) + self.names + "</svg>")


def side_picture(side, colors, ports, description, letter=""):
    """One of surfaces.drawings(). With a letter everything is named: inner edges by it, ports by p."""
    at, patch = side["corners"], _Patch()
    for a, b, c, style in side["triangles"]:
        patch.add(at[a], at[b], at[c], style)
    for i, (u, v, a, b) in enumerate(side["edges"]):
        patch.join(u, v, _middle(at[a], at[b]), colors >> i & 1)
    for i, (u, a, b) in enumerate(side["ports"]):
        patch.port(u, at[a], at[b], ports >> i & 1)
    if letter:
        vertices, triangles = side["names"]
        names = []
        for text, (x, y) in zip(vertices, at):
            away = math.hypot(x - 200, y - 200) or 1
            names.append((text, (x + 16 * (x - 200) / away, y + 16 * (y - 200) / away)))
        for i, (*_, a, b) in enumerate(side["edges"]):
            names.append((f"{letter}{i}", _middle(at[a], at[b])))
        for i, (u, a, b) in enumerate(side["ports"]):
            door = _middle(at[a], at[b])
            names.append((f"p{i}", tuple(d + (d - n) * 0.7 for d, n in zip(door, patch.nodes[u]))))
        # A triangle's name is around its node, in the direction that has most room.
        around = [(19 * math.sin(math.pi * i / 4), 19 * math.cos(math.pi * i / 4)) for i in range(8)]
        for text, (x, y) in zip(triangles, patch.nodes):
            places = [(round(x + dx, 1), round(y + dy, 1)) for dx, dy in around]
            names.append((text, max(places, key=lambda place: min(math.hypot(0.7 * (place[0] - p[0]), place[1] - p[1]) for _, p in names))))
        for text, place in names:
            patch.name(text, place)
    return patch.svg(description)


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
    """An arc of a fan (docs/explanation/automaton.md): a triangle for each letter but `b`, the mesh boundary, which is a gap."""
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
        for at, side in ((i - 1, 1), (i, -1)):  # the triangles before and after the link
            if at not in nodes:
                continue
            patch.stroke(patch.nodes[nodes[at]], across, solid)
            if (i - 1 if at == i else i) not in nodes:  # the link leaves the arc
                patch.stroke(across, (across[0] + side * 22 * math.sin(angle), across[1] - side * 22 * math.cos(angle)), solid)
    for i, letter in enumerate(word):
        if letter != "b":
            patch.port(nodes[i], rim[i], rim[i + 1], letter != "d")
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
    """The triangles that face the viewer, far ones first, each strip in a separate colour."""
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


PATCHES = PATCH_STYLE.replace(".patch { width: 100%; max-width: 150px; height: auto; } ", "") + PICTURE_STYLE
NAMES = (".name { font-size: 15px; text-anchor: middle; dominant-baseline: central; paint-order: stroke; stroke: var(--surface); "
         "stroke-width: 4px; }\n")


def sheet(rows, style):
    """Rows of pictures with captions: a whole SVG file."""
    width, height = SIZE * max(map(len, rows)), SIZE + CAPTION
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height * len(rows)}">\n<style>\n{style}</style>\n'
           '<rect width="100%" height="100%" fill="var(--surface)"/>\n')
    for y, row in enumerate(rows):
        for x, (picture, caption) in enumerate(row):
            svg += (f'<svg x="{SIZE * x}" y="{height * y}" width="{SIZE}" height="{SIZE}">{picture}</svg>\n'
                    f'<text x="{SIZE * x + SIZE // 2}" y="{height * y + SIZE + 10}" text-anchor="middle">{escaped(caption)}</text>\n')
    return svg + "</svg>\n"


def side_by_side(panels, style):
    """Pictures with captions: a whole SVG file."""
    width = SIZE * len(panels)
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {SIZE + CAPTION}">\n<style>\n{style}</style>\n'
           '<rect width="100%" height="100%" fill="var(--surface)"/>\n')
    for i, (picture, caption) in enumerate(panels):
        svg += (f'<svg x="{SIZE * i}" width="{SIZE}" height="{SIZE}">{picture}</svg>\n'
                f'<text x="{SIZE * i + SIZE // 2}" y="{SIZE + CAPTION // 2 + 2}" text-anchor="middle">{escaped(caption)}</text>\n')
    return svg + "</svg>\n"


def mesh_sheet(facts):
    rule = facts["rule"]
    mesh, fan = "a mesh coloured by strip", f"a {rule['k']}-vertex; solid: strip, dashed: no strip"
    after = "split, and repaired by its rule"
    return side_by_side([(mesh_picture(facts["points"], facts["strips"], mesh), mesh),
                         (fan_picture(rule["k"], rule["a"], rule["loop"], rule["ports"], fan), fan),
                         (split_picture(rule["k"], rule["a"], rule["inner"], rule["ports"], after), after)], PATCHES)


def rule_panels(position, section, sides):
    """Of each rule a patch before that has its key, and its answer."""
    constraint, known = position.description.constraint, configurations([position], section)
    for ports, joined, colors, kept, _ in section.rules:
        _, _, inner = known[ports, joined]
        change = strips_added(position, strips_left(position.before, constraint, inner.bit_count(), ports.bit_count()), colors, ports, kept)
        pairs = ", ".join(f"p{i} and p{j}" for i, j in pairs_of(joined))
        caption = f"rule {ports:x},{joined:x}" + (f": joins {pairs}" if pairs else "")
        what = "triangles alone" if constraint == "matching" else "strips"
        yield (ports, joined), [(side_picture(sides[0], inner, ports, caption), caption),
                                (side_picture(sides[1], colors, kept, f"{what}: {change:+d}"), f"{what}: {change:+d}")]


def operation_sheet(path, cert, rule):
    positions = list(positions_of(path))
    if len(positions) != 1:
        raise Refused(f"{path}: describes {len(positions)} positions; web/atlas/atlas.py draws all of them")
    position, = positions
    try:
        (before,), (after,) = drawings([position.before], [position.after])
    except Refused as fault:
        raise Refused(f"{path}: {fault}") from None
    name = position.description.name
    rows = [[(side_picture(side, 0, 0, f"{name}, {when}", letter), f"{name}: {when}")
             for side, when, letter in ((before, "before", "e"), (after, "after", "f"))]]
    if cert:
        named, sections = certificate(cert)
        keys = {key[:2] for section in sections for key in section.rules + section.copies}
        if named != position.description.certificate or len(sections) != 1 or set(configurations([position], sections[0])) != keys:
            raise Refused(f"{cert}: is not a certificate of {path}")
        panels = [panel for key, panel in rule_panels(position, sections[0], (before, after)) if rule in (None, key)]
        if not panels:
            raise Refused(f"{cert}: has no row rule {rule[0]:x} {rule[1]:x}")
        rows += [[each for panel in panels[n:n + 2] for each in panel] for n in range(0, len(panels), 2)]
    return sheet(rows, PATCHES + NAMES)


def key(word):
    ports, joined = word.split(",")
    return int(ports, 16), int(joined, 16)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=Path, help="what restrip draw wrote, or an operation file")
    parser.add_argument("out", type=Path, help="the SVG file that is written")
    parser.add_argument("--certificate", type=Path, help="of the operation, whose rules are drawn as well")
    parser.add_argument("--rule", type=key, metavar="P,J", help="the rule of these solid ports and joined pairs alone, as its row in the certificate begins")
    given = parser.parse_args()
    if given.rule and not given.certificate:
        parser.error("--rule: wants the --certificate that has it")
    try:
        facts = json.loads(given.file.read_text(encoding="utf-8"))
        svg = mesh_sheet(facts) if "points" in facts else operation_sheet(given.file, given.certificate, given.rule)
    except (OSError, ValueError) as fault:
        sys.exit(f"pictures.py: {given.file}: {fault}")
    except Refused as fault:
        sys.exit(f"pictures.py: {fault}")
    given.out.write_text(svg, encoding="utf-8")


if __name__ == "__main__":
    main()
