// Joins each side of a triangle to the side across its mesh edge.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/triangle_list.hpp"

namespace restrip {

namespace detail {

/// Finds the neighbour's side for each side. Sides are named like halfedges, 4 * triangle + side. Each side is put on
/// the list of the smaller of its two vertices; the links of the list are stored where the neighbours go later. A
/// vertex then reads its list, and the larger vertex identifies an edge. Which side comes second at its edge is as good
/// as random, so that is not a branch. O(triangles + vertices), for any valences; 12 bytes a vertex while it runs, 4
/// more with odd edges, and 16 for each side of an odd edge.
///
/// Edges with three sides or more, and edges with two sides of the same direction, are *odd*. Sides of opposite
/// directions are joined in pairs, so that windings stay right: first sides that close the fan around one of their
/// ends, so that sheets continue; then any. A triangle and its back (the same corners in reverse) are joined only if
/// no other pair is left. The result depends on the numbers of sides, not on those of vertices: files renumber them.
///
/// `Sides`: triangle_bound(); takes(t), whether t has sides; corner(h), the vertex that h leaves; link(h), a place for
/// a number of 32 bits, written before it is read; joined(h), its content if h is across, or not_joined; odd_edge(v,
/// w), called for each odd edge.
template <class Sides>
class JoinSides {
 public:
  JoinSides(const Sides& sides, std::size_t vertex_count, BuildReport& report)
      : sides_(sides), report_(report), lists_(vertex_count, end), edges_(vertex_count) {}

  void run() {
    for (std::uint32_t t = 0; t < sides_.triangle_bound(); ++t) {
      if (!sides_.takes(t)) continue;
      for (std::uint32_t h = t << 2; h < (t << 2 | 3U); ++h) {
        std::uint32_t& first = lists_[(std::min)(sides_.corner(h), sides_.corner(next(h)))];
        sides_.link(h) = first;
        first = h;
      }
    }
    for (std::uint32_t low = 0; low < lists_.size(); ++low) read_list(low);
    report_.boundary_edges += alone_;
    join_odd_edges();
  }

 private:
  static constexpr std::uint32_t end = 0xFFFF'FFFFU;  // of a list; not a vertex
  // Stored instead of the first side of an edge: two sides are joined, or the edge is odd.
  static constexpr std::uint32_t second = 1U << 31;
  static constexpr std::uint32_t odd = end;

  struct Edge {
    std::uint32_t low = end;   // the vertex whose list it was met in
    std::uint32_t side = end;  // the last one met
  };

  static constexpr std::uint32_t next(std::uint32_t h) noexcept { return (h & 2U) != 0 ? h - 2 : h + 1; }
  static constexpr std::uint32_t previous(std::uint32_t h) noexcept { return next(next(h)); }

  void read_list(std::uint32_t low) {
    for (std::uint32_t h = lists_[low], then = end; h != end; h = then) {
      then = sides_.link(h);
      const std::uint32_t from = sides_.corner(h);
      const std::uint32_t high = from + sides_.corner(next(h)) - low;
      Edge& edge = edges_[high];
      const bool met = edge.low == low;
      if (met && ((edge.side & second) != 0 || sides_.corner(edge.side) == from)) {
        put_odd(h, edge, low, high);
        continue;
      }
      const std::uint32_t g = met ? edge.side : h;
      sides_.link(g) = met ? sides_.joined(h) : Sides::not_joined;
      sides_.link(h) = met ? sides_.joined(g) : Sides::not_joined;
      alone_ += met ? std::size_t{0} - 1 : 1;
      edge = {low, met ? h | second : h};
    }
  }

  // ---- odd edges

  // A third side, or a side with the same direction as the other one.
  RESTRIP_COLD void put_odd(std::uint32_t h, Edge& edge, std::uint32_t low, std::uint32_t high) {
    if (edge.side != odd) {
      if (odd_of_.empty()) odd_of_.resize(edges_.size());
      odd_of_[high] = static_cast<std::uint32_t>(odd_edges_++);
      sides_.odd_edge(low, high);
      const std::uint32_t g = edge.side & ~second;
      if ((edge.side & second) != 0)
        put_odd_side(sides_.across(g), high);
      else
        --alone_;
      put_odd_side(g, high);
      edge.side = odd;
    }
    put_odd_side(h, high);
  }
  void put_odd_side(std::uint32_t h, std::uint32_t high) {
    sides_.link(h) = Sides::not_joined;
    odd_sides_.push_back({odd_of_[high], h});
  }

