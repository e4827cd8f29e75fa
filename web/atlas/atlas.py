#!/usr/bin/env python3
"""Makes the atlas: a page for each section of the certificates of operations and families, with a row for each of its rules, and an index.

  web/atlas/atlas.py FILE… --certificates FOLDER -o OUT

FILE is an operation file (docs/reference/operation-file.md), FOLDER has its certificate (docs/reference/certificate.md), in itself or in its folder
`operations`. With --met CSV it makes the pages of the project: they link to the viewer and the painter, and say how often
splits of real meshes use a rule, which scripts/met_rules.mjs has counted."""
import argparse
import csv
import json
import re
import sys
from collections import Counter, defaultdict
from pathlib import Path

sys.dont_write_bytecode = True
WEB = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(WEB.parent / "scripts"))
sys.path.insert(0, str(WEB))
from bundle import inlined  # noqa: E402
from pages import head, navigation  # noqa: E402
from operations import Refused, bits, certificate, configurations, pairs_of, positions_of, strips_added  # noqa: E402
from pictures import side_picture  # noqa: E402
from plots import escaped, grouped  # noqa: E402
from surfaces import drawings  # noqa: E402

STYLES = [WEB / "viewer/style.css", WEB / "atlas/atlas.css"]
SCRIPTS = [WEB / "atlas/atlas.mjs"]
LONGEST_PAGE = 450  # rules; a longer section has several pages, split by the number of solid ports
UNITS = {  # what a rule adds, one and several; what solid edges make
    "strips": ("strip", "strips", "strip"),
    "matching": ("triangle left alone", "triangles left alone", "pair")}


