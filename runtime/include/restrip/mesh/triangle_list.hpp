// Triangle lists, from which meshes are built, and the neighbours of their triangles.
//
//   const TriangleList list(indices);                        // or triples of corners
//   std::vector<std::array<std::uint32_t, 3>> across(list.size());
//   BuildReport report;
//   find_neighbors(list, vertex_count, across, report);
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "restrip/precondition.hpp"

namespace restrip {

using Vertex = std::uint32_t;    ///< index of a vertex
using Triangle = std::uint32_t;  ///< index of a triangle
inline constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

#ifndef RESTRIP_MAX_TRIANGLES
/// The most triangles that a list or a StripMesh holds, 2^29 - 1: a halfedge has 29 bits for its triangle. Tests define
/// it smaller.
#define RESTRIP_MAX_TRIANGLES ((std::size_t{1} << 29) - 1)
#endif

/// A report on a triangle list. Nothing is repaired silently: every triangle of the list is either in the mesh or
/// counted here as left out.
struct BuildReport {
  std::size_t degenerate_triangles = 0;    ///< left out: a corner twice
  std::size_t out_of_range_triangles = 0;  ///< left out: a corner that is not a vertex
  std::size_t boundary_edges = 0;          ///< edges of one triangle
  /// Edges of three triangles or more. Strips cross them in pairs of triangles wound alike, so that the sheets of a
  /// two-sided mesh keep their strips; operations there are refused.
  std::size_t non_manifold_edges = 0;
  std::size_t inconsistent_edges = 0;  ///< edges of two triangles that disagree in orientation: no strip crosses them
  std::size_t non_manifold_vertices =
      0;  ///< vertices of several fans, or on one of the edges above: operations refuse them
};

/// A view of a triangle list, counter-clockwise, three corners for each triangle: `Element` is an unsigned integer of
/// 16 or 32 bits, or std::array<Vertex, 3>. The viewed memory must outlive it.
template <class Element>
class TriangleList {
  static constexpr bool triples = std::same_as<Element, std::array<Vertex, 3>>;
  static_assert(triples || std::same_as<Element, std::uint32_t> || std::same_as<Element, std::uint16_t>);

 public:
  static constexpr std::size_t max_triangles = RESTRIP_MAX_TRIANGLES;
  static_assert(max_triangles < std::size_t{1} << 29);

  /// Takes anything that a std::span of elements can be made of. Throws std::invalid_argument when the number of
  /// indices is not a multiple of three, std::length_error when there are more than `max_triangles` triangles.
  template <class Elements>
  explicit TriangleList(const Elements& elements) : elements_(elements) {
    if (!triples && elements_.size() % 3 != 0)
      RESTRIP_THROW(std::invalid_argument, "restrip: a triangle has three indices");
    if (size() > max_triangles) RESTRIP_THROW(std::length_error, "restrip: more triangles than a StripMesh can hold");
  }

  [[nodiscard]] std::size_t size() const noexcept { return triples ? elements_.size() : elements_.size() / 3; }
  /// The vertex that a halfedge, 4 * triangle + side, leaves: side s runs from corner s to corner s + 1.
  [[nodiscard]] Vertex corner(std::uint32_t h) const noexcept {
    if constexpr (triples)
      return elements_[h >> 2][h & 3U];
    else
      return elements_[h - (h >> 2)];
  }
  /// Whether a triangle has three different corners below `vertex_count`.
  [[nodiscard]] bool is_triangle(Triangle t, std::size_t vertex_count) const noexcept {
    return in_range(t, vertex_count) && !degenerate(t);
  }
  [[nodiscard]] bool in_range(Triangle t, std::size_t vertex_count) const noexcept {
    return corner(t << 2) < vertex_count && corner(t << 2 | 1U) < vertex_count && corner(t << 2 | 2U) < vertex_count;
  }
  [[nodiscard]] bool degenerate(Triangle t) const noexcept {
    const Vertex a = corner(t << 2);
    const Vertex b = corner(t << 2 | 1U);
    const Vertex c = corner(t << 2 | 2U);
    return a == b || b == c || c == a;
  }

 private:
  std::span<const Element> elements_;
};

template <class Elements>
TriangleList(const Elements&)
    -> TriangleList<std::remove_cv_t<typename decltype(std::span(std::declval<const Elements&>()))::element_type>>;

/// Writes the halfedge across each side of each triangle, or none for sides without a neighbour: sides of triangles
/// that are left out, sides at boundary and inconsistent edges, and at non-manifold edges the sides that remain when
/// sides of opposite directions are joined in pairs. Writes all of the report except non_manifold_vertices. `across`
/// must have list.size() elements. O(triangles + vertices), for any valences; 12 bytes a vertex while it runs. Throws
/// std::length_error for more than 2^32 - 1 vertices.
template <class Element>
void find_neighbors(const TriangleList<Element>& list, std::size_t vertex_count,
                    std::span<std::array<std::uint32_t, 3>> across, BuildReport& report);

namespace detail {

/// The root of t in a forest in which a root is its own parent. Shortens the way to it.
std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t t) noexcept;

}  // namespace detail

}  // namespace restrip
