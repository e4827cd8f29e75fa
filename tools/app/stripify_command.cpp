// `restrip stripify`: makes the strips of a mesh from scratch, reports and writes them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "common/progress.hpp"
#include "common/stopwatch.hpp"
#include "lod/coloring_check.hpp"
#include "lod/mesh_files.hpp"
#include "measure/index_bound.hpp"
#include "measure/vertex_cache.hpp"
#include "meshes/strip_file.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip::tools {

namespace {

struct StripifyCommand {
  NamedFile mesh;
  NamedFile out;  ///< empty: strips are counted, not written
  StripOptions strips;
  bool as_in_file = false;  ///< use the strips of the file; the next four are ignored
  Effort effort = Effort::fast;
  std::optional<Cost> cost;
  std::uint64_t limit = 0;  ///< of stripify(), per triangle; 0: its default
  std::uint64_t seed = 1;
  VertexCache cache;  ///< that strips are cut and ordered for
  ReadAttributes attributes = ReadAttributes::yes;
  MendingOptions mending;
  std::string json;
  bool bound = false;  ///< compute a lower bound for any index buffer
};

int run(const StripifyCommand& command) {
  std::optional<files::Output> strip_file;
  if (!command.out.empty()) strip_file = open_output(command.out, extensions_of(writes_strips));
  Report out(command.json);
  const MeshFormat* format = strip_file ? &format_to_write(command.out, writes_strips) : nullptr;
  Soup soup = read_mesh(command.mesh, command.attributes);
  Mended mended = mend(soup, command.mesh.string(), command.mending);
  if (format != nullptr) leave_out_losses(soup, *format, mended);
  if (command.as_in_file && soup.strips.empty())
    throw BadInput(
        fmt::format("{}: has no strips (PLY `tristrips`, or strips of glTF); leave out --effort file to make "
                    "some",
                    command.mesh.string()));
  BuildReport report;
  StripMesh mesh;
  std::vector<std::uint32_t> origin;
  const double seconds_to_build =
      1e-9 * nanoseconds_of([&] { mesh = StripMesh::build(soup.triangles, soup.points.size(), &report, &origin); });
  FileStrips in_file;
  const auto make_strips = [&] {
    const Progress progress("making strips", 1);
    if (command.as_in_file)
      in_file = color_as_in_file(mesh, soup, origin);
    else
      stripify(mesh, command.effort, command.cost.value_or(default_cost), command.limit * mesh.triangle_count(),
               command.seed);
  };
  const double seconds = 1e-9 * nanoseconds_of(make_strips);
  Strips strips;
  const double seconds_to_order = 1e-9 * nanoseconds_of([&] { strips = strips_for_vertex_cache(mesh, command.cache); });
  std::vector<std::uint32_t> indices;
  const double seconds_to_write =
      1e-9 *
      nanoseconds_of([&] { indices = command.cache.size == 0 ? strip_indices(mesh) : strip_indices(mesh, strips); });
  WrittenStrips written;
  if (strip_file) {
    written = written_strips(*format, soup.points, indices, command.strips, soup.attributes, soup.is_64_bits);
    strip_file->write(written.bytes);
  }
  const std::vector<std::string> faults = find_faults(mesh);
  const std::size_t left_out = report.degenerate_triangles + report.out_of_range_triangles;
  const std::size_t triangles = mesh.triangle_count();
  // Repeated indices, within a strip or at its beginning.
  const std::size_t swaps = triangles == 0 ? 0 : indices.size() + 1 - triangles - 3 * strips.size();
  const double acmr_16 = acmr(indices, 16, triangles);
  const double acmr_32 = acmr(indices, 32, triangles);
  out.json = {{"triangles", triangles},
              {"left_out", left_out},
              {"strips", strips.size()},
              {"components", connected_components(mesh)},
              {"swaps", swaps},
              {"indices", indices.size()},
              {"acmr", acmr_16},
              {"acmr_32", acmr_32},
              {"seconds", seconds},
              {"seconds_to_build", seconds_to_build},
              {"seconds_to_order", seconds_to_order},
              {"seconds_to_write", seconds_to_write},
              {"valid", faults.empty()}};
  if (command.as_in_file) out.json["cut_strips"] = in_file.cut;
  if (indices.size() > 3 * triangles) out.json["list_indices"] = 3 * triangles;
  out.add(mended);
  const auto per_triangle = [triangles](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(triangles, 1));
  };
  std::string at_least;
  if (command.bound) {
    const std::size_t bound = strip_index_lower_bound(mesh);
    out.json["lower_bound_indices"] = bound;
    at_least = fmt::format(" (lower bound {:.3f})", per_triangle(bound));
  }
  out.text += fmt::format(
      "{}: {} ({} left out) in {}, {}\n"
      "{:.3f} indices per triangle with restart{}, {}\n"
      "vertex cache misses per triangle: FIFO of 16 {:.3f}, of 32 {:.3f}\n"
      "{:.3f} seconds: {:.3f} for the mesh, {:.3f} for its strips, {:.3f} for their order, {:.3f} for the indices\n",
      command.mesh.string(), counted(triangles, "triangle"), counted(left_out, "degenerate one"),
      counted(strips.size(), "strip"), counted(connected_components(mesh), "connected component"),
      per_triangle(indices.size()), at_least, counted(swaps, "swap"), acmr_16, acmr_32,
      seconds_to_build + seconds + seconds_to_order + seconds_to_write, seconds_to_build, seconds, seconds_to_order,
      seconds_to_write);
  if (in_file.cut != 0)
    out.text += fmt::format("strips of the file cut at {}: consecutive triangles share no edge\n",
                            counted(in_file.cut, "place"));
  if (indices.size() > 3 * triangles) out.text += fmt::format("a triangle list has fewer indices: {}\n", 3 * triangles);
  out.add(written, command.out.string());
  // Recommends mending, if it would help. A closed mesh has no seams.
  const bool has_seams = report.boundary_edges != 0;
  if (const std::size_t n = has_seams ? coincident_vertices(soup) : 0; n != 0)
    out.text += counted(n, "vertex lies", "vertices lie") +
                " where others do; strips end at such seams: --weld makes them one\n";
  if (const std::size_t n = has_seams ? vertices_at_seams(soup) : 0; n != 0)
    out.text += counted(n, "vertex lies where others do and has", "vertices lie where others do and have") +
                " other attributes; strips end at such seams: --no-attributes --weld makes them one\n";
  if (report.inconsistent_edges != 0)
    out.text += counted(report.inconsistent_edges, "edge lies", "edges lie") +
                " between triangles of opposite orientation, where strips end: --orient turns some\n";
  out.print();
  for (const std::string& fault : faults) fmt::print(stderr, "{}\n", fault);
  return faults.empty() ? 0 : 1;
}

}  // namespace

