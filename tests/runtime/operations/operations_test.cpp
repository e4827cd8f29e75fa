// Splits and collapses of any valence report exactly what they change. Fans that do not fit into words are compared
// with a second search for the best recolouring. Checked operations do all or nothing. Random operations on the free
// functions are in live_random_test.cpp.
#include "restrip/operations/operations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "naive_patch.hpp"
#include "outside_frontier.hpp"
#include "random_operations.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;

TEST(Operations, AnyValence) {
  for (const Vertex k : {9U, 40U, 61U, 62U, 63U, 64U, 65U, 130U, 1000U}) {
    SCOPED_TRACE(k);
    StripMesh mesh = sample::double_cone(k);
    // Give the fan some strips first, by operations of the rules themselves.
    for (unsigned round = 0; round < 3; ++round) {
      const std::vector<Halfedge> spokes = sample::spokes_around(mesh, 0);
      const Where where{spokes[1], spokes[1 + spokes.size() / (2 + round)], Where::Spokes::both};
      ASSERT_EQ(check_split(mesh, where), Refusal::granted);
      Census reported = census_of(mesh);
      const auto up = split(mesh, where);
      EXPECT_EQ(up.valence, spokes.size());
      ASSERT_EQ(census_of(mesh), reported += up);
      const auto down = collapse(mesh, up.halfedge);
      ASSERT_EQ(fault_of(mesh), "");
      EXPECT_EQ(down.valence, spokes.size());
      ASSERT_EQ(census_of(mesh), reported += down);
    }
  }
}

// Rule::valid promises that a patch with colours that no strips have becomes dashed, its ports left as they are. Here
// patches get a triangle of three solid edges or a solid cycle, and nothing but the patch is solid.
TEST(Operations, InvalidColorsBecomeDashedAtAnyValence) {
  for (const Vertex k : {5U, 12U, 40U, 61U, 62U, 100U, 1000U}) {
    for (const bool closed : {true, false}) {
      for (const bool cycle : {true, false}) {
        if (cycle && !closed) continue;  // an open fan has none
        for (const bool collapses : {true, false}) {
          SCOPED_TRACE(testing::Message() << k << (closed ? " closed" : " open") << (cycle ? " cycle" : " degree")
                                          << (collapses ? " collapse" : " split"));
          StripMesh mesh = closed ? sample::double_cone(k) : sample::open_double_cone(k);
          std::vector<Halfedge> spokes = sample::spokes_around(mesh, 0);
          const Where where{spokes[k / 2], spokes[1]};
          Halfedge chord{};
          if (collapses) {
            chord = split(mesh, where).halfedge;
            mesh.clear_colors();
            // One end of the new mesh edge is inside.
            spokes = sample::spokes_around(mesh, mesh.leaves_boundary(chord) ? mesh.to(chord) : mesh.from(chord));
          }
          if (cycle) {
            for (const Halfedge h : spokes) mesh.set_solid(h, true);
          } else {
            // A triangle of the fan, not one of the two that come and go, with a neighbour on every side.
            const auto in_patch = [&](Triangle t) {
              const auto c = mesh.corners(t);
              const auto has = [&](Vertex v) { return std::find(c.begin(), c.end(), v) != c.end(); };
              return collapses ? has(mesh.from(chord)) != has(mesh.to(chord)) : has(0);
            };
            const auto inside = [&](Triangle t) {
              return !StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, 0))) &&
                     !StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, 1))) &&
                     !StripMesh::on_boundary(mesh.opposite(StripMesh::halfedge(t, 2)));
            };
            Triangle t = 0;
            while (!in_patch(t) || !inside(t)) ASSERT_LT(++t, mesh.triangle_bound());
            for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(t, side), true);
          }
          ASSERT_FALSE(check_coloring(mesh).valid);
          const auto isolated = [&mesh] {
            int n = 0;
            for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
              n += mesh.alive(t) && mesh.solid_degree(t) == 0 ? 1 : 0;
            return n;
          };
          const int isolated_before = isolated();
          const std::size_t ports = cycle ? 0 : 1;
          const std::size_t solid = cycle ? spokes.size() : 3;
          const auto done = collapses ? collapse(mesh, chord) : split(mesh, where);
          const ColoringReport after = check_coloring(mesh);
          EXPECT_TRUE(after.valid);
          EXPECT_EQ(after.strips, after.triangles - ports);
          EXPECT_EQ(done.strips, (collapses ? -2 : 2) + static_cast<int>(solid - ports));
          EXPECT_EQ(done.isolated, isolated() - isolated_before);
          EXPECT_EQ(done.valence, k);
        }
      }
    }
  }
}

