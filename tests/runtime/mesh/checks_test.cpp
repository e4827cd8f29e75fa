// check_split, check_collapse and check_flip refuse an operation if and only if it is bad.
//
// triangle_list.hpp decides what is bad: it does the operation on the list of vertex triples and examines the outcome:
// every vertex that was one fan still is, nothing vanished, the topology is the same. All operations are tried, on
// every edge, between every two spokes and under every vertex name, on every list of few triangles over four and five
// vertices, on random lists (mostly not manifolds), and on meshes with and without boundary before and after random
// operations. Granted operations are done, and the mesh must equal the list that the other side made.
#include "restrip/mesh/checks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "random_operations.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;

// All halfedges of the mesh, boundary ones included.
std::vector<Halfedge> halfedges_of(const StripMesh& mesh) {
  std::vector<Halfedge> all;
  for (const Halfedge h : sample::sides_of(mesh)) {
    all.push_back(h);
    if (StripMesh::on_boundary(mesh.opposite(h))) all.push_back(mesh.opposite(h));
  }
  return all;
}

std::string text(const bare::List& list) {
  std::string all;
  for (const bare::Corners& c : list)
    all += " " + std::to_string(c[0]) + "," + std::to_string(c[1]) + "," + std::to_string(c[2]);
  return all;
}

// Compares one operation: the check and the outcome.
class Comparison {
 public:
  std::size_t granted = 0;
  std::size_t refused = 0;
  std::array<std::size_t, 16> reasons{};

  void all_operations(const StripMesh& mesh) {
    all_collapses(mesh);
    for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
      ASSERT_EQ(mesh.non_manifold(v), shape_.non_manifold.contains(v)) << "vertex " << v << " of" << text(list_);
    const std::vector<Halfedge> all = halfedges_of(mesh);
    for (const Halfedge h : all) {
      ASSERT_TRUE(mesh.alive(h));
      const Vertex b = mesh.to(h);
      compare("flip", h, h, check_flip(mesh, h), bare::flip(list_, shape_, mesh.from(h), b),
              [h](StripMesh& copy) { flip(copy, h); });
      one_split({h, {}, Where::Spokes::left_only}, b, {}, fresh());
      one_split({{}, h, Where::Spokes::right_only}, {}, b, fresh());
      for (const Halfedge g : all) one_split({h, g, Where::Spokes::both}, b, mesh.to(g), fresh());
    }
  }

  void all_collapses(const StripMesh& mesh) {
    look_at(mesh);
    for (const Halfedge h : halfedges_of(mesh))
      compare("collapse", h, h, check_collapse(mesh, h), bare::collapse(list_, shape_, mesh.from(h), mesh.to(h)),
              [h](StripMesh& copy) { collapse(copy, h); });
  }

  // Every split of the vertex of h that is not one-sided, under every name that is in use and some that are free.
  void all_names(const StripMesh& mesh) {
    look_at(mesh);
    const std::vector<Halfedge> all = halfedges_of(mesh);
    for (const Halfedge h : all)
      for (const Halfedge g : all)
        for (Vertex v = 0; mesh.from(h) == mesh.from(g) && v < mesh.vertex_bound() + 3; ++v)
          one_split({h, g, Where::Spokes::both}, mesh.to(h), mesh.to(g), v);
  }

 private:
  void look_at(const StripMesh& mesh) {
    mesh_ = &mesh;
    list_ = sample::triangles_of(mesh);
    shape_ = bare::shape_of(list_);
  }
  [[nodiscard]] Vertex fresh() const { return static_cast<Vertex>(mesh_->vertex_bound()); }

  void one_split(const Where& where, std::optional<Vertex> v_l, std::optional<Vertex> v_r, Vertex v_t) {
    const Halfedge first = v_l ? where.left : where.right;
    const Vertex v_h = mesh_->from(first);
    const bool one_vertex = !v_l || !v_r || v_h == mesh_->from(where.right);
    const auto expected = one_vertex ? bare::split(list_, shape_, v_h, v_l, v_r, v_t) : std::nullopt;
    compare("split", where.left, where.right, check_split(*mesh_, where, v_t), expected,
            [&](StripMesh& copy) { split(copy, where, v_t); });
    if (v_t == fresh()) {
      ASSERT_EQ(check_split(*mesh_, where), check_split(*mesh_, where, v_t));
    }
  }

  template <class Operation>
  void compare(const char* name, Halfedge g, Halfedge h, Refusal refusal, const std::optional<bare::List>& expected,
               const Operation& operation) {
    ++reasons.at(static_cast<std::size_t>(refusal));
    ++(expected ? granted : refused);
    if ((refusal == Refusal::granted) != expected.has_value()) {
      ADD_FAILURE() << name << " at " << g.id << ", " << h.id << " of" << text(list_) << ": the check says \""
                    << describe(refusal) << "\", the list " << (expected ? "good" : "bad");
      return;
    }
    if (!expected) return;
    StripMesh copy = *mesh_;
    operation(copy);
    if (sample::triangles_of(copy) != bare::sorted(*expected))
      ADD_FAILURE() << name << " at " << g.id << ", " << h.id << " of" << text(list_) << " makes"
                    << text(sample::triangles_of(copy));
  }

