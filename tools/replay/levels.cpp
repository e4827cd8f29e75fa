#include "replay/levels.hpp"

#include <fmt/format.h>

#include <cmath>

#include "restrip/output/strips.hpp"

namespace restrip::tools {

Level level_of(const StripMesh& mesh, std::vector<std::string>& faults) {
  const Strips strips = extract_strips(mesh);
  Level level{mesh.triangle_count(), strips.size(), 0, 0, strip_index_count(mesh, strips)};
  if (strips.size() != 0) level.swaps = level.indices + 1 - level.triangles - 3 * level.strips;
  for (std::size_t s = 0; s < strips.size(); ++s) level.isolated += static_cast<std::size_t>(strips[s].size() == 1);
  if (strips.order.size() != level.triangles)
    faults.push_back(
        fmt::format("at {} triangles: only {} of them are in a strip", level.triangles, strips.order.size()));
  return level;
}

LevelStops::LevelStops(std::size_t base_triangles, std::size_t fine_triangles, std::size_t count) {
  const auto first = static_cast<double>(base_triangles);
  const double ratio = static_cast<double>(fine_triangles) / first;
  for (std::size_t i = 0; i + 1 < count; ++i)
    sizes_.push_back(static_cast<std::size_t>(
        std::ceil(first * std::pow(ratio, static_cast<double>(i) / static_cast<double>(count - 1)))));
}

}  // namespace restrip::tools
