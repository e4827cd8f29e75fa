// The bound on indices: which sets of vertices are looked at. Included by index_bound.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "restrip/output/impl/cut_packing.hpp"
#include "restrip/output/index_bound.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

// Edges, triangles and balls around them.
class CutCandidates {
 public:
  CutCandidates(const ArrowGraph& graph, CutPacking& packing)
      : graph_(graph), packing_(packing), inside_(graph.vertices(), false) {}

  void look(std::span<const std::array<Vertex, 3>> triangles) {
    for (Vertex v = 0; v < graph_.vertices(); ++v) {
      if (graph_.from(v).empty()) continue;
      look_around({v}, 2);
      for (const ArrowGraph::Leaving& way : graph_.from(v))
        if (way.to > v) look_around({v, way.to}, 1);
    }
    for (const auto& [a, b, c] : triangles) look_around({a, b, c}, 1);
  }

 private:
  // The edges at the vertices of a set that is looked at, so that vertices of many triangles do not make it slow.
  static constexpr std::size_t most_edges = 256;

  void look_around(std::initializer_list<Vertex> seed, unsigned radius) {
    ball_.assign(seed);
    for (unsigned r = 0; is_small(); ++r) {
      if (ball_.size() > 1) packing_.add_if_uncrossed(ball_);
      if (r == radius) return;
      grow();
    }
  }
  [[nodiscard]] bool is_small() const {
    std::size_t edges = 0;
    for (const Vertex v : ball_) edges += graph_.from(v).size();
    return edges <= most_edges;
  }
  void grow() {
    for (const Vertex v : ball_) inside_[v] = true;
    const std::size_t before = ball_.size();
    for (std::size_t i = 0; i < before; ++i)
      for (const ArrowGraph::Leaving& way : graph_.from(ball_[i])) {
        if (!inside_[way.to]) ball_.push_back(way.to);
        inside_[way.to] = true;
      }
    for (const Vertex v : ball_) inside_[v] = false;
  }

  const ArrowGraph& graph_;
  CutPacking& packing_;
  std::vector<bool> inside_;
  std::vector<Vertex> ball_;
};

[[nodiscard]] inline bool are_triangles(std::span<const std::array<Vertex, 3>> triangles, std::size_t vertices) {
  for (const auto& [a, b, c] : triangles)
    if (a == b || b == c || c == a || a >= vertices || b >= vertices || c >= vertices) return false;
  return true;
}

}  // namespace detail

[[nodiscard]] inline IndexBound strip_index_lower_bound(std::span<const std::array<Vertex, 3>> triangles,
                                                        std::size_t vertex_count, unsigned rounds) {
  RESTRIP_ASSERT(detail::are_triangles(triangles, vertex_count), "strip_index_lower_bound",
                 "a triangle has a corner twice, or one that is no vertex");
  IndexBound bound;
  if (triangles.empty()) return bound;
  const detail::ArrowGraph graph(triangles, vertex_count);
  detail::CutPacking packing(graph, IndexBound::denominator);
  for (Vertex v = 0; v < vertex_count; ++v)
    if (graph.lacking(v) != 0) packing.add(std::array{v});
  packing.descend(80);
  detail::CutCandidates candidates(graph, packing);
  for (unsigned round = 0; round < rounds; ++round) {
    const std::size_t before = packing.size();
    candidates.look(triangles);
    if (packing.size() == before) break;
    packing.descend(60);
  }
  const auto multipliers = packing.feasible();
  std::uint64_t sum = 0;
  for (std::size_t row = 0; row < packing.size(); ++row) {
    if (multipliers[row] == 0) continue;
    const auto vertices = packing.vertices(row);
    bound.cuts.push_back({{vertices.begin(), vertices.end()}, static_cast<std::uint32_t>(multipliers[row])});
    sum += static_cast<std::uint64_t>(multipliers[row]);
  }
  bound.triangles = triangles.size();
  bound.components = graph.components();
  bound.arrows = static_cast<std::size_t>((sum + IndexBound::denominator - 1) / IndexBound::denominator);
  bound.indices = bound.triangles + bound.arrows + bound.components - 1;
  return bound;
}

[[nodiscard]] inline IndexBound strip_index_lower_bound(const StripMesh& mesh, unsigned rounds) {
  std::vector<std::array<Vertex, 3>> triangles;
  triangles.reserve(mesh.triangle_count());
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) triangles.push_back(mesh.corners(t));
  return strip_index_lower_bound(triangles, mesh.vertex_bound(), rounds);
}

}  // namespace restrip
