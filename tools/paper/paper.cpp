#include "paper/paper.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "common/progress.hpp"
#include "lod/coloring_check.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/seams.hpp"
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

std::vector<ValenceRow> valence_rows(const PaperMesh& mesh) {
  const auto at = [](const std::vector<std::size_t>& row, std::size_t n) { return n < row.size() ? row[n] : 0; };
  const std::vector<std::size_t>& here = mesh.survey.triangles_per_vertex;
  const std::size_t end = std::max(here.size(), mesh.paper ? mesh.paper->triangles_per_vertex.size() : 0);
  std::vector<ValenceRow> rows;
  for (std::size_t n = 1; n < end; ++n) {
    ValenceRow row{n, at(here, n), 0, std::nullopt};
    row.percent = 100 * static_cast<double>(row.vertices) / static_cast<double>(mesh.survey.used_vertices);
    if (mesh.paper) row.paper = at(mesh.paper->triangles_per_vertex, n);
    rows.push_back(row);
  }
  return rows;
}

PaperSubject read_subject(const std::filesystem::path& file, const MendingOptions& mending) {
  PaperSubject subject;
  subject.name = file.filename().string();
  ReadMesh read = read_mesh_file(file);
  if (auto* soup = std::get_if<Soup>(&read)) {
    subject.mended = mend(*soup, file.string(), mending);
    close_seams(*soup, subject.mended);
    subject.soup = std::move(*soup);
    return subject;
  }
  refuse_mending(file, mending);
  auto* baked = std::get_if<BakedBytes>(&read);
  subject.progressive = std::move(baked != nullptr ? baked->baked.mesh : std::get<ProgressiveMesh>(read));
  subject.soup = finest_level(*subject.progressive);
  return subject;
}

PaperMesh measure(const PaperSubject& subject, const PaperOptions& options) {
  PaperMesh result;
  result.name = subject.name;
  result.survey = report_on(subject.soup);
  result.mended = subject.mended;
  result.triangles = subject.soup.triangles.size();
  result.paper = paper_row(result.triangles);
  const ProgressiveMesh source =
      subject.progressive ? *subject.progressive : simplify(subject.soup, options.simplify).mesh;
  StripMesh base = StripMesh::build(source.base, source.points.size());
  stripify(base, Effort::full, Cost::strips());
  result.base_triangles = base.triangle_count();

  // Plays all splits and measures each level.
  const auto climb = [&](const std::string& label, const StripMesh& mesh, auto&& step, auto&& at_level) {
    Progress progress(result.name + ": " + label, source.splits.size());
    const auto sizes = level_sizes(result.base_triangles, source.fine_triangles(), options.levels);
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
      PolicyRun run{method.name, method.description, method.kind == Method::Kind::paper, 0, 0, {}};
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
  ScratchRun fast{"scratch-fast", "strips from scratch at each level, one pass", {}};
  ScratchRun full{"scratch-full", "strips from scratch at each level, with tunnelling", {}};
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

}  // namespace restrip::tools
