// Custom operations work like the shipped ones: strips, swaps and isolated triangles change as reported
// under every policy and either cost, and a mesh that is not ours comes out as a StripMesh does.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "../../support/sanitizers.hpp"
#include "coloring_cost.hpp"
#include "hand_made_mesh.hpp"
#include "locator_agrees.hpp"
#include "own_operations.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

// Under a keeper, reported changes are counted as well, and its locator follows; under every policy and either cost.
TEST(KeptApply, KeepersFollow) {
  std::mt19937 random(7);
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices(), Cost{3, 1, 2}})
      for (const StripMesh& start : {sample::torus(8, 7), sample::rectangle(7, 6)}) {
        StripMesh mesh = start;
        stripify(mesh, Effort::fast, Cost::strips());
        Keeper keeper(mesh, row.policy, cost);
        if (row.policy == Policy::local && cost == Cost::strips()) join_all(mesh), keeper.rebuild();
        std::size_t done = 0;
        for (std::size_t n = 0; n < test::large(1500); ++n) {
          if (row.policy == Policy::bare && n % 8 == 0) stripify(mesh, Effort::fast, Cost::strips()), keeper.rebuild();
          ColoringChange change = cost_of(mesh);
          Rewrite<Halfedge> reported = stir(keeper, mesh, random, 2 * start.triangle_count()).rewrite;
          random_application(mesh, random, 3 * start.triangle_count(), [&](const auto& table, Halfedge h) {
            const auto rewrite = keeper.apply(table, h);
            reported.strips += rewrite.strips;
            reported.isolated += rewrite.isolated;
            ++done;
          });
          change = cost_of(mesh) - change;
          ASSERT_EQ(reported.strips, change.strips);
          ASSERT_EQ(reported.isolated, change.isolated);
          ASSERT_EQ(keeper.swaps(), static_cast<std::size_t>(cost_of(mesh).swaps));
          if (n % 8 != 0) continue;
          const ColoringReport counted = check_coloring(mesh);
          ASSERT_TRUE(counted.valid);
          ASSERT_EQ(keeper.strips(), counted.strips);
          ASSERT_EQ(keeper.isolated(), counted.isolated);
          if (keeper.locator() != nullptr) {
            ASSERT_TRUE(agrees(*keeper.locator(), mesh));
          }
          if (row.policy == Policy::local && cost == Cost::strips()) {
            // No two ends meet: docs/explanation/theory.md, "What holds for the whole mesh".
            StripMesh copy = mesh;
            ASSERT_EQ(join_all(copy).strips, 0);
          }
        }
        EXPECT_GT(done, test::large(1500) / 40);
      }
}

// ---- a foreign mesh

/// A user's mesh: another type of handles, other numbers, and only the functions of the concepts.
class Foreign {
 public:
  struct Halfedge {
    std::uint32_t value = none;
    explicit Halfedge() = default;
    explicit Halfedge(StripMesh::Halfedge h) : value(~h.id) {}
    [[nodiscard]] StripMesh::Halfedge own() const { return {~value}; }
    friend bool operator==(Halfedge, Halfedge) = default;
  };
  explicit Foreign(StripMesh mesh) : mesh_(std::move(mesh)) {}

  [[nodiscard]] Halfedge next(Halfedge h) const { return Halfedge(StripMesh::next(h.own())); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const { return Halfedge(mesh_.opposite(h.own())); }
  [[nodiscard]] bool on_boundary(Halfedge h) const { return StripMesh::on_boundary(h.own()); }
  [[nodiscard]] bool solid(Halfedge h) const { return mesh_.solid(h.own()); }
  void set_solid(Halfedge h, bool solid) { mesh_.set_solid(h.own(), solid); }
  Halfedge insert_vertex(const VertexSplit<Halfedge>& where) {
    return Halfedge(mesh_.insert_vertex(
        {where.left.own(), where.right.own(), static_cast<VertexSplit<StripMesh::Halfedge>::Spokes>(where.spokes)}));
  }
  Halfedge remove_vertex(Halfedge chord) { return Halfedge(mesh_.remove_vertex(chord.own())); }
  Halfedge turn_edge(Halfedge h) { return Halfedge(mesh_.turn_edge(h.own())); }
  [[nodiscard]] std::uint32_t triangle(Halfedge h) const { return StripMesh::triangle(h.own()) + 5; }
  [[nodiscard]] Halfedge halfedge(std::uint32_t t) const { return Halfedge(StripMesh::halfedge(t - 5, 1)); }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return t >= 5 && mesh_.alive(t - 5); }
  [[nodiscard]] std::size_t triangle_bound() const { return mesh_.triangle_bound() + 5; }
  [[nodiscard]] std::uint32_t from(Halfedge h) const { return mesh_.from(h.own()); }
  [[nodiscard]] const StripMesh& same() const { return mesh_; }

 private:
  StripMesh mesh_;
};
static_assert(NumberedMesh<Foreign> && SplittableMesh<Foreign> && FlippableMesh<Foreign>);

/// Red-green refinement by operations that the mesh has: each side of the triangle in the middle is bisected, which
/// leaves one edge to be turned.
template <class Mesh>
auto refining(Mesh& mesh) {
  return [&mesh](const auto& patch) {
    const auto halve = [&](auto h) { return mesh.insert_vertex(detail::split_on_edge(mesh, h)); };
    const auto a_p = halve(patch.side[0][0]);
    const auto c_a = mesh.next(mesh.next(a_p));
    halve(patch.side[0][1]);
    const auto c_r = halve(c_a);
    return mesh.next(mesh.turn_edge(mesh.next(mesh.next(c_r))));  // p - c becomes q - r
  };
}
/// m goes, which is vertex 2 of the file, into a, which is 3.
template <class Mesh>
auto merging(Mesh& mesh) {
  return [&mesh](const auto& patch) { return mesh.next(mesh.opposite(mesh.remove_vertex(patch.between(3, 2)))); };
}

