// Random operations, legal or not, on a mesh or its keeper: the kinds, how often each is drawn, and where; and whether
// they report what a count of the whole mesh finds. tests/drive has those on a LiveMesh.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/policy.hpp"

namespace restrip {

enum class OperationKind : std::uint8_t { split, collapse, flip, split_face, join_faces, bisect, merge };

/// How often a kind is drawn, relative to the other rows of a list.
struct OperationShare {
  OperationKind kind;
  unsigned share = 1;
};
inline constexpr auto all_operations = std::to_array<OperationShare>({{OperationKind::split, 3},
                                                                      {OperationKind::collapse, 3},
                                                                      {OperationKind::flip, 2},
                                                                      {OperationKind::split_face},
                                                                      {OperationKind::join_faces},
                                                                      {OperationKind::bisect},
                                                                      {OperationKind::merge}});
static_assert(all_operations.size() == static_cast<std::size_t>(OperationKind::merge) + 1, "a row for each kind");
inline constexpr auto splits_collapses_flips =
    std::to_array<OperationShare>({{OperationKind::flip}, {OperationKind::split, 5}, {OperationKind::collapse, 5}});

/// What happens to the number of triangles: no operation drawn removes any (grow) or adds any (shrink).
enum class Trend : std::uint8_t { any, grow, shrink };
constexpr Trend trend_of(bool grow) noexcept { return grow ? Trend::grow : Trend::shrink; }
/// Keeps a number of triangles about between `low` and `high`.
constexpr Trend trend_between(std::size_t low, std::size_t high, std::size_t triangles) noexcept {
  return triangles > high ? Trend::shrink : triangles < low ? Trend::grow : Trend::any;
}
constexpr bool follows(OperationKind kind, Trend trend) noexcept {
  using enum OperationKind;
  if (trend == Trend::any || kind == flip) return true;
  return (kind == split || kind == split_face || kind == bisect) == (trend == Trend::grow);
}

/// The numbers that kind_at() maps to kinds are below this one.
template <std::size_t N>
constexpr unsigned sum_of_shares(const std::array<OperationShare, N>& list, Trend trend = Trend::any) noexcept {
  unsigned sum = 0;
  for (const auto& [kind, share] : list) sum += follows(kind, trend) ? share : 0;
  return sum;
}
template <std::size_t N>
constexpr OperationKind kind_at(const std::array<OperationShare, N>& list, unsigned number,
                                Trend trend = Trend::any) noexcept {
  for (const auto& [kind, share] : list) {
    if (!follows(kind, trend)) continue;
    if (number < share) return kind;
    number -= share;
  }
  return list.back().kind;
}

struct DrawnOperation {
  using Halfedge = StripMesh::Halfedge;
  OperationKind kind{};
  Halfedge h;         ///< all but splits
  VertexSplit where;  ///< splits
};

/// A side of a triangle.
inline StripMesh::Halfedge random_halfedge(const StripMesh& mesh, std::mt19937& random) {
  for (;;) {
    const StripMesh::Halfedge h{(static_cast<std::uint32_t>(random() % mesh.triangle_bound()) << 2) |
                                static_cast<std::uint32_t>(random() % 3)};
    if (mesh.alive(h)) return h;
  }
}
/// A halfedge, also of the boundary.
inline StripMesh::Halfedge random_side(const StripMesh& mesh, std::mt19937& random) {
  const StripMesh::Halfedge h = random_halfedge(mesh, random);
  return random() % 4 == 0 ? mesh.opposite(h) : h;
}

/// A split at this spoke; a spoke that does not count is not to be looked at.
inline VertexSplit random_split(const StripMesh& mesh, StripMesh::Halfedge h, std::mt19937& random) {
  using Spokes = VertexSplit::Spokes;
  VertexSplit where{h, h, Spokes::both};
  for (auto turns = 1 + random() % 4; turns > 0 && !StripMesh::on_boundary(where.right); --turns)
    where.right = turn_ccw(mesh, where.right);
  if (mesh.leaves_boundary(h) && random() % 2 == 0) {
    where.spokes = random() % 2 == 0 ? Spokes::left_only : Spokes::right_only;
    (where.spokes == Spokes::left_only ? where.right : where.left) = {};
  }
  return where;
}

/// An operation of the list at h.
template <std::size_t N>
DrawnOperation draw_at(const StripMesh& mesh, StripMesh::Halfedge h, std::mt19937& random,
                       const std::array<OperationShare, N>& list, Trend trend = Trend::any) {
  DrawnOperation drawn{kind_at(list, static_cast<unsigned>(random() % sum_of_shares(list, trend)), trend), h, {}};
  if (drawn.kind == OperationKind::split) drawn.where = random_split(mesh, h, random);
  return drawn;
}
template <std::size_t N>
DrawnOperation draw(const StripMesh& mesh, std::mt19937& random, const std::array<OperationShare, N>& list,
                    Trend trend = Trend::any) {
  return draw_at(mesh, random_halfedge(mesh, random), random, list, trend);
}

/// Of an operation that has a name and a table.
inline OperationPlace place_of(const StripMesh& mesh, OperationKind kind, Halfedge h) {
  if (kind == OperationKind::split_face) return split_face_at(mesh, h);
  if (kind == OperationKind::join_faces) return join_faces_at(mesh, h);
  return kind == OperationKind::bisect ? bisect_at(mesh, h) : merge_at(mesh, h);
}

inline Refusal check(const StripMesh& mesh, const DrawnOperation& drawn) {
  switch (drawn.kind) {
    case OperationKind::split:
      return check_split(mesh, drawn.where);
    case OperationKind::collapse:
      return check_collapse(mesh, drawn.h);
    case OperationKind::flip:
      return check_flip(mesh, drawn.h);
    default:
      return check_apply(mesh, place_of(mesh, drawn.kind, drawn.h));
  }
}

/// By a StripMesh or its keeper; refused if it is not legal.
template <class Target>
Checked perform(Target& target, const DrawnOperation& drawn) {
  if (drawn.kind == OperationKind::split) return checked_split(target, drawn.where);
  if (drawn.kind == OperationKind::collapse) return checked_collapse(target, drawn.h);
  if (drawn.kind == OperationKind::flip) return checked_flip(target, drawn.h);
  const StripMesh* mesh = nullptr;
  if constexpr (std::same_as<Target, StripMesh>)
    mesh = &target;
  else
    mesh = &target.mesh();
  const OperationPlace at = place_of(*mesh, drawn.kind, drawn.h);
  return checked_apply(target, at.table, at.where);
}

/// The policies that search after a rule, and so weigh more than strips.
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

/// False if the operation of the list that was drawn was not possible.
template <class Keeper, std::size_t N = splits_collapses_flips.size()>
bool random_operation(Keeper& keeper, std::mt19937& random, bool grow,
                      const std::array<OperationShare, N>& list = splits_collapses_flips) {
  const StripMesh& mesh = keeper.mesh();
  const DrawnOperation drawn = draw(mesh, random, list, trend_of(grow));
  const std::size_t before = keeper.strips();
  // Counting isolated triangles looks at the whole mesh.
  const bool counts_isolated = mesh.triangle_count() < 1000;
  const auto isolated = [&] { return counts_isolated ? static_cast<int>(check_coloring(mesh).isolated) : 0; };
  const int isolated_before = isolated();
  const Checked done = perform(keeper, drawn);
  if (!done) return false;
  EXPECT_EQ(static_cast<long>(keeper.strips()), static_cast<long>(before) + done.rewrite.strips);
  if (counts_isolated) {
    EXPECT_EQ(isolated(), isolated_before + done.rewrite.isolated);
  }
  return true;
}

}  // namespace restrip