Subcommand add_stripify(CLI::App& app) {
  const auto kept = std::make_shared<StripifyCommand>();
  StripifyCommand& command = *kept;
  CLI::App* sub = app.add_subcommand("stripify", "Make the strips of a mesh from scratch, and write them");
  add_mesh_option(*sub, command.mesh, help_of_mesh())->required();
  add_output_option(*sub, command.out, extensions_of(writes_strips), strip_formats());
  add_strip_options(*sub, command.strips);
  const auto* effort = sub->add_option_function<std::string>(
                              "--effort",
                              [&command](const std::string& word) {
                                command.as_in_file = word == "file";
                                command.effort = word == "full"   ? restrip::Effort::full
                                                 : word == "best" ? restrip::Effort::best
                                                                  : restrip::Effort::fast;
                              },
                              "fast: one pass; full: a search or annealing; best: ten times longer annealing "
                              "for --cost indices; file: the strips of the file")
                           ->check(one_of({"fast", "full", "best", "file"}))
                           ->default_str("fast");
  add_cost_option(*sub, command.cost);
  const auto* limit =
      sub->add_option("--limit", command.limit,
                      "for --effort full and best, per triangle: search states with --cost strips (default: 40), "
                      "annealing moves with --cost indices (default: 100, 900)")
          ->check(whole_number_from(1, 1'000'000));
  const auto* seed =
      sub->add_option("--seed", command.seed, "of annealing")->check(whole_number())->capture_default_str();
  const auto* cache = sub->add_option("--cache", command.cache.size,
                                      "cut and order strips for a first-in-first-out vertex cache of this many "
                                      "vertices; 16 suits most hardware")
                          ->check(whole_number_from(1, 1'000'000));
  const auto* weight =
      sub->add_option("--cache-weight", command.cache.weight,
                      "indices that a miss is worth: less for fewer indices, more for fewer misses (default: "
                      "by the strips; mostly 1 to 3)")
          ->check(CLI::Range(0.0, 1000.0).description("X from 0 to 1000"));
  sub->add_flag("--bound", command.bound,
                "also report a lower bound on the indices of every buffer that draws these triangles");
  add_attributes_option(*sub, command.attributes);
  add_mending_options(*sub, command.mending);
  add_json_option(*sub, command.json);
  sub->callback([sub, effort, limit, seed, cache, weight, &command] {
    check_strip_options(*sub, command.out, command.strips);
    if (command.as_in_file && sub->count("--cost") != 0)
      throw CLI::ValidationError("--cost", "--effort file leaves the strips as they are");
    const bool anneals = command.effort != restrip::Effort::fast && !(command.cost == restrip::Cost::strips());
    if (*weight && !*cache) throw CLI::ValidationError("--cache-weight", "needs --cache");
    if (*limit && command.effort == restrip::Effort::fast)
      throw CLI::ValidationError("--limit", fmt::format("only {} full and best have one", effort->get_name()));
    if (*seed && !anneals)
      throw CLI::ValidationError("--seed", "only --effort full and best with --cost indices use random numbers");
  });
  sub->footer("Example: restrip stripify bunny.obj --effort full -o bunny.glb");
  return {sub, [kept] { return run(*kept); }};
}

}  // namespace restrip::tools
