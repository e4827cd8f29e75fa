// `restrip simplify`: a coarser mesh, or the way back as a progressive mesh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/commands.hpp"
#include "app/level_file.hpp"
#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/report_output.hpp"
#include "files/output.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/soup_builder.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

struct SimplifyCommand {
  std::filesystem::path mesh;
  std::filesystem::path out;  ///< .pm: a progressive mesh; else its base, with strips from scratch
  GltfPrimitives gltf = GltfPrimitives::restart;
  SimplifyOptions simplify;
  MendingOptions mending;
  std::string json;
};

int run(const SimplifyCommand& command) {
  const files::Output out(command.out, {extensions_of(writes_strips_or_progressive), {command.mesh}});
  const ReportOutput report(command.json, {command.mesh, command.out});
  const MeshFormat& format = format_to_write(command.out, writes_strips_or_progressive, ".pm");
  Mended mended;
  const Simplification result = simplify(read_mesh(command.mesh, command.mending, mended), command.simplify);
  const ProgressiveMesh& made = result.mesh;
  nlohmann::ordered_json json{{"base_triangles", made.base.size()},
                              {"wanted_base_triangles", result.wanted_triangles},
                              {"splits", made.splits.size()},
                              {"triangles", made.fine_triangles()}};
  std::string text = as_text(mended);
  if (format.write_progressive != nullptr) {
    out.write(format.write_progressive(made));
    text += fmt::format("{}: {} and {} to {}\n", command.out.string(), counted(made.base.size(), "triangle"),
                        counted(made.splits.size(), "split"), made.fine_triangles());
  } else {
    StripMesh base = StripMesh::build(made.base, made.points.size());
    stripify(base);
    const LevelFile file = level_file(base, made.points, format, command.gltf);
    out.write(file.bytes);
    json["strips"] = file.strips;
    text += fmt::format("{}: {} of {}, in {}\n", command.out.string(), file.triangles,
                        counted(made.fine_triangles(), "triangle"), counted(file.strips, "strip"));
  }
  if (made.base.size() > result.wanted_triangles)
    text += fmt::format("a base of {} was wanted; {}\n", counted(result.wanted_triangles, "triangle"),
                        why_no_coarser(result.left_out));
  add_to(json, mended);
  report.print(text, json.dump(2) + "\n");
  return 0;
}

}  // namespace

Subcommand add_simplify(CLI::App& app) {
  const auto kept = std::make_shared<SimplifyCommand>();
  SimplifyCommand& command = *kept;
  CLI::App* sub = app.add_subcommand("simplify", "Simplify a mesh and write it, or the way back as a progressive mesh");
  sub->add_option("mesh", command.mesh, help_of_mesh())->required();
  sub->add_option(
         "-o,--output", command.out,
         ".pm: a progressive mesh as OpenMesh writes it; or the coarsest level with strips: " + strip_formats())
      ->required();
  CLI::Option* triangles =
      sub->add_option("--triangles", command.simplify.triangles, "of the coarsest level, in place of --base")
          ->check(CLI::Range(std::size_t{1}, max_triangles));
  add_simplify_options(*sub, command.simplify);
  const CLI::Option* gltf = add_gltf_option(*sub, command.gltf);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, triangles, gltf, &command] {
    refuse_gltf_elsewhere(*gltf, command.out);
    if (!triangles->empty() && sub->count("--base") != 0)
      throw CLI::ValidationError("--triangles", "and --base say the same thing twice; leave one out");
  });
  sub->footer("Example: restrip simplify bunny.obj --base 0.01 -o bunny.pm");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
