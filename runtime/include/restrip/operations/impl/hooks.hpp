// The halves of operations as separate calls. Included by hooks.hpp.
#pragma once

#include <cstddef>
#include <utility>
#include <variant>

#include "restrip/operations/hooks.hpp"
#include "restrip/operations/impl/halves.hpp"
#include "restrip/operations/impl/patch_checks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace detail {

inline constexpr const char* nothing_pending = "this pending operation is already finished";
inline constexpr const char* other_patch =
    "the mesh around the given halfedge is not the result of this operation on the patch read before";

/// A change that has begun, of one of these kinds; none once it has been moved from.
template <class... Changes>
class Pending {
 public:
  template <class Change>
  explicit Pending(Change change) : change_(std::move(change)) {}
  Pending(Pending&& other) noexcept : change_(std::exchange(other.change_, std::monostate{})) {}
  Pending& operator=(Pending&& other) noexcept {
    change_ = std::exchange(other.change_, std::monostate{});
    return *this;
  }
  Pending(const Pending&) = delete;
  Pending& operator=(const Pending&) = delete;
  ~Pending() = default;

  [[nodiscard]] bool waits() const noexcept { return change_.index() != 0; }
  /// k of the fan before a split or after a collapse.
  [[nodiscard]] std::size_t valence() const {
    return visit<std::size_t>([](const auto& change) { return change.fan.k; });
  }
  /// The result of visit(change), or Result{} if no change is pending.
  template <class Result, class Visit>
  Result visit(Visit&& visit) const {
    Result result{};
    const auto visit_if = [&](const auto* change) {
      if (change != nullptr) result = visit(*change);
    };
    (visit_if(std::get_if<Changes>(&change_)), ...);
    return result;
  }

 private:
  std::variant<std::monostate, Changes...> change_;
};
template <class Halfedge>
using PendingFan = Pending<InteriorChange<Halfedge>, PatchChange<WordBits>, PatchChange<LongBits>>;

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
class PendingSplit : public detail::PendingFan<Halfedge> {
  using Fan = detail::PendingFan<Halfedge>;
  using Fan::Fan;
};
template <class Halfedge>
class PendingCollapse : public detail::PendingFan<Halfedge> {
  using Fan = detail::PendingFan<Halfedge>;
  using Fan::Fan;
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
  auto pending = detail::with_split_begun(detail::LocalRules{}, mesh, where,
                                          [](auto& change) { return PendingSplit<Halfedge>(std::move(change)); });
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
  RESTRIP_ASSERT(detail::is_split_of(mesh, pending.valence(), chord), "after_split", detail::other_patch);
  return pending.template visit<Rewrite<typename Mesh::Halfedge>>(
      [&](const auto& change) { return detail::finish_split(mesh, change, chord); });
}

template <ColoredMesh Mesh>
PendingCollapse<typename Mesh::Halfedge> before_collapse(Mesh& mesh, typename Mesh::Halfedge chord) {
  using Halfedge = typename Mesh::Halfedge;
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(mesh, chord), "before_collapse");
  auto pending = detail::with_collapse_begun(detail::LocalRules{}, mesh, chord,
                                             [](auto& change) { return PendingCollapse<Halfedge>(std::move(change)); });
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
  RESTRIP_ASSERT(detail::fan_size(mesh, spoke, spoke).triangles == pending.valence(), "after_collapse",
                 detail::other_patch);
  return pending.template visit<Rewrite<typename Mesh::Halfedge>>(
      [&](const auto& change) { return detail::finish_collapse(mesh, change, spoke); });
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
  return pending.template visit<Rewrite<typename Mesh::Halfedge>>(
      [&](const detail::FlipChange& change) { return detail::finish_flip(mesh, change, h); });
}

}  // namespace restrip
