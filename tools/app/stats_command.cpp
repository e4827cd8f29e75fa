// `restrip stats`: what a mesh has, and what is wrong with it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/commands.hpp"
#include "app/options.hpp"
#include "app/source.hpp"
#include "common/report_output.hpp"
#include "lod/baked_gltf.hpp"
#include "lod/pm_file.hpp"
#include "meshes/mend.hpp"
#include "meshes/mesh_report.hpp"

namespace restrip::tools {
namespace {

struct StatsCommand {
  std::filesystem::path mesh;
  MendingOptions mending;
  std::string json;
};

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

}  // namespace

Subcommand add_stats(CLI::App& app) {
  const auto kept = std::make_shared<StatsCommand>();
  StatsCommand& command = *kept;
  CLI::App* sub = app.add_subcommand("stats", "Count what a mesh has: triangles per vertex, boundary, faults");
  sub->add_option("mesh", command.mesh,
                  mesh_formats() + "; a progressive mesh (.pm) or a baked one (.baked, .glb): its base")
      ->required();
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip stats bunny.obj");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