/// The triangles around some vertices, which edges between them are inner, and where the strips go that leave them.
class PatchInMesh {
 public:
  PatchInMesh(const StripMesh& mesh, std::set<Vertex> centers) : mesh_(&mesh), centers_(std::move(centers)) {
    for (const Vertex v : centers_)
      for (const Halfedge h : sample::spokes_around(mesh, v))
        if (!StripMesh::on_boundary(h) && node_.emplace(StripMesh::triangle(h), 0).second)
          triangles_.push_back(StripMesh::triangle(h));
    for (std::size_t n = 0; n < triangles_.size(); ++n) node_[triangles_[n]] = static_cast<int>(n);
  }

  /// In the mesh as it is: the frontier's value of the patch's colours.
  long value() const {
    long result = 0;
    for (const Triangle t : triangles_) {
      result -= mesh_->solid_degree(t) == 0 ? 1 : 0;
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (is_inner(h) && h.id < there.id && mesh_->solid(h)) result += 1'000'000;
      });
    }
    return result;
  }

  /// Pairs of ports, by their halfedges outside, that solid edges join inside.
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs() const {
    naive::UnionFind inside(triangles_.size());
    std::vector<std::pair<std::uint32_t, std::size_t>> ports;
    for (const Triangle t : triangles_)
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (!mesh_->solid(h)) return;
        const auto at = static_cast<std::size_t>(node_.at(t));
        if (is_inner(h))
          inside.unite(at, static_cast<std::size_t>(node_.at(StripMesh::triangle(there))));
        else
          ports.emplace_back(there.id, at);
      });
    std::set<std::pair<std::uint32_t, std::uint32_t>> result;
    for (const auto& [one, at] : ports)
      for (const auto& [other, there] : ports)
        if (one != other && inside.find(at) == inside.find(there)) result.emplace(one, other);
    return result;
  }

  /// The best value in every world that allows these pairs inside.
  long best_anywhere(const std::set<std::pair<std::uint32_t, std::uint32_t>>& before) const {
    naive::OutsideFrontier graph = inner_graph();
    std::vector<std::uint32_t> names;
    for (const Triangle t : triangles_)
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (is_inner(h) || !mesh_->solid(h)) return;
        graph.add_hidden(node_.at(t), static_cast<int>(names.size()));
        names.push_back(there.id);
      });
    return graph.best([&](int one, int other) {
      return before.count({names[static_cast<std::size_t>(one)], names[static_cast<std::size_t>(other)]}) != 0;
    });
  }

 private:
  template <class Visit>
  void for_each_side(Triangle t, const Visit& visit) const {
    for (unsigned side = 0; side < 3; ++side) {
      const auto h = StripMesh::halfedge(t, side);
      if (const auto there = mesh_->opposite(h); !StripMesh::on_boundary(there)) visit(h, there);
    }
  }
  bool is_inner(Halfedge h) const { return centers_.count(mesh_->from(h)) + centers_.count(mesh_->to(h)) > 0; }
  naive::OutsideFrontier inner_graph() const {
    naive::OutsideFrontier graph(static_cast<int>(triangles_.size()));
    for (const Triangle t : triangles_)
      for_each_side(t, [&](Halfedge h, Halfedge there) {
        if (is_inner(h) && h.id < there.id) graph.add_edge(node_.at(t), node_.at(StripMesh::triangle(there)));
      });
    return graph;
  }

  const StripMesh* mesh_;
  std::set<Vertex> centers_;
  std::vector<Triangle> triangles_;
  std::map<Triangle, int> node_;
};

// A count finds the reported change, and no colouring of the patch is better that joins what was joined.
void expect_best(const StripMesh& before, const std::set<Vertex>& centers, const StripMesh& after,
                 const std::set<Vertex>& around, const Rewrite& done) {
  Census expected = census_of(before);
  EXPECT_EQ(census_of(after), expected += done);
  const PatchInMesh patch(after, around);
  EXPECT_EQ(patch.value(), patch.best_anywhere(PatchInMesh(before, centers).pairs()));
}

