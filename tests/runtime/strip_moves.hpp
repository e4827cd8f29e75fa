// Moves of descents and of searches at strip ends, made and enumerated by their definition. Independent of how the
// library finds them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "restrip/output/strips.hpp"
#include "restrip/search/descent.hpp"
#include "sample_meshes.hpp"

namespace restrip::moves {

using Halfedge = StripMesh::Halfedge;
using sample::dual_edges;

inline constexpr std::int32_t any_price = 1'000'000;

inline const std::array<Cost, 4> some_costs{Cost::indices(), Cost::strips(), Cost{3, 1, 2}, Cost{2, 3, 0}};

// A dual edge as a number, the same from both sides.
inline std::uint32_t edge_number(const StripMesh& mesh, Halfedge h) { return std::min(h.id, mesh.opposite(h).id); }

// A move as the set of dual edges whose colours it changes.
using Changes = std::set<std::uint32_t>;

inline Changes changes_of(const StripMesh& mesh, const StripMove& move) {
  Changes changes{edge_number(mesh, move.edge)};
  for (const Halfedge h : move.given_up)
    if (h.id != none) changes.insert(edge_number(mesh, h));
  return changes;
}

inline void recolor(StripMesh& mesh, const Changes& changes) {
  std::vector<std::uint32_t> to_set;
  for (const std::uint32_t id : changes) {
    if (!mesh.solid({id})) to_set.push_back(id);
    if (mesh.solid({id})) mesh.set_solid({id}, false);
  }
  for (const std::uint32_t id : to_set) mesh.set_solid({id}, true);
}

// All moves at the dual edge of h, from the definition in descent.hpp. Those that begin at a strip's end are the same.
inline std::vector<Changes> moves_of(const StripMesh& mesh, Halfedge h) {
  const Halfedge back = mesh.opposite(h);
  const Triangle t = StripMesh::triangle(h);
  const Triangle u = StripMesh::triangle(back);
  const std::uint32_t edge = edge_number(mesh, h);
  if (mesh.solid(h)) return {{edge}};
  const auto solid_edges = [&](Triangle triangle) {
    std::vector<Halfedge> edges;
    for (unsigned side = 0; side < 3; ++side)
      if (mesh.solid(StripMesh::halfedge(triangle, side))) edges.push_back(StripMesh::halfedge(triangle, side));
    return edges;
  };
  for (const Halfedge g : solid_edges(t))
    if (StripMesh::triangle(mesh.opposite(g)) == u) return {};  // they follow each other already
  std::vector<Changes> moves{{edge}};
  for (const Triangle triangle : {t, u}) {
    const std::vector<Halfedge> edges = solid_edges(triangle);
    if (edges.size() < 2) continue;
    std::vector<Changes> longer;
    for (const Changes& move : moves)
      for (const Halfedge g : edges) {
        longer.push_back(move);
        longer.back().insert(edge_number(mesh, g));
      }
    moves = longer;
  }
  return moves;
}

inline std::vector<Triangle> all_triangles(const StripMesh& mesh) {
  std::vector<Triangle> all;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) all.push_back(t);
  return all;
}

// Calls visit(mesh, cost) for every valid colouring of every sample mesh of fewer than eight triangles, and of some
// more; one of some_costs with each.
template <class Visit>
void for_each_small_coloring(Visit&& visit) {
  std::vector<StripMesh> small{sample::octahedron(), sample::double_cone(3), sample::double_cone(2),
                               sample::rectangle(2, 2)};
  for (const StripMesh& mesh : sample::meshes())
    if (mesh.triangle_count() < 8) small.push_back(mesh);
  for (StripMesh& mesh : small) {
    const std::vector<Halfedge> edges = dual_edges(mesh);
    ASSERT_LE(edges.size(), 12U);
    for (std::uint32_t colors = 0; colors < 1U << edges.size(); ++colors) {
      for (std::size_t i = 0; i < edges.size(); ++i) mesh.set_solid(edges[i], (colors >> i & 1U) != 0);
      if (check_coloring(mesh).valid) visit(mesh, some_costs[colors % some_costs.size()]);
      if (testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace restrip::moves
