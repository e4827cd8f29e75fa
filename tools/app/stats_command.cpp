// `restrip stats`: counts the parts of a mesh and reports its faults.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "app/options.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/mesh_report.hpp"

namespace restrip::tools {
namespace {

struct StatsCommand {
  NamedFile mesh;
  MendingOptions mending;
  std::string json;
};

int run(const StatsCommand& command) {
  Report out(command.json);
  ReadMesh read = read_mesh_file(command.mesh);
  const std::string level = std::holds_alternative<Soup>(read) ? "" : " (its finest level)";
  Soup soup = finest_level(std::move(read));
  const Mended mended = mend(soup, command.mesh.string(), command.mending);
  const MeshReport report = report_on(soup);
  out.text = as_text(report, command.mesh.string() + level, mended);
  out.json = as_json(report, mended);
  out.print();
  return 0;
}

}  // namespace

Subcommand add_stats(CLI::App& app) {
  const auto kept = std::make_shared<StatsCommand>();
  StatsCommand& command = *kept;
  CLI::App* sub =
      app.add_subcommand("stats", "Count the triangles per vertex, the boundaries and the faults of a mesh");
  add_mesh_option(*sub, command.mesh, help_of_mesh())->required();
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip stats bunny.obj");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