TEST(Operations, LargeFansGetTheBestColors) {
  std::mt19937 random(14);
  std::size_t splits = 0;
  for (int n = 0; n < 60; ++n) {
    const Vertex k = n % 2 == 0 ? 63 + static_cast<Vertex>(random() % 8) : 126 + static_cast<Vertex>(random() % 8);
    const bool closed = n % 3 == 0;
    SCOPED_TRACE(testing::Message() << "number " << n << (closed ? " closed " : " open ") << k);
    StripMesh mesh = closed ? sample::double_cone(k) : sample::open_double_cone(k);
    sample::color_at_random(mesh, static_cast<double>(1 + random() % 8) / 8, random);
    const std::vector<Halfedge> spokes = sample::spokes_around(mesh, 0);
    const std::size_t left = random() % spokes.size();
    const std::size_t right = (left + 1 + random() % (spokes.size() - 1)) % spokes.size();
    Where where{spokes[left], spokes[right]};
    if (n % 3 == 1) where.spokes = n % 2 == 0 ? Where::Spokes::left_only : Where::Spokes::right_only;
    if (check_split(mesh, where) != Refusal::granted) continue;
    const StripMesh fan = mesh;
    const auto up = split(mesh, where);
    const std::set<Vertex> ends{mesh.from(up.halfedge), mesh.to(up.halfedge)};
    expect_best(fan, {0}, mesh, ends, up);
    if (HasFailure()) return;
    ++splits;

    sample::color_at_random(mesh, static_cast<double>(1 + random() % 8) / 8, random);
    const StripMesh divided = mesh;
    const auto down = collapse(mesh, up.halfedge);
    expect_best(divided, ends, mesh, {mesh.from(down.halfedge)}, down);
    if (HasFailure()) return;
  }
  EXPECT_GT(splits, 50U);
}

TEST(Operations, GoingDownAndUpGivesTheSameHandles) {
  StripMesh mesh = sample::sphere(3);
  const auto corners = [&] {  // by handle
    std::vector<sample::Corners> all;
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) all.push_back(sample::sorted({mesh.corners(t)}).front());
    return all;
  };
  // A split and its collapse leave the triangles as they were; so does the other order, after a first round has set the
  // handles.
  const std::vector<Halfedge> spokes = sample::spokes_around(mesh, 5);
  const auto first = split(mesh, Where{spokes[0], spokes[2], Where::Spokes::both});
  const auto up = corners();
  const Vertex v_s = mesh.from(first.halfedge);
  const Vertex v_l = mesh.to(StripMesh::next(first.halfedge));
  const Vertex v_r = mesh.to(StripMesh::next(mesh.opposite(first.halfedge)));
  collapse(mesh, first.halfedge);
  split(mesh, Where{mesh.spoke(v_s, v_l), mesh.spoke(v_s, v_r), Where::Spokes::both});
  EXPECT_EQ(corners(), up);
}

TEST(Checked, OperationsDoAllOrNothing) {
  StripMesh mesh = sample::rectangle(4, 4);
  Keeper keeper(mesh, Policy::local, Cost::strips());
  const std::vector<sample::Corners> before = sample::triangles_of(mesh);
  const Halfedge edge = mesh.spoke(0);
  EXPECT_EQ(checked_flip(mesh, edge).refusal, Refusal::boundary_edge);
  EXPECT_EQ(checked_flip(keeper, edge).refusal, Refusal::boundary_edge);
  EXPECT_EQ(checked_collapse(mesh, {}).refusal, Refusal::no_such_edge);
  EXPECT_EQ(checked_collapse(keeper, {}).refusal, Refusal::no_such_edge);
  const Halfedge inside = mesh.spoke(6);
  EXPECT_EQ(checked_split(mesh, {inside, inside}).refusal, Refusal::same_spoke);
  EXPECT_EQ(checked_split(mesh, {inside, turn_ccw(mesh, inside)}, 3).refusal, Refusal::vertex_in_use);
  EXPECT_EQ(checked_split(keeper, {inside, turn_ccw(mesh, inside)}, 3).refusal, Refusal::vertex_in_use);
  // Up to this name all vertices would be allocated.
  EXPECT_EQ(checked_split(mesh, {inside, turn_ccw(mesh, inside)}, none - 1).refusal, Refusal::vertex_too_far);
  const auto furthest = static_cast<Vertex>(mesh.vertex_bound() + StripMesh::max_vertex_gap + mesh.triangle_bound());
  EXPECT_EQ(check_split(mesh, {inside, turn_ccw(mesh, inside)}, furthest + 1), Refusal::vertex_too_far);
  EXPECT_EQ(check_split(mesh, {inside, turn_ccw(mesh, inside)}, furthest), Refusal::granted);
  const auto alone = [](Vertex v) { return std::vector<sample::Corners>{{30, 31, v}}; };
  EXPECT_EQ(check_replace(mesh, {}, alone(furthest + 1)), Refusal::vertex_too_far);
  EXPECT_EQ(check_replace(mesh, {}, alone(furthest)), Refusal::granted);
  EXPECT_EQ(sample::triangles_of(mesh), before);
  const Checked up = checked_split(keeper, {inside, turn_ccw(mesh, inside)}, 30);
  ASSERT_TRUE(up);
  EXPECT_EQ(mesh.to(up.rewrite.halfedge), 30U);
  EXPECT_TRUE(checked_collapse(keeper, up.rewrite.halfedge));
  EXPECT_EQ(sample::triangles_of(mesh), before);
}

}  // namespace
}  // namespace restrip
