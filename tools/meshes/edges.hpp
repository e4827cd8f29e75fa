// The edges of a soup, with the triangles at each, from the definition: no mesh, any number of triangles at an edge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// A side of a triangle: corner `side` and the next one. Corners are numbered 3 * triangle + side.
struct Side {
  std::uint32_t high;    ///< the larger vertex
  std::uint32_t corner;  ///< the corner where the side begins
};

[[nodiscard]] constexpr std::uint32_t next_corner(std::uint32_t corner) noexcept {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
[[nodiscard]] inline std::uint32_t vertex_at(const Soup& soup, std::uint32_t corner) {
  return soup.triangles[corner / 3][corner % 3];
}

/// Calls visit(sides) for each edge of triangles that are not degenerate, by its smaller vertex, then the larger one.
/// The sides of an edge are in the order of their corners. Sorts them by the smaller vertex (counting sort), then by
/// the larger one.
template <class Visit>
void for_each_edge(const Soup& soup, Visit&& visit) {
  const auto low = [&](std::uint32_t corner) {
    return std::min(vertex_at(soup, corner), vertex_at(soup, next_corner(corner)));
  };
  const auto each_corner = [&](auto&& use) {
    for (std::uint32_t t = 0; t < soup.triangles.size(); ++t)
      if (!degenerate(soup.triangles[t]))
        for (std::uint32_t side = 0; side < 3; ++side) use(3 * t + side);
  };
  std::vector<std::uint32_t> first(soup.points.size() + 1, 0);
  each_corner([&](std::uint32_t corner) { ++first[low(corner) + std::size_t{1}]; });
  for (std::size_t v = 0; v < soup.points.size(); ++v) first[v + 1] += first[v];
  std::vector<Side> sides(first.back());
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  each_corner([&](std::uint32_t corner) {
    sides[fill[low(corner)]++] = {std::max(vertex_at(soup, corner), vertex_at(soup, next_corner(corner))), corner};
  });
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    Side* const begin = sides.data() + first[v];
    Side* const end = sides.data() + first[v + 1];
    std::sort(begin, end,
              [](const Side& a, const Side& b) { return a.high != b.high ? a.high < b.high : a.corner < b.corner; });
    for (Side* group = begin; group != end;) {
      Side* const stop = std::find_if(group, end, [&](const Side& side) { return side.high != group->high; });
      visit(std::span<const Side>(group, stop));
      group = stop;
    }
  }
}

}  // namespace restrip::tools
