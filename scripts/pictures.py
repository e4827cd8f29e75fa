"""Pictures as inline SVG: plots of lines and of bars, and the patches of vertex splits.

No scripts and no fixed colours: the page's style sheet names them (PLOT_STYLE, PATCH_STYLE), light and dark. Series differ in
colour by family and in marker and dashes within one, so that nobody depends on hue. The same bytes on every machine.
"""
import math
from dataclasses import dataclass, field

# Vermilion, blue and grey differ for every kind of colour vision, and in lightness.
PLOT_STYLE = """:root { --surface: #ffffff; --ink: #1c1e21; --faint: #d9dce1; --soft: #5a6068;
  --ours: #0b5cad; --paper: #c2410c; --scratch: #6b7280; }
@media (prefers-color-scheme: dark) { :root { --surface: #16181c; --ink: #e8eaed; --faint: #363b43; --soft: #a4abb5;
  --ours: #6cb6ff; --paper: #ff9e64; --scratch: #9aa3af; } }
svg.plot { width: 100%; max-width: 760px; min-width: 540px; height: auto; font: 13px system-ui, sans-serif; overflow: visible; }
.plot text { fill: var(--ink); } .plot .tick { fill: var(--soft); font-size: 12px; }
.plot .grid { stroke: var(--faint); stroke-width: 1; }
.plot .line { fill: none; stroke: var(--series); stroke-width: 2; }
.plot .mark { fill: var(--series); stroke: var(--surface); stroke-width: 1; }
.plot .ring { fill: none; stroke: var(--series); stroke-width: 2; }
.plot .bar { fill: var(--series); }
.plot .reference { stroke: var(--ink); stroke-width: 1.5; stroke-dasharray: 5 3; }
.ours { --series: var(--ours); } .paper { --series: var(--paper); } .scratch { --series: var(--scratch); }
.member1 .line { stroke-dasharray: 8 3; } .member2 .line { stroke-dasharray: 3 3; }
.member3 .line { stroke-dasharray: 10 3 2 3; } .member4 .line { stroke-dasharray: 14 4; }
"""

PATCH_STYLE = """:root { --old: #e3f2fd; --new: #ffe082; --rim: #7a8794; --solid: #c2185b; --dashed: #6b7280; }
@media (prefers-color-scheme: dark) { :root { --old: #24405c; --new: #8a6414; --rim: #8d9aa8; --solid: #ff77b0;
  --dashed: #c3cad3; } }
.patch { width: 100%; max-width: 150px; height: auto; } .old { fill: var(--old); } .new { fill: var(--new); }
.old, .new { stroke: var(--rim); stroke-width: 1.5; } .solid, .dashed { fill: none; }
.solid { stroke: var(--solid); stroke-width: 9; stroke-linecap: round; }
.dashed { stroke: var(--dashed); stroke-width: 3; stroke-dasharray: 9 8; }
.node { fill: none; stroke: var(--solid); stroke-width: 17; stroke-linecap: round; }
"""


