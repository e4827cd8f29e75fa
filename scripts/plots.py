"""Plots of lines, of bars and of named points, as inline SVG or as separate files.

No scripts, and no fixed colours: the style sheet names them (PLOT_STYLE), light and dark. Series differ in colour by family
and in marker and line pattern within one, so that they can be distinguished without colours. The same bytes on every machine.
"""
import math
from dataclasses import dataclass, field

# Vermilion, blue and grey can be distinguished with every kind of colour vision, and differ in lightness.
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

def escaped(text):
    """Text that is safe between tags and inside quoted attributes."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def grouped(number):
    """69451 as 69,451."""
    return f"{number:,}"


@dataclass
class Axis:
    label: str  # with its unit
    logarithmic: bool = False


@dataclass
class Series:
    name: str
    family: str  # ours, paper, scratch: a colour each
    member: int  # of the family: selects marker and line pattern
    points: list  # (x, y), ascending x, or (x, y, name) for named points; what a logarithm cannot show is left out
    markers_only: bool = False  # rings, around what another series marks


@dataclass
class Bar:
    name: str
    family: str
    value: float
    text: str  # the value as written next to the bar


@dataclass
class BarPlot:
    """Horizontal bars from 0 to `top`; `reference`, if positive, is a line across all bars."""

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


def _shown(x, y, series):
    """The points of a series that the axes can show."""
    return [p for p in series.points if (not x.logarithmic or p[0] > 0) and (not y.logarithmic or p[1] > 0)]


def _axes(x, y, points, description):
    """The opening of a plot with its grid, and the scales of both axes."""
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
    return svg, across, up


def _spot(series, x, y, px, py, a, b, name):
    """A marker that shows its values when pointed at."""
    return (f"<g>{_marker(series, px, py)}<title>{escaped(name)}: {_label(a)} {escaped(x.label)}, {_label(b)} "
            f"{escaped(y.label)}</title></g>")


def line_plot(x, y, series, description):
    """Lines with their names at their ends. Empty without a point."""
    points = [p for s in series for p in _shown(x, y, s)]
    if not points:
        return ""
    svg, across, up = _axes(x, y, points, description)
    ends = []
    for s in series:
        spots = [(across.place(a), up.place(b), a, b) for a, b in _shown(x, y, s)]
        svg += f'<g class="{s.family} member{s.member}">'
        if not s.markers_only:
            path = "".join(f"{'L' if i else 'M'}{a:.1f},{b:.1f}" for i, (a, b, _, _) in enumerate(spots))
            svg += f'<path class="line" d="{path}"/>'
        svg += "".join(_spot(s, x, y, *spot, s.name) for spot in spots)
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


def standalone(svg, style=PLOT_STYLE):
    """An inline SVG as a separate file, with a background, for pages that do not know the style sheet."""
    opening, rest = svg.split(">", 1)
    return (f'{opening} xmlns="http://www.w3.org/2000/svg">\n<style>\n{style}</style>\n'
            f'<rect width="100%" height="100%" fill="var(--surface)"/>{rest}')
