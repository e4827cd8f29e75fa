#!/usr/bin/env python3
"""Makes the page of `restrip paper`: FOLDER/index.html from FOLDER/report.json.

One page of HTML that needs nothing else; the CSV files next to it hold the figures of each picture. No dates and no
timings: the same bytes on every run.
"""
import argparse
import csv
import io
import json
import os
import sys
import tempfile
from pathlib import Path

import pictures
import plots
from plots import Axis, Bar, BarPlot, Series, escaped, grouped

PAGE_STYLE = """
body { margin: 0 auto; padding: 1rem 1.25rem 4rem; max-width: 1080px; background: var(--surface); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; color-scheme: light dark; }
a { color: var(--ours); } h2 { margin: 2.5rem 0 0.5rem; border-bottom: 1px solid var(--faint); }
p, li { max-width: 72ch; } .note, figcaption { color: var(--soft); font-size: 0.9rem; }
figure { margin: 1rem 0; overflow-x: auto; } table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
.wide { overflow-x: auto; } caption { text-align: left; color: var(--soft); font-size: 0.9rem; padding-bottom: 0.25rem; }
th, td { padding: 0.15rem 0.7rem; text-align: right; border-bottom: 1px solid var(--faint); font-size: 0.9rem; }
th:first-child, td:first-child { text-align: left; } th { vertical-align: bottom; }
th.words, td.words { text-align: left; }
.differs { color: var(--paper); font-weight: 600; }
.grid { display: grid; grid-template-columns: repeat(auto-fill, minmax(var(--cell), 1fr)); gap: 0.8rem; }
.grid figure { margin: 0; text-align: center; } .pair { display: flex; align-items: center; justify-content: center; }
details { margin: 1rem 0; } summary { cursor: pointer; }
"""
DRAWN_K = 6  # of the isolated triangles


def before(k, a, rule):
    return pictures.fan_picture(k, a, rule["loop"], rule["ports"], f"before: loop {rule['loop']}, ports {rule['ports']}")


def after(k, a, rule, inner, what):
    return pictures.split_picture(k, a, inner, rule["ports"], f"{what}: inner {inner}")


def change(number, what):
    if number == 0:
        return f"no {what} added"
    return f"{number:+} {what}{'' if abs(number) == 1 else 's'}"


def pair_figure(k, a, rule):
    return (f'<figure><div class="pair">{before(k, a, rule)}<span>→</span>{after(k, a, rule, rule["inner"], "after")}</div>'
            f'<figcaption>{change(rule["strips"], "strip")}, stands for {rule["orbit"]}</figcaption></figure>\n')


def head(text, style=""):
    return f'<th{style} scope="col">{escaped(text)}</th>'


def cell(text):
    return f"<td>{text}</td>"


def row(cells):
    return "<tr>" + "".join(cells) + "</tr>\n"


# ---- the sections


def positions_section(report):
    positions, largest = report["positions"], report["table_max_k"]
    to_tables = sum(at["k"] <= largest for at in positions)
    html = ('<h2 id="figure-6">Split positions (figure 6)</h2>\n<p>A split of a vertex of k triangles cuts two edges of the loop '
            "and puts a new triangle (yellow) on each. Up to rotation and mirror image only the length a of the shorter arc "
            f"counts: {to_tables} positions up to k = {largest}, {len(positions)} up to k = {positions[-1]['k']}. "
            '<a href="positions.csv">positions.csv</a></p>\n<div class="grid" style="--cell: 130px">\n')
    for at in positions:
        k, a = at["k"], at["a"]
        html += (f'<figure class="position">{pictures.split_picture(k, a, 0, 0, f"split position {k}, {a}")}'
                 f"<figcaption>k = {k}, a = {a}</figcaption></figure>\n")
    return html + "</div>\n"


