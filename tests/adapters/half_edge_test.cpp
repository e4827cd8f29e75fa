// docs/how-to/own-mesh.md suffices to write an adapter: a mesh that was written from it keeps the contract, supports
// every policy, either cost, strips from scratch and live buffers, and its owner's undo works with strips.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "../support/half_edge_mesh.hpp"
#include "lockstep.hpp"

namespace restrip {
namespace {

static_assert(SplittableMesh<half_edge::Mesh> && CollapsibleMesh<half_edge::Mesh> && FlippableMesh<half_edge::Mesh> &&
              NumberedMesh<half_edge::Mesh>);

using half_edge::copy_of;

class Foreign {
 public:
  using Halfedge = half_edge::Halfedge;
  using Vertex = std::uint32_t;
  explicit Foreign(const StripMesh& from) : mesh_(copy_of(from)) {}
  half_edge::Mesh& strips() { return mesh_; }
  static Vertex vertex(restrip::Vertex v) { return v + half_edge::first_vertex; }
  static std::uint32_t number(Vertex v) { return v; }
  [[nodiscard]] Halfedge find(Vertex v, Vertex w) const { return mesh_.find(v, w); }
  [[nodiscard]] bool exists(Halfedge h) const { return h != Halfedge{} && !mesh_.on_boundary(h); }
  [[nodiscard]] Vertex from(Halfedge h) const { return mesh_.from(h); }
  [[nodiscard]] Vertex to(Halfedge h) const { return mesh_.to(h); }
  template <class Visit>
  void for_each_triangle(Visit&& visit) const {
    for (std::uint32_t t = 0; t < mesh_.triangle_bound(); ++t)
      if (mesh_.has_triangle(t)) visit(mesh_.halfedge(t));
  }

