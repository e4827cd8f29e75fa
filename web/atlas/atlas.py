#!/usr/bin/env python3
"""Makes the atlas: a page for each section of the certificates, with a row for each of their rules, and an index.

atlas.py CERTIFICATES OUT --met CSV --style FILE… --script FILE…
Reads tables/certificates (docs/certificate.md); what it says of a rule it reads there or counts from
docs/notation.md. How often splits meet a rule it reads in met.csv, which scripts/met_rules.mjs wrote of real meshes."""
import argparse
import csv
import sys
from collections import defaultdict
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.path.insert(0, str(ROOT / "web"))
from bundle import inlined  # noqa: E402
from pictures import fan_picture, split_picture  # noqa: E402
from plots import escaped, grouped  # noqa: E402

FAMILIES = {  # in this order: what one reads, and whether the fan is closed
    "split": ("Vertex splits inside the mesh", True), "collapse": ("Edge collapses inside the mesh", True),
    "flip": ("Edge flips", True), "open-split": ("Splits at the boundary, two new triangles", False),
    "boundary-split": ("Splits along the boundary, one new triangle", False),
    "fan-collapse": ("Collapses at the boundary", False)}


def bits(mask):
    return [i for i in range(mask.bit_length()) if mask >> i & 1]


# ---- certificates

