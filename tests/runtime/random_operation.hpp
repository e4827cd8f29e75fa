// A random split, collapse or flip under a keeper, for tests that need many.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip {

inline StripMesh::Halfedge random_halfedge(const StripMesh& mesh, std::mt19937& random) {
  for (;;) {
    const StripMesh::Halfedge h{(static_cast<std::uint32_t>(random() % mesh.triangle_bound()) << 2) |
                                static_cast<std::uint32_t>(random() % 3)};
    if (mesh.alive(h)) return h;
  }
}

/// A split at this spoke, drawn at random, legal or not; the spoke that does not count is not to be looked at.
inline VertexSplit<StripMesh::Halfedge> random_split(const StripMesh& mesh, StripMesh::Halfedge h,
                                                     std::mt19937& random) {
  using Spokes = VertexSplit<StripMesh::Halfedge>::Spokes;
  VertexSplit<StripMesh::Halfedge> where{h, h, Spokes::both};
  for (auto turns = 1 + random() % 4; turns > 0 && !StripMesh::on_boundary(where.right); --turns)
    where.right = turn_ccw(mesh, where.right);
  if (mesh.leaves_boundary(h) && random() % 2 == 0) {
    where.spokes = random() % 2 == 0 ? Spokes::left_only : Spokes::right_only;
    (where.spokes == Spokes::left_only ? where.right : where.left) = {};
  }
  return where;
}

// Returns false when the operation drawn was not possible.
template <class Keeper>
bool random_operation(Keeper& keeper, std::mt19937& random, bool grow) {
  using Halfedge = StripMesh::Halfedge;
  const StripMesh& mesh = keeper.mesh();
  const Halfedge h = random_halfedge(mesh, random);
  const std::size_t before = keeper.strips();
  // Counting isolated triangles looks at the whole mesh.
  const bool counts_isolated = mesh.triangle_count() < 1000;
  const auto isolated = [&] { return counts_isolated ? static_cast<int>(check_coloring(mesh).isolated) : 0; };
  const int isolated_before = isolated();
  Rewrite<Halfedge> done;
  if (random() % 6 == 0) {
    if (check_flip(mesh, h) != Refusal::granted) return false;
    done = keeper.flip(h);
  } else if (!grow) {
    if (check_collapse(mesh, h) != Refusal::granted) return false;
    done = keeper.collapse(h);
  } else {
    const VertexSplit<Halfedge> where = random_split(mesh, h, random);
    if (check_split(mesh, where) != Refusal::granted) return false;
    done = keeper.split(where);
  }
  EXPECT_EQ(static_cast<long>(keeper.strips()), static_cast<long>(before) + done.strips);
  if (counts_isolated) {
    EXPECT_EQ(isolated(), isolated_before + done.isolated);
  }
  return true;
}

}  // namespace restrip
