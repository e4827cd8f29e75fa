// The figures of `restrip paper` as CSV, JSON and text.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/counted.hpp"
#include "paper/paper.hpp"

namespace restrip::tools {
namespace {

/// A field of a CSV file (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

template <class... Fields>
void add_row(std::string& csv, const char* format, const Fields&... fields) {
  csv += fmt::format(fmt::runtime(format), fields...);
  csv += '\n';
}

}  // namespace

std::vector<files::NamedBytes> csv_files(const RuleFigures& figures) {
  std::string positions = "k,a,b\n";
  for (const SplitPosition& at : figures.positions) add_row(positions, "{},{},{}", at.k, at.a, at.k - at.a);

  std::string rules = "a,loop,ports,inner,strips,isolated,orbit\n";
  for (const RuleFigures::FourVertex& four : figures.four)
    for (const RuleOfOrbit& r : four.all)
      add_row(rules, "{},{},{},{},{},{},{}", r.at.a, r.loop, r.ports, r.inner, r.strips, r.isolated, r.orbit);

  std::string counts = "k,a,valid,lonely,rule_isolates,rule_adds_strip,orbits\n";
  std::string lonely = "k,a,loop,ports,orbit,whole,isolated_if_whole,inner,strips,isolated\n";
  for (const LonelyCount& count : figures.lonely) {
    add_row(counts, "{},{},{},{},{},{},{}", count.at.k, count.at.a, count.valid, count.lonely, count.isolated,
            count.adding_strip, count.orbits.size());
    for (const LonelyRule& one : count.orbits) {
      const RuleOfOrbit& r = one.rule;
      add_row(lonely, "{},{},{},{},{},{},{},{},{},{}", r.at.k, r.at.a, r.loop, r.ports, r.orbit, one.whole,
              one.isolated_if_whole, r.inner, r.strips, r.isolated);
    }
  }
  return {{"positions.csv", positions}, {"rules-4.csv", rules}, {"lonely-counts.csv", counts}, {"lonely.csv", lonely}};
}

std::vector<files::NamedBytes> csv_files(const std::vector<PaperMesh>& meshes) {
  std::string valence = "mesh,triangles_per_vertex,vertices,percent,paper_vertices\n";
  std::string isolating = "mesh,policy,splits,isolating,percent\n";
  std::string strips = "mesh,policy,triangles,strips,isolated\n";
  for (const PaperMesh& mesh : meshes) {
    const std::string name = field(mesh.name);
    for (const ValenceRow& row : valence_rows(mesh))
      add_row(valence, "{},{},{},{:.2f},{}", name, row.triangles, row.vertices, row.percent,
              row.paper ? fmt::format("{}", *row.paper) : std::string());
    for (const PolicyRun& run : mesh.runs) {
      add_row(isolating, "{},{},{},{},{:.2f}", name, run.name, run.splits, run.isolating, run.isolating_percent());
      for (const Level& level : run.levels)
        add_row(strips, "{},{},{},{},{}", name, run.name, level.triangles, level.strips, level.isolated);
    }
    for (const ScratchRun& run : mesh.scratch)
      for (const Level& level : run.levels)
        add_row(strips, "{},{},{},{},{}", name, run.name, level.triangles, level.strips, level.isolated);
  }
  return {{"valence.csv", valence}, {"isolating.csv", isolating}, {"strips.csv", strips}};
}

std::string as_text(const std::vector<PaperMesh>& meshes) {
  std::string text;
  for (const PaperMesh& mesh : meshes) {
    text += fmt::format("{}: {}, base {}\n", mesh.name, counted(mesh.triangles, "triangle"), mesh.base_triangles);
    text += as_text(mesh.mended);
    if (mesh.paper)
      text += fmt::format("  triangles per vertex: {} the paper's {}\n",
                          mesh.equals_paper() ? "equal, row for row, to" : "NOT equal to", mesh.paper->mesh);
    text += fmt::format("  {:<20}{:>12}{:>22}{:>14}\n", "policy", "isolating", "strips at the top", "isolated");
    for (const PolicyRun& run : mesh.runs)
      text += fmt::format("  {:<20}{:>10.2f} %{:>22}{:>14}\n", run.name, run.isolating_percent(),
                          run.levels.back().strips, run.levels.back().isolated);
    for (const ScratchRun& run : mesh.scratch)
      text += fmt::format("  {:<20}{:>12}{:>22}{:>14}\n", run.name, "", run.levels.back().strips,
                          run.levels.back().isolated);
    for (const std::string& fault : mesh.faults) text += fmt::format("  FAULT: {}\n", fault);
  }
  return text;
}

nlohmann::ordered_json as_json(const RuleFigures& figures, const std::vector<PaperMesh>& meshes,
                               const PaperOptions& options) {
  using Json = nlohmann::ordered_json;
  const auto list_of = [](const auto& items, auto&& json_of) {
    Json json = Json::array();
    for (const auto& item : items) json.push_back(json_of(item));
    return json;
  };
  const auto rule = [](const RuleOfOrbit& r) -> Json {
    return {{"loop", r.loop},     {"ports", r.ports},       {"inner", r.inner},
            {"strips", r.strips}, {"isolated", r.isolated}, {"orbit", r.orbit}};
  };
  const auto lonely_rule = [&](const LonelyRule& one) {
    Json json = rule(one.rule);
    json["whole"] = one.whole;
    json["isolated_if_whole"] = one.isolated_if_whole;
    return json;
  };
  const auto lonely = [&](const LonelyCount& count) -> Json {
    return {{"k", count.at.k},
            {"a", count.at.a},
            {"valid", count.valid},
            {"lonely", count.lonely},
            {"rule_isolates", count.isolated},
            {"rule_adds_strip", count.adding_strip},
            {"orbits", list_of(count.orbits, lonely_rule)}};
  };
  const auto four = [&](const RuleFigures::FourVertex& f) -> Json {
    return {
        {"a", f.at.a}, {"loop_orbits", f.loops}, {"by_loop", list_of(f.by_loop, rule)}, {"all", list_of(f.all, rule)}};
  };
  const auto level = [](const Level& l) -> Json {
    return {{"triangles", l.triangles}, {"strips", l.strips}, {"isolated", l.isolated}};
  };
  const auto policy = [&](const PolicyRun& run) -> Json {
    return {{"policy", run.name},   {"says", run.says},           {"of_paper", run.of_paper},
            {"splits", run.splits}, {"isolating", run.isolating}, {"levels", list_of(run.levels, level)}};
  };
  const auto scratch = [&](const ScratchRun& run) -> Json {
    return {{"name", run.name}, {"says", run.says}, {"levels", list_of(run.levels, level)}};
  };
  const auto valence = [](const ValenceRow& row) -> Json {
    return {{"triangles", row.triangles},
            {"vertices", row.vertices},
            {"percent", row.percent},
            {"paper", row.paper ? Json(*row.paper) : Json(nullptr)}};
  };
  const auto paper = [](const PaperRow& row) -> Json {
    return {{"mesh", row.mesh},
            {"isolating_percent", row.isolating_percent ? Json(*row.isolating_percent) : Json(nullptr)}};
  };
  const auto mesh_of = [&](const PaperMesh& mesh) {
    Json by_valence = Json::object();
    for (std::size_t k = 0; k < mesh.splits_by_valence.size(); ++k)
      if (mesh.splits_by_valence[k] != 0) by_valence[std::to_string(k)] = mesh.splits_by_valence[k];
    Json json{{"mesh", mesh.name},
              {"triangles", mesh.triangles},
              {"base_triangles", mesh.base_triangles},
              {"used_vertices", mesh.survey.used_vertices},
              {"paper", mesh.paper ? paper(*mesh.paper) : Json(nullptr)},
              {"equals_paper", mesh.paper ? Json(mesh.equals_paper()) : Json(nullptr)},
              {"valence", list_of(valence_rows(mesh), valence)},
              {"splits_by_valence", std::move(by_valence)},
              {"policies", list_of(mesh.runs, policy)},
              {"scratch", list_of(mesh.scratch, scratch)},
              {"faults", mesh.faults}};
    add_to(json, mesh.mended);
    return json;
  };
  const auto position = [](const SplitPosition& at) -> Json { return {{"k", at.k}, {"a", at.a}}; };
  return {{"base", options.simplify.base},
          {"boundary", options.simplify.boundary == BoundaryPolicy::lock ? "lock" : "move"},
          {"levels", options.levels},
          {"table_max_k", table_max_k},
          {"split_positions", figures.positions.size()},
          {"positions", list_of(figures.positions, position)},
          {"four_vertex", list_of(figures.four, four)},
          {"lonely", list_of(figures.lonely, lonely)},
          {"meshes", list_of(meshes, mesh_of)}};
}

}  // namespace restrip::tools