def escaped(text):
    """Text that is safe between tags and inside quoted attributes."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def grouped(number):
    """69451 as 69,451."""
    return f"{number:,}"


# ---- plots


@dataclass
class Axis:
    label: str  # with its unit
    logarithmic: bool = False


@dataclass
class Series:
    name: str
    family: str  # ours, paper, scratch: a colour each
    member: int  # of the family: chooses marker and dashes
    points: list  # (x, y), ascending x; on a logarithmic axis those that are not positive are left out
    markers_only: bool = False  # rings, around what another series marks


@dataclass
class Bar:
    name: str
    family: str
    value: float
    text: str  # the value as written beside the bar


@dataclass
class BarPlot:
    """Horizontal bars from 0 to `top`; `reference`, where positive, is a line across all bars."""

    label: str  # of the values, with their unit
    top: float = 100
    bars: list = field(default_factory=list)
    reference: float = 0
    reference_text: str = ""


LEFT, RIGHT, TOP, BOTTOM = 72, 560, 14, 330  # where the lines are drawn, inside the margins


class Scale:
    """From values to places along one axis."""

    def __init__(self, logarithmic, low, high, start, end):
        self.logarithmic, self.start, self.end = logarithmic, start, end
        self.ticks = self._log_ticks(low, high) if logarithmic else self._even_ticks(low, high)

    def place(self, value):
        low, high = self._along(self.ticks[0]), self._along(self.ticks[-1])
        return self.start + (self.end - self.start) * (self._along(value) - low) / (high - low)

    def _along(self, value):
        return math.log10(value) if self.logarithmic else value

    @staticmethod
    def _log_ticks(low, high):
        ticks = []
        few = math.log10(high / low) < 2.5
        decade = math.floor(math.log10(low) + 1e-9)
        while len(ticks) < 2 or ticks[-1] < high:
            for step in (1.0, 2.0, 5.0) if few else (1.0,):
                if len(ticks) > 1 and ticks[-1] >= high:
                    break
                ticks.append(step * 10.0**decade)
            decade += 1
        # Steps wholly below the lowest value go.
        while len(ticks) > 2 and ticks[1] <= low:
            del ticks[0]
        return ticks

    @staticmethod
    def _even_ticks(low, high):
        # The smallest of 1, 2, 5, 10, 20, … that makes at most eight steps.
        step, n = 1.0, 0
        while (high - low) / step > 8:
            step *= 2.5 if n % 3 == 1 else 2
            n += 1
        ticks = [math.floor(low / step) * step]
        while len(ticks) < 2 or ticks[-1] < high:
            ticks.append(ticks[-1] + step)
        return ticks


def _label(value):
    return grouped(int(value)) if value >= 1 and value == math.floor(value) else f"{value:g}"


def _marker(series, x, y):
    if series.markers_only:  # a ring around the place, where another series may have its marker
        return f'<circle class="ring" cx="{x:.1f}" cy="{y:.1f}" r="7"/>'
    return [f'<circle class="mark" cx="{x:.1f}" cy="{y:.1f}" r="4"/>',
            f'<rect class="mark" x="{x - 3.5:.1f}" y="{y - 3.5:.1f}" width="7" height="7"/>',
            f'<path class="mark" d="M{x:.1f},{y - 5:.1f}l5,5l-5,5l-5,-5z"/>',
            f'<path class="mark" d="M{x:.1f},{y - 5.5:.1f}l5,8.5h-10z"/>'][series.member % 4]


def _text(style, x, y, anchor, words):
    return f'<text class="{style}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escaped(words)}</text>\n'


def _line(style, x1, y1, x2, y2):
    return f'<line class="{style}" x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}"/>\n'


def _opening(width, height, description):
    return f'<svg class="plot" viewBox="0 0 {width:.0f} {height:.0f}" role="img" aria-label="{escaped(description)}">\n'


def _spread_out(places, gap, lowest):
    """Moves labels apart that would be written over each other, as little as a pass from above and one from below can."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    last = -1e9
    for i in order:
        last = places[i] = max(places[i], last + gap)
    following = lowest + gap
    for i in reversed(order):
        following = places[i] = min(places[i], following - gap)
    return places


