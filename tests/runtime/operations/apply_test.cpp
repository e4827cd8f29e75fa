// apply() does what an operation file says: on a StripMesh the triangles are those that are worked out on a bare list;
// its check grants just the operations that leave the mesh as good; strips and isolated triangles are as many as told,
// under every policy and either cost; where a shipped function does the same, mesh and colours are the same; and a mesh
// that is not ours comes out as a StripMesh does.
#include "restrip/operations/apply.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "../../support/sanitizers.hpp"
#include "coloring_cost.hpp"
#include "hand_made_mesh.hpp"
#include "locator_agrees.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"
#include "restrip/tables/operations/bisect.hpp"
#include "restrip/tables/operations/bisect_boundary.hpp"
#include "restrip/tables/operations/bisect_matching.hpp"
#include "restrip/tables/operations/flip_matching.hpp"
#include "restrip/tables/operations/join_faces.hpp"
#include "restrip/tables/operations/merge.hpp"
#include "restrip/tables/operations/merge_boundary.hpp"
#include "restrip/tables/operations/merge_matching.hpp"
#include "restrip/tables/operations/refine_face.hpp"
#include "restrip/tables/operations/split_face.hpp"
#include "sample_meshes.hpp"
#include "triangle_list.hpp"

namespace restrip {
namespace {

using Halfedge = StripMesh::Halfedge;

static_assert(SurfaceTable<std::remove_const_t<decltype(tables::refine_face)>>);
static_assert(!SurfaceTable<tables::OperationTable<std::uint8_t, 8>>, "a graph has no triangles");

/// Calls visit(table) for every shipped operation whose edges are those of strips, and then for those of pairs.
template <class Visit>
void for_each_operation_of_strips(Visit&& visit) {
  visit(tables::split_face);
  visit(tables::join_faces);
  visit(tables::bisect);
  visit(tables::merge);
  visit(tables::bisect_boundary);
  visit(tables::merge_boundary);
  visit(tables::refine_face);
}
template <class Visit>
void for_each_operation_of_pairs(Visit&& visit) {
  visit(tables::flip_matching);
  visit(tables::bisect_matching);
  visit(tables::merge_matching);
}

/// The list after an operation at the directed edge from -> to; nothing when the patch is not there, has a vertex twice
/// or leaves a worse mesh. `added`: the names of new vertices, as they are met in the file.
template <class Table>
std::optional<bare::List> applied(const bare::List& list, const bare::Shape& shape, const Table& table, Vertex from,
                                  Vertex to, const std::vector<Vertex>& added) {
  std::map<unsigned, Vertex> names;
  std::vector<bare::Corners> out;
  for (const tables::PatchTriangle& t : table.triangles_before) {
    const bool first = out.empty();
    const Vertex a = first ? from : out[t.from][(t.from_side + 1U) % 3];
    const Vertex b = first ? to : out[t.from][t.from_side];
    const auto c = bare::apex(list, a, b);
    if (!c) return {};
    out.push_back({a, b, *c});
    for (std::size_t s = 0; s < 3; ++s)
      if (!names.emplace(t.vertex[s], out.back()[s]).second && names.at(t.vertex[s]) != out.back()[s]) return {};
  }
  for (std::size_t t = 0; t < out.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (table.triangles_before[t].side[s] == tables::PatchTriangle::boundary_side &&
          bare::apex(list, out[t][(s + 1) % 3], out[t][s]))
        return {};
  std::set<Vertex> gone;
  for (const auto& [place, name] : names)
    if (!gone.insert(name).second) return {};
  std::vector<Vertex> made;
  std::vector<Vertex> named;
  bare::List after;
  for (const bare::Corners& c : list)
    if (std::none_of(out.begin(), out.end(),
                     [&](const bare::Corners& o) { return bare::sorted({o}) == bare::sorted({c}); }))
      after.push_back(c);
  if (after.size() + out.size() != list.size()) return {};
  for (const tables::PatchTriangle& t : table.triangles_after) {
    bare::Corners corners{};
    for (std::size_t s = 0; s < 3; ++s) {
      if (!names.contains(t.vertex[s])) {
        made.push_back(added.at(made.size()));
        names[t.vertex[s]] = made.back();
      }
      corners[s] = names.at(t.vertex[s]);
      named.push_back(corners[s]);
    }
    after.push_back(corners);
  }
  for (const Vertex v : named) gone.erase(v);
  std::vector<Vertex> old(named);
  old.insert(old.end(), gone.begin(), gone.end());
  if (!bare::all_regular(shape, old)) return {};
  if (!bare::as_good(shape, after, named, {gone.begin(), gone.end()}, made)) return {};
  return bare::sorted(after);
}

/// The vertices of the triangles after an operation that were not there before, as they are met in the file.
template <class Mesh, class Table>
std::vector<Vertex> added_vertices(const Mesh& mesh, const Table& table, typename Mesh::Halfedge first) {
  std::set<unsigned> met;
  for (const tables::PatchTriangle& t : table.triangles_before) met.insert(t.vertex.begin(), t.vertex.end());
  std::vector<Vertex> added;
  const auto patch = detail::read_sides(mesh, table.triangles_after, first);
  for (std::size_t t = 0; t < patch.side.size(); ++t)
    for (std::size_t s = 0; s < 3; ++s)
      if (met.insert(table.triangles_after[t].vertex[s]).second) added.push_back(mesh.from(patch.side[t][s]));
  return added;
}

/// All of StripMesh that is not said by its triangles: links, first spokes.
void expect_sound(const StripMesh& mesh) {
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    for (unsigned s = 0; s < 3; ++s) {
      const Halfedge h = StripMesh::halfedge(t, s);
      const Halfedge g = mesh.opposite(h);
      ASSERT_EQ(mesh.opposite(g), h);
      ASSERT_EQ(mesh.from(g), mesh.to(h));
      ASSERT_EQ(mesh.to(g), mesh.from(h));
      if (mesh.non_manifold(mesh.from(h))) continue;
      bool met = false;
      for_each_spoke(mesh, mesh.from(h), [&](Halfedge spoke) { met = met || spoke == h; });
      ASSERT_TRUE(met);
    }
  }
}

template <class Table>
std::size_t try_everywhere(const StripMesh& start, const Table& table) {
  std::size_t granted = 0;
  const bare::List list = bare::sorted(sample::triangles_of(start));
  const bare::Shape shape = bare::shape_of(list);
  for (Triangle t = 0; t < start.triangle_bound(); ++t)
    for (unsigned s = 0; start.alive(t) && s < 3; ++s) {
      const Halfedge h = StripMesh::halfedge(t, s);
      const auto after = [&](const std::vector<Vertex>& added) {
        return applied(list, shape, table, start.from(h), start.to(h), added);
      };
      StripMesh mesh = start;
      std::vector<Triangle> changed;
      mesh.watch(&changed);
      const Checked done = checked_apply(mesh, table, h);
      EXPECT_EQ(done.granted(), after({1000, 1001, 1002}).has_value()) << describe(done.refusal);
      if (!done) {
        EXPECT_EQ(sample::triangles_of(mesh), list);
        continue;
      }
      ++granted;
      expect_sound(mesh);
      const auto wanted = after(added_vertices(mesh, table, done.rewrite.halfedge));
      EXPECT_TRUE(wanted && *wanted == sample::triangles_of(mesh));
      for (Triangle u = 0; u < std::max(start.triangle_bound(), mesh.triangle_bound()); ++u) {
        const bool same =
            u < start.triangle_bound() && u < mesh.triangle_bound() && start.corners(u) == mesh.corners(u);
        EXPECT_TRUE(same || std::count(changed.begin(), changed.end(), u) != 0);
      }
    }
  return granted;
}

// At every halfedge of small meshes, among them such with vertices of two and three triangles and non-manifold ones.
TEST(Apply, DoesWhatTheFileSaysWhereItMay) {
  std::vector<StripMesh> meshes{sample::octahedron(),       sample::rectangle(4, 3), sample::tube(4, 4),
                                sample::torus(4, 5),        sample::sphere(1),       sample::double_cone(3),
                                sample::open_double_cone(3)};
  meshes.push_back(StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, 4));
  meshes.push_back(StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}, 4));
  meshes.push_back(StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {2, 1, 3}, {4, 5, 0}, {0, 6, 4}}, 7));
  // Vertices of three triangles, and of two on the boundary.
  for (const auto& [mesh, t] : {std::pair{sample::torus(4, 5), 3U}, {sample::rectangle(4, 3), 2U}}) {
    meshes.push_back(mesh);
    apply(meshes.back(), tables::split_face, StripMesh::halfedge(t));
    apply(meshes.back(), tables::split_face, StripMesh::halfedge(t));
    for (Triangle u = 0; u < mesh.triangle_bound(); ++u)
      checked_apply(meshes.back(), tables::bisect_boundary, StripMesh::halfedge(u, 1));
    checked_apply(meshes.back(), tables::bisect, StripMesh::halfedge(0));
    meshes.back().clear_colors();  // pairs are wanted as well as strips
  }
  const auto look = [&](const auto& table) {
    std::size_t granted = 0;
    for (const StripMesh& mesh : meshes) granted += try_everywhere(mesh, table);
    EXPECT_GT(granted, 5U);
    for (const StripMesh& mesh : sample::meshes())
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
        StripMesh copy = mesh;
        if (checked_apply(copy, table, StripMesh::halfedge(t))) expect_sound(copy);
      }
  };
  for_each_operation_of_strips(look);
  for_each_operation_of_pairs(look);
}

