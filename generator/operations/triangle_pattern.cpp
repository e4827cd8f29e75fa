#include "operations/triangle_pattern.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "operations/description_file.hpp"

namespace restrip::generator {
namespace {

std::string name_at(const IndexedName& vertex, const PositionNumbers& place, int index = 0) {
  if (!vertex.index) return vertex.name;
  const int value = vertex.index->at(place, index);
  if (value < 0) throw std::runtime_error(fmt::format("{}[{}] is no vertex", vertex.name, value));
  return fmt::format("{}_{}", vertex.name, value);
}

NamedPatch::Triangles triangles_at(const TrianglePatterns& patterns, const PositionNumbers& place) {
  NamedPatch::Triangles triangles;
  for (const auto& [corners, index] : patterns) {
    const int from = index ? index->range->from.at(place) : 0;
    const int to = index ? index->range->to.at(place) : 1;
    if (from < 0 || to < 0) throw std::runtime_error(fmt::format("{}[{},{}) are no indices", index->name, from, to));
    for (int i = from; i < to; ++i) {
      if (triangles.size() == most_nodes)
        throw std::runtime_error(fmt::format("expected 1 to {} triangles", most_nodes));
      triangles.push_back(
          {name_at(corners[0], place, i), name_at(corners[1], place, i), name_at(corners[2], place, i)});
    }
  }
  return triangles;
}

}  // namespace

NamedPatch named_at(const TrianglePatterns& before, const TrianglePatterns& after,
                    const std::vector<StretchPattern>& boundary, const PositionNumbers& place) {
  NamedPatch named{triangles_at(before, place), triangles_at(after, place), {}};
  for (const auto& [from, to] : boundary) named.boundary.push_back({name_at(from, place), name_at(to, place)});
  return named;
}

}  // namespace restrip::generator
