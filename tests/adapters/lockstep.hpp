// The same random operations by keepers of a StripMesh and of a foreign mesh through its adapter: afterwards both have
// the same triangles, and each keeper knows what its mesh counts. If the policy does not search, colours are the same
// edge by edge; searches take the sides of triangles in the order of the mesh. Their index buffers draw the same: one
// made from scratch, and one kept by updates from the list of changes that Watched makes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <random>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "../runtime/sample_meshes.hpp"
#include "../support/random_operations.hpp"
#include "measure/check_buffer.hpp"
#include "restrip/mesh/watched.hpp"
#include "restrip/operations/test_adapter.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {

/// `Foreign` wraps an adapter with what the test needs of its mesh:
///   Adapter& strips();  Vertex vertex(Vertex of the StripMesh);  std::uint32_t number(Vertex);
///   Halfedge find(Vertex, Vertex), Halfedge() if it does not exist;  bool exists(Halfedge): and has it a triangle;
///   Vertex from(Halfedge), to(Halfedge);  void for_each_triangle(visit(Halfedge));
template <class Foreign>
class Lockstep {
 public:
  Lockstep(StripMesh start, Foreign& foreign, Policy policy, Cost cost, unsigned seed)
      : mesh_(std::move(start)),
        foreign_(foreign),
        watched_(foreign.strips()),
        mine_(mesh_, policy, cost),
        theirs_(watched_, policy, cost),
        buffer_(watched_),
        exact_(row_of(policy).search.states == 0 && cost == Cost::strips()),
        random_(seed) {
    for (Vertex v = 0; v < mesh_.vertex_bound(); ++v) name_.push_back(foreign.vertex(v));
  }

  void run(int operations) {
    const std::size_t low = mesh_.triangle_count() / 2;
    const std::size_t high = mesh_.triangle_count() * 2;
    for (int n = 0; n < operations; ++n) {
      const Trend trend = trend_between(low, high, mesh_.triangle_count());
      operate(draw_at(mesh_, random_side(mesh_, random_), random_, splits_collapses_flips, trend));
      if (n % 300 == 0 && !exact_) {
        mine_.improve(300);
        theirs_.improve(300);
      }
      if (n % 4 == 3 || n < 200) update_buffer();
      if (n % 50 == 0 || n < 200) compare();
      if (testing::Test::HasFatalFailure()) return;
    }
    compare();
    std::uint64_t asked = 0;
    for (const auto& [kind, share] : splits_collapses_flips) {
      EXPECT_GT(done_[kind], operations / 20);
      if (mine_.policy() != Policy::bare) asked += static_cast<std::uint64_t>(done_[kind]);
    }
    for (const RuleCounts& counts : {mine_.rule_counts(), theirs_.rule_counts()}) {
      EXPECT_EQ(counts.asked, asked);
      EXPECT_EQ(counts.taken + counts.kept, asked);
    }
  }
  [[nodiscard]] int one_sided() const { return one_sided_; }

 private:
  using Halfedge = StripMesh::Halfedge;
  using ForeignHalfedge = typename Foreign::Halfedge;

  ForeignHalfedge there(Halfedge h) {
    return h == Halfedge{} ? ForeignHalfedge() : foreign_.find(name_.at(mesh_.from(h)), name_.at(mesh_.to(h)));
  }

  /// By both, if the StripMesh permits it.
  void operate(const DrawnOperation& drawn) {
    if (check(mesh_, drawn) != Refusal::granted) return;
    const ForeignHalfedge theirs = there(drawn.h);
    ASSERT_TRUE(theirs != ForeignHalfedge());
    if (drawn.kind == OperationKind::collapse)
      return expect_same(drawn.kind, mine_.collapse(drawn.h), theirs_.collapse(theirs));
    if (drawn.kind == OperationKind::flip) return expect_same(drawn.kind, mine_.flip(drawn.h), theirs_.flip(theirs));
    using TheirSpokes = typename VertexSplit<ForeignHalfedge>::Spokes;
    const auto& [left, right, spokes] = drawn.where;
    one_sided_ += spokes == VertexSplit<Halfedge>::Spokes::both ? 0 : 1;
    const VertexSplit<ForeignHalfedge> where{there(left), there(right), static_cast<TheirSpokes>(spokes)};
    const auto mine = mine_.split(drawn.where);
    const auto yours = theirs_.split(where);
    const Vertex made = mesh_.to(mine.halfedge);
    if (made >= name_.size()) name_.resize(made + 1);
    name_[made] = foreign_.to(yours.halfedge);
    expect_same(drawn.kind, mine, yours);
  }
  template <class Mine, class Yours>
  void expect_same(OperationKind kind, const Mine& mine, const Yours& yours) {
    ++done_[kind];
    ASSERT_EQ(foreign_.from(yours.halfedge), name_[mesh_.from(mine.halfedge)]);
    ASSERT_EQ(foreign_.to(yours.halfedge), name_[mesh_.to(mine.halfedge)]);
    EXPECT_EQ(mine.valence, yours.valence);
    if (!exact_) return;
    EXPECT_EQ(mine.strips, yours.strips);
    EXPECT_EQ(mine.isolated, yours.isolated);
  }