  RESTRIP_COLD void join_odd_edges() {
    std::vector<std::size_t> begin(odd_edges_ + 1, 0);
    for (const OddSide& side : odd_sides_) ++begin[side.edge + 1];
    for (std::size_t e = 0; e < odd_edges_; ++e) begin[e + 1] += begin[e];
    std::vector<std::uint32_t> sorted(odd_sides_.size());
    std::vector<std::size_t> place(begin.begin() + 1, begin.end());
    for (const OddSide& side : odd_sides_) sorted[--place[side.edge]] = side.h;  // ascending: lists are read backwards
    const auto sides_of = [&](std::size_t e) { return std::span(sorted).subspan(begin[e], begin[e + 1] - begin[e]); };
    std::vector<std::size_t> edges(odd_edges_);
    std::iota(edges.begin(), edges.end(), std::size_t{0});
    std::sort(edges.begin(), edges.end(),
              [&](std::size_t e, std::size_t f) { return sorted[begin[e]] > sorted[begin[f]]; });
    for (const std::size_t e : edges) join_odd_edge(sides_of(e));
    // If two pairs of sides of an edge are in two connected components, they exchange partners, so that one strip may
    // cover both.
    std::vector<std::uint32_t> parent(odd_edges_ == 0 ? 0 : sides_.triangle_bound());
    std::iota(parent.begin(), parent.end(), 0U);
    for (std::uint32_t t = 0; t < parent.size(); ++t)
      for (std::uint32_t h = t << 2; h < (t << 2 | 3U); ++h)
        if (is_joined(h)) parent[find_root(parent, t)] = find_root(parent, sides_.across(h) >> 2);
    for (const std::size_t e : edges) {
      std::uint32_t one = end;
      for (const std::uint32_t h : sides_of(e)) {
        if (!is_joined(h) || sides_.corner(h) != sides_.corner(sides_of(e).front())) continue;
        const std::uint32_t before = std::exchange(one, h);
        if (before == end || find_root(parent, before >> 2) == find_root(parent, h >> 2)) continue;
        const std::uint32_t g = sides_.across(h);
        join(h, sides_.across(before));
        join(before, g);
        parent[find_root(parent, before >> 2)] = find_root(parent, h >> 2);
      }
    }
  }

  RESTRIP_COLD void join_odd_edge(std::span<const std::uint32_t> sides) {
    ++(sides.size() == 2 ? report_.inconsistent_edges : report_.non_manifold_edges);
    for (const std::uint32_t h : sides)
      if (const std::uint32_t other = is_joined(h) ? end : beyond_fan(h); other != end) join(h, other);
    for (auto& way : ways_) way.clear();
    for (const std::uint32_t h : sides)
      if (!is_joined(h)) ways_[sides_.corner(h) == sides_.corner(sides.front()) ? 0 : 1].push_back(h);
    if (ways_[0].size() > ways_[1].size()) std::swap(ways_[0], ways_[1]);
    auto& [few, many] = ways_;
    // Looks at only a few others, so that an edge of many sides takes linear time.
    constexpr std::size_t most_looks = 8;
    for (std::size_t i = 0; i < few.size(); ++i)
      for (std::size_t j = i; j < (std::min)(i + most_looks, many.size()); ++j)
        if (!are_backs(few[i], many[j])) {
          std::swap(many[i], many[j]);
          break;
        }
    for (std::size_t i = 0; i < few.size(); ++i)
      for (std::size_t j = i - (std::min)(i, most_looks); are_backs(few[i], many[i]) && j < i; ++j)
        if (!are_backs(few[i], many[j]) && !are_backs(few[j], many[i])) std::swap(many[i], many[j]);
    for (std::size_t i = 0; i < few.size(); ++i) join(few[i], many[i]);
  }

  [[nodiscard]] bool is_joined(std::uint32_t h) const noexcept { return sides_.link(h) != Sides::not_joined; }
  void join(std::uint32_t h, std::uint32_t g) noexcept {
    sides_.link(h) = sides_.joined(g);
    sides_.link(g) = sides_.joined(h);
  }
  // For two sides of one edge.
  [[nodiscard]] bool are_backs(std::uint32_t h, std::uint32_t g) const noexcept {
    return sides_.corner(previous(h)) == sides_.corner(previous(g));
  }
  // The side of the same edge, the other way, that is met when one turns from h around one of its ends; or `end`.
  [[nodiscard]] std::uint32_t beyond_fan(std::uint32_t h) const noexcept {
    const auto turned = [this, h](auto turn) {
      std::uint32_t g = turn(h);
      for (unsigned steps = 0; steps < 64 && is_joined(g); ++steps) g = turn(sides_.across(g));
      const bool same =
          !is_joined(g) && sides_.corner(g) == sides_.corner(next(h)) && sides_.corner(next(g)) == sides_.corner(h);
      return same && !are_backs(h, g) ? g : end;
    };
    const std::uint32_t g = turned(next);
    return g != end ? g : turned(previous);
  }

  struct OddSide {
    std::uint32_t edge;
    std::uint32_t h;
  };

  const Sides& sides_;
  BuildReport& report_;
  std::size_t alone_ = 0;              // edges with one side so far
  std::vector<std::uint32_t> lists_;   // the first side of each vertex
  std::vector<Edge> edges_;            // by their larger vertex
  std::vector<std::uint32_t> odd_of_;  // of an odd edge, by its larger vertex: its number
  std::size_t odd_edges_ = 0;
  std::vector<OddSide> odd_sides_;
  std::array<std::vector<std::uint32_t>, 2> ways_;  // of an odd edge: its sides that are not joined, by their direction
};

void expect_vertices(std::size_t vertex_count);

}  // namespace detail

}  // namespace restrip