 private:
  half_edge::Mesh mesh_;
};

TEST(HalfEdgeMesh, Closed) { walk_in_lockstep<Foreign>(sample::torus(12, 10), false, 1); }
TEST(HalfEdgeMesh, WithBoundary) { walk_in_lockstep<Foreign>(sample::rectangle(6, 5), true, 2); }

TEST(HalfEdgeMesh, KeepsTheContract) { expect_contract_kept<Foreign>(); }

/// An owner who gives back a frame, here by a copy of the records, rebuilds the keeper and names the triangles of the
/// frame to the buffer. The strips are the former ones, and operations continue from there.
TEST(HalfEdgeMesh, UndoOfItsOwnerGoesWithStrips) {
  half_edge::Mesh mesh = copy_of(sample::rectangle(8, 8));
  stripify(mesh, Effort::fast, Cost::strips());
  Watched watched(mesh);
  Keeper keeper(watched, Policy::quick, Cost::strips());
  StripBuffer buffer(watched);
  std::mt19937 random(5);
  int done = 0;
  const auto operations = [&] {
    for (int n = 0; n < 30; ++n) {
      const auto t = static_cast<std::uint32_t>(random() % mesh.triangle_bound());
      if (!mesh.has_triangle(t)) continue;
      const half_edge::Halfedge h = mesh.halfedge(t);
      const half_edge::Halfedge other = mesh.opposite(h);
      if (n % 2 == 0) {
        keeper.split_face(h);
      } else if (!mesh.on_boundary(other)) {
        const half_edge::Halfedge to_left = mesh.next(h);
        const half_edge::Halfedge to_right = mesh.opposite(mesh.next(mesh.next(other)));
        const bool valence_three = !mesh.on_boundary(to_right) && turn_ccw(mesh, to_right) == to_left;
        if (valence_three)
          keeper.join_faces(h);
        else if (mesh.find(mesh.to(to_left), mesh.to(to_right)) == half_edge::Halfedge{})
          keeper.flip(h);
        else
          continue;
      }
      ++done;
    }
    buffer.update(watched, watched.changed());
    ASSERT_TRUE(check_buffer(buffer, mesh).right());
  };
  struct Frame {
    half_edge::Mesh before;
    std::size_t strips;
    std::vector<std::uint32_t> changed;
  };
  std::vector<Frame> frames;
  for (int repeat = 0; repeat < 3; ++repeat) {
    for (int n = 0; n < 10; ++n) {
      frames.push_back({mesh, keeper.strips(), {}});
      operations();
      frames.back().changed.swap(watched.changed());
    }
    for (; frames.size() > 2; frames.pop_back()) {
      mesh = frames.back().before;
      keeper.rebuild();
      buffer.update(watched, frames.back().changed);
      ASSERT_EQ(keeper.strips(), frames.back().strips);
      ASSERT_EQ(count_strips(mesh), frames.back().strips);
      ASSERT_TRUE(check_buffer(buffer, mesh).right());
    }
  }
  EXPECT_GT(done, 400);
}

std::size_t triangles_in(const half_edge::Mesh& mesh) {
  std::size_t triangles = 0;
  for (std::uint32_t t = 0; t < mesh.triangle_bound(); ++t) triangles += mesh.has_triangle(t) ? 1U : 0U;
  return triangles;
}
/// Checked operations on the mesh and on its keeper: what is refused changes nothing, what is granted is done.
template <class Target>
void expect_checked(half_edge::Mesh& mesh, Target& target) {
  using Spokes = VertexSplit<half_edge::Halfedge>;
  std::size_t flips = 0;
  std::size_t refused = 0;
  const std::size_t size = triangles_in(mesh);
  for (std::uint32_t t = 0; t < mesh.triangle_bound(); ++t) {
    const auto h = [&mesh, t] {
      std::uint32_t next = t;
      while (!mesh.has_triangle(next)) next = (next + 1) % static_cast<std::uint32_t>(mesh.triangle_bound());
      return mesh.halfedge(next);
    };
    const bool boundary = mesh.on_boundary(mesh.opposite(h()));
    const auto bisected = checked_bisect(target, h());
    ASSERT_TRUE(bisected);
    ASSERT_EQ(triangles_in(mesh), size + (boundary ? 1U : 2U));
    ASSERT_TRUE(checked_merge(target, bisected.rewrite.halfedge));
    ASSERT_EQ(triangles_in(mesh), size);
    const auto face = checked_split_face(target, h());
    ASSERT_TRUE(face);
    ASSERT_EQ(checked_merge(target, face.rewrite.halfedge).refusal, Refusal::other_valence);
    ASSERT_EQ(triangles_in(mesh), size + 2);
    ASSERT_TRUE(checked_join_faces(target, face.rewrite.halfedge));
    ASSERT_EQ(checked_split(target, Spokes{h(), h()}).refusal, Refusal::same_spoke);
    const auto split = checked_split(target, Spokes{turn_ccw(mesh, h()), h()});
    ASSERT_TRUE(split);
    ASSERT_EQ(triangles_in(mesh), size + 2);
    ASSERT_TRUE(checked_collapse(target, split.rewrite.halfedge));
    ASSERT_EQ(triangles_in(mesh), size);
    const std::size_t strips = count_strips(mesh);
    const auto flip = checked_flip(target, h());
    if (flip) {
      ++flips;
      ASSERT_EQ(count_strips(mesh), strips + static_cast<std::size_t>(flip.rewrite.strips));
      ASSERT_TRUE(checked_flip(target, flip.rewrite.halfedge));
    } else {
      ++refused;
      ASSERT_EQ(count_strips(mesh), strips);
    }
    ASSERT_TRUE(check_coloring(mesh).valid);
  }
  EXPECT_GT(flips, 20U);
  EXPECT_GT(refused, 2U);
}
TEST(HalfEdgeMesh, HasCheckedOperations) {
  half_edge::Mesh mesh = copy_of(sample::rectangle(6, 5));
  stripify(mesh);
  expect_checked(mesh, mesh);
  Watched watched(mesh);
  Keeper keeper(watched, Policy::quick, Cost::indices());
  expect_checked(mesh, keeper);
}

}  // namespace
}  // namespace restrip

namespace half_edge {

/// Also has the checks of docs/how-to/own-mesh.md, which know vertices, and counts how often they are asked.
struct CheckedMesh : Mesh {
  using Mesh::Mesh;
  mutable int asked = 0;

  [[nodiscard]] std::vector<std::uint32_t> neighbors(Halfedge spoke) const {
    std::vector<std::uint32_t> found;
    Halfedge h = spoke;
    do {
      found.push_back(to(h));
      h = on_boundary(h) ? Halfedge{} : opposite(next(next(h)));
    } while (h != Halfedge{} && h != spoke);
    if (h == spoke) return found;
    for (h = spoke; !on_boundary(opposite(h));) {
      h = next(opposite(h));
      found.push_back(to(h));
    }
    return found;
  }
};

restrip::Refusal check_collapse(const CheckedMesh& mesh, Halfedge chord) {
  ++mesh.asked;
  std::size_t apexes = 0;
  for (const Halfedge h : {chord, mesh.opposite(chord)}) apexes += mesh.on_boundary(h) ? 0U : 1U;
  std::size_t common = 0;
  const auto ahead = mesh.neighbors(mesh.opposite(chord));
  for (const std::uint32_t v : mesh.neighbors(chord)) common += static_cast<std::size_t>(std::ranges::count(ahead, v));
  return common == apexes ? restrip::Refusal::granted : restrip::Refusal::link_condition;
}
restrip::Refusal check_flip(const CheckedMesh& mesh, Halfedge h) {
  ++mesh.asked;
  const auto apex = [&](Halfedge side) { return mesh.to(mesh.next(side)); };
  return mesh.find(apex(h), apex(mesh.opposite(h))) == Halfedge{} ? restrip::Refusal::granted
                                                                  : restrip::Refusal::edge_exists;
}
restrip::Refusal check_split(const CheckedMesh& mesh, const restrip::VertexSplit<Halfedge>& where) {
  ++mesh.asked;
  return mesh.from(where.left) == 0 ? restrip::Refusal::vertex_in_use : restrip::Refusal::granted;
}

}  // namespace half_edge

