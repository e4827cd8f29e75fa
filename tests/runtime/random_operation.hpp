// A random split, collapse or flip under a keeper, for tests that need many, and a count of what operations report.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "restrip/operations/checked.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"

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

/// The policies that search after a rule, which are those that weigh more than strips.
inline std::vector<Policy> searching_policies() {
  std::vector<Policy> found;
  for (const PolicyRow& row : policies)
    if (row.plan.limits.looks > 0) found.push_back(row.policy);
  return found;
}

/// Strips and isolated triangles of the whole mesh: what operations report must add up to them.
struct Census {
  long strips = 0;
  long isolated = 0;
  /// Adds the changes that an operation reports.
  template <class Done>
  Census& operator+=(const Done& done) {
    strips += done.strips;
    isolated += done.isolated;
    return *this;
  }
  friend bool operator==(const Census&, const Census&) = default;
};

/// Of a valid colouring.
inline Census census_of(const StripMesh& mesh) {
  const ColoringReport report = check_coloring(mesh);
  EXPECT_TRUE(report.valid);
  return {static_cast<long>(report.strips), static_cast<long>(report.isolated)};
}

enum class Refining { split_face, join_faces, bisect, merge };

/// By a mesh or its keeper.
template <class Target>
Checked checked_refining(Target& target, Refining kind, StripMesh::Halfedge h) {
  if (kind == Refining::split_face) return checked_split_face(target, h);
  if (kind == Refining::join_faces) return checked_join_faces(target, h);
  if (kind == Refining::bisect) return checked_bisect(target, h);
  return checked_merge(target, h);
}

// Returns false when the operation drawn was not possible.
template <class Keeper>
bool random_operation(Keeper& keeper, std::mt19937& random, bool grow) {
  const StripMesh& mesh = keeper.mesh();
  const StripMesh::Halfedge h = random_halfedge(mesh, random);
  const std::size_t before = keeper.strips();
  // Counting isolated triangles looks at the whole mesh.
  const bool counts_isolated = mesh.triangle_count() < 1000;
  const auto isolated = [&] { return counts_isolated ? static_cast<int>(check_coloring(mesh).isolated) : 0; };
  const int isolated_before = isolated();
  Checked done;
  if (random() % 6 == 0)
    done = checked_flip(keeper, h);
  else if (!grow)
    done = checked_collapse(keeper, h);
  else
    done = checked_split(keeper, random_split(mesh, h, random));
  if (!done) return false;
  EXPECT_EQ(static_cast<long>(keeper.strips()), static_cast<long>(before) + done.rewrite.strips);
  if (counts_isolated) {
    EXPECT_EQ(isolated(), isolated_before + done.rewrite.isolated);
  }
  return true;
}

}  // namespace restrip
