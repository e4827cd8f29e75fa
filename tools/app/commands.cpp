#include "app/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/level_file.hpp"
#include "app/source.hpp"
#include "common/bad_input.hpp"
#include "common/report_output.hpp"
#include "common/stopwatch.hpp"
#include "files/output.hpp"
#include "files/reading.hpp"
#include "lod/baked_file.hpp"
#include "lod/baked_gltf.hpp"
#include "lod/coloring_check.hpp"
#include "lod/pm_file.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/mesh_report.hpp"
#include "replay/replay_text.hpp"
#include "replay/walk.hpp"
#include "replay/ways.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

BakedCosts costs_of(const BakedMesh& baked, double seconds) {
  if (baked.mesh.splits.empty()) return {};
  BakedMesh base{baked.mesh, baked.base, {}, {}};
  base.mesh.splits.clear();
  const auto records = static_cast<double>(baked.mesh.splits.size());
  return {static_cast<double>(baked.records.flips.size()) / records,
          static_cast<double>(baked_bytes(baked).size() - baked_bytes(base).size()) / records, seconds};
}

/// In the way of the plan; baked strips go on by the rules where a mesh goes its own ways.
WalkTaken take_walk(const Source& source, const ReplayCommand& command, const Plan& plan) {
  StripMesh mesh;
  if (source.original.empty()) {
    mesh = StripMesh::build(source.mesh.base, source.mesh.points.size());
    for (const Record& record : source.mesh.splits) mesh.insert_vertex(spokes_of(mesh, record), record.v_t);
  } else {
    mesh = StripMesh::build(source.original, source.mesh.points.size());
  }
  stripify(mesh);
  WalkTaken taken{{command.walk_steps, command.seed}, {}};
  taken.report = walk(mesh, taken.options, [&](StripMesh& on) { return plan.begin(on); });
  return taken;
}

}  // namespace

int run(const StatsCommand& command) {
  const ReportOutput out(command.json, {command.mesh});
  const bool baked = is_baked(command.mesh);
  if (baked || is_progressive(command.mesh)) {
    refuse_mending(command.mesh, command.mending);
    // The base is a mesh like any other.
    ProgressiveMesh mesh = baked ? read_baked_bytes(command.mesh).baked.mesh : read_pm(command.mesh);
    Soup soup;
    soup.points = std::move(mesh.points);
    soup.points.resize(soup.points.size() - mesh.splits.size());
    soup.triangles = std::move(mesh.base);
    const MeshReport report = report_on(soup);
    out.print(as_text(report, command.mesh.string() + " (its base)"), as_json(report));
    return 0;
  }
  Mended mended;
  const MeshReport report = report_on(read_mesh(command.mesh, command.mending, mended));
  mended.left_out_attributes.clear();  // nothing is written that could have them
  out.print(as_text(report, command.mesh.string(), mended), as_json(report, mended));
  return 0;
}

int run(const ReplayCommand& command) {
  std::optional<files::Output> level;
  if (!command.out.empty()) level.emplace(command.out, files::OutputRules{written_strip_extensions(), {command.mesh}});
  const ReportOutput out(command.json, {command.mesh, command.out});
  Source source = command.built_in
                      ? simplified("built-in torus", make_mesh(command.built_in_triangles), command.simplify)
                      : source_of(command.mesh, command.mending, command.simplify, command.simplify_given);
  const Way& way = command.way.empty() ? usual_way(source.baked.has_value()) : way_named(command.way);
  Plan::Given given;
  given.cost = command.cost;
  given.handles_along_strips = command.handles_along_strips;
  if (command.states != 0) given.search = {command.states, 0};
  if (source.baked) given.baked = &*source.baked;
  const Plan plan(way, source.mesh, given);
  source.subject.policy = way.name;
  source.subject.search = plan.search();
  source.subject.cost = plan.cost();
  if (plan.baked() != nullptr) source.subject.baked = costs_of(*plan.baked(), plan.seconds_to_bake());
  const ReplayReport report = replay(plan, source.original, command.replay);
  std::optional<WalkTaken> walk;
  if (command.walk_steps != 0 && report.operations_without_rule == 0) walk = take_walk(source, command, plan);

  std::string text = as_text(report, source.subject) + (walk ? as_text(*walk) : "");
  if (level && report.valid()) {
    const std::size_t triangles = command.out_triangles == 0 ? report.triangles : command.out_triangles;
    const LevelFile file = level_file(plan, triangles, files::extension_of(command.out), command.gltf);
    level->write(file.bytes);
    text += fmt::format("\n  {}: {} triangles in {} strips\n", command.out.string(), file.triangles, file.strips) +
            as_text(file.required_extensions, command.out.string());
  }
  out.print(text, as_json(report, source.subject, walk));
  return report.valid() && (!walk || walk->report.fault.empty()) ? 0 : 1;
}

