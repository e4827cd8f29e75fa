#include "replay/source.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "lod/baked_file.hpp"
#include "meshes/mend.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {

BakedCosts costs_of(const BakedMesh& baked, double seconds) {
  if (baked.mesh.splits.empty()) return {};
  BakedMesh base{baked.mesh, baked.base, {}, {}};
  base.mesh.splits.clear();
  const auto records = static_cast<double>(baked.mesh.splits.size());
  return {static_cast<double>(baked.records.flips.size()) / records,
          static_cast<double>(baked_bytes(baked).size() - baked_bytes(base).size()) / records, seconds};
}

Source simplified(std::string name, Soup soup, const SimplifyOptions& options, Mended mended) {
  close_seams(soup, mended);
  Simplification simplified = simplify(soup, options);
  Source source;
  source.subject.mended = std::move(mended);
  source.subject.name = std::move(name);
  source.subject.wanted_triangles = simplified.wanted_triangles;
  source.subject.left_out = simplified.left_out;
  source.mesh = std::move(simplified.mesh);
  source.original = std::move(soup.triangles);
  return source;
}

Source source_of(ReadMesh read, const NamedFile& file, const MendingOptions& mending, const SimplifyOptions& options,
                 bool options_given) {
  if (auto* soup = std::get_if<Soup>(&read)) {
    Mended mended = mend(*soup, file.string(), mending);
    return simplified(file.string(), std::move(*soup), options, std::move(mended));
  }
  if (options_given)
    throw BadInput(
        fmt::format("{}: is progressive already and not simplified, so --base and --boundary do not apply; leave them "
                    "out, or give the mesh that it was made from",
                    file.string()));
  refuse_mending(file.string(), mending);
  Source source;
  source.subject.name = file.string();
  source.subject.mended.left_out = left_out_of(read);
  if (auto* baked = std::get_if<BakedBytes>(&read)) {
    source.baked = std::move(baked->baked);
    source.mesh = source.baked->mesh;
    return source;
  }
  source.mesh = std::move(std::get<ProgressiveMesh>(read));
  BuildReport report;
  const StripMesh base = StripMesh::build(source.mesh.base, source.mesh.points.size(), &report);
  source.subject.left_out = {report.degenerate_triangles, report.non_manifold_vertices};
  return source;
}

LevelFile level_file(const StripMesh& mesh, std::span<const Point> points, const MeshFormat& format,
                     const StripOptions& options, std::span<const Attribute> attributes) {
  const Strips strips = extract_strips(mesh);
  std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
  std::vector<std::uint32_t> number(points.size(), none);
  std::vector<std::uint32_t> used;
  for (std::uint32_t& index : indices) {
    if (index == restart_index) continue;
    if (number[index] == none) {
      number[index] = static_cast<std::uint32_t>(used.size());
      used.push_back(index);
    }
    index = number[index];
  }
  std::vector<Point> used_points;
  used_points.reserve(used.size());
  for (const std::uint32_t v : used) used_points.push_back(points[v]);
  std::vector<Attribute> used_attributes;
  for (const Attribute& attribute : attributes) used_attributes.push_back(selected(attribute, used));
  return {written_strips(format, used_points, indices, options, used_attributes), strips.order.size(), strips.size()};
}

StripMesh level_mesh(const PreparedMethod& prepared, std::size_t triangles) {
  StripMesh mesh = prepared.base();
  mesh.reserve(prepared.mesh().fine_triangles(), prepared.mesh().points.size());
  const auto maintainer = prepared.begin(mesh);
  const auto splits = std::span(prepared.mesh().splits).first(prepared.mesh().splits_to(triangles));
  for (std::size_t i = 0; i < splits.size(); ++i) {
    (void)possible_split(mesh, prepared.mesh(), i);
    maintainer->play_up(splits.subspan(i, 1), i);
  }
  return mesh;
}

}  // namespace restrip::tools
