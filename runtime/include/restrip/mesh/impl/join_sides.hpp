// The sides of triangles, each joined to the one across its mesh edge. Included by triangle_list.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/triangle_list.hpp"

namespace restrip {

namespace detail {

/// Finds for each side the one of the neighbour. Sides are named as halfedges are, 4 * triangle + side. Each side gets
/// on the list of the smaller of its two vertices, whose links are the places where the neighbours go later. A vertex
/// then reads its list, and an edge of it is known by the larger vertex. Which side is the second of its edge is as
/// good as random, so that is no branch. O(triangles + vertices), however many triangles a vertex has; 12 bytes a
/// vertex while it runs.
///
/// `Sides`: triangle_bound(); takes(t), are there sides of t?; corner(h), the vertex that h leaves; link(h), a place
/// for a number of 32 bits, written before it is read; joined(h), what stands there when h is across, or not_joined;
/// odd_edge(v, w), told of each edge that is left unjoined though it has several sides. Unless `checked`, each directed
/// edge must be there once at most, and its triangle be one that is taken.
template <bool checked, class Sides>
class JoinSides {
 public:
  JoinSides(const Sides& sides, std::size_t vertex_count, BuildReport& report)
      : sides_(sides), report_(report), lists_(vertex_count, end), edges_(vertex_count) {}

  void run() {
    make_lists();
    for (std::uint32_t v = 0; v < lists_.size(); ++v) read_list(v);
    if constexpr (checked) report_.boundary_edges += alone_;
  }

 private:
  static constexpr std::uint32_t end = 0xFFFF'FFFFU;  // of a list; also no vertex
  // What an edge has in place of its first side: it is joined, or as below; these have the highest bit.
  static constexpr std::uint32_t second = 1U << 31;
  static constexpr std::uint32_t inconsistent = end - 1;
  static constexpr std::uint32_t non_manifold = end;

  struct Edge {
    std::uint32_t low = end;   // the vertex whose list it was met in
    std::uint32_t side = end;  // the last one met
  };

  static constexpr std::uint32_t next(std::uint32_t h) noexcept { return (h & 2U) != 0 ? h - 2 : h + 1; }

  void make_lists() {
    for (std::uint32_t t = 0; t < sides_.triangle_bound(); ++t) {
      if (checked && !sides_.takes(t)) continue;
      for (std::uint32_t h = t << 2; h < (t << 2 | 3U); ++h) {
        std::uint32_t& first = lists_[std::min(sides_.corner(h), sides_.corner(next(h)))];
        sides_.link(h) = first;
        first = h;
      }
    }
  }

  void read_list(std::uint32_t low) {
    for (std::uint32_t h = lists_[low], then = end; h != end; h = then) {
      then = sides_.link(h);
      const std::uint32_t from = sides_.corner(h);
      const std::uint32_t high = from + sides_.corner(next(h)) - low;
      Edge& edge = edges_[high];
      const bool met = edge.low == low;
      if (checked && met && ((edge.side & second) != 0 || sides_.corner(edge.side) == from)) {
        refuse(h, edge, low, high);
        continue;
      }
      const std::uint32_t g = met ? edge.side : h;
      sides_.link(g) = met ? sides_.joined(h) : Sides::not_joined;
      sides_.link(h) = met ? sides_.joined(g) : Sides::not_joined;
      if (checked) alone_ += met ? std::size_t{0} - 1 : 1;
      edge = {low, checked && met ? h | second : h};
    }
  }

  // One side too many, or one that runs the same way as the other.
  void refuse(std::uint32_t h, Edge& edge, std::uint32_t low, std::uint32_t high) {
    sides_.link(h) = Sides::not_joined;
    if (edge.side == non_manifold) return;
    if (edge.side == inconsistent) {
      --report_.inconsistent_edges;
      ++report_.non_manifold_edges;
      edge.side = non_manifold;
      return;
    }
    sides_.odd_edge(low, high);
    if ((edge.side & second) == 0) {
      --alone_;
      ++report_.inconsistent_edges;
      edge.side = inconsistent;
      return;
    }
    const std::uint32_t g = edge.side & ~second;
    sides_.link(sides_.across(g)) = Sides::not_joined;
    sides_.link(g) = Sides::not_joined;
    ++report_.non_manifold_edges;
    edge.side = non_manifold;
  }