def four_section(report):
    html = ('<h2 id="figure-7">Rules of the 4-vertex (figure 7)</h2>\n<p>Thick lines are solid (the two triangles follow each other '
            "in a strip), thin broken ones dashed. The paper shows 9 + 9 rules and reduces by symmetry the colours of the loop "
            "alone; with the ports, which decide what a rule may do, there are more. First, one rule for each orbit of loop "
            "colours, with a solid port wherever a triangle has room for one. "
            '<a href="rules-4.csv">rules-4.csv</a></p>\n')
    for four in report["four_vertex"]:
        a, by_loop, rules = four["a"], four["by_loop"], four["all"]
        html += (f'<h3>a = {a}</h3>\n<p class="note">{four["loop_orbits"]} orbits of loop colours, {len(by_loop)} without the solid '
                 f'cycle; {sum(rule["orbit"] for rule in rules)} valid configurations in {len(rules)} orbits.</p>\n'
                 '<div class="grid" style="--cell: 240px">\n')
        html += "".join(pair_figure(4, a, rule) for rule in by_loop)
        html += (f'</div>\n<details><summary>All {len(rules)} orbits</summary>\n<div class="grid" style="--cell: 200px">\n')
        html += "".join(pair_figure(4, a, rule) for rule in rules) + "</div>\n</details>\n"
    return html


def lonely_section(report):
    html = ('<h2 id="figure-8">The isolated triangle (figure 8)</h2>\n<p>The paper shows a 6-vertex on which a split must leave a '
            "triangle alone. It must, if every strip that passes through the patch, in at one port and out at another, is to stay "
            "whole. Below is every such configuration, found by trying all recolourings. The rules do not keep passing strips whole: "
            "they cut one and give the isolated triangle to one half. There are never more strips than with the isolated triangle, "
            "which is a strip too, and no triangle is isolated.</p>\n"
            '<div class="wide" tabindex="0"><table id="lonely-counts">\n<caption>Configurations in which whole strips leave a triangle alone '
            '(<a href="lonely-counts.csv">lonely-counts.csv</a>, <a href="lonely.csv">lonely.csv</a>)</caption>\n')
    html += row(map(head, ("k, a", "valid configurations", "alone if strips stay whole", "orbits",
                           "of them alone under the rule", "of them one strip more under the rule")))
    for count in report["lonely"]:
        figures = (count["valid"], count["lonely"], len(count["orbits"]), count["rule_isolates"], count["rule_adds_strip"])
        html += row([cell(f"{count['k']}, {count['a']}"), *(cell(grouped(n)) for n in figures)])
    html += f'</table></div>\n<h3>All of k = {DRAWN_K}</h3>\n<div class="grid" style="--cell: 400px">\n'
    for count in report["lonely"]:
        k, a = count["k"], count["a"]
        for rule in count["orbits"] if k == DRAWN_K else ():
            html += (f'<figure class="lonely"><div class="pair">{before(k, a, rule)}<span>→</span>'
                     f'{after(k, a, rule, rule["whole"], "strips whole")}{after(k, a, rule, rule["inner"], "the rule")}</div>'
                     f'<figcaption>a = {a}: before; strips whole, {change(rule["isolated_if_whole"], "isolated triangle")}; the rule, '
                     f'{change(rule["strips"], "strip")} and {change(rule["isolated"], "isolated triangle")}</figcaption></figure>\n')
    return html + "</div>\n"


def valence_part(mesh, number):
    rows, paper = mesh["valence"], mesh["paper"]
    name = escaped(mesh["mesh"])
    series = [Series(mesh["mesh"], "ours", 0, [(r["triangles"], r["vertices"]) for r in rows])]
    html = f"<h3>{name}</h3>\n<p>{grouped(mesh['used_vertices'])} vertices with triangles, {grouped(mesh['triangles'])} triangles. "
    if paper is None:
        html += "Not a mesh whose row the paper gives.</p>\n"
    else:
        theirs = escaped(paper["mesh"])
        series.append(Series(f"the paper's {paper['mesh']}", "paper", 2, [(r["triangles"], r["paper"]) for r in rows], True))
        html += (f"Equal to the paper's {theirs}, row for row.</p>\n" if mesh["equals_paper"] else
                 f"The same number of triangles as the paper's {theirs}, but <strong class=\"differs\">not the same rows</strong>.</p>\n")
    plot = plots.line_plot(Axis("triangles per vertex"), Axis("vertices", True), series,
                              f"vertices by triangles per vertex, {mesh['mesh']}")
    html += f'<figure class="valence">{plot}</figure>\n<div class="wide" tabindex="0"><table id="valence-{number}">\n'
    html += row([head("triangles per vertex"), head("vertices"), head("%")] + ([head("paper")] if paper else []))
    for r in rows:
        cells = [cell(grouped(r["triangles"])), cell(grouped(r["vertices"])), cell(f"{r['percent']:.2f}")]
        if paper:
            differs = ' class="differs"' if r["paper"] != r["vertices"] else ""
            cells.append(f"<td{differs}>{grouped(r['paper'])}</td>")
        html += row(cells)
    return html + "</table></div>\n"


