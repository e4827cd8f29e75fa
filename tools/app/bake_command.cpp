// `restrip bake`: precomputes the strips of every level of detail and writes them with the mesh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "lod/bake.hpp"
#include "lod/baked_file.hpp"
#include "lod/mesh_files.hpp"
#include "meshes/strip_file.hpp"
#include "replay/replay.hpp"
#include "replay/source.hpp"

namespace restrip::tools {
namespace {

struct BakeCommand {
  NamedFile mesh;
  NamedFile out;
  SimplifyOptions simplify;
  bool simplify_given = false;
  BakeOptions bake;
  std::optional<Cost> cost;
  StripOptions strips;
  MendingOptions mending;
  std::string json;
};

int run(const BakeCommand& command) {
  const files::Output out = open_output(command.out, extensions_of(writes_baked));
  Report report(command.json);
  const MeshFormat& format = format_to_write(command.out, writes_baked, ".baked");
  Source source =
      source_of(read_mesh_file(command.mesh), command.mesh, command.mending, command.simplify, command.simplify_given);
  source.subject.mended.rounding = rounding_of(source.mesh.points);
  BakeReport made;
  BakedMesh baked = bake(std::move(source.mesh), command.bake, &made);
  if (source.baked) baked.payload = std::move(source.baked->payload);  // the records are the same
  const WrittenStrips written = format.write_baked(baked_bytes(baked), command.strips);
  const std::size_t bytes = written.bytes.size();
  out.write(written.bytes);
  const std::size_t records = baked.records.size();
  const auto each = static_cast<double>(std::max<std::size_t>(records, 1));
  const BakedCosts costs = costs_of(baked, made.seconds);
  report.json = {{"base_triangles", baked.base.triangle_count()},
                 {"triangles", baked.mesh.fine_triangles()},
                 {"records", records},
                 {"components", made.components},
                 {"base_strips", made.base_strips},
                 {"top_strips", made.top_strips},
                 {"top_indices", made.top_indices},
                 {"top_at_least", made.top_at_least},
                 {"most_strips", made.most_strips},
                 {"levels_with_fewest", made.fewest_levels},
                 {"flips_per_record", costs.flips_per_record},
                 {"bytes_per_record", costs.bytes_per_record},
                 {"bytes", bytes},
                 {"states", made.states},
                 {"seconds", made.seconds}};
  report.add(source.subject.mended);
  report.add(written, command.out.string());
  report.text += fmt::format(
      "{}: {} and {} to {}\n"
      "{} at the base, {} at the finest level (at least {} needed), {} at most; {}, {:.2f} % of the levels with "
      "one strip for each\n"
      "{:.2f} flips and {:.1f} bytes a record, {} in all; {:.1f} seconds\n",
      command.out.string(), counted(baked.base.triangle_count(), "triangle"), counted(records, "record"),
      baked.mesh.fine_triangles(), counted(made.base_strips, "strip"), made.top_strips, made.top_at_least,
      made.most_strips, counted(made.components, "connected component"),
      100.0 * static_cast<double>(made.fewest_levels) / (each + 1), costs.flips_per_record, costs.bytes_per_record,
      counted(bytes, "byte"), made.seconds);
  report.print();
  return 0;
}

}  // namespace

Subcommand add_bake(CLI::App& app) {
  const auto kept = std::make_shared<BakeCommand>();
  BakeCommand& command = *kept;
  CLI::App* sub =
      app.add_subcommand("bake", "Precompute the strips of every level of detail and write them with the mesh");
  add_mesh_option(*sub, command.mesh, help_of_mesh(levels_kept))->required();
  add_output_option(*sub, command.out, extensions_of(writes_baked),
                    ".baked; or .glb, whose mesh is the base, with all levels in an extension (RESTRIP_baked_strips)")
      ->required();
  add_simplify_options(*sub, command.simplify);
  sub->add_option("--effort", command.bake.effort,
                  "search budget per record, in edges; with --cost indices, 600 edges stand for one look at a strip "
                  "end")
      ->check(whole_number_from(1, 1'000'000'000'000))
      ->capture_default_str();
  add_cost_option(*sub, command.cost, command.bake.cost);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  add_strip_options(*sub, command.strips);
  sub->callback([sub, &command] {
    check_strip_options(*sub, command.out, command.strips);
    command.simplify_given = simplify_options_given(*sub);
    command.bake.cost = command.cost.value_or(command.bake.cost);
  });
  sub->footer("Example: restrip bake bunny.obj -o bunny.baked");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