// The same rule, the same colours.
TEST(KeptApply, DoesTheSameOnAForeignMesh) {
  std::mt19937 random(8);
  StripMesh mesh = sample::torus(9, 8);
  stripify(mesh, Effort::fast, Cost::strips());
  std::array<std::size_t, 2> compared{};
  const auto compare = [&](std::size_t kind, const auto& table, auto&& change) {
    const auto h = random_place(mesh, table, random);
    if (!h) return;
    Foreign foreign(mesh);
    const auto reported = apply(foreign, table, Foreign::Halfedge(*h), change(foreign));
    const auto done = apply(mesh, table, *h);
    EXPECT_EQ(reported.strips, done.strips);
    EXPECT_EQ(reported.isolated, done.isolated);
    std::map<Vertex, Vertex> names;
    const std::vector<Vertex> theirs = added_vertices(foreign, table, reported.halfedge);
    const std::vector<Vertex> ours = added_vertices(mesh, table, done.halfedge);
    ASSERT_EQ(theirs.size(), ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i) names[theirs[i]] = ours[i];
    std::set<std::pair<Vertex, Vertex>> solid;
    for (auto [v, w] : solid_edges_of(foreign.same())) {
      if (names.contains(v)) v = names.at(v);
      if (names.contains(w)) w = names.at(w);
      solid.insert(std::minmax(v, w));
    }
    EXPECT_EQ(solid, solid_edges_of(mesh));
    ++compared[kind];
  };
  for (int n = 0; n < 400 && !HasFailure(); ++n) {
    stir(mesh, mesh, random, 300);
    if (mesh.triangle_count() < 600) compare(0, tables::refine_face_rules, [](Foreign& f) { return refining(f); });
    compare(1, tables::merge_rules, [](Foreign& f) { return merging(f); });
  }
  EXPECT_GT(compared[0], 50U);
  EXPECT_GT(compared[1], 50U);
}

TEST(KeptApply, KeepersFollowOnAForeignMesh) {
  std::mt19937 random(9);
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices()}) {
      Foreign mesh(sample::torus(9, 8));
      Keeper<Foreign> keeper(mesh, row.policy, cost);
      keeper.improve(2000);
      std::array<std::size_t, 2> done{};
      const auto step = [&](std::size_t kind, const auto& table, auto&& change_mesh) {
        const auto h = random_place(mesh.same(), table, random);
        if (!h) return;
        ++done[kind];
        const ColoringChange before = cost_of(mesh.same());
        const auto reported = keeper.apply(table, Foreign::Halfedge(*h), change_mesh);
        const ColoringChange change = cost_of(mesh.same()) - before;
        ASSERT_EQ(reported.strips, change.strips);
        ASSERT_EQ(reported.isolated, change.isolated);
        ASSERT_TRUE(check_coloring(mesh.same()).valid);
        ASSERT_EQ(count_strips(mesh), keeper.strips());
        ASSERT_EQ(static_cast<long>(keeper.swaps()), cost_of(mesh.same()).swaps);
      };
      for (int n = 0; n < 100 && !HasFailure(); ++n) {
        const Halfedge h = random_halfedge(mesh.same(), random);
        if (mesh.same().triangle_count() > 300 && check_collapse(mesh.same(), h) == Refusal::granted)
          keeper.collapse(Foreign::Halfedge(h));
        else if (check_flip(mesh.same(), h) == Refusal::granted)
          keeper.flip(Foreign::Halfedge(h));
        if (mesh.same().triangle_count() < 600) step(0, tables::refine_face_rules, refining(mesh));
        step(1, tables::merge_rules, merging(mesh));
      }
      EXPECT_GT(done[0], 30U);
      EXPECT_GT(done[1], 30U);
    }
}

/// Triangles that are paired, on a mesh that flips and nothing else.
TEST(KeptApply, KeepsPairsOnAHandMadeMesh) {
  std::mt19937 random(10);
  sample::HandMade mesh(sample::torus(6, 6));
  const auto single = [&](int h) {
    int solid = 0;
    for (int side = 0; side < 3; ++side, h = mesh.next(h)) solid += mesh.solid(h) ? 1 : 0;
    EXPECT_LE(solid, 1);
    return solid == 0;
  };
  const auto count_single = [&] {
    int count = 0;
    for (int h = 0; h < mesh.size(); h += 3) count += single(h) ? 1 : 0;
    return count;
  };
  for (int h = 0; h < mesh.size(); ++h)
    if (single(h) && single(mesh.opposite(h))) mesh.set_solid(h, true);
  int alone = count_single();
  int flips = 0;
  for (int n = 0; n < 3000; ++n) {
    const int h = static_cast<int>(random() % static_cast<unsigned>(mesh.size()));
    if (!mesh.can_flip(h)) continue;
    const auto done = apply(mesh, tables::flip_matching_rules, h, [&](const auto& patch) {
      // r -> l of (r, l, u); the file begins with l, u, r
      return mesh.next(mesh.turn_edge(patch.side[0][0]));
    });
    alone += done.isolated;
    ASSERT_EQ(count_single(), alone);
    ++flips;
  }
  EXPECT_GT(flips, 500);
}

}  // namespace
}  // namespace restrip