  const StripMesh* mesh_ = nullptr;
  bare::List list_;
  bare::Shape shape_;
};

// The triangles over n vertices, each turned both ways.
std::vector<bare::Corners> triangles_over(Vertex n) {
  std::vector<bare::Corners> all;
  for (Vertex a = 0; a < n; ++a)
    for (Vertex b = a + 1; b < n; ++b)
      for (Vertex c = b + 1; c < n; ++c) {
        all.push_back({a, b, c});
        all.push_back({a, c, b});
      }
  return all;
}

TEST(Checks, AgreeOnEveryListOverFourVertices) {
  Comparison comparison;
  const std::vector<bare::Corners> all = triangles_over(4);
  ASSERT_EQ(all.size(), 8U);
  for (unsigned chosen = 0; chosen < 256; ++chosen) {
    std::vector<bare::Corners> triangles;
    for (unsigned i = 0; i < 8; ++i)
      if ((chosen >> i & 1U) != 0) triangles.push_back(all[i]);
    const StripMesh mesh = StripMesh::build(triangles, 4);
    comparison.all_operations(mesh);
    comparison.all_names(mesh);
    if (HasFailure()) return;
  }
  EXPECT_GT(comparison.granted, 500U);
  EXPECT_GT(comparison.refused, 5000U);
}

TEST(Checks, AgreeOnEveryListOfFourTrianglesOverFiveVertices) {
  Comparison comparison;
  const std::vector<bare::Corners> all = triangles_over(5);
  ASSERT_EQ(all.size(), 20U);
  std::size_t meshes = 0;
  for (std::size_t a = 0; a < 20; ++a)
    for (std::size_t b = a + 1; b < 20; ++b)
      for (std::size_t c = b + 1; c < 20; ++c)
        for (std::size_t d = c + 1; d < 20; ++d) {
          const std::array<bare::Corners, 4> triangles{all[a], all[b], all[c], all[d]};
          comparison.all_operations(StripMesh::build(triangles, 5));
          ++meshes;
          if (HasFailure()) return;
        }
  EXPECT_EQ(meshes, 4845U);  // 20 over 4
  EXPECT_GT(comparison.granted, 10000U);
}

// Meshes of a few triangles: closed, open, in several components, with handles, with holes, and not manifold.
std::vector<StripMesh> small_meshes() {
  std::vector<StripMesh> all;
  const auto add = [&](const std::vector<bare::Corners>& list, std::size_t vertices) {
    all.push_back(StripMesh::build(list, vertices));
  };
  all.push_back(sample::tetrahedron());
  add({{0, 1, 2}}, 3);
  all.push_back(sample::octahedron());
  for (Vertex k = 3; k < 8; ++k) all.push_back(sample::double_cone(k));
  all.push_back(sample::rectangle(1, 1));
  all.push_back(sample::rectangle(3, 2));
  all.push_back(sample::rectangle(5, 1, 3));
  all.push_back(sample::tube(3, 1));
  all.push_back(sample::tube(3, 2));
  all.push_back(sample::tube(4, 2));
  all.push_back(sample::torus(3, 3));
  // The torus of seven vertices: every two are neighbours.
  std::vector<bare::Corners> csaszar;
  for (Vertex v = 0; v < 7; ++v) {
    csaszar.push_back({v, (v + 1) % 7, (v + 3) % 7});
    csaszar.push_back({v, (v + 3) % 7, (v + 2) % 7});
  }
  add(csaszar, 7);
  // A square with a square hole; two components that share no names with others; two tetrahedra with a vertex, an edge
  // in common; three triangles on an edge; a Möbius strip.
  add({{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}}, 8);
  add({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {4, 5, 6}, {4, 6, 7}, {4, 7, 8}}, 9);
  add({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}}, 7);
  add({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 1, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 4}}, 6);
  add({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 1, 5}, {2, 5, 6}, {3, 0, 7}}, 8);
  add({{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}}, 5);
  for (StripMesh& mesh : sample::meshes())
    if (mesh.triangle_count() < 30) all.push_back(std::move(mesh));
  return all;
}