def percent(run):
    return 100 * run["isolating"] / run["splits"] if run["splits"] else 0.0


def family(run):
    return "paper" if run["of_paper"] else "ours"


def isolating_part(mesh, number):
    plot = BarPlot("splits that introduced an isolated triangle (%)")
    plot.bars = [Bar(run["policy"], family(run), percent(run), f"{percent(run):.2f} %") for run in mesh["policies"]]
    if mesh["paper"] and mesh["paper"]["isolating_percent"] is not None:
        plot.reference = mesh["paper"]["isolating_percent"]
        plot.reference_text = f"the paper reports {plot.reference:g} %"
    picture = plots.bar_plot(plot, f"splits that introduced an isolated triangle, {mesh['mesh']}")
    html = (f'<h3>{escaped(mesh["mesh"])}</h3>\n<figure class="isolating">{picture}</figure>\n'
            f'<div class="wide" tabindex="0"><table id="isolating-{number}">\n')
    html += row([head("policy"), head("splits"), head("isolating"), head("%"), head("what it does", ' class="words"')])
    for run in mesh["policies"]:
        html += row([cell(escaped(run["policy"])), cell(grouped(run["splits"])), cell(grouped(run["isolating"])),
                     cell(f"{percent(run):.2f}"), f'<td class="words">{escaped(run["says"])}</td>'])
    html += "</table></div>\n"
    by_valence = "; ".join(f"{k}: {grouped(n)}" for k, n in mesh["splits_by_valence"].items())
    if not by_valence:
        return html
    return html + f'<p class="note">Splits by triangles around the vertex before the split: {by_valence}.</p>\n'


def strips_part(mesh, number):
    runs = [(run["policy"], family(run), run["levels"]) for run in mesh["policies"]]
    runs += [(run["name"], "scratch", run["levels"]) for run in mesh["scratch"]]
    series, members = [], {}
    for name, kind, levels in runs:
        member = members[kind] = members.get(kind, -1) + 1
        series.append(Series(name, kind, member, [(level["triangles"], level["strips"]) for level in levels]))
    plot = plots.line_plot(Axis("triangles at this level of detail", True), Axis("strips", True), series,
                              f"strips at each level of detail, {mesh['mesh']}")
    html = (f'<h3>{escaped(mesh["mesh"])}</h3>\n<figure class="strips">{plot}</figure>\n'
            f'<div class="wide" tabindex="0"><table id="strips-{number}">\n<caption>Strips, isolated triangles among them</caption>\n')
    html += row([head("triangles"), *(head(name) for name, _, _ in runs)])
    for i, level in enumerate(runs[0][2]):
        html += row([cell(grouped(level["triangles"])), *(cell(grouped(levels[i]["strips"])) for _, _, levels in runs)])
    return html + "</table></div>\n"


def page(report):
    def each_mesh(part):
        return "".join(part(mesh, number) for number, mesh in enumerate(report["meshes"], 1))

    command = " ".join(["restrip paper --out DIR", *(mesh["mesh"] for mesh in report["meshes"])])
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n<meta name="viewport" content="width=device-width, '
        "initial-scale=1\"/>\n<title>The paper's figures, reproduced</title>\n"
        f"<style>\n{plots.PLOT_STYLE}{pictures.PATCH_STYLE}{PAGE_STYLE}</style>\n</head>\n<body>\n"
        "<h1>The paper's figures, reproduced</h1>\n<p>M. B. Porcu, N. Sanna, R. Scateni, “Rewriting rules for the dual graph of a "
        f"stripified CLOD mesh”. Made by <code>{escaped(command)} --base {report['base']:g} --levels {report['levels']} --boundary "
        f"{report['boundary']}</code>; the figures of each picture are in the CSV files next to this page.</p>\n"
        '<h2 id="valence">Triangles per vertex (tables 1 and 2, plots 9 and 10)</h2>\n<p>The number of vertices on a logarithmic '
        'axis. <a href="valence.csv">valence.csv</a></p>\n' + each_mesh(valence_part) + positions_section(report) +
        four_section(report) + lonely_section(report) +
        '<h2 id="isolating">Splits that introduce an isolated triangle</h2>\n<p>Each mesh is simplified by quadric edge collapses '
        "and taken up again split by split. A split counts when the triangles around it hold more isolated ones after it than "
        "before; what tunnelling repairs between two splits does not excuse the one that came before. The paper has rules for the "
        "4-vertex and leaves open what becomes of the colours elsewhere. Here both halves of a cut edge inherit its colour, and two "
        "switches decide the rest: whether the two new triangles join when both are alone, and whether tunnelling keeps isolated "
        'triangles below a tenth of the strips. <a href="isolating.csv">isolating.csv</a></p>\n' + each_mesh(isolating_part) +
        '<h2 id="strips">Strips over level of detail</h2>\n<p>Every policy starts on the base with the same strips, the best that '
        "the program can make from scratch, and goes up; baked strips have a separate base. Strips from scratch ignore "
        'the level before. Both axes are logarithmic; lower is better. <a href="strips.csv">strips.csv</a></p>\n' +
        each_mesh(strips_part) + "</body>\n</html>\n")


