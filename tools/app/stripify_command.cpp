// `restrip stripify`: a mesh's strips from scratch, told and written.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands.hpp"
#include "common/bad_input.hpp"
#include "common/report_output.hpp"
#include "common/stopwatch.hpp"
#include "files/output.hpp"
#include "files/reading.hpp"
#include "lod/coloring_check.hpp"
#include "meshes/file_strips.hpp"
#include "meshes/mend.hpp"
#include "meshes/strip_file.hpp"
#include "restrip/output/index_bound.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/output/vertex_cache.hpp"

namespace restrip::tools {

int run(const StripifyCommand& command) {
  std::optional<files::Output> strip_file;
  if (!command.out.empty())
    strip_file.emplace(command.out, files::OutputRules{written_strip_extensions(), {command.mesh}});
  const ReportOutput out(command.json, {command.mesh, command.out});
  Mended mended;
  const Soup soup = read_mesh(command.mesh, command.mending, mended, command.attributes);
  if (strip_file) leave_out_attributes(soup, files::extension_of(command.out), mended);
  if (command.as_in_file && soup.strips.empty())
    throw BadInput(
        fmt::format("{}: has no strips (PLY `tristrips`, or strips of glTF); leave out --effort file to make "
                    "some",
                    command.mesh.string()));
  BuildReport report;
  StripMesh mesh;
  std::vector<std::uint32_t> origin;
  Medians building;
  building.time([&] { mesh = StripMesh::build(soup.triangles, soup.points.size(), &report, &origin); });
  FileStrips in_file;
  Medians clock;
  clock.time([&] {
    if (command.as_in_file)
      in_file = color_as_in_file(mesh, soup, origin);
    else
      stripify(mesh, command.effort, command.cost, command.limit * mesh.triangle_count(), command.seed);
  });
  Strips strips = extract_strips(mesh);
  std::vector<std::uint32_t> indices;
  Medians writing;
  writing.time([&] {
    if (command.order_for_cache) {
      strips = order_for_vertex_cache(mesh, strips);
      indices = strip_indices(mesh, strips);
    } else {
      indices = strip_indices(mesh);
    }
  });
  if (strip_file) {
    const std::vector<Corners> drawn = decode_strips(indices);
    strip_file->write(
        strip_bytes({soup.points, indices, drawn, soup.attributes}, files::extension_of(command.out), command.gltf));
  }
  const std::size_t bound = strip_index_lower_bound(mesh);
  const std::vector<std::string> faults = find_faults(mesh);
  const std::size_t left_out = report.degenerate_triangles + report.out_of_range_triangles;
  const double seconds = clock.nanoseconds() * 1e-9;
  const std::size_t triangles = mesh.triangle_count();
  // Indices that are repeated, in the middle of a strip or at its beginning.
  const std::size_t swaps = triangles == 0 ? 0 : indices.size() + 1 - triangles - 3 * strips.size();
  const double cache_misses = acmr(indices, 16, triangles);
  nlohmann::ordered_json json{{"triangles", triangles},
                              {"left_out", left_out},
                              {"strips", strips.size()},
                              {"components", connected_components(mesh)},
                              {"swaps", swaps},
                              {"indices", indices.size()},
                              {"lower_bound_indices", bound},
                              {"acmr", cache_misses},
                              {"acmr_32", acmr(indices, 32, triangles)},
                              {"seconds", seconds},
                              {"seconds_to_build", building.nanoseconds() * 1e-9},
                              {"seconds_to_write", writing.nanoseconds() * 1e-9},
                              {"valid", faults.empty()}};
  if (command.as_in_file) json["cut_strips"] = in_file.cut;
  const auto required = required_extensions(files::extension_of(command.out), command.gltf, strips.size());
  if (!required.empty()) json["required_extensions"] = required;
  add_to(json, mended);
  const auto per_triangle = [triangles](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(triangles, 1));
  };
  std::string text = as_text(mended);
  text += fmt::format(
      "{}: {} triangles ({} degenerate ones left out) in {} strips, {} connected components\n"
      "{:.3f} indices per triangle (at least {:.3f} in any strips), {} swaps, {:.3f} vertex cache misses "
      "per triangle (FIFO 16), {:.3f} seconds\n",
      command.mesh.string(), triangles, left_out, strips.size(), connected_components(mesh),
      per_triangle(indices.size()), per_triangle(bound), swaps, cache_misses, seconds);
  if (in_file.cut != 0)
    text += fmt::format("cut {} times, where a strip of the file goes on and no dual edge is\n", in_file.cut);
  text += as_text(required, command.out.string());
  // A closed mesh has no seams.
  const bool has_seams = report.boundary_edges != 0;
  text += hints(has_seams ? coincident_vertices(soup) : 0, has_seams ? vertices_at_seams(soup) : 0,
                report.inconsistent_edges);
  out.print(text, json.dump(2) + "\n");
  for (const std::string& fault : faults) fmt::print(stderr, "{}\n", fault);
  return faults.empty() ? 0 : 1;
}

}  // namespace restrip::tools