TEST(Checks, AgreeOnSmallMeshesAndWhatOperationsMakeOfThem) {
  Comparison comparison;
  std::mt19937 random(21);
  for (const StripMesh& start : small_meshes()) {
    comparison.all_operations(start);
    comparison.all_names(start);
    StripMesh mesh = start;
    for (int n = 0; n < 3; ++n) {
      for (int tries = 0; tries < 12; ++tries) {
        const Trend trend = trend_between(0, 14, mesh.triangle_count());
        perform(mesh, draw_at(mesh, random_side(mesh, random), random, splits_collapses_flips, trend));
      }
      comparison.all_operations(mesh);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(comparison.granted, 10000U);
  // Each reason except for invalid handles, which have their own test.
  for (const Refusal reason :
       {Refusal::granted, Refusal::different_vertices, Refusal::same_spoke, Refusal::non_manifold_vertex,
        Refusal::boundary_edge, Refusal::spoke_on_boundary, Refusal::joins_boundaries, Refusal::link_condition,
        Refusal::too_few_triangles, Refusal::dangling_edge, Refusal::edge_exists, Refusal::vertex_in_use})
    EXPECT_GT(comparison.reasons.at(static_cast<std::size_t>(reason)), 0U) << describe(reason);
}

// Three vertices of more than 32 triangles, every two of them neighbours in the end: a cone whose apex is split,
// and an edge of the rim turned on either side, so that both halves reach the other apex.
TEST(Checks, AgreeBetweenVerticesOfHighValence) {
  constexpr Vertex k = 72;
  StripMesh mesh = sample::double_cone(k);
  Comparison comparison;
  const Checked up = checked_split(mesh, {mesh.spoke(0, 2), mesh.spoke(0, 2 + k / 2)});
  ASSERT_TRUE(up);
  const Vertex v_s = mesh.from(up.rewrite.halfedge);
  const Vertex v_t = mesh.to(up.rewrite.halfedge);
  EXPECT_EQ(check_collapse(mesh, mesh.spoke(v_s, v_t)), Refusal::granted);
  ASSERT_TRUE(checked_flip(mesh, mesh.spoke(2 + k / 4, 3 + k / 4)));
  EXPECT_EQ(check_collapse(mesh, mesh.spoke(v_s, v_t)), Refusal::granted);
  ASSERT_TRUE(checked_flip(mesh, mesh.spoke(2 + 3 * k / 4, 3 + 3 * k / 4)));
  comparison.all_collapses(mesh);
  for (const Vertex v : {v_s, v_t, Vertex{1}})
    ASSERT_GT(bare::link_of(sample::triangles_of(mesh), v)->triangles(), 32U);
  EXPECT_EQ(check_collapse(mesh, mesh.spoke(v_s, v_t)), Refusal::link_condition);
  EXPECT_EQ(check_collapse(mesh, mesh.spoke(v_t, v_s)), Refusal::link_condition);
}

TEST(Checks, HandlesThatAreNoneAreRefused) {
  StripMesh mesh = sample::rectangle(2, 2);
  ASSERT_TRUE(checked_collapse(mesh, mesh.spoke(0)));  // leaves a handle free
  std::vector<bool> real;
  std::size_t alive = 0;
  const std::vector<Halfedge> all = halfedges_of(mesh);
  for (const std::uint32_t above : {0U, 1U << 31, 1U << 30})
    for (std::uint32_t id = 0; id < 4 * (mesh.triangle_bound() + 2); ++id) {
      const Halfedge h{id | above};
      const bool is_one = std::find(all.begin(), all.end(), h) != all.end();
      ASSERT_EQ(mesh.alive(h), is_one) << h.id;
      alive += is_one ? 1U : 0U;
      if (is_one) continue;
      EXPECT_EQ(check_collapse(mesh, h), Refusal::no_such_edge);
      EXPECT_EQ(check_flip(mesh, h), Refusal::no_such_edge);
      for (const Where& where : {Where{h, all[0]}, Where{all[0], h}, Where{h, {}, Where::Spokes::left_only},
                                 Where{{}, h, Where::Spokes::right_only}})
        EXPECT_EQ(check_split(mesh, where), Refusal::no_such_edge);
    }
  EXPECT_EQ(alive, all.size());
  EXPECT_EQ(check_collapse(mesh, {}), Refusal::no_such_edge);
}

TEST(Refusals, EachHasItsOwnSentence) {
  static_assert(static_cast<int>(Refusal::granted) == 0, "a refusal that is not zero is one");
  std::set<std::string> sentences;
  const int last = static_cast<int>(Refusal::colors_not_valid);
  for (int n = 0; n <= last; ++n) {
    const std::string sentence = describe(static_cast<Refusal>(n));
    EXPECT_GT(sentence.size(), 15U);
    EXPECT_TRUE(sentences.insert(sentence).second) << sentence;
  }
  EXPECT_STREQ(describe(static_cast<Refusal>(last + 1)), "unknown");
}

#ifdef NDEBUG
// A condition that does not hold costs nothing in release builds, because it is not evaluated.
TEST(Preconditions, AreNotEvaluatedWithNdebug) {
  int evaluated = 0;
  RESTRIP_ASSERT(++evaluated == 0, "unasked", "never");
  EXPECT_EQ(evaluated, 0);
}
#endif

}  // namespace
}  // namespace restrip
