// StripKeeper: split, collapse and flip with strips that do not age.
//
// The local rules (operations.hpp) see one patch and lose strips over thousands of operations. The keeper runs the same
// operations, keeps an index of the strips beside them (strip_index.hpp), and after each one tunnels (tunnel.hpp) from
// every strip end that it finds in the patch: the moment a strip breaks its ends are at hand, and so are, somewhere
// near, the ends of others. (Porcu and Scateni call tunnelling when isolated triangles pass a threshold; calling it at
// once and locally keeps every level of detail as good as strips made from scratch.)
//
//   StripMesh mesh = ...;
//   stripify(mesh, Effort::full);
//   StripKeeper keeper(mesh, Policy::quick);
//   keeper.collapse(chord); keeper.split(where); keeper.flip(h);
//   keeper.improve(10'000);                            // in idle time
//
// Cost. An operation costs its local rule, time linear in the patch for the index, and the searches; their mean number
// of states is bounded by policy, not by the size of the mesh, and so is everything but the O(log n) of the index.
// After warm-up nothing is allocated but what the mesh itself allocates to grow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/detail/patch_triangles.hpp"
#include "restrip/operations.hpp"
#include "restrip/rounds.hpp"
#include "restrip/strip_index.hpp"
#include "restrip/strip_mesh.hpp"
#include "restrip/tunnel.hpp"

namespace restrip {

/// How far an operation looks for strips to join.
enum class Policy {
  local,  ///< not at all: the rules of operations.hpp alone
  quick,  ///< 44 states from each strip end in the patch
  full    ///< 240 states from each strip end in the patch
};

/// States that a search may look at under a policy. Searches of n states keep about 2 n triangles per strip or more on
/// meshes far larger than that.
[[nodiscard]] constexpr std::uint32_t max_states(Policy policy) noexcept {
  switch (policy) {
    case Policy::local:
      return 0;
    case Policy::quick:
      return 44;
    case Policy::full:
      return 240;
  }
  return 0;
}

/// Keeps the strips of one mesh. While a keeper is in use, colour and change the mesh through it alone; after any other
/// change call rebuild(). The mesh must outlive the keeper and have a valid colouring (all dashed is one).
class StripKeeper {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit StripKeeper(StripMesh& mesh, Policy policy = Policy::quick) : mesh_(&mesh), states_(max_states(policy)) {
    index_.rebuild(mesh);
  }

  /// From the next operation on.
  void set_policy(Policy policy) noexcept { states_ = max_states(policy); }
  /// Any number of states from each strip end: more keep longer strips and take proportionally longer.
  void set_max_states(std::uint32_t states) noexcept { states_ = states; }

  /// The operations of operations.hpp, with the same preconditions. `strips` of the result counts what tunnelling
  /// joined as well, so it is often negative; `isolated` is that of the local rule.
  Rewrite<Halfedge> split(const VertexSplit<Halfedge>& where, Vertex new_vertex = none) {
    using Spokes = VertexSplit<Halfedge>::Spokes;
    detail::fan_triangles(*mesh_, where.spokes == Spokes::right_only ? where.right : where.left, patch_);
    index_.before_patch(*mesh_, patch_);
    Rewrite<Halfedge> done = restrip::split(*mesh_, where, new_vertex);
    detail::edge_triangles(*mesh_, done.halfedge, patch_);
    return finish(done);
  }
  Rewrite<Halfedge> collapse(Halfedge chord) {
    detail::edge_triangles(*mesh_, chord, patch_);
    index_.before_patch(*mesh_, patch_);
    Rewrite<Halfedge> done = restrip::collapse(*mesh_, chord);
    detail::fan_triangles(*mesh_, done.halfedge, patch_);
    return finish(done);
  }
  Rewrite<Halfedge> flip(Halfedge h) {
    patch_.assign({StripMesh::triangle(h), StripMesh::triangle(mesh_->opposite(h))});
    index_.before_patch(*mesh_, patch_);
    return finish(restrip::flip(*mesh_, h));
  }

  /// Background work: goes on with rounds over all strip ends (rounds.hpp), looking at about `budget` states. Returns
  /// the number of strips it saved.
  std::size_t improve(std::size_t budget) {
    const std::size_t before = index_.strips();
    rounds_.run(*mesh_, index_, tunnel_, budget);
    return before - index_.strips();
  }

  /// Reads the mesh anew. Linear time.
  void rebuild() {
    index_.rebuild(*mesh_);
    rounds_.restart();
  }
  void reserve(std::size_t triangles) { index_.reserve(triangles); }

  [[nodiscard]] std::size_t strips() const noexcept { return index_.strips(); }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] const StripIndex& index() const noexcept { return index_; }
  [[nodiscard]] const TunnelCounts& counts() const noexcept { return tunnel_.counts(); }

 private:
  Rewrite<Halfedge> finish(Rewrite<Halfedge> done) {
    index_.after_patch(*mesh_, patch_);
    if (states_ == 0) return done;
    for (const Triangle t : patch_)
      if (mesh_->solid_degree(t) < 2 && tunnel_.join(*mesh_, index_, t, states_)) --done.strips;
    return done;
  }

  StripMesh* mesh_;
  StripIndex index_;
  Tunnel tunnel_;
  TunnelRounds rounds_{256, 4096};
  std::uint32_t states_;
  std::vector<Triangle> patch_;
};

}  // namespace restrip
