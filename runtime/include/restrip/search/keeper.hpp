// StripKeeper: split, collapse and flip under a policy, with strips that stay long.
//
// The local rules (operations.hpp) see one patch, and under them strips get shorter over thousands of operations. A
// policy says how much more an operation looks at: the strip ends that meet (join.hpp), the strips around the patch
// (linked.hpp), or everything that tunnelling (tunnel.hpp) reaches from every strip end in the patch, which needs a
// locator of the strips beside the mesh (strip_locator.hpp). At the moment when a strip breaks, its ends are known, and
// ends of other strips are near. (Porcu and Scateni tunnel when isolated triangles exceed a threshold. Tunnelling at
// once and locally keeps the strips of every level of detail as long as those made from scratch.)
//
//   StripMesh mesh = ...;
//   stripify(mesh, Effort::full);
//   StripKeeper keeper(mesh, Policy::quick);
//   keeper.collapse(chord); keeper.split(where); keeper.flip(h);
//   keeper.improve(10'000);                            // in idle time
//
// Complexity. An operation costs its rule and, if the policy tunnels, time linear in the patch for the locator, and the
// searches. Their mean number of states depends on the policy, not on the size of the mesh. The same holds for the mean
// length of the strips, on which the locator depends, once they have the length that the policy keeps. After warm-up
// nothing is allocated beyond what the mesh itself allocates to grow.
//
// Exceptions (only std::bad_alloc). The mesh and its colouring are valid after one: the operation, or the repair that
// follows it, is done as a whole, in part or not at all. What the keeper knows beside the mesh is then out of date:
// up_to_date() is false, locator() is null and strips() is stale until rebuild(), which the next operation calls
// itself.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/operations/linked.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/rounds.hpp"
#include "restrip/search/strip_locator.hpp"
#include "restrip/search/tunnel.hpp"

namespace restrip {

/// How large the searches from the strip ends in a patch are, and what for.
struct Search {
  std::uint32_t states = 0;  ///< state limit per search; 0 disables searching
  std::uint32_t enough = 0;  ///< triangles per strip: searches get smaller while strips are longer on average. 0: never
};

/// Searches of n states keep about 3 n triangles per strip, where holes and connected components of the mesh allow it.
[[nodiscard]] constexpr Search search_of(Policy policy) noexcept {
  switch (policy) {
    case Policy::local:
    case Policy::linked:
      return {};
    case Policy::quick:
      return {56, 150};
    case Policy::full:
      return {320, 0};
  }
  return {};
}

/// Keeps the strips of one mesh. While a keeper is in use, colour and change the mesh through it alone; after any other
/// change call rebuild(). The mesh must outlive the keeper and have a valid colouring (all dashed is one;
/// check_coloring in strips.hpp tells). Where the keeper reads the whole mesh anew, it throws std::invalid_argument
/// when the colouring is not valid.
class StripKeeper {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit StripKeeper(StripMesh& mesh, Policy policy = Policy::quick)
      : mesh_(&mesh), search_(search_of(policy)), linked_(policy == Policy::linked) {
    rebuild();
  }

  /// From the next operation on. Linear time when the locator has to be made.
  void set_policy(Policy policy) {
    linked_ = policy == Policy::linked;
    set_search(search_of(policy));
  }
  /// Searches of any size: larger ones keep longer strips and take proportionally longer.
  void set_search(Search search) {
    const bool had_locator = tunnels();
    search_ = search;
    if (!had_locator && tunnels()) rebuild();
  }

