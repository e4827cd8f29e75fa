#include "commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "coloring_check.hpp"
#include "draw.hpp"
#include "mesh_file.hpp"
#include "mesh_report.hpp"
#include "pm_file.hpp"
#include "replay_text.hpp"
#include "restrip/operations.hpp"
#include "restrip/strips.hpp"
#include "stopwatch.hpp"
#include "walk.hpp"
#include "whole_file.hpp"

namespace restrip::replay {
namespace {

bool is_progressive(const std::filesystem::path& file) {
  return file.extension() == ".pm" || file.extension() == ".PM";
}

/// A mesh ready to be replayed, with the triangles that must come out (none for a file that has only the splits).
struct Source {
  Subject subject;
  ProgressiveMesh mesh;
  std::vector<Corners> original;
};

Source source_of(const ReplayCommand& command) {
  if (!command.built_in && is_progressive(command.mesh)) {
    Source source;
    source.subject.name = command.mesh.string();
    source.mesh = read_pm(command.mesh);
    BuildReport report;
    const StripMesh base = StripMesh::build(source.mesh.base, source.mesh.points.size(), &report);
    source.subject.left_out = {report.degenerate_triangles, report.irregular_vertices, 0};
    return source;
  }
  Soup soup = command.built_in ? make_mesh(command.built_in_triangles) : read_mesh(command.mesh);
  Simplification simplified = simplify(soup, command.simplify);
  Source source;
  source.subject.name = command.built_in ? "built-in torus" : command.mesh.string();
  source.subject.wanted_triangles = simplified.wanted_triangles;
  source.subject.left_out = simplified.left_out;
  source.mesh = std::move(simplified.mesh);
  source.original = std::move(soup.triangles);
  return source;
}

/// Moves each vertex to the mean of its neighbours, so that the made mesh's jitter does not hide it in a picture.
void smooth(Soup& soup, int rounds) {
  for (; rounds > 0; --rounds) {
    std::vector<Point> sum(soup.points.size());
    std::vector<float> count(soup.points.size(), 0);
    for (const Corners& t : soup.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = soup.points[t[(i + 1) % 3]];
        Point& s = sum[t[i]];
        s = {s.x + p.x, s.y + p.y, s.z + p.z};
        count[t[i]] += 1;
      }
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
      if (count[v] > 0) soup.points[v] = {sum[v].x / count[v], sum[v].y / count[v], sum[v].z / count[v]};
  }
}

WalkTaken take_walk(const Source& source, const ReplayCommand& command) {
  StripMesh mesh;
  if (source.original.empty()) {
    mesh = StripMesh::build(source.mesh.base, source.mesh.points.size());
    for (const Record& record : source.mesh.splits) mesh.insert_vertex(spokes_of(mesh, record), record.v_t);
  } else {
    mesh = StripMesh::build(source.original, source.mesh.points.size());
  }
  stripify(mesh);
  WalkTaken taken{{command.walk_steps, command.seed}, {}};
  taken.report = walk(mesh, taken.options);
  return taken;
}

}  // namespace

int run(const StatsCommand& command) {
  if (is_progressive(command.mesh)) {
    // The base is a mesh like any other.
    ProgressiveMesh mesh = read_pm(command.mesh);
    Soup soup;
    soup.points = std::move(mesh.points);
    soup.points.resize(soup.points.size() - mesh.splits.size());
    soup.triangles = std::move(mesh.base);
    const MeshReport report = report_on(soup);
    fmt::print("{}", command.json ? as_json(report) : as_text(report, command.mesh.string() + " (its base)"));
    return 0;
  }
  const MeshReport report = report_on(read_mesh(command.mesh));
  fmt::print("{}", command.json ? as_json(report) : as_text(report, command.mesh.string()));
  return 0;
}

int run(const ReplayCommand& command) {
  const Source source = source_of(command);
  const ReplayReport report = replay(source.mesh, source.original, command.replay);
  std::optional<WalkTaken> walk;
  if (command.walk_steps != 0 && report.operations_without_rule == 0) walk = take_walk(source, command);

  const std::string json = command.json.empty() ? "" : as_json(report, source.subject, walk);
  if (command.json == "-") {
    fmt::print("{}", json);
  } else {
    if (!command.json.empty()) write_whole_file(command.json, json);
    fmt::print("{}", as_text(report, source.subject));
    if (walk) fmt::print("{}", as_text(*walk));
  }
  return report.valid() && (!walk || walk->report.fault.empty()) ? 0 : 1;
}

int run(const SimplifyCommand& command) {
  const Simplification result = simplify(read_mesh(command.mesh), command.simplify);
  write_pm(command.out, result.mesh);
  fmt::print("{}: {} triangles and {} splits to {}\n", command.out.string(), result.mesh.base.size(),
             result.mesh.splits.size(), result.mesh.fine_triangles());
  if (result.mesh.base.size() > result.wanted_triangles)
    fmt::print("a base of {} triangles was wanted; no further collapse is legal\n", result.wanted_triangles);
  return 0;
}

int run(const MakeMeshCommand& command) {
  const Soup soup = make_mesh(command.triangles, command.seed);
  write_mesh(command.out, soup);
  fmt::print("{}: {} vertices, {} triangles\n", command.out.string(), soup.points.size(), soup.triangles.size());
  return 0;
}

int run(const StripifyCommand& command) {
  const Soup soup = read_mesh(command.mesh);
  BuildReport report;
  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size(), &report);
  Medians clock;
  clock.time([&] { stripify(mesh, command.effort); });
  const Strips strips = extract_strips(mesh);
  const std::size_t indices = strip_index_count(mesh, strips);
  const std::vector<std::string> faults = find_faults(mesh);
  const std::size_t left_out = report.degenerate_triangles + report.out_of_range_triangles;
  const double seconds = clock.nanoseconds() * 1e-9;
  if (command.json) {
    const nlohmann::ordered_json json{{"triangles", mesh.triangle_count()},
                                      {"left_out", left_out},
                                      {"strips", strips.size()},
                                      {"pieces", connected_pieces(mesh)},
                                      {"indices", indices},
                                      {"seconds", seconds},
                                      {"valid", faults.empty()}};
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print(
        "{}: {} triangles ({} degenerate ones left out) in {} strips, {} connected pieces\n"
        "{:.3f} indices per triangle, {:.3f} seconds\n",
        command.mesh.string(), mesh.triangle_count(), left_out, strips.size(), connected_pieces(mesh),
        static_cast<double>(indices) / static_cast<double>(std::max<std::size_t>(mesh.triangle_count(), 1)), seconds);
  }
  for (const std::string& fault : faults) fmt::print(stderr, "{}\n", fault);
  return faults.empty() ? 0 : 1;
}

int run(const DrawCommand& command) {
  constexpr std::size_t triangles_in_a_picture = 2400;
  Soup soup = command.mesh.empty() ? make_mesh(triangles_in_a_picture) : read_mesh(command.mesh);
  if (command.mesh.empty()) smooth(soup, 4);
  const ProgressiveMesh source = simplify(soup, {}).mesh;
  StripMesh mesh = StripMesh::build(source.base, source.points.size());
  stripify(mesh);
  for (const Record& record : source.splits) split(mesh, spokes_of(mesh, record), record.v_t);
  // Six triangles, five of them in one strip that enters and leaves, the last one in a strip of its own.
  constexpr SplitPosition at{6, 3};
  constexpr Word loop = 0b001111;
  constexpr Word ports = 0b110001;
  write_whole_file(command.out, svg_of({{draw_mesh(mesh, source.points), "a mesh coloured by strip"},
                                        {draw_fan(at, loop, ports), "a 6-vertex; solid: strip, dashed: no strip"},
                                        {draw_split(at, loop, ports), "split, and repaired by its rule"}}));
  return 0;
}

}  // namespace restrip::replay