def csv_files(report):
    """The figures of each picture, by the name of their file. Masks are decimal, numbered as in docs/reference/notation.md."""
    lonely = [(at, rule) for at in report["lonely"] for rule in at["orbits"]]
    policies = [(mesh, run) for mesh in report["meshes"] for run in mesh["policies"]]
    runs = [(mesh, run.get("policy", run.get("name")), run) for mesh in report["meshes"] for run in mesh["policies"] + mesh["scratch"]]
    return {
        "positions.csv": ("k,a,b", ((at["k"], at["a"], at["k"] - at["a"]) for at in report["positions"])),
        "rules-4.csv": ("a,loop,ports,inner,strips,isolated,orbit",
                        ((four["a"], *(rule[name] for name in ("loop", "ports", "inner", "strips", "isolated", "orbit")))
                         for four in report["four_vertex"] for rule in four["all"])),
        "lonely-counts.csv": ("k,a,valid,lonely,rule_isolates,rule_adds_strip,orbits",
                              ((*(at[name] for name in ("k", "a", "valid", "lonely", "rule_isolates", "rule_adds_strip")),
                                len(at["orbits"])) for at in report["lonely"])),
        "lonely.csv": ("k,a,loop,ports,orbit,whole,isolated_if_whole,inner,strips,isolated",
                       ((at["k"], at["a"], *(rule[name] for name in ("loop", "ports", "orbit", "whole", "isolated_if_whole", "inner",
                                                                     "strips", "isolated"))) for at, rule in lonely)),
        "valence.csv": ("mesh,triangles_per_vertex,vertices,percent,paper_vertices",
                        ((mesh["mesh"], row["triangles"], row["vertices"], f"{row['percent']:.2f}", row["paper"])
                         for mesh in report["meshes"] for row in mesh["valence"])),
        "isolating.csv": ("mesh,policy,splits,isolating,percent",
                          ((mesh["mesh"], run["policy"], run["splits"], run["isolating"], f"{percent(run):.2f}") for mesh, run in policies)),
        "strips.csv": ("mesh,policy,triangles,strips,isolated",
                       ((mesh["mesh"], name, level["triangles"], level["strips"], level["isolated"])
                        for mesh, name, run in runs for level in run["levels"])),
    }


def csv_text(header, rows):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([header.split(","), *rows])
    return text.getvalue()


def write_whole(file, text):
    """The file as it was, or all of the text."""
    handle, partial = tempfile.mkstemp(dir=file.parent, prefix=file.name + ".")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as out:
            out.write(text)
        os.chmod(partial, 0o644)
        os.replace(partial, file)
    except BaseException:
        os.unlink(partial)
        raise


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                                     epilog="Example: restrip paper --out report bunny.obj && scripts/paper_page.py report")
    parser.add_argument("folder", type=Path, help="the folder that restrip paper wrote")
    file = parser.parse_args().folder / "report.json"
    try:
        report = json.loads(file.read_text(encoding="utf-8"))
        files = {name: csv_text(*figures) for name, figures in csv_files(report).items()}
        for name, text in {**files, "index.html": page(report)}.items():
            write_whole(file.with_name(name), text)
    except OSError as error:
        sys.exit(f"paper_page.py: {error.filename}: {error.strerror}; name a folder that restrip paper wrote")
    except (ValueError, KeyError, TypeError) as error:
        sys.exit(f"paper_page.py: {file}: is not a report of restrip paper ({error!r}); run restrip paper --out {file.parent} again")


if __name__ == "__main__":
    main()
