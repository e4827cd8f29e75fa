// The page of `restrip paper`.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "paper/paper_report.hpp"
#include "paper/patch_drawing.hpp"
#include "paper/plot.hpp"

namespace restrip::tools {
namespace {

constexpr const char* page_style = R"(
body { margin: 0 auto; padding: 1rem 1.25rem 4rem; max-width: 1080px; background: var(--surface); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; color-scheme: light dark; }
:root { --old: #e3f2fd; --new: #ffe082; --rim: #7a8794; --solid: #c2185b; --dashed: #6b7280; }
@media (prefers-color-scheme: dark) { :root { --old: #24405c; --new: #8a6414; --rim: #8d9aa8; --solid: #ff77b0;
  --dashed: #c3cad3; } }
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
.patch { width: 100%; max-width: 150px; height: auto; } .old { fill: var(--old); } .new { fill: var(--new); }
.old, .new { stroke: var(--rim); stroke-width: 1.5; } .solid, .dashed { fill: none; }
.solid { stroke: var(--solid); stroke-width: 9; stroke-linecap: round; }
.dashed { stroke: var(--dashed); stroke-width: 3; stroke-dasharray: 9 8; }
.node { fill: none; stroke: var(--solid); stroke-width: 17; stroke-linecap: round; }
details { margin: 1rem 0; } summary { cursor: pointer; }
)";

// ---- drawings of patches

std::string svg_of(const PatchDrawing& drawing, const std::string& description) {
  std::string faces[2];
  std::string strokes[2];
  std::string nodes;
  for (const PatchDrawing::Face& f : drawing.faces)
    faces[f.is_new ? 1 : 0] +=
        fmt::format("M{:.1f},{:.1f}L{:.1f},{:.1f}L{:.1f},{:.1f}z", f.a.x, f.a.y, f.b.x, f.b.y, f.c.x, f.c.y);
  for (const PatchDrawing::Stroke& s : drawing.strokes)
    strokes[s.solid ? 1 : 0] += fmt::format("M{:.1f},{:.1f}L{:.1f},{:.1f}", s.from.x, s.from.y, s.to.x, s.to.y);
  for (const Place& at : drawing.nodes) nodes += fmt::format("M{:.1f},{:.1f}h0", at.x, at.y);
  std::string svg =
      fmt::format("<svg class=\"patch\" viewBox=\"5 5 390 390\" role=\"img\" aria-label=\"{}\">", escaped(description));
  const auto path = [&svg](const char* style, const std::string& d) {
    if (!d.empty()) svg += fmt::format("<path class=\"{}\" d=\"{}\"/>", style, d);
  };
  path("old", faces[0]);
  path("new", faces[1]);
  path("dashed", strokes[0]);
  path("solid", strokes[1]);
  path("node", nodes);
  return svg + "</svg>";
}

std::string before(const RuleOfOrbit& r) {
  return svg_of(fan_drawing(r.at, r.loop, r.ports), fmt::format("before: loop {}, ports {}", r.loop, r.ports));
}
std::string after(const RuleOfOrbit& r, Word inner, const char* what) {
  return svg_of(split_drawing(r.at, inner, r.ports), fmt::format("{}: inner {}", what, inner));
}

std::string change_of(int change, const std::string& what) {
  if (change == 0) return "no " + what + " added";
  return fmt::format("{:+} {}{}", change, what, change == 1 || change == -1 ? "" : "s");
}

std::string pair_figure(const RuleOfOrbit& r) {
  return fmt::format(
      "<figure><div class=\"pair\">{}<span>→</span>{}</div><figcaption>{}, stands for {}</figcaption></figure>\n",
      before(r), after(r, r.inner, "after"), change_of(r.strips, "strip"), r.orbit);
}

// ---- tables

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }
std::string head(const std::string& text) { return "<th scope=\"col\">" + escaped(text) + "</th>"; }

// ---- the sections

std::string positions_section(const RuleFigures& figures) {
  std::string html =
      "<h2 id=\"figure-6\">Split positions (figure 6)</h2>\n<p>A split of a vertex of k triangles cuts two edges of "
      "the "
      "loop and puts a new triangle (yellow) on each. Up to rotation and mirror image only the length a of the shorter "
      "arc counts: ";
  const auto to_eight = std::count_if(figures.positions.begin(), figures.positions.end(),
                                      [](const SplitPosition& at) { return at.k <= table_max_k; });
  html += fmt::format("{} positions up to k = {}, {} up to k = {}. <a href=\"positions.csv\">positions.csv</a></p>\n",
                      to_eight, table_max_k, figures.positions.size(), figures.positions.back().k);
  html += "<div class=\"grid\" style=\"--cell: 130px\">\n";
  for (const SplitPosition& at : figures.positions)
    html += fmt::format("<figure class=\"position\">{}<figcaption>k = {}, a = {}</figcaption></figure>\n",
                        svg_of(split_drawing(at, 0, 0), fmt::format("split position {}, {}", at.k, at.a)), at.k, at.a);
  return html + "</div>\n";
}

std::string four_section(const RuleFigures& figures) {
  std::string html =
      "<h2 id=\"figure-7\">Rules of the 4-vertex (figure 7)</h2>\n<p>Thick lines are solid (the two triangles follow "
      "each "
      "other in a strip), thin broken ones dashed. The paper shows 9 + 9 rules and reduces by symmetry the colours of "
      "the loop alone; with the ports, which decide what a rule may do, there are more. First, one rule for each orbit "
      "of "
      "loop colours, with a solid port wherever a triangle has room for one. <a "
      "href=\"rules-4.csv\">rules-4.csv</a></p>\n";
  for (const RuleFigures::FourVertex& four : figures.four) {
    std::size_t valid = 0;
    for (const RuleOfOrbit& r : four.all) valid += r.orbit;
    html += fmt::format(
        "<h3>a = {}</h3>\n<p class=\"note\">{} orbits of loop colours, {} without the solid cycle; {} valid "
        "configurations in {} orbits.</p>\n<div class=\"grid\" style=\"--cell: 240px\">\n",
        four.at.a, four.loops, four.by_loop.size(), valid, four.all.size());
    for (const RuleOfOrbit& r : four.by_loop) html += pair_figure(r);
    html +=
        fmt::format("</div>\n<details><summary>All {} orbits</summary>\n<div class=\"grid\" style=\"--cell: 200px\">\n",
                    four.all.size());
    for (const RuleOfOrbit& r : four.all) html += pair_figure(r);
    html += "</div>\n</details>\n";
  }
  return html;
}

std::string lonely_section(const RuleFigures& figures) {
  constexpr std::size_t drawn = 6;
  std::string html =
      "<h2 id=\"figure-8\">The lonely triangle (figure 8)</h2>\n<p>The paper shows a 6-vertex on which a split must "
      "leave "
      "a triangle alone. It must, if every strip that passes through the patch, in at one port and out at another, is "
      "to "
      "stay whole. Below is every such configuration, found by trying all recolourings. The rules do not insist: they "
      "cut "
      "a passing strip and give the lonely triangle to one half. That costs no more strips than the lonely triangle, "
      "itself a strip of one, and nobody is alone.</p>\n";
  html +=
      "<div class=\"wide\"><table id=\"lonely-counts\">\n<caption>Configurations in which whole strips leave a "
      "triangle "
      "alone (<a href=\"lonely-counts.csv\">lonely-counts.csv</a>, <a "
      "href=\"lonely.csv\">lonely.csv</a>)</caption>\n<tr>";
  for (const char* name : {"k, a", "valid configurations", "alone if strips stay whole", "orbits",
                           "of them alone under the rule", "of them one strip more under the rule"})
    html += head(name);
  html += "</tr>\n";
  for (const LonelyCount& count : figures.lonely)
    html += fmt::format("<tr>{}{}{}{}{}{}</tr>\n", cell(fmt::format("{}, {}", count.at.k, count.at.a)),
                        cell(grouped(count.valid)), cell(grouped(count.lonely)), cell(grouped(count.orbits.size())),
                        cell(grouped(count.isolated)), cell(grouped(count.adding_strip)));
  html += fmt::format("</table></div>\n<h3>All of k = {}</h3>\n<div class=\"grid\" style=\"--cell: 400px\">\n", drawn);
  for (const LonelyCount& count : figures.lonely) {
    if (count.at.k != drawn) continue;
    for (const LonelyRule& one : count.orbits)
      html += fmt::format(
          "<figure class=\"lonely\"><div class=\"pair\">{}<span>→</span>{}{}</div><figcaption>a = {}: before; strips "
          "whole, "
          "{}; the rule, {} and {}</figcaption></figure>\n",
          before(one.rule), after(one.rule, one.whole, "strips whole"), after(one.rule, one.rule.inner, "the rule"),
          count.at.a, change_of(one.isolated_if_whole, "lonely triangle"), change_of(one.rule.strips, "strip"),
          change_of(one.rule.isolated, "lonely triangle"));
  }
  return html + "</div>\n";
}

std::string valence_part(const PaperMesh& mesh, std::size_t number) {
  const std::vector<ValenceRow> rows = valence_rows(mesh);
  Series here{mesh.name, Family::ours, 0, {}, false};
  Series paper{mesh.paper ? fmt::format("the paper's {}", mesh.paper->mesh) : "", Family::paper, 2, {}, true};
  for (const ValenceRow& row : rows) {
    here.points.push_back({static_cast<double>(row.triangles), static_cast<double>(row.vertices)});
    if (row.paper) paper.points.push_back({static_cast<double>(row.triangles), static_cast<double>(*row.paper)});
  }
  std::vector<Series> series{here};
  if (mesh.paper) series.push_back(paper);
  std::string html = fmt::format("<h3>{}</h3>\n<p>{} vertices with triangles, {} triangles. ", escaped(mesh.name),
                                 grouped(mesh.survey.used_vertices), grouped(mesh.triangles));
  if (!mesh.paper)
    html += "Not a mesh whose row the paper gives.</p>\n";
  else if (mesh.equals_paper())
    html += fmt::format("Equal to the paper's {}, row for row.</p>\n", escaped(mesh.paper->mesh));
  else
    html += fmt::format(
        "As many triangles as the paper's {}, but <strong class=\"differs\">not the same rows</strong>.</p>\n",
        escaped(mesh.paper->mesh));
  html += "<figure class=\"valence\">" +
          line_plot({"triangles per vertex", false}, {"vertices", true}, series,
                    "vertices by triangles per vertex, " + mesh.name) +
          "</figure>\n";
  html += fmt::format("<div class=\"wide\"><table id=\"valence-{}\">\n<tr>{}{}{}{}</tr>\n", number,
                      head("triangles per vertex"), head("vertices"), head("%"), mesh.paper ? head("paper") : "");
  for (const ValenceRow& row : rows) {
    const bool differs = row.paper && *row.paper != row.vertices;
    html += fmt::format(
        "<tr>{}{}{}{}</tr>\n", cell(grouped(row.triangles)), cell(grouped(row.vertices)),
        cell(fmt::format("{:.2f}", row.percent)),
        row.paper ? fmt::format("<td{}>{}</td>", differs ? " class=\"differs\"" : "", grouped(*row.paper)) : "");
  }
  return html + "</table></div>\n";
}

std::string isolating_part(const PaperMesh& mesh, std::size_t number) {
  BarPlot plot;
  plot.label = "splits that introduced an isolated triangle (%)";
  for (const PolicyRun& run : mesh.runs)
    plot.bars.push_back({run.name, run.of_paper ? Family::paper : Family::ours, run.isolating_percent(),
                         fmt::format("{:.2f} %", run.isolating_percent())});
  if (mesh.paper && mesh.paper->isolating_percent) {
    plot.reference = *mesh.paper->isolating_percent;
    plot.reference_text = fmt::format("the paper reports {:g} %", plot.reference);
  }
  std::string html = fmt::format("<h3>{}</h3>\n<figure class=\"isolating\">{}</figure>\n", escaped(mesh.name),
                                 bar_plot(plot, "splits that introduced an isolated triangle, " + mesh.name));
  html +=
      fmt::format("<div class=\"wide\"><table id=\"isolating-{}\">\n<tr>{}{}{}{}{}</tr>\n", number, head("policy"),
                  head("splits"), head("isolating"), head("%"), "<th class=\"words\" scope=\"col\">what it does</th>");
  for (const PolicyRun& run : mesh.runs)
    html += fmt::format("<tr>{}{}{}{}<td class=\"words\">{}</td></tr>\n", cell(escaped(run.name)),
                        cell(grouped(run.splits)), cell(grouped(run.isolating)),
                        cell(fmt::format("{:.2f}", run.isolating_percent())), escaped(run.says));
  html += "</table></div>\n";
  std::string by_valence;
  for (std::size_t k = 0; k < mesh.splits_by_valence.size(); ++k)
    if (const std::size_t splits = mesh.splits_by_valence[k]; splits != 0)
      by_valence += fmt::format("{}{}: {}", by_valence.empty() ? "" : "; ", k, grouped(splits));
  if (by_valence.empty()) return html;
  return html + "<p class=\"note\">Splits by triangles around the vertex before the split: " + by_valence + ".</p>\n";
}

std::string strips_part(const PaperMesh& mesh, std::size_t number) {
  std::vector<Series> series;
  std::size_t members[2] = {0, 0};
  const auto points_of = [](const std::vector<StripCount>& levels) {
    std::vector<XY> points;
    points.reserve(levels.size());
    for (const StripCount& l : levels)
      points.push_back({static_cast<double>(l.triangles), static_cast<double>(l.strips)});
    return points;
  };
  std::string header = head("triangles");
  for (const PolicyRun& run : mesh.runs) {
    series.push_back({run.name, run.of_paper ? Family::paper : Family::ours, members[run.of_paper ? 1 : 0]++,
                      points_of(run.levels), false});
    header += head(run.name);
  }
  std::size_t member = 0;
  for (const ScratchRun& run : mesh.scratch) {
    series.push_back({run.name, Family::scratch, member++, points_of(run.levels), false});
    header += head(run.name);
  }
  std::string html = fmt::format("<h3>{}</h3>\n<figure class=\"strips\">{}</figure>\n", escaped(mesh.name),
                                 line_plot({"triangles at this level of detail", true}, {"strips", true}, series,
                                           "strips at each level of detail, " + mesh.name));
  html += fmt::format(
      "<div class=\"wide\"><table id=\"strips-{}\">\n<caption>Strips, isolated triangles among "
      "them</caption>\n<tr>{}</tr>\n",
      number, header);
  for (std::size_t i = 0; i < mesh.runs.front().levels.size(); ++i) {
    html += "<tr>" + cell(grouped(mesh.runs.front().levels[i].triangles));
    for (const PolicyRun& run : mesh.runs) html += cell(grouped(run.levels[i].strips));
    for (const ScratchRun& run : mesh.scratch) html += cell(grouped(run.levels[i].strips));
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

template <class Part>
std::string each_mesh(const std::vector<PaperMesh>& meshes, Part&& part) {
  std::string html;
  for (std::size_t i = 0; i < meshes.size(); ++i) html += part(meshes[i], i + 1);
  return html;
}

}  // namespace

std::string as_html(const RuleFigures& figures, const std::vector<PaperMesh>& meshes, const PaperOptions& options) {
  std::string command = "restrip paper --out DIR";
  for (const PaperMesh& mesh : meshes) command += " " + mesh.name;
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\"/>\n<title>The paper's figures, done "
      "again</title>\n<style>\n{}{}</style>"
      "\n</head>\n<body>\n<h1>The paper's figures, done again</h1>\n",
      plot_style(), page_style);
  html += fmt::format(
      "<p>M. B. Porcu, N. Sanna, R. Scateni, “Rewriting rules for the dual graph of a stripified CLOD mesh”. Made by "
      "<code>{} --base {:g} --levels {} --boundary {}</code>; the figures behind each picture are in the CSV files "
      "beside "
      "this page.</p>\n",
      escaped(command), options.simplify.base, options.levels,
      options.simplify.boundary == BoundaryPolicy::lock ? "lock" : "move");
  html +=
      "<h2 id=\"valence\">Triangles per vertex (tables 1 and 2, plots 9 and 10)</h2>\n<p>The number of vertices on a "
      "logarithmic axis. <a href=\"valence.csv\">valence.csv</a></p>\n";
  html += each_mesh(meshes, valence_part);
  html += positions_section(figures) + four_section(figures) + lonely_section(figures);
  html +=
      "<h2 id=\"isolating\">Splits that introduce an isolated triangle</h2>\n<p>Each mesh is simplified by quadric "
      "edge "
      "collapses and taken up again split by split. A split counts when the triangles around it hold more isolated "
      "ones "
      "after it than before; what tunnelling repairs between two splits does not excuse the one that came before. The "
      "paper has rules for the 4-vertex and leaves open what becomes of the colours elsewhere. Here both halves of a "
      "cut "
      "edge inherit its colour, and two switches decide the rest: whether the two new triangles join when both are "
      "alone, "
      "and whether tunnelling keeps isolated triangles below a tenth of the strips. "
      "<a href=\"isolating.csv\">isolating.csv</a></p>\n";
  html += each_mesh(meshes, isolating_part);
  html +=
      "<h2 id=\"strips\">Strips over level of detail</h2>\n<p>Every policy starts on the base with the same strips, "
      "the "
      "best that the program can make from scratch, and goes up; baked strips bring a base of their own. Strips from "
      "scratch know nothing of the level before. "
      "Both axes are logarithmic; lower is better. <a href=\"strips.csv\">strips.csv</a></p>\n";
  html += each_mesh(meshes, strips_part);
  return html + "</body>\n</html>\n";
}

}  // namespace restrip::tools