namespace restrip {
namespace {

/// The refusals of every edge, through this target, are those of a StripMesh.
template <class Target>
void expect_refusals_of(const StripMesh& known, const half_edge::CheckedMesh& mesh, const Target& target) {
  std::size_t refused = 0;
  for (const StripMesh::Halfedge h : sample::sides_of(known)) {
    const auto mine = mesh.find(known.from(h), known.to(h));
    const Refusal collapse = detail::refusal_of_collapse(target, mine);
    ASSERT_EQ(collapse == Refusal::granted, check_collapse(known, h) == Refusal::granted) << describe(collapse);
    const Refusal flip = detail::refusal_of_flip(target, mine);
    ASSERT_EQ(flip == Refusal::granted, check_flip(known, h) == Refusal::granted) << describe(flip);
    const Refusal split = detail::refusal_of_split(target, {turn_ccw(mesh, mine), mine});
    ASSERT_EQ(split, known.from(h) == 0 ? Refusal::vertex_in_use : Refusal::granted);
    refused += collapse == Refusal::link_condition ? 1U : 0U;
  }
  EXPECT_GT(refused, 10U);
}
TEST(HalfEdgeMesh, HasItsOwnChecksThroughEveryWrapper) {
  for (const StripMesh& known : {sample::torus(3, 6), sample::torus(4, 3)}) {
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : sample::triangles_of(known))
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    half_edge::CheckedMesh mesh(corners);
    Watched watched(mesh);
    struct Derived : decltype(watched) {
      explicit Derived(half_edge::CheckedMesh& base) : Watched(base) {}
    } derived(mesh);
    Watched<decltype(watched)> twice(watched);
    expect_refusals_of(known, mesh, mesh);
    expect_refusals_of(known, mesh, watched);
    expect_refusals_of(known, mesh, derived);
    expect_refusals_of(known, mesh, twice);
    Keeper keeper(twice, Policy::quick);
    const auto ring = mesh.find(0, 1);
    mesh.asked = 0;
    EXPECT_EQ(checked_split_face(keeper, ring).refusal, Refusal::vertex_in_use);
    EXPECT_GE(mesh.asked, 1);
    const Refusal expected = detail::refusal_of_collapse(mesh, ring);
    mesh.asked = 0;
    EXPECT_EQ(checked_collapse(keeper, ring).refusal, expected);
    EXPECT_GE(mesh.asked, 1);
  }
}

/// The mesh's own checks are asked about what the checks on triangles grant, and only about that.
TEST(HalfEdgeMesh, ChecksTrianglesBeforeItsOwnChecks) {
  for (const std::vector<std::uint32_t>& corners :
       {std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}, {0, 1, 2}, {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2}}) {
    half_edge::CheckedMesh mesh(corners);
    Watched watched(mesh);
    Watched<decltype(watched)> twice(watched);
    Keeper keeper(twice, Policy::quick);
    std::size_t size = triangles_in(mesh);
    for (bool collapsed = true; collapsed;) {
      collapsed = false;
      for (std::uint32_t t = 0; t < mesh.triangle_bound() && !collapsed; ++t)
        for (unsigned side = 0; mesh.has_triangle(t) && side < 3 && !collapsed; ++side) {
          auto h = mesh.halfedge(t);
          for (unsigned turn = 0; turn < side; ++turn) h = mesh.next(h);
          mesh.asked = 0;
          const auto done = checked_collapse(keeper, h);
          collapsed = done.granted();
          EXPECT_EQ(mesh.asked > 0, collapsed || done.refusal == Refusal::link_condition) << describe(done.refusal);
        }
      if (collapsed) {
        ASSERT_LT(triangles_in(mesh), size);
        size = triangles_in(mesh);
        ASSERT_GT(size, 0U);
      }
    }
    EXPECT_EQ(size, corners.size() == 12 ? 4U : 1U);
  }
}

}  // namespace
}  // namespace restrip
