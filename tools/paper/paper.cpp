#include "paper/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/counted.hpp"
#include "common/progress.hpp"
#include "lod/coloring_check.hpp"
#include "replay/methods.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

std::size_t isolated_in(const StripMesh& mesh, const std::vector<Triangle>& patch) {
  return static_cast<std::size_t>(
      std::count_if(patch.begin(), patch.end(), [&](Triangle t) { return mesh.solid_degree(t) == 0; }));
}

}  // namespace

std::optional<PaperRow> paper_row(std::size_t triangles) {
  static const std::vector<PaperRow> rows{
      {"bunny", 69451, {0, 2, 31, 111, 438, 3875, 26165, 3888, 298, 22, 3, 1}, 51.5},
      {"dragon",
       871414,
       {0, 775, 1073, 2244, 39545, 119944, 141423, 83482, 34087, 10931, 3145, 770, 170, 44, 10, 2},
       std::nullopt}};
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const PaperRow& r) { return r.triangles == triangles; });
  return row == rows.end() ? std::nullopt : std::optional(*row);
}

PaperMesh measure(const Source& subject, std::size_t levels) {
  const ProgressiveMesh& source = subject.mesh;
  PaperMesh result;
  result.name = std::filesystem::path(subject.subject.name).filename().string();
  result.survey = report_on({source.points, subject.original});
  result.mended = subject.subject.mended;
  result.triangles = subject.original.size();
  result.paper = paper_row(result.triangles);
  StripMesh base = StripMesh::build(source.base, source.points.size());
  stripify(base, Effort::full, Cost::strips());
  result.base_triangles = base.triangle_count();

  // Plays all splits and measures each level.
  const auto climb = [&](const std::string& label, const StripMesh& mesh, auto&& step, auto&& at_level) {
    Progress progress(result.name + ": " + label, source.splits.size());
    const auto sizes = level_sizes(result.base_triangles, source.fine_triangles(), levels);
    std::size_t next = 0;
    for (std::size_t i = 0; i < source.splits.size(); ++i) {
      if (next != sizes.size() && mesh.triangle_count() >= sizes[next]) {
        ++next;
        at_level();
      }
      step(source.splits[i]);
      progress.at(i);
    }
    at_level();
  };
  const auto count = [&result](const StripMesh& mesh, const std::string& label) {
    const ColoringReport report = check_coloring(mesh);
    if (!report.valid)
      result.faults.push_back(fmt::format("{}: invalid strips at {} triangles", label, report.triangles));
    return level_of(mesh, result.faults);
  };
  const auto insert = [](StripMesh& mesh, const Record& record) {
    mesh.insert_vertex(spokes_of(mesh, record), record.v_t);
  };
  StripMesh finest = base;
  for (const Record& record : source.splits) insert(finest, record);
  const std::vector<Corners> fine_triangles = sorted_triangles(corners_of(finest));

  // By each method of keeping strips.
  for (const Method::Kind kind : {Method::Kind::paper, Method::Kind::ours})
    for (const Method& method : methods()) {
      if (method.kind != kind) continue;
      PreparedMethod::Given given;
      given.cost = Cost::strips();
      given.base = &base;
      const PreparedMethod prepared(method, source, given);
      StripMesh mesh = prepared.base();
      const auto maintainer = prepared.begin(mesh);
      PolicyRun run{method.name, method.description, method.kind == Method::Kind::paper};
      std::vector<Triangle> patch;
      std::vector<std::size_t> by_valence;
      const auto step = [&](const Record& record) {
        const auto where = spokes_of(mesh, record);
        fan_triangles(mesh, record.v_l == none ? where.right : where.left, patch);
        if (patch.size() >= by_valence.size()) by_valence.resize(patch.size() + 1);
        ++by_valence[patch.size()];
        const std::size_t before = isolated_in(mesh, patch);
        const StripMesh::Halfedge chord = maintainer->split(where, record.v_t, run.splits).halfedge;
        edge_triangles(mesh, chord, patch);
        run.isolating += static_cast<std::size_t>(isolated_in(mesh, patch) > before);
        ++run.splits;
        maintainer->between();
      };
      climb(method.name, mesh, step, [&] { run.levels.push_back(count(mesh, method.name)); });
      if (sorted_triangles(corners_of(mesh)) != fine_triangles)
        result.faults.push_back(fmt::format("{}: the last split does not lead to the mesh", method.name));
      result.splits_by_valence = std::move(by_valence);
      result.runs.push_back(std::move(run));
    }

  // From scratch.
  PolicyRun fast{"scratch-fast", "strips from scratch at each level, one pass"};
  PolicyRun full{"scratch-full", "strips from scratch at each level, with tunnelling"};
  StripMesh mesh = base;
  climb(
      "from scratch", mesh, [&](const Record& record) { insert(mesh, record); },
      [&] {
        stripify(mesh, Effort::fast, Cost::strips());
        fast.levels.push_back(count(mesh, fast.name));
        stripify(mesh, Effort::full, Cost::strips());
        full.levels.push_back(count(mesh, full.name));
      });
  result.scratch = {std::move(fast), std::move(full)};
  return result;
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
    for (const PolicyRun& run : mesh.scratch)
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
  const auto scratch = [&](const PolicyRun& run) -> Json {
    return {{"name", run.name}, {"says", run.says}, {"levels", list_of(run.levels, level)}};
  };
  const auto valences = [](const PaperMesh& mesh) {
    const auto at = [](const std::vector<std::size_t>& row, std::size_t n) { return n < row.size() ? row[n] : 0; };
    const std::vector<std::size_t>& here = mesh.survey.triangles_per_vertex;
    const std::size_t end = std::max(here.size(), mesh.paper ? mesh.paper->triangles_per_vertex.size() : 0);
    Json rows = Json::array();
    for (std::size_t n = 1; n < end; ++n)
      rows.push_back(
          {{"triangles", n},
           {"vertices", at(here, n)},
           {"percent", 100 * static_cast<double>(at(here, n)) / static_cast<double>(mesh.survey.used_vertices)},
           {"paper", mesh.paper ? Json(at(mesh.paper->triangles_per_vertex, n)) : Json(nullptr)}});
    return rows;
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
              {"valence", valences(mesh)},
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
