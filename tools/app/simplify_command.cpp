// `restrip simplify`: writes a coarser mesh or a progressive mesh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "common/printable.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/mend.hpp"
#include "meshes/soup_builder.hpp"
#include "replay/source.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {
namespace {

struct SimplifyCommand {
  NamedFile mesh;
  NamedFile out;  ///< .pm: a progressive mesh; otherwise its base, stripified from scratch
  StripOptions strips;
  bool progressive = false;  ///< all levels in a .glb
  SimplifyOptions simplify;
  bool size_given = false;                         ///< set by the caller: stopping short of it is then a failure
  ReadAttributes attributes = ReadAttributes::no;  ///< if kept, vertices that differ in them are separate
  MendingOptions mending;
  std::string json;
};

int run(const SimplifyCommand& command) {
  const files::Output out = open_output(command.out, extensions_of(writes_strips_or_progressive));
  Report report(command.json);
  const MeshFormat& format = format_to_write(command.out, writes_strips_or_progressive, ".pm");
  Soup soup = read_mesh(command.mesh, command.attributes);
  Mended mended = mend(soup, command.mesh.string(), command.mending);
  leave_out_losses(soup, format, mended);
  if (soup.attributes.empty()) close_seams(soup, mended);
  const Simplification result = simplify(soup, command.simplify);
  const ProgressiveMesh& made = result.mesh;
  const std::string name = command.out.string();
  report.json = {{"base_triangles", made.base.size()},
                 {"wanted_base_triangles", result.wanted_triangles},
                 {"stopped_short", result.stopped_short()},
                 {"splits", made.splits.size()},
                 {"triangles", made.fine_triangles()}};
  report.add(mended);
  if (!mended.left_out.empty() && command.attributes == ReadAttributes::no)
    report.text += "with --attributes, .glb, .ply and .obj keep the attributes that the format has\n";
  if (!soup.attributes.empty())
    report.text +=
        "attributes are carried, not weighed: if they matter more than the shape, simplify with a program that weighs "
        "them, then use restrip\n";
  if (command.progressive || !writes_strips(format)) {
    out.write(format.write_progressive(made));
    report.text += fmt::format("{}: {} and {} to {}\n", name, counted(made.base.size(), "triangle"),
                               counted(made.splits.size(), "split"), made.fine_triangles());
  } else {
    StripMesh base = StripMesh::build(made.base, made.points.size());
    stripify(base);
    const LevelFile file = level_file(base, made.points, format, command.strips, soup.attributes);
    out.write(file.written.bytes);
    report.json["strips"] = file.strips;
    report.text += fmt::format("{}: {} of {}, in {}\n", name, file.triangles,
                               counted(made.fine_triangles(), "triangle"), counted(file.strips, "strip"));
    report.add(file.written, name);
  }
  for (const Obstacle& obstacle : result.left_out.obstacles)
    report.json["obstacles"].push_back({{"why", obstacle.why}, {"edges", obstacle.edges}});
  report.print();
  if (!result.stopped_short()) return 0;
  fmt::print(stderr, "restrip: {}: stopped at {}, but {}: {}\n", files::printable(name),
             counted(made.base.size(), "triangle"), counted(result.wanted_triangles, "was requested", "were requested"),
             why_no_coarser(result.left_out));
  return command.size_given ? 1 : 0;
}

}  // namespace

Subcommand add_simplify(CLI::App& app) {
  const auto kept = std::make_shared<SimplifyCommand>();
  SimplifyCommand& command = *kept;
  CLI::App* sub = app.add_subcommand("simplify", "Simplify a mesh and write it, or write a progressive mesh");
  add_mesh_option(*sub, command.mesh, help_of_mesh())->required();
  add_output_option(
      *sub, command.out, extensions_of(writes_strips_or_progressive),
      ".pm: a progressive mesh as OpenMesh writes it; or the coarsest level with strips: " + strip_formats())
      ->required();
  CLI::Option* triangles =
      sub->add_option("--triangles", command.simplify.triangles, "of the coarsest level, in place of --base")
          ->check(whole_number_from(1, max_triangles));
  add_simplify_options(*sub, command.simplify);
  add_strip_options(*sub, command.strips, nullptr, &command.progressive);
  sub->add_flag_callback(
      "--attributes", [&command] { command.attributes = ReadAttributes::yes; },
      "keep normals, texture coordinates and colours: a place at which they differ is several vertices, and such "
      "seams stay; without it seams are closed. Attributes are carried, not weighed");
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, triangles, &command] {
    check_strip_options(*sub, command.out, command.strips);
    command.size_given = triangles->count() + sub->count("--base") != 0;
    if (!triangles->empty() && sub->count("--base") != 0)
      throw CLI::ValidationError("--triangles", "and --base both set the size; leave one out");
  });
  sub->footer(
      "Only the shape decides which edges collapse. If colours or textures must be weighed, simplify with a program\n"
      "that does so (meshoptimizer, for example), then use restrip on its result.\n"
      "If no remaining edge may collapse, the mesh is written as it is then, and standard error and\n"
      "--json give the reason. If --base or --triangles requested a coarser mesh, the exit code is 1.\n"
      "Example: restrip simplify bunny.obj --base 0.01 -o bunny.pm");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