class Page:
    """A section with its positions."""

    def __init__(self, section, positions, met):
        self.section, self.positions = section, positions
        self.description, self.after = positions[0].description, positions[0].after
        family = self.description.certificate
        self.name = "-".join([family, *(word for word in section.text.split() if word.isdigit())])
        self.words = in_short(section.text)  # its place in words
        self.title = family.replace("-", " ").capitalize() + (f", {self.words}" if self.words else "")
        self.met = sum(n for rule, n in met.items() if rule.startswith(f"{self.name}-"))  # splits of real meshes at its position
        self.unit, self.units, self.made = UNITS[self.description.constraint]
        self.known = configurations(positions, section)
        rows = section.rules + section.copies
        if {row[:2] for row in rows} != set(self.known) or any(sorted(to) != list(range(len(self.after.owners))) for *_, to in section.copies):
            raise Refused(f"{self.title}: the certificate has not the keys of its description")
        self.orbits = Counter({rule[:2]: 1 for rule in section.rules})
        for ports, joined, *_, to in section.copies:
            pairs = [sorted((to[i], to[j])) for i, j in pairs_of(joined)]
            self.orbits[sum(1 << to[i] for i in bits(ports)), sum(1 << j * (j - 1) // 2 + i for i, j in pairs)] += 1
        self.costing = sum(count for *key, colors, kept, _ in rows for change, count in self.changes(tuple(key), colors, kept).items() if change > 0)
        counted = {"valid": sum(sum(counts.values()) for counts, *_ in self.known.values()), "keys": len(rows), "costing": self.costing}
        for word, number in counted.items():
            if section.claims.get(word) != number:
                raise Refused(f"{self.title}: the certificate claims {word} {section.claims.get(word)}; by its description it is {number}")
        if len(self.orbits) > len(section.rules):
            raise Refused(f"{self.title}: a copy of the certificate has no rule")

    def changes(self, key, colors, kept):
        """How many configurations of a key gain how many strips or triangles alone by this recolouring."""
        return {strips_added(self.positions[0], before, colors, key[0], kept): count for before, count in self.known[key][0].items()}

    def parts(self):
        """The pages of a section: the name of the file, and the numbers of solid ports that its rules have."""
        counts, parts = Counter(ports.bit_count() for ports, *_ in self.section.rules), []
        for ports in sorted(counts):
            if not parts or sum(counts[n] for n in [*parts[-1], ports]) > LONGEST_PAGE:
                parts.append([])
            parts[-1].append(ports)
        return {self.name + (f"-from-{some[0]}" if n else ""): some for n, some in enumerate(parts)}

    def leaves_alone(self, colors, kept):
        met = {n for i in bits(colors) for n in self.after.edges[i]} | {self.after.owners[i] for i in bits(kept)}
        return len(met) < len(self.after.names)


# ---- words

def in_short(text):
    """The place of a section: "k 6 a 3" is "6 triangles, 3 on one side"."""
    numbers = dict(zip(text.split()[::2], text.split()[1::2]))
    if not set(numbers) <= {"k", "a"} or not all(value.isdigit() for value in numbers.values()):
        return text if any(word.isdigit() for word in text.split()) else ""
    k = f"{numbers['k']} triangle{'' if numbers['k'] == '1' else 's'}" if "k" in numbers else ""
    return k + (f", {numbers['a']} on one side" if "a" in numbers else "")


def in_words(tree, edges):
    def name(edge):
        return f"f{edge}" if edge < edges else f"p{edge - edges}"

    if tree is None:
        return "–"
    if isinstance(tree, tuple):
        edge, solid, dashed = tree
        return f"<i>{name(edge)} solid:</i> {in_words(solid, edges)} <i>{name(edge)} dashed:</i> {in_words(dashed, edges)}"
    if not tree:
        return "no other edge need be dashed."
    return "not all of " + ", nor of ".join("{" + " ".join(map(name, bits(s))) + "}" for s in tree) + "."


def numbers(mask):
    return " ".join(map(str, bits(mask))) or "–"


def signed(n):
    return f"+{n}" if n > 0 else str(n).replace("-", "−")


def often(met, name):
    """The number of 10,000 splits of real meshes that use this rule, in words."""
    if met.get(name, 0) == 0:
        return "–"
    share = 10000 * met[name] / sum(met.values())
    return f"{share:.2f}" if share >= 0.01 else "under 0.01"


def row(page, rule, sides, met):
    ports, joined, colors, kept, tree = rule
    name = f"{page.name}-{ports:x}-{joined:x}"
    counts, position, inner = page.known[ports, joined]
    changes = page.changes((ports, joined), colors, kept)
    low, high = min(changes), max(changes)
    kinds = ["costs"] if high > 0 else []
    kinds += ["alone"] if page.leaves_alone(colors, kept) else []
    kinds += ["symmetric"] if page.orbits[ports, joined] < max(page.orbits.values()) else []
    kinds += ["met"] if name in met else []
    picture = picture_of(f"b{position}", inner, ports, "before") + picture_of("a", colors, kept, "after")
    cells = [f'<a href="#{name}">{ports:x}-{joined:x}</a>', numbers(ports), " ".join(f"{i}–{j}" for i, j in sorted(pairs_of(joined))) or "–"]
    cells += [numbers(kept)] if page.description.gives_up else []
    cells += [numbers(colors), grouped(sum(counts.values())), signed(low) if low == high else f"{signed(low)} to {signed(high)}"]
    cells += [often(met, name)] if page.met else []
    cells += [str(page.orbits[ports, joined]), in_words(tree, len(page.after.edges))]
    more = f' data-met="{met[name]}"' if name in met else ""
    return (f'<tr id="{name}" class="{" ".join(kinds)}" data-rule="{ports} {joined} {colors} {kept}" data-before="{position} {inner}"{more}>'
            f'<td class="pic">{picture}</td>' + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")


# ---- pictures: a page has each patch once, with all edges dashed, and each of its edges and ports as a solid line

def picture_parts(side, name):
    def solid(kind, i, colors, ports):
        line = re.search('<path class="solid"[^>]*>', side_picture(side, colors, ports, ""))[0]
        return f'<g id="{name}{kind}{i}" class="patch">{line}</g>'

    whole_patch = re.search("<svg[^>]*>(.*)</svg>", side_picture(side, 0, 0, ""))[1]
    return (f'<g id="{name}" class="patch">{whole_patch}</g>' + "".join(solid("e", i, 1 << i, 0) for i in range(len(side["edges"]))) +
            "".join(solid("p", i, 0, 1 << i) for i in range(len(side["ports"]))))


def picture_of(name, colors, ports, description):
    parts = [name, *(f"{name}e{i}" for i in bits(colors)), *(f"{name}p{i}" for i in bits(ports))]
    return (f'<svg class="patch" viewBox="5 5 390 390" role="img" aria-label="{description}">' +
            "".join(f'<use href="#{part}"/>' for part in parts) + "</svg>")


WHY = """<p>Why nothing is better: of the edges in a pair of braces at least one must stay dashed. If all of them were solid, a
triangle would have too many solid edges, a cycle would close, or two ports would be joined that were not joined before. The
sets share no edge, so each takes a different dashed edge. In none of the cases does the rule leave more edges dashed than
that, or the same number and more triangles alone.</p>"""
LEGEND = ('<p class="legend"><i class="key solid"></i> same {unit} <i class="key dashed"></i> different {unit}s '
          '<i class="key fresh"></i> triangles that come or go</p>')


def words_of(page, sides):
    """The meaning of the words on the page: in its title, its drawings and its table."""
    title = page.section.text.split()
    count = int(title[title.index("k") + 1]) if "k" in title else 0
    fresh = [name for _, names in (side["names"] for side in (*sides[0], sides[1])) for name in names if name in ("A", "D")]
    meanings = {
        "k": f"the number of triangles that are there before and after, t0 to t{count - 1}" if "k" in title else "",
        "a": "how many of them, from t0 on, lie at one end of the new edge; the others lie at the other end" if "a" in title else "",
        "gap": "a place in an open fan where a triangle comes in: gap i is before ti; gaps 0 and k are at the boundary" if {"gap", "gaps"} & set(title) else "",
        " and ".join(sorted(set(fresh))): "the triangles that come or go" if fresh else "",
        "p": "a port, an edge that leads out of the patch",
        "e, f": "an edge inside the patch, before and after",
        "orbit": "a rule with its images under the symmetries of the patch; one of them is listed" if page.section.copies else ""}
    return '<dl class="words">' + "".join(f"<dt><em>{word}</em></dt><dd>{meaning}</dd>" for word, meaning in meanings.items() if meaning) + "</dl>"


def legend(page):
    return LEGEND.format(unit=page.made)


def parts_navigation(page, here):
    """Links between the pages of a section. A link to a rule names the first, which sends it on."""
    parts = page.parts()
    if len(parts) == 1:
        return ""
    words = {name: f"{some[0]} to {some[-1]}" if len(some) > 1 else str(some[0]) for name, some in parts.items()}
    return ('<nav id="pages">Rules with ' + ", ".join(
        f"<strong>{words[name]}</strong>" if name == here else f'<a href="{name}.html" data-ports="{" ".join(map(str, some))}">{words[name]}</a>'
        for name, some in parts.items()) + " solid ports</nav>")


def body_of(page, sides, met, here):
    section, claims = page.section, page.section.claims
    shown = page.parts()[here]
    rows = "\n".join(row(page, rule, sides, met) for rule in section.rules if rule[0].bit_count() in shown)
    several = len(page.positions) > 1
    with_met = page.met > 0
    columns = ["", "rule", "solid ports", "joined before", *(["ports kept"] if page.description.gives_up else []), "solid edges after",
               "patches before, one of them drawn", f"change in {page.units}",
               *(["met by 10,000 splits"] if with_met else []), "in its orbit", "why nothing is better"]
    worst = max(change for *key, colors, kept, _ in section.rules for change in page.changes(tuple(key), colors, kept))
    facts = (f"{grouped(claims['configurations'])} configurations, {grouped(claims['valid'])} of them valid. "
             f"They need {grouped(len(section.rules) + len(section.copies))} rules" +
             (f"; {grouped(len(section.rules))} are listed here, the others are their images under symmetries. " if section.copies else ". ") +
             (f"No rule adds a {page.unit}." if page.costing == 0 else
              f"In {grouped(page.costing)} configurations the best rule adds a {page.unit}; none adds more than {worst}."))
    if with_met:
        facts += (f" Of the splits of four real meshes, from 2 % of their triangles up, {100 * page.met / sum(met.values()):.1f} % are at this "
                  f"position; they meet {grouped(sum(f'{page.name}-{ports:x}-{joined:x}' in met for ports, joined, *_ in section.rules))} of these rules.")
    notes = ("A rule depends only on the solid ports and on which of them are joined before, so it serves "
             f"{'several positions and ' if several else ''}all patches that agree in these. One with the fewest solid edges is drawn. " +
             ("A rule may clear ports, and so may everything that it is compared with." if page.description.gives_up else
              "The ports keep their colours, in the rule and in everything that it is compared with."))
    filters = "".join(f'<label><input type="checkbox" name="{name}"> {words}</label>' for name, words in
                      [("costs", f"adds a {page.unit} somewhere"), ("alone", "leaves a triangle alone"), ("symmetric", "is its own image under a symmetry")] +
                      [("met", "met on real meshes")] * with_met)
    sorting = '<label><input type="checkbox" id="often"> most often met first</label>' if with_met else ""
    names = "".join(side_picture(side, 0, 0, f"the names of edges and ports {when}", letter)
                    for side, when, letter in ((sides[0][-1], "before", "e"), (sides[1], "after", "f")))
    abouts = dict.fromkeys(position.description.about for position in page.positions)
    patches = "".join(picture_parts(side, f"b{n}") for n, side in enumerate(sides[0])) + picture_parts(sides[1], "a")
    positions = escaped(json.dumps([f"{position.description.name} {position.text}" for position in page.positions])).replace('"', "&quot;")
    heads = "".join(f'#rules td:nth-child({n})::before {{ content: "{column}: "; }}' for n, column in enumerate(columns, 1) if column)
    return (f'<h1>{escaped(page.title)}</h1><div id="names">{names}</div><p>{escaped(" ".join(abouts))}</p>{words_of(page, sides)}<p>{facts}</p><p>{notes}</p>'
            f'{WHY if any(tree is not None for *_, tree in section.rules) else ""}'
            '<p>A solid port leads out of the patch. A rule may join two of them only if they were joined before.</p>'
            f'{legend(page)}<form id="filter" hidden>{filters}{sorting}<label>solid ports <input name="ports" size="10" placeholder="0 3"></label>'
            f'<output></output></form>{parts_navigation(page, here)}'
            f'<style>@media (max-width: 700px), print {{ {heads} }}</style>'
            f'<svg width="0" height="0" class="parts" aria-hidden="true"><defs>{patches}</defs></svg>'
            f'<div class="wide" tabindex="0"><table id="rules" data-positions="{positions}"><thead><tr>{"".join(f"<th>{c}</th>" if c else "<td></td>" for c in columns)}</tr></thead><tbody>\n{rows}\n</tbody></table></div>')


INTRODUCTION = """<p>A strip is a path through triangles that share an edge. When a vertex is split, two triangles come into the mesh and
cut the paths around it. A <em>rule</em> says how the edges of that patch are to be coloured afterwards, solid where a
strip continues and dashed where it does not, so that the fewest possible strips remain, for every surrounding
mesh. Each rule here is proved: no recolouring that is safe in every mesh leaves fewer strips, or fewer triangles alone where
triangles are paired. Most rules keep the <em>ports</em>, the edges that lead out of the patch, and are compared with those that do;
where a rule may cut a strip at a port, its page says so.</p>
<p>In the tables <em>k</em> is the number of triangles around the vertex, and <em>a</em> the number of them at one end of the new edge.
Each page explains the words that it uses.</p>
<p>Theorems checked by Coq (<code>verify/formal/Answers.v</code> and <code>Flip.v</code>) say that the library's rules for splits,
collapses and flips are sound and that no sound recolouring is preferred to them. Families come first here, single operations follow.</p>"""


def index_body(groups, picture, met):
    body = "<h1>Atlas of rules</h1>"
    if met:
        body += picture + INTRODUCTION + '<p><a class="button" href="paint.html">Paint a configuration and see its rule</a></p>'
    for name, pages in groups.items():
        rows = ""
        with_met = any(page.met for page in pages)
        for page in pages:
            claims = page.section.claims
            rows += (f'<tr><td><a href="{page.name}.html"><span class="thumb">{page.thumbnail}</span> {escaped(page.words or page.title)}</a></td><td>{grouped(len(page.section.rules))}</td>'
                     f'<td>{grouped(claims["valid"])}</td><td>{grouped(page.costing)}</td><td>{signed(claims["worst-isolated"])}</td>'
                     + (f"<td>{100 * page.met / sum(met.values()):.1f} %</td>" if with_met else "") + "</tr>")
        table = ('<div class="wide" tabindex="0"><table class="index"><thead><tr><td></td><th>rules</th><th>valid configurations</th>'
                 f'<th>of which cost a {pages[0].unit}</th><th>most triangles isolated</th>{"<th>splits of real meshes</th>" if with_met else ""}'
                 f'</tr></thead><tbody>{rows}</tbody></table></div>')
        abouts = dict.fromkeys(position.description.about for page in pages for position in page.positions)
        body += (f'<h2 id="{name}">{escaped(name.replace("-", " ").capitalize())}</h2><p>{escaped(" ".join(abouts))}</p>' +
                 (table if len(pages) < 20 else f"<details><summary>{len(pages)} positions</summary>{table}</details>"))
    total = sum(len(page.section.rules) for pages in groups.values() for page in pages)
    return body + f"<p>{grouped(total)} rules in all" + (
        ", for interior vertices of up to 8 triangles. For larger ones and on the boundary a finite automaton answers, exactly as well; the painter asks it.</p>" if met else ".</p>")


def whole(title, body, nav, place, has_picture):
    description = f"Rules that repair triangle strips: {title}, each drawn with the reason why none is better."
    return (f'<!doctype html>\n<html lang="en">\n{head(f"{title} – restrip", description, place, "", has_picture)}'
            '<link rel="stylesheet" href="atlas.css">\n<script src="atlas.js" defer></script>\n<body>\n'
            f'{nav}\n<main>{body}</main>\n</body>\n</html>\n')


def pages_of(files, folder, met):
    """The pages of all sections, by the name of their certificate, in the order of the files."""
    positions = defaultdict(lambda: defaultdict(list))
    for file in files:
        for position in positions_of(file):
            positions[position.description.certificate][position.section].append(position)
    groups = {}
    for name, by_section in positions.items():
        path = next((path for path in (folder / f"{name}.cert", folder / f"operations/{name}.cert") if path.exists()), folder / f"{name}.cert")
        if not path.exists() and not any(position.description.has_table for some in by_section.values() for position in some):
            continue  # the automaton answers this family
        named, sections = certificate(path)
        if named != name or any(section.text not in by_section for section in sections):
            raise Refused(f"{path}: is not a certificate of {name}")
        groups[name] = [Page(section, by_section[section.text], met) for section in sections]
    return groups


def write(given, met):
    groups = pages_of(given.files, given.certificates, met)
    names = Counter(page.name for pages in groups.values() for page in pages)
    if max(names.values()) > 1:
        raise Refused(f"{names.most_common(1)[0][0]}: is the name of two pages")
    if stray := set(met) - {f"{page.name}-{ports:x}-{joined:x}" for pages in groups.values() for page in pages
                            for ports, joined, *_ in page.section.rules} - {"boundary", "larger"}:
        raise Refused(f"{given.met}: {min(stray)} is not a rule of the certificates; make the file again")
    texts, picture = {}, ""
    for pages in groups.values():
        for page in pages:
            try:
                sides = drawings([position.before for position in page.positions], [page.after])
            except Refused as fault:
                raise Refused(f"{page.title}: {fault}") from None
            sides = sides[0], sides[1][0]
            page.thumbnail = "".join(side_picture(side, 0, 0, "") for side in (sides[0][-1], sides[1])).replace('role="img" aria-label=""', 'aria-hidden="true"')
            for part in page.parts():
                texts[part] = page.title, body_of(page, sides, met, part)
            if page.name == "split-5-2":  # one of its rules is the picture of the index
                ports, joined, colors, kept, _ = next(rule for rule in page.section.rules if rule[0].bit_count() == 3 and rule[1] > 0)
                _, position, inner = page.known[ports, joined]
                picture = ('<div class="rule"><div class="pictures"><figure>' + side_picture(sides[0][position], inner, ports, "before") +
                           "<figcaption>before the split</figcaption></figure><figure>" + side_picture(sides[1], colors, kept, "after") +
                           "<figcaption>after it, by its rule</figcaption></figure></div>" + legend(page) + "</div>")
    if given.drawn:
        drawn = defaultdict(list)
        for position in positions_of(given.files[0]):
            before, after = drawings([position.before], [position.after])
            drawn[position.description.name].append([position.text, before[0], after[0]])
        given.drawn.write_text(json.dumps(drawn, separators=(",", ":")), encoding="utf-8")
    texts["index"] = "Atlas of rules", index_body(groups, picture, met)
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "atlas.css").write_text("".join(style.read_text(encoding="utf-8") for style in STYLES), encoding="utf-8")
    (given.out / "atlas.js").write_text("(() => {\n" + inlined(SCRIPTS) + "\n})();\n", encoding="utf-8")
    for name, (title, body) in texts.items():
        nav = navigation(f"atlas/{name}.html") if met else '<nav><a href="index.html">Atlas of rules</a></nav>'
        (given.out / f"{name}.html").write_text(whole(title, body, nav, f"atlas/{name}.html", bool(met)), encoding="utf-8")
    for name, pages in groups.items():
        rules = sum(len(page.section.rules) for page in pages)
        count = sum(len(page.parts()) for page in pages)
        print(f"{name}: {grouped(rules)} rules on {count} page{'s' * (count != 1)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE")
    parser.add_argument("--certificates", type=Path, required=True, metavar="FOLDER")
    parser.add_argument("-o", dest="out", type=Path, required=True, metavar="OUT")
    parser.add_argument("--met", type=Path, metavar="CSV")
    parser.add_argument("--drawn", type=Path, metavar="JSON", help="is written: the drawings of all positions of the first FILE, for the painter")
    given = parser.parse_args()
    met = {}
    if given.met:
        with given.met.open(encoding="ascii", newline="") as file:
            met = {name: sum(map(int, counts)) for name, *counts in list(csv.reader(file))[1:]}
    try:
        write(given, met)
    except Refused as fault:
        sys.exit(f"atlas.py: {fault}")


if __name__ == "__main__":
    main()