def line_plot(x, y, series, description):
    """Lines with their names beside their ends; each marker tells its values when pointed at. Empty without a point."""
    def shown(line):
        return [p for p in line.points if (not x.logarithmic or p[0] > 0) and (not y.logarithmic or p[1] > 0)]

    points = [p for s in series for p in shown(s)]
    if not points:
        return ""
    across = Scale(x.logarithmic, min(p[0] for p in points), max(p[0] for p in points), LEFT, RIGHT)
    low = min(p[1] for p in points) if y.logarithmic else min(0, *(p[1] for p in points))
    up = Scale(y.logarithmic, low, max(p[1] for p in points), BOTTOM, TOP)
    svg = _opening(760, 385, description)
    for tick in up.ticks:
        svg += _line("grid", LEFT, up.place(tick), RIGHT, up.place(tick))
        svg += _text("tick", LEFT - 8, up.place(tick) + 4, "end", _label(tick))
    for tick in across.ticks:
        svg += _line("grid", across.place(tick), TOP, across.place(tick), BOTTOM)
        svg += _text("tick", across.place(tick), BOTTOM + 18, "middle", _label(tick))
    svg += _text("axis", (LEFT + RIGHT) / 2, BOTTOM + 42, "middle", x.label)
    svg += (f'<text class="axis" transform="translate(14 {(TOP + BOTTOM) / 2:.1f}) rotate(-90)" '
            f'text-anchor="middle">{escaped(y.label)}</text>\n')

    ends = []
    for s in series:
        spots = [(across.place(a), up.place(b), a, b) for a, b in shown(s)]
        svg += f'<g class="{s.family} member{s.member}">'
        if not s.markers_only:
            path = "".join(f"{'L' if i else 'M'}{a:.1f},{b:.1f}" for i, (a, b, _, _) in enumerate(spots))
            svg += f'<path class="line" d="{path}"/>'
        for a, b, value, height in spots:
            svg += (f"<g>{_marker(s, a, b)}<title>{escaped(s.name)}: {_label(value)} {escaped(x.label)}, {_label(height)} "
                    f"{escaped(y.label)}</title></g>")
        svg += "</g>\n"
        ends.append(spots[-1][1] if spots else BOTTOM)
    for s, at in zip(series, _spread_out(ends, 17, BOTTOM)):
        svg += f'<g class="{s.family} member{s.member}">'
        if not s.markers_only:
            svg += f'<path class="line" d="M{RIGHT + 16:.1f},{at:.1f}h26"/>'
        svg += _marker(s, RIGHT + 29, at) + "</g>" + _text("name", RIGHT + 48, at + 4, "start", s.name)
    return svg + "</svg>\n"


def bar_plot(plot, description):
    left, right, row, above = 160, 660, 28, 26
    bottom = above + row * len(plot.bars)
    across = Scale(False, 0, plot.top, left, right)
    svg = _opening(760, bottom + 52, description)
    for tick in across.ticks:
        svg += _line("grid", across.place(tick), above, across.place(tick), bottom)
        svg += _text("tick", across.place(tick), bottom + 18, "middle", _label(tick))
    for i, bar in enumerate(plot.bars):
        y = above + row * i + 5
        width = max(across.place(bar.value) - left, 1.0)
        svg += (f'<g class="{bar.family}"><rect class="bar" x="{left:.1f}" y="{y:.1f}" width="{width:.1f}" '
                f'height="{row - 10:.0f}"/><title>{escaped(bar.name)}: {escaped(bar.text)}</title></g>\n')
        svg += _text("name", left - 8, y + 14, "end", bar.name) + _text("value", 742, y + 14, "end", bar.text)
    if plot.reference > 0:
        at = across.place(plot.reference)
        svg += _line("reference", at, above - 6, at, bottom) + _text("value", at, above - 12, "middle", plot.reference_text)
    return svg + _text("axis", (left + right) / 2, bottom + 42, "middle", plot.label) + "</svg>\n"


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

    def _stroke(self, start, end, solid):
        self.strokes["solid" if solid else "dashed"] += f"M{start[0]:.1f},{start[1]:.1f}L{end[0]:.1f},{end[1]:.1f}"

    def join(self, i, j, across, solid):
        self._stroke(self.nodes[i], across, solid)
        self._stroke(across, self.nodes[j], solid)

    def port(self, i, a, b, solid):
        node, door = self.nodes[i], _middle(a, b)
        self._stroke(node, tuple(d + (d - n) * 0.7 for d, n in zip(door, node)), solid)

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
