#include "app/level_file.hpp"

#include <vector>

#include "lod/coloring_check.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {

LevelFile level_file(const StripMesh& mesh, std::span<const Point> points, const std::string& extension,
                     GltfPrimitives primitives) {
  const Strips strips = extract_strips(mesh);
  std::vector<std::uint32_t> indices = strip_indices(mesh, strips);
  std::vector<std::uint32_t> number(points.size(), none);
  std::vector<Point> used;
  for (std::uint32_t& index : indices) {
    if (index == restart_index) continue;
    if (number[index] == none) {
      number[index] = static_cast<std::uint32_t>(used.size());
      used.push_back(points[index]);
    }
    index = number[index];
  }
  const std::vector<Corners> drawn = decode_strips(indices);
  return {strip_bytes({used, indices, drawn}, extension, primitives), drawn.size(), strips.size()};
}

LevelFile level_file(const Plan& plan, std::size_t triangles, const std::string& extension, GltfPrimitives primitives) {
  StripMesh mesh = plan.base();
  mesh.reserve(plan.mesh().fine_triangles(), plan.mesh().points.size());
  const auto upkeep = plan.begin(mesh);
  upkeep->play_up(std::span(plan.mesh().splits).first(plan.mesh().splits_to(triangles)), 0);
  return level_file(mesh, plan.mesh().points, extension, primitives);
}

}  // namespace restrip::tools