struct Census {
  long strips = 0;
  long isolated = 0;
  friend bool operator==(const Census&, const Census&) = default;
};
Census census_of(const StripMesh& mesh) {
  const ColoringReport report = check_coloring(mesh);
  EXPECT_TRUE(report.valid);
  return {static_cast<long>(report.strips), static_cast<long>(report.isolated)};
}

Halfedge random_halfedge(const StripMesh& mesh, std::mt19937& random) {
  for (;;) {
    const auto h = StripMesh::halfedge(static_cast<Triangle>(random() % mesh.triangle_bound()),
                                       static_cast<unsigned>(random() % 3));
    if (mesh.alive(h)) return h;
  }
}

/// A place for the operation, if one is found soon.
template <class Table>
std::optional<Halfedge> random_place(const StripMesh& mesh, const Table& table, std::mt19937& random) {
  for (int tries = 0; tries < 60; ++tries)
    if (const Halfedge h = random_halfedge(mesh, random); check_apply(mesh, table, h) == Refusal::granted) return h;
  return {};
}

/// One of the operations at a random place: done(table, h), on a mesh that neither grows nor vanishes.
template <class Do>
bool random_application(const StripMesh& mesh, std::mt19937& random, std::size_t size, Do&& done) {
  std::size_t left = random() % 7;
  bool did = false;
  for_each_operation_of_strips([&](const auto& table) {
    if (left-- != 0) return;
    const bool grows = table.triangles_after.size() > table.triangles_before.size();
    if (grows ? mesh.triangle_count() > size : mesh.triangle_count() < size / 2) return;
    const auto h = random_place(mesh, table, random);
    if (h) done(table, *h);
    did = h.has_value();
  });
  return did;
}