int run(const SimplifyCommand& command) {
  std::vector<std::string> extensions = written_strip_extensions();
  extensions.emplace_back(".pm");
  const files::Output out(command.out, {extensions, {command.mesh}});
  const ReportOutput report(command.json, {command.mesh, command.out});
  Mended mended;
  const std::string extension = files::extension_of(command.out);
  const Soup soup = read_mesh(command.mesh, command.mending, mended, command.attributes);
  leave_out_attributes(soup, extension, mended);
  if (!mended.left_out_attributes.empty())  // before the work begins
    fmt::print(
        stderr, "restrip: {}: leaves out {}{}\n", command.out.string(), attributes_in_words(mended.left_out_attributes),
        command.attributes == ReadAttributes::no ? "; with --attributes .glb, .ply and .obj keep what they hold" : "");
  const Simplification result = simplify(soup, command.simplify);
  const ProgressiveMesh& made = result.mesh;
  nlohmann::ordered_json json{{"base_triangles", made.base.size()},
                              {"wanted_base_triangles", result.wanted_triangles},
                              {"stopped_short", result.stopped_short()},
                              {"splits", made.splits.size()},
                              {"triangles", made.fine_triangles()}};
  std::string text = as_text(mended);
  if (is_progressive(command.out) || extension.empty()) {
    out.write(pm_bytes(made));
    text += fmt::format("{}: {} triangles and {} splits to {}\n", command.out.string(), made.base.size(),
                        made.splits.size(), made.fine_triangles());
  } else {
    StripMesh base = StripMesh::build(made.base, made.points.size());
    stripify(base);
    const LevelFile file = level_file(base, made.points, extension, command.gltf, soup.attributes);
    out.write(file.bytes);
    json["strips"] = file.strips;
    text += fmt::format("{}: {} of {} triangles, in {} strips\n", command.out.string(), file.triangles,
                        made.fine_triangles(), file.strips);
    if (!file.required_extensions.empty()) json["required_extensions"] = file.required_extensions;
    text += as_text(file.required_extensions, command.out.string());
  }
  for (const Obstacle& obstacle : result.left_out.obstacles)
    json["obstacles"].push_back({{"why", obstacle.why}, {"edges", obstacle.edges}});
  add_to(json, mended);
  report.print(text, json.dump(2) + "\n");
  if (!result.stopped_short()) return 0;
  fmt::print(stderr, "restrip: {}: stopped at {} triangles, where {} were asked for: {}\n", command.out.string(),
             made.base.size(), result.wanted_triangles, why_no_coarser(result.left_out));
  return command.size_given ? 1 : 0;
}

int run(const BakeCommand& command) {
  const files::Output out(command.out, {baked_extensions(), {command.mesh}});
  const ReportOutput told(command.json, {command.mesh, command.out});
  Source source = source_of(command.mesh, command.mending, command.simplify, command.simplify_given);
  BakeReport report;
  BakedMesh baked = bake(std::move(source.mesh), command.bake, &report);
  if (source.baked) baked.payload = std::move(source.baked->payload);  // the records are the same
  std::string file = baked_bytes(baked);
  if (files::extension_of(command.out) == ".glb") file = baked_glb_bytes(file, command.gltf);
  const std::size_t bytes = file.size();
  out.write(file);
  const std::size_t records = baked.records.size();
  const auto each = static_cast<double>(std::max<std::size_t>(records, 1));
  const BakedCosts costs = costs_of(baked, report.seconds);
  nlohmann::ordered_json json{{"base_triangles", baked.base.triangle_count()},
                              {"triangles", baked.mesh.fine_triangles()},
                              {"records", records},
                              {"components", report.components},
                              {"base_strips", report.base_strips},
                              {"top_strips", report.top_strips},
                              {"top_indices", report.top_indices},
                              {"top_at_least", report.top_at_least},
                              {"most_strips", report.most_strips},
                              {"levels_with_fewest", report.fewest_levels},
                              {"flips_per_record", costs.flips_per_record},
                              {"bytes_per_record", costs.bytes_per_record},
                              {"bytes", bytes},
                              {"states", report.states},
                              {"seconds", report.seconds}};
  add_to(json, source.subject.mended);
  const auto required = required_extensions(files::extension_of(command.out), command.gltf, report.base_strips);
  if (!required.empty()) json["required_extensions"] = required;
  const std::string text =
      as_text(source.subject.mended) + as_text(required, command.out.string()) +
      fmt::format(
          "{}: {} triangles and {} records to {}\n"
          "{} strips at the base, {} at the finest level (where {} are needed at least), {} at most; {} connected "
          "components, {:.2f} % of the levels in as many strips\n"
          "{:.2f} flips and {:.1f} bytes a record, {} bytes in all; {:.1f} seconds\n",
          command.out.string(), baked.base.triangle_count(), records, baked.mesh.fine_triangles(), report.base_strips,
          report.top_strips, report.top_at_least, report.most_strips, report.components,
          100.0 * static_cast<double>(report.fewest_levels) / (each + 1), costs.flips_per_record,
          costs.bytes_per_record, bytes, report.seconds);
  told.print(text, json.dump(2) + "\n");
  return 0;
}

std::vector<std::string> baked_extensions() { return {std::string(baked_extension), ".glb"}; }

int run(const MakeMeshCommand& command) {
  const files::Output out(command.out, {written_mesh_extensions(), {}});
  const ReportOutput report(command.json, {command.out});
  const std::string format = files::extension_of(command.out);
  if (format.empty())  // a device
    throw BadInput(fmt::format("{}: has no extension that names a format; name a file that ends in {}",
                               command.out.string(), fmt::join(written_mesh_extensions(), ", ")));
  const Soup soup = make_mesh(command.triangles, command.seed);
  out.write(mesh_bytes(soup, format));
  const nlohmann::ordered_json json{{"vertices", soup.points.size()}, {"triangles", soup.triangles.size()}};
  report.print(
      fmt::format("{}: {} vertices, {} triangles\n", command.out.string(), soup.points.size(), soup.triangles.size()),
      json.dump(2) + "\n");
  return 0;
}

}  // namespace restrip::tools