  template <class AnyMesh>
  static void expect_counted(const Keeper<AnyMesh>& keeper) {
    const ColoringReport report = check_coloring(keeper.mesh());
    ASSERT_TRUE(report.valid);
    ASSERT_EQ(keeper.strips(), report.strips);
    ASSERT_EQ(keeper.isolated(), report.isolated);
    ASSERT_EQ(keeper.swaps(), count_swaps(keeper.mesh()));
  }
  void compare() {
    expect_counted(mine_);
    expect_counted(theirs_);
    std::size_t triangles = 0;
    foreign_.for_each_triangle([&](ForeignHalfedge) { ++triangles; });
    ASSERT_EQ(triangles, mesh_.triangle_count());
    for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
      if (!mesh_.alive(t)) continue;
      const ForeignHalfedge first = there(StripMesh::halfedge(t, 0));
      ASSERT_TRUE(foreign_.exists(first));
      ForeignHalfedge h = first;
      for (unsigned s = 0; s < 3; ++s) {
        ASSERT_EQ(foreign_.from(h), name_[mesh_.from(StripMesh::halfedge(t, s))]);
        if (exact_) {
          ASSERT_EQ(foreign_.strips().solid(h), mesh_.solid(StripMesh::halfedge(t, s)));
        }
        h = foreign_.strips().next(h);
      }
      ASSERT_EQ(h, first);
    }
    compare_buffers();
  }

  void update_buffer() {
    buffer_.update(watched_, watched_.changed());
    watched_.changed().clear();
  }
  /// In their vertices.
  void compare_buffers() {
    update_buffer();
    const auto& strips = foreign_.strips();
    std::vector<DrawnTriangle> expected = sample::triangles_of(mesh_);
    for (DrawnTriangle& corners : expected)
      for (std::uint32_t& v : corners) v = foreign_.number(name_[v]);
    expected = sample::sorted(std::move(expected));
    const auto drawn = [](std::span<const std::uint32_t> indices) { return triangles_of_strips(indices); };
    ASSERT_EQ(triangles_of(strips), expected);
    ASSERT_EQ(drawn(strip_indices(strips)), expected);
    ASSERT_EQ(drawn(strip_indices(strips, extract_strips(strips))), expected);
    ASSERT_TRUE(check_buffer(StripBuffer(strips), strips).right());
    ASSERT_EQ(drawn(buffer_.indices()), expected);
  }

  StripMesh mesh_;
  Foreign& foreign_;
  Watched<std::remove_reference_t<decltype(std::declval<Foreign&>().strips())>> watched_;
  Keeper<StripMesh> mine_;
  Keeper<decltype(watched_)> theirs_;
  StripBuffer buffer_;
  bool exact_;
  std::mt19937 random_;
  std::vector<typename Foreign::Vertex> name_;
  std::map<OperationKind, int> done_;
  int one_sided_ = 0;
};

/// `point(v)` places a vertex, `vertex(v)` names it.
template <class Mesh, class Point, class Name>
Mesh copy_of(const StripMesh& from, Point&& point, Name&& vertex) {
  Mesh mesh;
  for (Vertex v = 0; v < from.vertex_bound(); ++v) mesh.add_vertex(point(v));
  for (Triangle t = 0; t < from.triangle_bound(); ++t) {
    const auto [a, b, c] = from.corners(t);
    mesh.add_face(vertex(a), vertex(b), vertex(c));
  }
  return mesh;
}

/// If the mesh and the StripMesh have the same sides, their strips from scratch are equal. Otherwise both have about as
/// few.
template <class Foreign>
void stripify_both(StripMesh mesh) {
  for (const Cost& cost : {Cost::strips(), Cost::indices()})
    for (const Effort effort : {Effort::fast, Effort::full}) {
      Foreign foreign(mesh);
      const std::size_t strips = stripify(foreign.strips(), effort, cost);
      ASSERT_TRUE(check_coloring(foreign.strips()).valid);
      ASSERT_EQ(strips, count_strips(foreign.strips()));
      StripMesh mine = mesh;
      const auto indices = [](const auto& of) { return static_cast<double>(strip_indices(of).size()); };
      stripify(mine, effort, cost);
      EXPECT_LE(indices(foreign.strips()), 1.1 * indices(mine));
    }
}

/// How many operations each walk does: 2,000, or what RESTRIP_LOCKSTEP says.
inline int lockstep_operations() {
  const char* said = std::getenv("RESTRIP_LOCKSTEP");
  return said ? std::atoi(said) : 2000;
}

/// Under every policy and either cost.
template <class Foreign>
void walk_in_lockstep(const StripMesh& start, bool boundary, unsigned seed) {
  for (const Cost& cost : {Cost::strips(), Cost::indices()})
    for (const PolicyRow& row : policies) {
      Foreign foreign(start);
      Lockstep<Foreign> both(start, foreign, row.policy, cost, seed);
      both.run(lockstep_operations());
      if (boundary) {
        EXPECT_GT(both.one_sided(), 5);
      }
      if (testing::Test::HasFailure()) FAIL() << row.name << ", restart " << cost.restart;
    }
  stripify_both<Foreign>(start);
}

/// The adapter does what test_adapter asks of it.
template <class Foreign>
void expect_contract_kept() {
  for (const StripMesh& from : {sample::torus(7, 6), sample::rectangle(6, 5)}) {
    Foreign foreign(from);
    auto& strips = foreign.strips();
    Watched watched(strips);
    std::uint32_t first = 0;
    while (!strips.has_triangle(first)) ++first;
    const AdapterReport report = test_adapter(watched, strips.halfedge(first), &watched.changed());
    EXPECT_TRUE(report.kept()) << describe(report.broken) << " (" << report.during << ")";
    EXPECT_GT(report.splits, 100U);
    EXPECT_GT(report.collapses, 100U);
    EXPECT_GT(report.flips, 50U);
  }
}

}  // namespace restrip