  /// The operations of operations.hpp, with the same preconditions. `strips` of the result includes what tunnelling
  /// joined, so it is often negative; `isolated` includes what tunnelling and adoption saved.
  Rewrite<Halfedge> split(const VertexSplit<Halfedge>& where, Vertex new_vertex = none) {
    using Spokes = VertexSplit<Halfedge>::Spokes;
    RESTRIP_ASSERT(check_split(*mesh_, where, new_vertex) == Refusal::granted, "StripKeeper::split",
                   describe(check_split(*mesh_, where, new_vertex)));
    begin();
    if (!tunnels())
      return counted(linked_ ? split_and_link(*mesh_, where, new_vertex) : split_and_join(*mesh_, where, new_vertex));
    fan_triangles(*mesh_, where.spokes == Spokes::right_only ? where.right : where.left, patch_);
    locator_.before_patch(*mesh_, patch_);
    const Rewrite<Halfedge> done = restrip::split(*mesh_, where, new_vertex);
    for (const Halfedge h : {done.halfedge, mesh_->opposite(done.halfedge)})
      if (!StripMesh::on_boundary(h)) patch_.push_back(StripMesh::triangle(h));
    return finish(done);
  }
  Rewrite<Halfedge> collapse(Halfedge chord) {
    RESTRIP_ASSERT(check_collapse(*mesh_, chord) == Refusal::granted, "StripKeeper::collapse",
                   describe(check_collapse(*mesh_, chord)));
    begin();
    if (!tunnels()) return counted(linked_ ? collapse_and_link(*mesh_, chord) : collapse_and_join(*mesh_, chord));
    edge_triangles(*mesh_, chord, patch_);
    locator_.before_patch(*mesh_, patch_);
    const Rewrite<Halfedge> done = restrip::collapse(*mesh_, chord);
    forget_removed();
    return finish(done);
  }
  Rewrite<Halfedge> flip(Halfedge h) {
    RESTRIP_ASSERT(check_flip(*mesh_, h) == Refusal::granted, "StripKeeper::flip", describe(check_flip(*mesh_, h)));
    begin();
    if (!tunnels()) return counted(linked_ ? flip_and_link(*mesh_, h) : flip_and_join(*mesh_, h));
    patch_.assign({StripMesh::triangle(h), StripMesh::triangle(mesh_->opposite(h))});
    locator_.before_patch(*mesh_, patch_);
    Rewrite<Halfedge> done = finish(restrip::flip(*mesh_, h));
    adopt_beside_patch(done);
    return done;
  }

  /// The operations of refine.hpp. Linked rules have none of their own here: linked is as local.
  Rewrite<Halfedge> split_face(Halfedge h) {
    RESTRIP_ASSERT(check_split_face(*mesh_, h) == Refusal::granted, "StripKeeper::split_face",
                   describe(check_split_face(*mesh_, h)));
    return insert(h, false, [&] { return restrip::split_face(*mesh_, h); });
  }
  Rewrite<Halfedge> bisect(Halfedge h) {
    RESTRIP_ASSERT(check_bisect(*mesh_, h) == Refusal::granted, "StripKeeper::bisect",
                   describe(check_bisect(*mesh_, h)));
    return insert(h, true, [&] { return restrip::bisect(*mesh_, h); });
  }
  Rewrite<Halfedge> join_faces(Halfedge chord) {
    RESTRIP_ASSERT(check_join_faces(*mesh_, chord) == Refusal::granted, "StripKeeper::join_faces",
                   describe(check_join_faces(*mesh_, chord)));
    return remove(chord, [&] { return restrip::join_faces(*mesh_, chord); });
  }
  Rewrite<Halfedge> merge(Halfedge chord) {
    RESTRIP_ASSERT(check_merge(*mesh_, chord) == Refusal::granted, "StripKeeper::merge",
                   describe(check_merge(*mesh_, chord)));
    return remove(chord, [&] { return restrip::merge(*mesh_, chord); });
  }

  /// Background work: goes on with rounds over all strip ends (rounds.hpp), looking at about `budget` states. Returns
  /// the number of strips it saved.
  std::size_t improve(std::size_t budget) {
    begin();
    if (!tunnels()) locator_.rebuild(*mesh_);
    const std::size_t before = locator_.strips();
    rounds_.run(*mesh_, locator_, tunnel_, budget);
    strips_ = locator_.strips();
    up_to_date_ = true;
    return before - strips_;
  }

  /// Reads the mesh anew. Linear time. Throws std::invalid_argument when its colouring is not valid; the keeper must
  /// not be used then until rebuild() succeeds.
  void rebuild() {
    up_to_date_ = false;
    rounds_.restart();
    if (tunnels()) {
      locator_.rebuild(*mesh_);
      strips_ = locator_.strips();
    } else {
      strips_ = count_strips(*mesh_);
    }
    up_to_date_ = true;
  }
  void reserve(std::size_t triangles) { locator_.reserve(triangles); }

  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  /// False after an exception, until rebuild() or the next operation.
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }
  /// Null under policies without a locator, and while it is not up to date.
  [[nodiscard]] const StripLocator* locator() const noexcept { return tunnels() && up_to_date_ ? &locator_ : nullptr; }
  [[nodiscard]] const TunnelCounts& counts() const noexcept { return tunnel_.counts(); }