  const Sides& sides_;
  BuildReport& report_;
  std::size_t alone_ = 0;             // edges of one side, as far as it is known
  std::vector<std::uint32_t> lists_;  // of each vertex the first side
  std::vector<Edge> edges_;           // by their larger vertex
};

/// What JoinSides asks of a list, and where it writes.
template <bool checked, class Element>
class ListedSides {
 public:
  static constexpr std::uint32_t not_joined = none;

  ListedSides(const TriangleList<Element>& list, std::size_t vertex_count,
              std::span<std::array<std::uint32_t, 3>> across, BuildReport& report) noexcept
      : list_(list), vertex_count_(vertex_count), across_(across), report_(&report) {}

  [[nodiscard]] std::size_t triangle_bound() const noexcept { return list_.size(); }
  [[nodiscard]] bool takes(Triangle t) const noexcept {
    if (list_.is_triangle(t, vertex_count_)) return true;
    ++(list_.in_range(t, vertex_count_) ? report_->degenerate_triangles : report_->out_of_range_triangles);
    across_[t] = {none, none, none};
    return false;
  }
  [[nodiscard]] Vertex corner(std::uint32_t h) const noexcept { return list_.corner(h); }
  [[nodiscard]] std::uint32_t& link(std::uint32_t h) const noexcept { return across_[h >> 2][h & 3U]; }
  [[nodiscard]] static std::uint32_t joined(std::uint32_t h) noexcept { return h; }
  [[nodiscard]] std::uint32_t across(std::uint32_t h) const noexcept { return link(h); }
  void odd_edge(Vertex /*v*/, Vertex /*w*/) const noexcept {}

 private:
  TriangleList<Element> list_;
  std::size_t vertex_count_;
  std::span<std::array<std::uint32_t, 3>> across_;
  BuildReport* report_;
};

inline void expect_vertices(std::size_t vertex_count) {
  if (vertex_count > none) RESTRIP_THROW(std::length_error, "restrip: a StripMesh has at most 2^32 - 1 vertices");
}

template <class Element>
bool is_oriented_manifold(const TriangleList<Element>& list, std::size_t vertex_count) {
  std::vector<std::array<std::uint32_t, 3>> across(list.size());
  BuildReport report;
  find_neighbors(list, vertex_count, across, report);
  return report.degenerate_triangles + report.out_of_range_triangles + report.non_manifold_edges +
             report.inconsistent_edges ==
         0;
}

}  // namespace detail

template <class Element>
void find_neighbors(const TriangleList<Element>& list, std::size_t vertex_count,
                    std::span<std::array<std::uint32_t, 3>> across, BuildReport& report) {
  RESTRIP_ASSERT(across.size() == list.size(), "find_neighbors", "there is not one place for each triangle");
  detail::expect_vertices(vertex_count);
  report = {};
  const detail::ListedSides<true, Element> sides(list, vertex_count, across, report);
  detail::JoinSides<true, detail::ListedSides<true, Element>>(sides, vertex_count, report).run();
}

template <class Element>
void find_neighbors(Trusted /*trust*/, const TriangleList<Element>& list, std::size_t vertex_count,
                    std::span<std::array<std::uint32_t, 3>> across) {
  RESTRIP_ASSERT(across.size() == list.size(), "find_neighbors", "there is not one place for each triangle");
  detail::expect_vertices(vertex_count);
  RESTRIP_ASSERT(detail::is_oriented_manifold(list, vertex_count), "find_neighbors",
                 "the list that is trusted is no oriented manifold");
  BuildReport report;
  const detail::ListedSides<false, Element> sides(list, vertex_count, across, report);
  detail::JoinSides<false, detail::ListedSides<false, Element>>(sides, vertex_count, report).run();
}

}  // namespace restrip