class Section:
    def __init__(self, family, words):
        self.family, self.words = family, words
        numbers = dict(zip(words[::2], words[1::2])) if words != ["flip"] else {}
        self.k = int(numbers.get("k", 4))
        self.places = [int(w) for w in words[3:]]
        self.claims, self.rules, self.copies = {}, [], []
        self.name = "-".join([family, *(w for w in words if w.isdigit())])

    @property
    def closed(self):
        return FAMILIES[self.family][1]

    def keys(self, ports, joined, colors, kept):
        """A row as the pages show it: by the mask of ports joined to the one before, of a flip by its inner edge."""
        pairs = {frozenset((i, j)) for j in range(self.k) for i in range(j) if joined >> (j * (j - 1) // 2 + i) & 1}
        if self.family != "flip":
            return [[ports, mask_of_pairs(ports, pairs, self.closed), colors]]
        return [[ports, inner, kept, colors] for inner in (0, 1) if flip_pairs(ports, inner) == pairs]

    def name_of(self, ports, joined):
        """Of the rule of a fan: by its key as the certificate has it."""
        pairs = map(sorted, joined_pairs(self.k, ports, joined, self.closed))
        return f"{self.name}-{ports:x}-{sum(1 << j * (j - 1) // 2 + i for i, j in pairs):x}"

    def title(self):
        if self.family == "flip":
            return "The flip"
        at = {"split": "a = %d", "open-split": "gaps %d and %d", "boundary-split": "gap %d"}.get(self.family, "")
        return f"{FAMILIES[self.family][0]}: k = {self.k}" + (", " + at % tuple(self.places) if at else "")


def reason(words):
    """The case tree, from words; returns it and the words left."""
    if words[0] == "if":
        edge = int(words[1])
        solid, rest = reason(words[3:])
        dashed, rest = reason(rest[1:])
        return (edge, solid, dashed), rest
    sets = []
    while words and words[0] != "else":
        if words[0] != "-":
            sets.append(int(words[0], 16))
        words = words[1:]
    return sets, words


def read(path):
    sections = []
    lines = path.read_text(encoding="ascii").split("\n")
    if lines[0] != "restrip-certificate 3" or not lines[-2].startswith("end "):
        sys.exit(f"atlas.py: {path}: is no certificate, or not whole")
    family = lines[1].split()[1]
    rows = 0
    for number, line in enumerate(lines[2:-2], start=3):
        words = line.split()
        if words[0] == "section":
            sections.append(Section(family, words[1:]))
        elif words[0] == "claim":
            sections[-1].claims[words[1]] = int(words[2])
        elif words[0] == "rule":
            rows += 1
            at = words.index("because")
            tree, rest = reason(words[at + 1:])
            if rest:
                sys.exit(f"atlas.py: {path}:{number}: the reason goes on: {' '.join(rest)}")
            sections[-1].rules += [(key, tree) for key in sections[-1].keys(*(int(w, 16) for w in words[1:at]))]
        elif words[0] == "copy":
            rows += 1
            at = words.index("by")
            to = [int(w) for w in words[at + 1:]]
            sections[-1].copies += [(key, to) for key in sections[-1].keys(*(int(w, 16) for w in words[1:at]))]
        else:
            sys.exit(f"atlas.py: {path}:{number}: a line that is not known: {line}")
    if rows != int(lines[-2].split()[1]):
        sys.exit(f"atlas.py: {path}: has {rows} rows, not as many as it says")
    return sections


# ---- keys

def joined_pairs(k, ports, joined, closed):
    solid = bits(ports)
    pairs = set()
    for n, port in enumerate(solid):
        if joined >> port & 1 and (closed or n > 0):
            pairs.add(frozenset((port, solid[n - 1])))
    return pairs


def mask_of_pairs(ports, pairs, closed):
    solid, out = bits(ports), 0
    for n, port in enumerate(solid):
        if (closed or n > 0) and frozenset((port, solid[n - 1])) in pairs and len(solid) > 1:
            out |= 1 << port
    return out


def key_after(k, ports, joined, closed, to):
    moved = sum(1 << to[i] for i in bits(ports))
    pairs = {frozenset(to[i] for i in pair) for pair in joined_pairs(k, ports, joined, closed)}
    return moved, mask_of_pairs(moved, pairs, closed)


def flip_pairs(ports, inner):
    """The pairs of ports that two triangles join before a flip, p_0 and p_1 at one, p_2 and p_3 at the other; None when
    one has three solid edges."""
    sides = [[i for i in bits(ports) if i // 2 == side] for side in (0, 1)]
    if any(len(side) + inner > 2 for side in sides):
        return None
    groups = [sides[0] + sides[1]] if inner else sides
    return {frozenset((i, j)) for group in groups for i in group for j in group if i < j}


def configurations(k, closed):
    """By key: how many valid fans have it, their fewest and most solid loop edges, and a loop with the most."""
    out = {}
    length = k if closed else k - 1
    for loop in range(1 << length):
        if closed and loop == (1 << k) - 1:
            continue  # a solid cycle
        two = loop & (loop << 1 | loop >> (k - 1)) if closed else loop & loop << 1
        free = [i for i in range(k) if not two >> i & 1]
        for choice in range(1 << len(free)):
            ports = sum(1 << free[n] for n in bits(choice))
            solid, joined = bits(ports), 0
            for n, port in enumerate(solid):
                if n == 0 and (not closed or len(solid) == 1):
                    continue
                i, whole = solid[n - 1], True
                while i != port and whole:
                    whole = bool(loop >> i & 1)
                    i = (i + 1) % k
                joined |= whole << port
            if closed and len(solid) == 2 and joined:
                joined = ports
            count, low, high, example = out.get((ports, joined), (0, 99, -1, 0))
            n = loop.bit_count()
            out[ports, joined] = (count + 1, min(low, n), max(high, n), loop if n > high else example)
    return out


def split_order(closed, k, places):
    """The nodes of a patch with its new triangles, in the order of its inner edges, 't' numbers and 'A', 'D'; whether the last
    is joined to the first; whether there is a chord."""
    t = list(range(k))
    if closed:
        a, = places
        return ["A", *t[:a], "D", *t[a:]], True, True
    if len(places) == 2:
        i, j = places
        return [*t[:i], "A", *t[i:j], "D", *t[j:]], False, True
    i, = places
    return [*t[:i], "A", *t[i:]], False, False


def order_after(section):
    if "split" in section.family:
        return split_order(section.closed, section.k, section.places)
    return list(range(section.k)), section.closed, False


def strips_within(nodes, edges):
    """The two ends of each strip that solid edges make of the nodes (a lonely node twice); none if they are no strips."""
    beside = {node: [] for node in nodes}
    for a, b in edges:
        beside[a].append(b)
        beside[b].append(a)
    if any(len(there) > 2 for there in beside.values()):
        return None
    ends, seen = [], set()
    for node in nodes:
        if node in seen or len(beside[node]) == 2:
            continue
        last, here = None, node
        while here is not None:
            seen.add(here)
            last, here = here, next((there for there in beside[here] if there not in seen), None)
        ends.append((node, last))
    return ends if len(seen) == len(nodes) else None  # what is left are cycles


def before_collapses(k, closed):
    """By key: how many valid patches before a collapse have it, at all positions, and of those with the fewest solid edges the
    first, as its position and inner edges."""
    places = ([(a,) for a in range(1, k // 2 + 1)] if closed else
              [(i, j) for i in range(k + 1) for j in range(i + 1, k - i + 1)] + [(i,) for i in range(k // 2 + 1)])
    shapes = {}  # by the triangles that may have a port, and which two of them are the ends of a strip
    for place in places:
        nodes, ring, chord = split_order(closed, k, place)
        edges = list(zip(nodes, nodes[1:] + nodes[:1] if ring else nodes[1:]))
        edges += [("A", "D")] if chord else []
        for inner in range(1 << len(edges)):
            ends = strips_within(nodes, [edge for n, edge in enumerate(edges) if inner >> n & 1])
            if ends is None:
                continue
            pairs = tuple(pair for pair in ends if pair[0] != pair[1] and "A" not in pair and "D" not in pair)
            free = sum(1 << node for node in {node for pair in ends for node in pair} if isinstance(node, int))
            count, best = shapes.get((free, pairs), (0, (99,)))
            shapes[free, pairs] = (count + 1, min(best, (inner.bit_count(), place, inner)))
    out = {}
    for (free, pairs), (count, best) in shapes.items():
        joined_to = dict(pairs) | {b: a for a, b in pairs}
        ports = free
        while True:
            solid, joined = bits(ports), 0
            for n, port in enumerate(solid):
                if len(solid) > 1 and (closed or n > 0) and joined_to.get(port) == solid[n - 1]:
                    joined |= 1 << port
            known, least = out.get((ports, joined), (0, (99,)))
            out[ports, joined] = (known + count, min(least, best))
            if ports == 0:
                break
            ports = (ports - 1) & free
    return {key: (count, *best[1:]) for key, (count, best) in out.items()}


def isolated_after(section, ports, colors):
    order, ring, chord = order_after(section)
    degree = defaultdict(int, {i: ports >> i & 1 for i in range(section.k)})
    joints = len(order) if ring else len(order) - 1
    for j in range(joints):
        if colors >> j & 1:
            degree[order[j]] += 1
            degree[order[(j + 1) % len(order)]] += 1
    if chord and colors >> joints & 1:
        degree["A"] += 1
        degree["D"] += 1
    return sum(degree[node] == 0 for node in order)


# ---- words

def in_words(tree):
    if isinstance(tree, tuple):
        edge, solid, dashed = tree
        return f"<i>f{edge} solid:</i> {in_words(solid)} <i>f{edge} dashed:</i> {in_words(dashed)}"
    if not tree:
        return "no other edge need be dashed."
    return "not all of " + ", nor of ".join("{" + " ".join(f"f{i}" for i in bits(s)) + "}" for s in tree) + "."


def numbers(mask):
    return " ".join(map(str, bits(mask))) or "–"


def signed(n):
    return f"+{n}" if n > 0 else str(n).replace("-", "−")


def met_at(met, section):
    """Splits of real meshes at the position of this section."""
    return sum(n for name, n in met.items() if name.startswith(f"{section.name}-"))


def often(met, name):
    """Of 10,000 splits of real meshes, how many meet this rule; in words."""
    if met.get(name, 0) == 0:
        return "–"
    share = 10000 * met[name] / sum(met.values())
    return f"{share:.2f}" if share >= 0.01 else "under 0.01"


def row(section, group, orbit, known, key, colors, tree, met):
    ports, joined = key
    name = section.name_of(ports, joined)
    pairs = " ".join(f"{a}–{b}" for a, b in sorted(sorted(p) for p in joined_pairs(section.k, ports, joined, section.closed)))
    # Only the fan before a split has loop edges to be counted.
    splits = "split" in section.family
    _, low, high, example = known[key] if splits else (0, 0, 0, 0)
    count, place, inner = (0, (), 0) if splits else known[key]
    more = "" if splits else f' data-before="{" ".join(map(str, (inner, *place)))}"'
    kinds = []
    cost = ""
    if splits:
        new = 1 if section.family == "boundary-split" else 2
        changes = [new - colors.bit_count() + n for n in (low, high)]
        cost = signed(changes[0]) if low == high else f"{signed(changes[0])} to {signed(changes[1])}"
        kinds += ["costs"] if changes[1] > 0 else []
    kinds += ["alone"] if isolated_after(section, ports, colors) else []
    kinds += ["symmetric"] if orbit < group else []
    if name in met:
        kinds.append("met")
        more += f' data-met="{met[name]}"'
    picture = ""
    if section.family == "split" and section.k <= 4:
        picture = (fan_picture(section.k, section.places[0], example, ports, "before") +
                   split_picture(section.k, section.places[0], colors, ports, "after"))
    cells = [f'<a href="#{name}">{name.removeprefix(section.name + "-")}</a>', numbers(ports), pairs or "–", numbers(colors)]
    cells += [cost] if splits else [grouped(count)]
    cells += [often(met, name)] if section.family == "split" else []
    cells += [str(orbit), in_words(tree)]
    return (f'<tr id="{name}" class="{" ".join(kinds)}" data-k="{ports} {joined} {example} {colors}"{more}>'
            f'<td class="pic">{picture}</td>' + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")


WHY = """<p>Why nothing is better: of the edges in a pair of braces at least one must stay dashed. If all of them were solid, a
triangle would have three solid edges, a cycle would close, or two ports would be joined that were not joined before. The
sets share no edge, so each takes a dashed edge of its own. In none of the cases does the rule leave more edges dashed than
that, or as many and more triangles alone.</p>"""
LEGEND = ('<p class="legend"><i class="key solid"></i> same strip <i class="key dashed"></i> different strips '
          '<i class="key fresh"></i> new triangles</p>')
NOTES = {
    "split": "f0 … f{k1} lead around the ring A, t0 … , D, … and back to A; f{k2} joins the two new triangles A and D.",
    "collapse": "f0 … f{km} are the loop edges of the fan that is left: f0 joins t0 and t1. A rule depends only on the ports and on "
                "which of them are joined before, so it serves every position and many patches. One with the fewest solid edges is drawn.",
    "fan-collapse": "f0 … are the loop edges of the open fan that is left: f0 joins t0 and t1. A rule depends only on the ports and on "
                    "which of them are joined before, so it serves both kinds of collapse at the boundary, every position, and many "
                    "patches. One with the fewest solid edges is drawn.",
    "open-split": "f0 … f{k} lead along the path of all triangles; f{k1} joins the two new triangles.",
    "boundary-split": "f0 … f{km} lead along the path of all triangles."}


def section_page(section, known, met, page):
    orbits = defaultdict(lambda: 1)
    for key, to in section.copies:
        orbits[key_after(section.k, key[0], key[1], section.closed, to)] += 1
    rules = {tuple(key[:2]) for key, _ in section.rules}
    if not set(orbits) <= rules:
        sys.exit(f"atlas.py: {section.name}: a copy has no rule")
    split_in_halves = section.family == "split" and 2 * section.places[0] == section.k
    palindrome = {"split": True, "open-split": section.places and sum(section.places) == section.k,
                  "boundary-split": section.places and 2 * section.places[0] == section.k}.get(section.family, True)
    group = 2 * section.k if section.family == "collapse" else 4 if split_in_halves else 2 if palindrome else 1
    rows = "\n".join(row(section, group, orbits[tuple(k[:2])], known, tuple(k[:2]), k[2], tree, met) for k, tree in section.rules)
    claims = section.claims
    k = section.k
    note = NOTES[section.family].format(k=k, k1=k + 1, k2=k + 2, km=k - 1)
    columns = ["", "rule", "solid ports", "joined before", "solid edges after"]
    columns += ["change in strips"] if "split" in section.family else ["patches before, one of them drawn"]
    columns += ["met by 10,000 splits"] if section.family == "split" else []
    columns += ["in its orbit", "why nothing is better"]
    costs = claims["costing"]
    facts = (f"{grouped(claims['configurations'])} configurations, {grouped(claims['valid'])} of them valid. "
             f"They need {grouped(len(section.rules) + len(section.copies))} rules" +
             (f"; {grouped(len(section.rules))} are listed here, the others are their mirror images"
              f"{' and turns' if section.family == 'collapse' or split_in_halves else ''}. " if section.copies else ". ") +
             ("No rule adds a strip." if costs == 0 and claims["worst-strips"] <= 0 else
              f"In {grouped(costs)} configurations the best rule adds a strip; none adds more than {claims['worst-strips']}."))
    filters = "".join(f'<label><input type="checkbox" name="{n}"> {w}</label>' for n, w in
                      ((("costs", "adds a strip somewhere"),) if "split" in section.family else ()) +
                      (("alone", "leaves a triangle alone"), ("symmetric", "is its own mirror image or turn")) +
                      ((("met", "met on real meshes"),) if section.family == "split" else ()))
    sorting = '<label><input type="checkbox" id="often"> most often met first</label>' if section.family == "split" else ""
    if section.family == "split":
        facts += (f" Of the splits of four real meshes, from 2 % of their triangles up, {100 * met_at(met, section) / sum(met.values()):.1f} % are at this "
                  f"position; they meet {grouped(rows.count(' data-met='))} of these rules.")
    body = (f'<h1>{escaped(section.title())}</h1><div id="names"></div><p>{facts}</p><p>{note} The ports keep their colours, in the rule and in all that it is compared with.</p>{WHY}'
            '<p>A solid port is a strip that leaves the patch. A rule may join two of them only if they were joined before. '
            'The theorem <code>all_correct</code> (verify/formal/Answers.v, checked by Coq) says that what the library answers here is '
            'sound and that nothing sound is preferred to it.</p>'
            f'{LEGEND}<form id="filter" hidden>{filters}{sorting}<label>solid ports <input name="ports" size="10" placeholder="0 3"></label>'
            '<output></output></form>'
            f'<div class="wide"><table id="rules" data-family="{section.family}" data-n="{k}" data-at="{" ".join(map(str, section.places))}">'
            f'<thead><tr>{"".join(f"<th>{c}</th>" for c in columns)}</tr></thead><tbody>\n{rows}\n</tbody></table></div>')
    return page(section.title(), body)


def flip_page(section, page):
    rows = []
    orbits = defaultdict(lambda: 1)
    for (ports, inner, *_), to in section.copies:
        orbits[sum(1 << to[i] for i in bits(ports)), inner] += 1
    for (ports, inner, kept, after), tree in section.rules:
        name = f"flip-{ports:x}-{inner:x}"
        change = inner + ports.bit_count() - after - kept.bit_count()
        words = in_words(tree).replace("f0", "the inner edge")
        for i in range(4):
            words = words.replace(f"f{i + 1}", f"p{i}")
        rows.append(f'<tr id="{name}" class="{"costs" if change > 0 else ""}" data-k="{ports} {inner} {kept} {after}"><td class="pic"></td>'
                    f'<td><a href="#{name}">{ports:x}-{inner:x}</a></td><td>{numbers(ports)}</td><td>{"solid" if inner else "dashed"}</td>'
                    f'<td>{numbers(kept)}</td><td>{"solid" if after else "dashed"}</td><td>{signed(change)}</td><td>{orbits[ports, inner]}</td><td>{words}</td></tr>')
    columns = ["", "rule", "solid ports", "inner edge before", "ports kept", "inner edge after", "change in strips", "in its orbit", "why nothing is better"]
    body = (f'<h1>The flip</h1><p>Two triangles share an edge; the flip replaces it by the other diagonal. {section.claims["valid"]} '
            f'valid configurations of {section.claims["configurations"]}. A flip may have to give a port up: two ports that '
            'come to hang on one triangle would otherwise be joined, and the strips outside might close a cycle. Coq checks the '
            'answers of the library for flips in verify/formal/Flip.v.</p>' + WHY +
            LEGEND + '<form id="filter" hidden><label><input type="checkbox" name="costs"> adds a strip</label><output></output></form>'
            '<div class="wide"><table id="rules" data-family="flip" data-n="4" data-at=""><thead><tr>' +
            "".join(f"<th>{c}</th>" for c in columns) + "</tr></thead><tbody>\n" + "\n".join(rows) + "\n</tbody></table></div>")
    return page("The flip", body)


def index_page(families, picture, met, page):
    body = ("<h1>Atlas of rules</h1>"
            "<p>A strip is a path through triangles that share an edge. When a vertex is split, two triangles come into the mesh and "
            "cut the paths around it. A <em>rule</em> says how the edges of that patch are to be coloured afterwards, solid where a "
            "strip goes on and dashed where it does not, so that as few strips as possible remain, whatever the rest of the mesh looks "
            "like. Each rule here is proved: no recolouring that keeps the <em>ports</em>, the edges that lead out of the patch, and "
            "is safe in every mesh leaves fewer strips. (Only the rules of flips may cut a strip at a port.)</p>" + picture +
            '<p><a class="button" href="paint.html">Paint a configuration and see its rule</a></p>')
    total = 0
    for family, (title, _) in FAMILIES.items():
        sections = families[family]
        rows = ""
        with_met = family == "split"
        for s in sections:
            total += len(s.rules)
            rows += (f'<tr><td><a href="{s.name}.html">{escaped(s.title().split(": ")[-1])}</a></td><td>{grouped(len(s.rules))}</td>'
                     f'<td>{grouped(s.claims["valid"])}</td><td>{grouped(s.claims["costing"])}</td><td>{signed(s.claims["worst-isolated"])}</td>'
                     + (f"<td>{100 * met_at(met, s) / sum(met.values()):.1f} %</td>" if with_met else "") + "</tr>")
        table = ('<div class="wide"><table class="index"><thead><tr><th></th><th>rules</th><th>valid configurations</th><th>of which cost a strip</th>'
                 f'<th>most triangles isolated</th>{"<th>splits of real meshes</th>" if with_met else ""}</tr></thead><tbody>{rows}</tbody></table></div>')
        shown = table if len(sections) < 20 else f"<details><summary>{len(sections)} positions</summary>{table}</details>"
        body += f"<h2>{title}</h2>{shown}"
    body += (f"<p>{grouped(total)} rules in all, for vertices of up to 8 triangles. For larger ones a finite automaton answers, exactly "
             "as well; the painter asks it.</p>")
    return page("Atlas of rules", body)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("certificates", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--met", type=Path, required=True)
    parser.add_argument("--style", nargs="+", required=True)
    parser.add_argument("--script", nargs="+", required=True)
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "atlas.css").write_text("".join(Path(s).read_text(encoding="utf-8") for s in given.style), encoding="utf-8")
    (given.out / "atlas.js").write_text("(() => {\n" + inlined(given.script) + "\n})();\n", encoding="utf-8")

    def page(title, body):
        return ('<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
                f'<meta name="color-scheme" content="light dark">\n<title>{escaped(title)} – restrip</title>\n<link rel="icon" href="data:,">\n'
                '<link rel="stylesheet" href="atlas.css">\n<script src="atlas.js" defer></script>\n<body>\n'
                '<nav><a href="../index.html">restrip</a> <a href="../viewer.html">Viewer</a> <a href="index.html">Atlas of rules</a></nav>\n'
                f'<main>{body}</main>\n</body>\n</html>\n')

    with given.met.open(encoding="ascii", newline="") as file:
        met = {name: sum(map(int, counts)) for name, *counts in list(csv.reader(file))[1:]}
    families = {family: read(given.certificates / f"{family}.cert") for family in FAMILIES}
    known = {}
    for family, sections in families.items():
        for section in sections:
            shape = (section.k, section.closed, "collapse" in family)
            if family != "flip" and shape not in known:
                known[shape] = before_collapses(*shape[:2]) if shape[2] else configurations(*shape[:2])
                if shape[2] and sum(count for count, *_ in known[shape].values()) != section.claims["valid"]:
                    sys.exit(f"atlas.py: {section.name}: the keys have not as many configurations as the certificate says")
            text = flip_page(section, page) if family == "flip" else section_page(section, known[shape], met, page)
            (given.out / f"{section.name}.html").write_text(text, encoding="utf-8")
    chosen = next((key, tree) for key, tree in families["split"][4].rules if len(bits(key[0])) == 3)
    (ports, joined, colors), _ = chosen
    loop = known[5, True, False][ports, joined][3]
    picture = ('<div class="pictures"><figure>' + fan_picture(5, 2, loop, ports, "before") + "<figcaption>before the split</figcaption></figure><figure>" +
                     split_picture(5, 2, colors, ports, "after") + "<figcaption>after it, by its rule</figcaption></figure></div>" + LEGEND)
    rules = {s.name_of(*key[:2]) for s in families["split"] for key, _ in s.rules}
    if stray := set(met) - rules - {"boundary", "larger"}:
        sys.exit(f"atlas.py: {given.met}: {min(stray)} is no rule of the certificates; make the file anew")
    (given.out / "index.html").write_text(index_page(families, picture, met, page), encoding="utf-8")


if __name__ == "__main__":
    main()