 private:
  // An operation that ends by an exception leaves up_to_date_ false.
  void begin() {
    if (!up_to_date_) rebuild();
    up_to_date_ = false;
  }
  [[nodiscard]] Exchange exchange() const noexcept { return linked_ ? Exchange::yes : Exchange::no; }
  [[nodiscard]] bool tunnels() const noexcept { return search_.states != 0; }
  // For the next operation. The longer the strips, the more states it takes to find an end; a high power of the length
  // keeps all levels of detail close to `enough`.
  [[nodiscard]] std::uint32_t states_now() const noexcept {
    const double short_of = static_cast<double>(search_.enough) * static_cast<double>(locator_.strips()) /
                            static_cast<double>(mesh_->triangle_count());
    if (search_.enough == 0 || short_of >= 1) return search_.states;
    const double square = short_of * short_of;
    return static_cast<std::uint32_t>(square * square * search_.states);
  }
  Rewrite<Halfedge> counted(const Rewrite<Halfedge>& done) {
    strips_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(strips_) + done.strips);
    up_to_date_ = true;
    return done;
  }
  Rewrite<Halfedge> finish(Rewrite<Halfedge> done) {
    locator_.after_patch(*mesh_, patch_);
    const std::uint32_t states = states_now();
    const TunnelCounts before = tunnel_.counts();
    for (const Triangle t : patch_)
      if (mesh_->solid_degree(t) < 2) tunnel_.join(*mesh_, locator_, t, states);
    done.strips -= static_cast<int>(tunnel_.counts().joined - before.joined);
    done.isolated += static_cast<int>(tunnel_.counts().isolated - before.isolated);
    if (done.isolated > 0)
      for (const Triangle t : patch_) adopt_isolated(done, StripMesh::halfedge(t, 0));
    strips_ = locator_.strips();
    up_to_date_ = true;
    return done;
  }
  /// A new vertex in the triangle of h, or on its edge. Nothing is isolated by that.
  template <class Do>
  Rewrite<Halfedge> insert(Halfedge h, bool on_edge, Do&& operation) {
    begin();
    if (!tunnels()) {
      const Rewrite<Halfedge> done = operation();
      return counted(detail::with(done, join_around(*mesh_, mesh_->opposite(done.halfedge), exchange())));
    }
    patch_.clear();
    for (const Halfedge side : {h, mesh_->opposite(h)})
      if (!StripMesh::on_boundary(side) && (on_edge || side == h)) patch_.push_back(StripMesh::triangle(side));
    locator_.before_patch(*mesh_, patch_);
    const Rewrite<Halfedge> done = operation();
    fan_triangles(*mesh_, mesh_->opposite(done.halfedge), patch_);
    return finish(done);
  }
  /// The end of the chord is removed.
  template <class Do>
  Rewrite<Halfedge> remove(Halfedge chord, Do&& operation) {
    begin();
    if (!tunnels()) {
      const Rewrite<Halfedge> done = operation();
      return counted(detail::with(done, join_beside(*mesh_, done.halfedge, exchange())));
    }
    fan_triangles(*mesh_, mesh_->opposite(chord), patch_);
    locator_.before_patch(*mesh_, patch_);
    Rewrite<Halfedge> done = operation();
    forget_removed();
    done = finish(done);
    for (const Triangle t : patch_) adopt_isolated(done, StripMesh::halfedge(t, 0));
    adopt_beside_patch(done);
    return done;
  }
  void forget_removed() {
    std::erase_if(patch_, [this](Triangle t) { return !mesh_->alive(t); });
  }
  /// An operation that gives ports up may isolate a triangle beside the patch.
  void adopt_beside_patch(Rewrite<Halfedge>& done) {
    up_to_date_ = false;
    for (const Triangle t : patch_)
      for (unsigned side = 0; side < 3; ++side)
        if (const Halfedge across = mesh_->opposite(StripMesh::halfedge(t, side)); !StripMesh::on_boundary(across))
          adopt_isolated(done, across);
    up_to_date_ = true;
  }
  void adopt_isolated(Rewrite<Halfedge>& done, Halfedge h) {
    const auto paint = [this](Halfedge g, bool solid) { solid ? locator_.link(*mesh_, g) : locator_.cut(*mesh_, g); };
    const Mending mending = detail::adopt_with(*mesh_, h, detail::default_adoptions, paint, [](Halfedge) {});
    done = detail::with(done, mending);
    strips_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(strips_) + mending.strips);
  }

  StripMesh* mesh_;
  StripLocator locator_;
  Tunnel tunnel_;
  TunnelRounds rounds_{256, 4096};
  Search search_;
  bool linked_;
  std::size_t strips_ = 0;
  bool up_to_date_ = false;
  std::vector<Triangle> patch_;
};

}  // namespace restrip
