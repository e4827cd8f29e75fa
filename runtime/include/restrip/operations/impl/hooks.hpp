// The halves of operations as separate calls. Included by hooks.hpp.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "restrip/operations/hooks.hpp"
#include "restrip/operations/impl/halves.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

inline constexpr const char* nothing_pending = "this pending operation is already finished";
inline constexpr const char* other_patch =
    "the mesh around the given halfedge is not the result of this operation on the patch read before";

/// A change that has begun; none once it has been moved from.
template <class Change>
class Pending {
 public:
  explicit Pending(Change change) : change_(std::move(change)) {}
  Pending(Pending&& other) noexcept : change_(std::exchange(other.change_, std::nullopt)) {}
  Pending& operator=(Pending&& other) noexcept {
    change_ = std::exchange(other.change_, std::nullopt);
    return *this;
  }
  Pending(const Pending&) = delete;
  Pending& operator=(const Pending&) = delete;
  ~Pending() = default;

  [[nodiscard]] bool waits() const noexcept { return change_.has_value(); }
  [[nodiscard]] const Change& change() const noexcept { return *change_; }

 private:
  std::optional<Change> change_;
};

template <class Mesh>
void clear_if_solid(Mesh& mesh, typename Mesh::Halfedge h) {
  if (mesh.solid(h)) mesh.set_solid(h, false);
}

/// Whether a split of a fan of k triangles has made the triangles at the two ends of the chord. Around an interior mesh
/// edge it adds two triangles, each of which has both ends.
template <class Mesh>
bool is_split_of(const Mesh& mesh, std::size_t k, typename Mesh::Halfedge chord) {
  const auto back = mesh.opposite(chord);
  const std::size_t made = (mesh.on_boundary(chord) ? 0U : 1U) + (mesh.on_boundary(back) ? 0U : 1U);
  return made != 0 && fan_size(mesh, chord, chord).triangles + fan_size(mesh, back, back).triangles == k + 2 * made;
}

}  // namespace detail

template <class Halfedge>
class PendingSplit : public detail::Pending<detail::FanChange<Halfedge>> {
  using detail::Pending<detail::FanChange<Halfedge>>::Pending;
};
template <class Halfedge>
class PendingCollapse : public detail::Pending<detail::FanChange<Halfedge>> {
  using detail::Pending<detail::FanChange<Halfedge>>::Pending;
};
template <class Halfedge>
class PendingFlip : public detail::Pending<detail::FlipChange> {
  using detail::Pending<detail::FlipChange>::Pending;
};

template <ColoredMesh Mesh>
PendingSplit<typename Mesh::Halfedge> before_split(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where) {
  using Halfedge = typename Mesh::Halfedge;
  using Spokes = typename VertexSplit<Halfedge>::Spokes;
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(mesh, where), "before_split");
  PendingSplit<Halfedge> pending(detail::begin_split(detail::LocalRules{}, mesh, where));
  // The edges of the spokes become two each.
  if (where.spokes != Spokes::right_only) detail::clear_if_solid(mesh, where.left);
  if (where.spokes != Spokes::left_only) detail::clear_if_solid(mesh, where.right);
  return pending;
}

template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_split(Mesh& mesh, PendingSplit<typename Mesh::Halfedge> pending,
                                             typename Mesh::Halfedge chord) {
  RESTRIP_ASSERT(pending.waits(), "after_split", detail::nothing_pending);
  RESTRIP_ASSERT(detail::knows(mesh, chord), "after_split", describe(Refusal::no_such_edge));
  RESTRIP_ASSERT(detail::is_split_of(mesh, pending.change().fan.k, chord), "after_split", detail::other_patch);
  if (!pending.waits()) return {};
  return detail::finish_split(mesh, pending.change(), chord);
}

template <ColoredMesh Mesh>
PendingCollapse<typename Mesh::Halfedge> before_collapse(Mesh& mesh, typename Mesh::Halfedge chord) {
  using Halfedge = typename Mesh::Halfedge;
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(mesh, chord), "before_collapse");
  PendingCollapse<Halfedge> pending(detail::begin_collapse(detail::LocalRules{}, mesh, chord));
  // Two edges merge, and the library chooses which one it removes.
  for (const Halfedge inward : {chord, mesh.opposite(chord)}) {
    if (mesh.on_boundary(inward)) continue;
    const Halfedge up = mesh.next(inward);
    for (const Halfedge h : {inward, up, mesh.next(up)}) detail::clear_if_solid(mesh, h);
  }
  return pending;
}

template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_collapse(Mesh& mesh, PendingCollapse<typename Mesh::Halfedge> pending,
                                                typename Mesh::Halfedge spoke) {
  RESTRIP_ASSERT(pending.waits(), "after_collapse", detail::nothing_pending);
  RESTRIP_ASSERT(detail::knows(mesh, spoke), "after_collapse", describe(Refusal::no_such_edge));
  RESTRIP_ASSERT(detail::fan_size(mesh, spoke, spoke).triangles == pending.change().fan.k, "after_collapse",
                 detail::other_patch);
  if (!pending.waits()) return {};
  return detail::finish_collapse(mesh, pending.change(), spoke);
}

template <ColoredMesh Mesh>
PendingFlip<typename Mesh::Halfedge> before_flip(Mesh& mesh, typename Mesh::Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_flip(mesh, h), "before_flip");
  PendingFlip<typename Mesh::Halfedge> pending(detail::begin_flip(mesh, h));
  detail::clear_if_solid(mesh, h);  // the library may make the turned edge again
  return pending;
}

template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_flip(Mesh& mesh, PendingFlip<typename Mesh::Halfedge> pending,
                                            typename Mesh::Halfedge h) {
  RESTRIP_ASSERT(pending.waits(), "after_flip", detail::nothing_pending);
  RESTRIP_ASSERT(detail::knows(mesh, h), "after_flip", describe(Refusal::no_such_edge));
  RESTRIP_ASSERT(!mesh.on_boundary(h) && !mesh.on_boundary(mesh.opposite(h)), "after_flip", detail::other_patch);
  if (!pending.waits()) return {};
  return detail::finish_flip(mesh, pending.change(), h);
}

}  // namespace restrip