/// A collapse while there are many triangles, else a flip, by a mesh or its keeper: they make vertices of all valences.
template <class Mesh>
Checked stir(Mesh& by, const StripMesh& mesh, std::mt19937& random, std::size_t size) {
  const Halfedge h = random_halfedge(mesh, random);
  return mesh.triangle_count() > size ? checked_collapse(by, h) : checked_flip(by, h);
}

TEST(Apply, TellsWhatItChanged) {
  std::mt19937 random(5);
  std::size_t done = 0;
  for (StripMesh& mesh : sample::meshes()) {
    stripify(mesh, Effort::fast);
    Census told = census_of(mesh);
    const std::size_t size = 3 * mesh.triangle_count() + 20;
    for (std::size_t n = 0; n < test::large(20'000); ++n) {
      Rewrite<Halfedge> rewrite = stir(mesh, mesh, random, size).rewrite;
      told.strips += rewrite.strips;
      told.isolated += rewrite.isolated;
      if (!random_application(mesh, random, size, [&](const auto& table, Halfedge h) {
            rewrite = apply(mesh, table, h);
            EXPECT_EQ(rewrite.valence, table.ports);
          }))
        continue;
      ++done;
      told.strips += rewrite.strips;
      told.isolated += rewrite.isolated;
      if (n % 64 != 0) continue;
      ASSERT_EQ(census_of(mesh), told);
    }
    ASSERT_EQ(census_of(mesh), told);
    expect_sound(mesh);
  }
  EXPECT_GT(done, test::large(20'000) / 5);
}

/// Its dual edges that are solid, by the vertices of the mesh edge.
std::set<std::pair<Vertex, Vertex>> solid_edges_of(const StripMesh& mesh) {
  std::set<std::pair<Vertex, Vertex>> solid;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (unsigned s = 0; mesh.alive(t) && s < 3; ++s)
      if (const Halfedge h = StripMesh::halfedge(t, s); mesh.solid(h))
        solid.insert(std::minmax({mesh.from(h), mesh.to(h)}));
  return solid;
}

// And the same mesh, colours and handles of the operation itself as the shipped functions.
TEST(Apply, DoesWhatTheShippedFunctionsDo) {
  std::mt19937 random(6);
  std::array<std::size_t, 6> compared{};
  const auto compare = [&](const StripMesh& start, std::size_t kind, const auto& table, Halfedge where,
                           auto&& shipped) {
    StripMesh by_function = start;
    StripMesh by_table = start;
    const auto wanted = shipped(by_function);
    const auto done = checked_apply(by_table, table, where);
    ASSERT_TRUE(done) << describe(done.refusal);
    EXPECT_EQ(sample::triangles_of(by_table), sample::triangles_of(by_function));
    EXPECT_EQ(solid_edges_of(by_table), solid_edges_of(by_function));
    EXPECT_EQ(done.rewrite.strips, wanted.strips);
    EXPECT_EQ(done.rewrite.isolated, wanted.isolated);
    EXPECT_EQ(done.rewrite.valence, wanted.valence);
    ++compared[kind];
  };
  for (const StripMesh& start : {sample::torus(6, 5), sample::rectangle(5, 4), sample::tube(5, 6)}) {
    StripMesh mesh = start;
    stripify(mesh, Effort::fast);
    for (std::size_t n = 0; n < 2000; ++n) {
      stir(mesh, mesh, random, 3 * start.triangle_count());
      random_application(mesh, random, 3 * start.triangle_count(),
                         [&](const auto& table, Halfedge h) { apply(mesh, table, h); });
      const Halfedge h = random_halfedge(mesh, random);
      const Halfedge g = mesh.opposite(h);
      const auto split = [&](StripMesh& m) { return split_face(m, h); };
      const auto bisected = [&](StripMesh& m) { return bisect(m, h); };
      const auto joined = [&](StripMesh& m) { return join_faces(m, g); };
      const auto merged = [&](StripMesh& m) { return merge(m, g); };
      if (check_split_face(mesh, h) == Refusal::granted) compare(mesh, 0, tables::split_face, h, split);
      if (check_join_faces(mesh, g) == Refusal::granted) compare(mesh, 1, tables::join_faces, h, joined);
      if (check_bisect(mesh, h) == Refusal::granted) {
        if (StripMesh::on_boundary(g))
          compare(mesh, 2, tables::bisect_boundary, h, bisected);
        else
          compare(mesh, 3, tables::bisect, h, bisected);
      }
      if (check_merge(mesh, g) != Refusal::granted) continue;
      // h leaves the vertex that goes.
      if (StripMesh::on_boundary(g))
        compare(mesh, 4, tables::merge_boundary, h, merged);
      else if (!mesh.leaves_boundary(h))
        compare(mesh, 5, tables::merge, detail::first_around(mesh, g), merged);
      if (HasFatalFailure()) return;
    }
  }
  for (const std::size_t times : compared) EXPECT_GT(times, 10U);
}

// Under a keeper told is counted as well, and its locator follows; under every policy and either cost.
TEST(Apply, KeepersFollow) {
  std::mt19937 random(7);
  for (const PolicyRow& row : policies)
    for (const Cost& cost : {Cost::strips(), Cost::indices(), Cost{3, 1, 2}})
      for (const StripMesh& start : {sample::torus(8, 7), sample::rectangle(7, 6)}) {
        StripMesh mesh = start;
        stripify(mesh, Effort::fast);
        Keeper keeper(mesh, row.policy, cost);
        if (row.policy == Policy::local && cost == Cost::strips()) join_all(mesh), keeper.rebuild();
        std::size_t done = 0;
        for (std::size_t n = 0; n < test::large(1500); ++n) {
          if (row.policy == Policy::bare && n % 8 == 0) stripify(mesh, Effort::fast), keeper.rebuild();
          ColoringChange change = cost_of(mesh);
          Rewrite<Halfedge> told = stir(keeper, mesh, random, 2 * start.triangle_count()).rewrite;
          random_application(mesh, random, 3 * start.triangle_count(), [&](const auto& table, Halfedge h) {
            const auto rewrite = keeper.apply(table, h);
            told.strips += rewrite.strips;
            told.isolated += rewrite.isolated;
            ++done;
          });
          change = cost_of(mesh) - change;
          ASSERT_EQ(told.strips, change.strips);
          ASSERT_EQ(told.isolated, change.isolated);
          ASSERT_EQ(keeper.swaps(), static_cast<std::size_t>(cost_of(mesh).swaps));
          if (n % 8 != 0) continue;
          const Census counted = census_of(mesh);
          ASSERT_EQ(static_cast<long>(keeper.strips()), counted.strips);
          ASSERT_EQ(static_cast<long>(keeper.isolated()), counted.isolated);
          if (keeper.locator() != nullptr) {
            ASSERT_TRUE(agrees(*keeper.locator(), mesh));
          }
          if (row.policy == Policy::local && cost == Cost::strips()) {
            // No two ends meet: docs/theory.md, "What holds for the whole mesh".
            StripMesh copy = mesh;
            ASSERT_EQ(join_all(copy).strips, 0);
          }
        }
        EXPECT_GT(done, test::large(1500) / 40);
      }
}

// ---- a mesh that is not ours

/// A user's mesh: another type of handles, other numbers, and no function but those of the concepts.
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
TEST(Apply, DoesTheSameOnAForeignMesh) {
  std::mt19937 random(8);
  StripMesh mesh = sample::torus(9, 8);
  stripify(mesh, Effort::fast);
  std::array<std::size_t, 2> compared{};
  const auto compare = [&](std::size_t kind, const auto& table, auto&& change) {
    const auto h = random_place(mesh, table, random);
    if (!h) return;
    Foreign foreign(mesh);
    const auto told = apply(foreign, table, Foreign::Halfedge(*h), change(foreign));
    const auto done = apply(mesh, table, *h);
    EXPECT_EQ(told.strips, done.strips);
    EXPECT_EQ(told.isolated, done.isolated);
    std::map<Vertex, Vertex> names;
    const std::vector<Vertex> theirs = added_vertices(foreign, table, told.halfedge);
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
    if (mesh.triangle_count() < 600) compare(0, tables::refine_face, [](Foreign& f) { return refining(f); });
    compare(1, tables::merge, [](Foreign& f) { return merging(f); });
  }
  EXPECT_GT(compared[0], 50U);
  EXPECT_GT(compared[1], 50U);
}

TEST(Apply, KeepersFollowOnAForeignMesh) {
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
        const auto told = keeper.apply(table, Foreign::Halfedge(*h), change_mesh);
        const ColoringChange change = cost_of(mesh.same()) - before;
        ASSERT_EQ(told.strips, change.strips);
        ASSERT_EQ(told.isolated, change.isolated);
        ASSERT_EQ(census_of(mesh.same()).strips, static_cast<long>(keeper.strips()));
        ASSERT_EQ(static_cast<long>(keeper.swaps()), cost_of(mesh.same()).swaps);
      };
      for (int n = 0; n < 100 && !HasFailure(); ++n) {
        const Halfedge h = random_halfedge(mesh.same(), random);
        if (mesh.same().triangle_count() > 300 && check_collapse(mesh.same(), h) == Refusal::granted)
          keeper.collapse(Foreign::Halfedge(h));
        else if (check_flip(mesh.same(), h) == Refusal::granted)
          keeper.flip(Foreign::Halfedge(h));
        if (mesh.same().triangle_count() < 600) step(0, tables::refine_face, refining(mesh));
        step(1, tables::merge, merging(mesh));
      }
      EXPECT_GT(done[0], 30U);
      EXPECT_GT(done[1], 30U);
    }
}

/// Triangles that are paired, on a mesh that flips and nothing else.
TEST(Apply, KeepsPairsOnAHandMadeMesh) {
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
    const auto done = apply(mesh, tables::flip_matching, h, [&](const auto& patch) {
      // r -> l of (r, l, u), where the file begins with l, u, r.
      return mesh.next(mesh.turn_edge(patch.side[0][0]));
    });
    alone += done.isolated;
    ASSERT_EQ(count_single(), alone);
    ++flips;
  }
  EXPECT_GT(flips, 500);
}

