#include "app/level_file.hpp"

#include <vector>

#include "restrip/output/strips.hpp"

namespace restrip::tools {

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

StripMesh level_mesh(const Plan& plan, std::size_t triangles) {
  StripMesh mesh = plan.base();
  mesh.reserve(plan.mesh().fine_triangles(), plan.mesh().points.size());
  const auto upkeep = plan.begin(mesh);
  const auto splits = std::span(plan.mesh().splits).first(plan.mesh().splits_to(triangles));
  for (std::size_t i = 0; i < splits.size(); ++i) {
    (void)possible_split(mesh, plan.mesh(), i);
    upkeep->play_up(splits.subspan(i, 1), i);
  }
  return mesh;
}

}  // namespace restrip::tools
