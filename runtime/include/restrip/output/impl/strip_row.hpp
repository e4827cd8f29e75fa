// The strips of a mesh, laid out one after the other; a *place* is a triangle in this row. Included by
// strip_order.hpp.
//
// A row is the mesh in flat arrays: the search for a drawing order reads corners and neighbours of a place some fifty
// times, and most of its steps lead to the next place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::detail {

/// The strips of a mesh in a row.
struct StripRow {
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  static constexpr std::int8_t no_side = -1;

  std::vector<std::uint32_t> corners;  // three a place; corner s begins side s
  std::vector<std::uint32_t> across;   // three a place: 3 * place + side on the other side, or none
  // The sides to the previous and to the next triangle of a strip.
  std::vector<std::int8_t> previous;
  std::vector<std::int8_t> next;

  [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(previous.size()); }
};

template <NumberedMesh Mesh>
typename Mesh::Halfedge side_of(const Mesh& mesh, Triangle t, unsigned side) {
  auto h = mesh.halfedge(t);
  for (; side != 0; --side) h = mesh.next(h);
  return h;
}

template <NumberedMesh Mesh>
StripRow row_of(const Mesh& mesh, const std::vector<Triangle>& order) {
  StripRow row;
  std::vector<std::uint32_t> place_of(mesh.triangle_bound(), StripRow::none);
  for (std::uint32_t p = 0; p < order.size(); ++p) place_of[order[p]] = p;
  row.corners.reserve(3 * order.size());
  row.across.reserve(3 * order.size());
  row.previous.assign(order.size(), StripRow::no_side);
  row.next.assign(order.size(), StripRow::no_side);
  for (std::uint32_t p = 0; p < order.size(); ++p) {
    auto h = mesh.halfedge(order[p]);
    for (std::int8_t side = 0; side < 3; ++side, h = mesh.next(h)) {
      row.corners.push_back(from_of(mesh, h));
      std::uint32_t across = StripRow::none;
      if (const auto back = mesh.opposite(h); !mesh.on_boundary(back)) {
        const Triangle t = triangle_of(mesh, back);
        const std::uint32_t q = place_of[t];
        if (q != p && q != StripRow::none) {
          across = 3 * q;
          for (auto g = mesh.halfedge(t); !(g == back); g = mesh.next(g)) ++across;
          if (mesh.solid(h)) (q == p + 1 ? row.next : row.previous)[p] = side;
        }
      }
      row.across.push_back(across);
    }
  }
  return row;
}

}  // namespace restrip::detail