// The halves, for code that changes the mesh by itself.
TEST(Apply, InTwoHalves) {
  StripMesh mesh = sample::torus(6, 6);
  stripify(mesh, Effort::fast);
  for (Triangle t = 0; t < 60; ++t) {
    StripMesh other = mesh;
    const Halfedge h = StripMesh::halfedge(t, t % 3);
    const auto pending = before_apply(other, tables::split_face, h);
    EXPECT_EQ(pending.patch().side[0][0], h);
    EXPECT_TRUE(check_coloring(other).valid);
    const Halfedge chord = other.insert_vertex(detail::split_into_face(other, h));
    const auto told = after_apply(other, pending, StripMesh::next(other.opposite(chord)));
    const auto done = split_face(mesh, h);
    EXPECT_EQ(told.strips, done.strips);
    EXPECT_EQ(solid_edges_of(other), solid_edges_of(mesh));
  }
}

// Coarsening and refining again gives the same handles.
TEST(Apply, TakesBackTheHandlesThatItGave) {
  StripMesh mesh = sample::torus(5, 5);
  const Halfedge h = StripMesh::halfedge(7, 1);
  const Halfedge first = apply(mesh, tables::split_face, h).halfedge;
  const std::vector<bare::Corners> refined = sample::triangles_of(mesh);
  const std::size_t bound = mesh.triangle_bound();
  const Halfedge apex = mesh.next(mesh.next(first));  // m -> a
  const auto joined = apply(mesh, tables::join_faces, apex);
  EXPECT_EQ(mesh.triangle_count(), 50U);
  EXPECT_EQ(StripMesh::triangle(joined.halfedge), StripMesh::triangle(apex));
  apply(mesh, tables::split_face, joined.halfedge);
  EXPECT_EQ(sample::triangles_of(mesh), refined);
  EXPECT_EQ(mesh.triangle_bound(), bound);
}

