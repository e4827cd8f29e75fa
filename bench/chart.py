"""Charts as SVG with logarithmic axes, readable in light and dark; series differ in marker and dashes, not in hue alone."""
import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 860, 460, 74, 190, 18, 58
STYLE = """
  svg { --surface: #fff; --ink: #1f2328; --faint: #d1d9e0; --a: #0a5bbd; --b: #b3400e; --c: #59636e; font: 13px system-ui, sans-serif; }
  @media (prefers-color-scheme: dark) { svg { --surface: #0d1117; --ink: #e6edf3; --faint: #3d444d; --a: #6cb6ff; --b: #f0935a; --c: #9aa4af; } }
  .surface { fill: var(--surface); } text { fill: var(--ink); } .grid { stroke: var(--faint); } .mark { stroke: var(--c); stroke-dasharray: 2 5; }
  .a { --hue: var(--a); } .b { --hue: var(--b); } .c { --hue: var(--c); }
  .line { fill: none; stroke: var(--hue); stroke-width: 2; } .dot { fill: var(--hue); stroke: none; } text.name { fill: var(--hue); }
"""
DASHES = ["", "7 4", "2 4", "10 4 2 4"]


def _ticks(low, high):
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    return [10.0**d for d in decades if low * 0.999 <= 10.0**d <= high * 1.001]


def _short(value):
    for limit, suffix in ((1e6, "M"), (1e3, "k")):
        if value >= limit:
            return f"{value / limit:g}{suffix}"
    return f"{value:g}"


def _marker(kind, x, y):
    shapes = [f'<circle class="dot" cx="{x:.1f}" cy="{y:.1f}" r="4"/>',
              f'<rect class="dot" x="{x - 3.8:.1f}" y="{y - 3.8:.1f}" width="7.6" height="7.6"/>',
              f'<path class="dot" d="M{x:.1f} {y - 5:.1f}l5 9h-10z"/>', f'<path class="dot" d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z"/>']
    return shapes[kind % len(shapes)]


def log_chart(x_label, y_label, series, description, marks=(), each_named=False):
    """`series`: (name, class a/b/c, [(x, y, name), …]); `marks`: (x, text) vertical lines. With `each_named` there are no lines
    and every point bears its name."""
    points = [(x, y) for _, _, line in series for x, y, *_ in line]
    low_x, high_x = min(p[0] for p in points), max(p[0] for p in points)
    low_y, high_y = min(p[1] for p in points), max(p[1] for p in points)
    low_x, high_x, low_y, high_y = low_x / 1.3, high_x * 1.3, low_y / 1.5, high_y * 1.5

    def at(x, y):
        across = math.log(x / low_x) / math.log(high_x / low_x)
        up = math.log(y / low_y) / math.log(high_y / low_y)
        return LEFT + across * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - up * (HEIGHT - TOP - BOTTOM)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" role="img">', f"<title>{escape(description)}</title>",
           f"<style>{STYLE}</style>", '<rect class="surface" width="100%" height="100%"/>']
    for tick in _ticks(low_x, high_x):
        x, _ = at(tick, low_y)
        out.append(f'<path class="grid" d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
                   f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{_short(tick)}</text>')
    for tick in _ticks(low_y, high_y):
        _, y = at(low_x, tick)
        out.append(f'<path class="grid" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>'
                   f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{_short(tick)}</text>')
    for value, text in marks:
        if low_x < value < high_x:
            x, _ = at(value, low_y)
            out.append(f'<path class="mark" d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
                       f'<text x="{x + 4:.1f}" y="{TOP + 12}">{escape(text)}</text>')
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2:.0f}" y="{HEIGHT - 14}" text-anchor="middle">{escape(x_label)}</text>')
    middle = (TOP + HEIGHT - BOTTOM) / 2
    out.append(f'<text transform="translate(18 {middle:.0f}) rotate(-90)" text-anchor="middle">{escape(y_label)}</text>')

    names = []
    taken = []

    def free(x, y, text):
        """A height for a name at x, near y, where no name stands yet; seven units a letter are enough."""
        height = next((y + off for off in (0, 15, -15, 30, -30)
                       if all(abs(y + off - b) > 13 or x + 7 * len(text) < a or a + 7 * length < x for a, b, length in taken)), y)
        taken.append((x, height, len(text)))
        return height

    for number, (name, kind, line) in enumerate(series):
        spots = [at(x, y) for x, y, *_ in line]
        out.append(f'<g class="{kind}">')
        if not each_named:
            way = "L".join(f"{x:.1f} {y:.1f}" for x, y in spots)
            out.append(f'<path class="line" stroke-dasharray="{DASHES[number % len(DASHES)]}" d="M{way}"/>')
            names.append([spots[-1][1], name, kind])
        for (x, y), (a, b, *label) in zip(spots, line):
            tip = " ".join(label) or name
            out.append(f"<g><title>{escape(f'{tip}: {a:,.4g}, {b:,.4g}')}</title>{_marker(number, x, y)}</g>")
            if each_named:
                out.append(f'<text class="name" x="{x + 8:.1f}" y="{free(x, y, tip) + 4:.1f}">{escape(tip)}</text>')
        out.append("</g>")
    # Names beside the ends of their lines, apart from each other.
    names.sort()
    floor = TOP
    for y, name, kind in names:
        floor = max(y + 4, floor + 15)
        out.append(f'<text class="name {kind}" x="{WIDTH - RIGHT + 8}" y="{floor:.1f}">{escape(name)}</text>')
    out.append("</svg>\n")
    return "\n".join(out)
