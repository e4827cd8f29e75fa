// Splits and collapses of large fans on meshes, under the rules and the linked rules: the strips stay valid, a recount
// of the whole mesh finds what is reported, and no valid recolouring of the patch is better. For linked rules that
// follow every strip to its end, valid means in this mesh; for the rules, in every mesh. The graph that is searched is
// made of the triangles of the mesh after the operation, patch and strips outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "patch_in_mesh.hpp"
#include "random_operation.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/linked.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using FanHalfedge = StripMesh::Halfedge;
using FanSplit = VertexSplit<FanHalfedge>;

constexpr std::size_t to_the_end = std::numeric_limits<std::size_t>::max();

/// Collapses neighbours into a vertex until it has `k` triangles or no collapse is legal.
template <class Random>
void grow_fan(StripMesh& mesh, Vertex v, std::size_t k, Random& random) {
  for (bool goes_on = true; goes_on;) {
    std::vector<FanHalfedge> spokes = sample::spokes_around(mesh, v);
    if (spokes.size() >= k) return;
    std::shuffle(spokes.begin(), spokes.end(), random);
    const auto legal = std::find_if(spokes.begin(), spokes.end(), [&](FanHalfedge h) {
      return check_collapse(mesh, h) == Refusal::granted &&
             (mesh.leaves_boundary(h) || !mesh.leaves_boundary(mesh.opposite(h)));
    });
    goes_on = legal != spokes.end();
    if (goes_on) collapse(mesh, *legal);
  }
}

struct FanTally {
  std::size_t operations = 0;
  std::size_t bolder = 0;  ///< the linked rule kept more strips together than the local one
  std::set<std::size_t> valences;
};

/// One operation on copies of the mesh: by the rules, by linked rules that follow strips to their ends, and by
/// linked rules that follow them for three triangles. `operate(copy, rules)` does it and returns the reported changes
/// and the vertices around which the patch lies then; before it lies around `centers`.
template <class Operate>
void check_rules(const StripMesh& mesh, const std::set<Vertex>& centers, const Operate& operate, FanTally& tally) {
  const auto pairs = PatchInMesh(mesh, centers).pairs();
  long best = 0;           // in this mesh
  long best_anywhere = 0;  // in every mesh
  std::size_t valence = 0;
  const auto run = [&](const auto& rules) {
    StripMesh copy = mesh;
    const auto [done, around] = operate(copy, rules);
    Census expected = census_of(mesh);
    EXPECT_EQ(census_of(copy), expected += done);
    const PatchInMesh patch(copy, around);
    if (valence == 0) {  // neither depends on the rules
      valence = done.valence;
      best = patch.best_here();
      best_anywhere = patch.best_anywhere(pairs);
    }
    return patch.value();
  };
  const long local = run(detail::LocalRules{});
  EXPECT_EQ(local, best_anywhere);
  const long linked = run(detail::LinkedRules{to_the_end});
  EXPECT_EQ(linked, valence <= max_word_valence ? best : best_anywhere) << "k " << valence;
  const long short_sighted = run(detail::LinkedRules{3});
  EXPECT_GE(short_sighted, local);
  EXPECT_LE(short_sighted, linked);
  ++tally.operations;
  tally.bolder += linked / 500'000 > local / 500'000 ? 1 : 0;
  tally.valences.insert(valence);
}

/// A split at a random position of the fan of `v`, then a collapse of the new edge, each under separate colours.
template <class Random>
void check_fan(StripMesh mesh, Vertex v, Random& random, FanTally& tally) {
  using Spokes = FanSplit::Spokes;
  sample::color_at_random(mesh, 1, random);
  const std::vector<FanHalfedge> spokes = sample::spokes_around(mesh, v);
  FanSplit where{spokes[random() % spokes.size()], spokes[random() % spokes.size()], Spokes::both};
  if (mesh.leaves_boundary(where.left) && random() % 3 == 0)
    where.spokes = random() % 2 == 0 ? Spokes::left_only : Spokes::right_only;
  if (check_split(mesh, where) != Refusal::granted) return;
  check_rules(
      mesh, {v},
      [&](StripMesh& copy, const auto& rules) {
        const auto done = detail::split_with(rules, copy, where);
        return std::pair{done, std::set<Vertex>{copy.from(done.halfedge), copy.to(done.halfedge)}};
      },
      tally);
  const FanHalfedge chord = split(mesh, where).halfedge;
  if (check_collapse(mesh, chord) != Refusal::granted) return;
  sample::color_at_random(mesh, 1, random);
  check_rules(
      mesh, {mesh.from(chord), mesh.to(chord)},
      [&](StripMesh& copy, const auto& rules) {
        const auto done = detail::collapse_with(rules, copy, chord);
        return std::pair{done, std::set<Vertex>{copy.from(done.halfedge)}};
      },
      tally);
}

TEST(LinkedFans, AreTheBestInTheirMeshInLargeFans) {
  std::mt19937 random(20260206);
  FanTally tally;
  for (const StripMesh& start : {sample::torus(12, 12), sample::rectangle(12, 12), sample::sphere(3)})
    for (const std::size_t k : {9U, 10U, 12U, 16U, 17U, 24U, 40U, 61U})
      for (int n = 0; n < 3; ++n) {
        SCOPED_TRACE(::testing::Message() << start.triangle_count() << " triangles, k " << k << ", number " << n);
        StripMesh mesh = start;
        const auto v = static_cast<Vertex>(random() % mesh.vertex_bound());
        grow_fan(mesh, v, k, random);
        for (int colors = 0; colors < 4; ++colors) check_fan(mesh, v, random, tally);
        if (HasFailure()) return;
      }
  EXPECT_GT(tally.operations, 300U);
  EXPECT_GT(tally.bolder, 100U);
  EXPECT_GT(tally.valences.size(), 15U);
  EXPECT_GT(*tally.valences.rbegin(), 30U);
}

TEST(LinkedFans, AreTheBestInFansOfAnySize) {
  std::mt19937 random(20260207);
  FanTally tally;
  for (const Vertex k : {9U, 33U, 60U, 61U, 62U, 63U, 64U, 65U, 130U, 1000U})
    for (const bool closed : {true, false})
      for (int n = 0; n < (k < 100 ? 4 : 1); ++n) {
        SCOPED_TRACE(::testing::Message() << (closed ? "closed " : "open ") << k << ", number " << n);
        check_fan(closed ? sample::double_cone(k) : sample::open_double_cone(k), 0, random, tally);
        if (HasFailure()) return;
      }
  EXPECT_GT(tally.operations, 80U);
  EXPECT_GT(tally.bolder, 10U);
}

}  // namespace
}  // namespace restrip