TEST(Apply, RefusesWithAReason) {
  const StripMesh rectangle = sample::rectangle(4, 3);
  EXPECT_EQ(check_apply(rectangle, tables::split_face, {none}), Refusal::no_such_edge);
  Halfedge rim = StripMesh::halfedge(0);
  while (!StripMesh::on_boundary(rectangle.opposite(rim))) rim = StripMesh::next(rim);
  EXPECT_EQ(check_apply(rectangle, tables::split_face, rectangle.opposite(rim)), Refusal::boundary_edge);
  EXPECT_EQ(check_apply(rectangle, tables::bisect, rim), Refusal::other_patch);
  EXPECT_EQ(check_apply(rectangle, tables::bisect_boundary, rim), Refusal::granted);
  EXPECT_EQ(check_apply(sample::torus(5, 5), tables::bisect_boundary, StripMesh::halfedge(0)), Refusal::other_patch);
  EXPECT_EQ(check_apply(sample::octahedron(), tables::join_faces, StripMesh::halfedge(0)), Refusal::other_patch);
  const StripMesh tetrahedron =
      StripMesh::build(std::vector<bare::Corners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, 4);
  EXPECT_EQ(check_apply(tetrahedron, tables::join_faces, StripMesh::halfedge(0)), Refusal::too_few_triangles);
  EXPECT_EQ(check_apply(tetrahedron, tables::flip_matching, StripMesh::halfedge(0)), Refusal::edge_exists);
  EXPECT_EQ(check_apply(sample::meshes().back(), tables::split_face, StripMesh::halfedge(0)),
            Refusal::non_manifold_vertex);
  StripMesh bad = sample::torus(5, 5);
  for (unsigned s = 0; s < 3; ++s) bad.set_solid(StripMesh::halfedge(0, s), true);
  EXPECT_EQ(check_apply(bad, tables::split_face, StripMesh::halfedge(0)), Refusal::colors_not_valid);
}

}  // namespace
}  // namespace restrip
