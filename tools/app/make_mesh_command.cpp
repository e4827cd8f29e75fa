// `restrip make-mesh`: makes a mesh for experiments.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "common/progress.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/made_mesh.hpp"

namespace restrip::tools {
namespace {

struct MakeMeshCommand {
  NamedFile out;
  std::size_t triangles = default_made_triangles;
  std::uint64_t seed = 1;
  std::string json;
};

int run(const MakeMeshCommand& command) {
  const files::Output out = open_output(command.out, extensions_of(writes_mesh));
  Report report(command.json);
  const MeshFormat& format = format_to_write(command.out, writes_mesh);
  const Soup soup = [&command] {
    const Progress progress("making a mesh", 1);
    return make_mesh(command.triangles, command.seed);
  }();
  out.write(format.write_mesh(soup));
  report.json = {{"vertices", soup.points.size()}, {"triangles", soup.triangles.size()}};
  report.text = fmt::format("{}: {}, {}\n", command.out.string(), counted(soup.points.size(), "vertex", "vertices"),
                            counted(soup.triangles.size(), "triangle"));
  report.print();
  return 0;
}

}  // namespace

Subcommand add_make_mesh(CLI::App& app) {
  const auto kept = std::make_shared<MakeMeshCommand>();
  MakeMeshCommand& command = *kept;
  CLI::App* sub =
      app.add_subcommand("make-mesh", "Make a closed mesh of irregular valences, the same on every machine");
  add_output_option(*sub, command.out, extensions_of(writes_mesh),
                    "a file that ends in " + list_in_words(extensions_of(writes_mesh), "or"))
      ->required();
  sub->add_option("--triangles", command.triangles, "approximate number")
      ->check(whole_number_from(least_made_triangles, most_made_triangles))
      ->capture_default_str();
  sub->add_option("--seed", command.seed, "of its irregularities")->check(whole_number())->capture_default_str();
  add_json_option(*sub, command.json);
  sub->footer("Example: restrip make-mesh --triangles 1000000 -o torus.ply");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
