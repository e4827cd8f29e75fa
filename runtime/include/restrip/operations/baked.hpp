// Baked strips: strips chosen offline, played back at the cost of a copy.
//
// A progressive mesh is fixed long before it is shown, so its strips can be precomputed too. `restrip bake` chooses the
// strips of every level with long searches and stores, for each record, the dual edges whose colours change. At run
// time a split flips exactly these colours, and a collapse flips them back, without rules, searches or state. A level
// always has the same strips, bit for bit, whether it is reached by splits or by collapses.
//
//   BakedPlayer player(mesh, records);                 // mesh: the base, coloured as it was baked
//   player.split(i, where, v_t);                       // record i, as the level grows
//   player.collapse(i, chord);                         // and as it shrinks
//
// The flips of a record are relative to the *plain* colouring, which is valid by itself. A split gives both halves of
// an edge that it cuts the colour of that edge, so that the inserted triangle continues that strip; all other new dual
// edges are dashed. For a collapse the same holds in reverse.
//
// Play records in order: the flips of a record fit only the state just before it. For records that are played out of
// order, and after any other change of the mesh, BakedPlayer falls back on the rules of operations.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/mesh.hpp"
#include "restrip/operations/join.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/rules/bits.hpp"

namespace restrip {

/// The flips of all records, one after the other. Each is a halfedge of the mesh after the split; a dual edge is named
/// once, by either of its halfedges.
template <class Halfedge>
struct BakedRecords {
  std::vector<Halfedge> flips;
  std::vector<std::uint32_t> first{0};  ///< of record i in `flips`; one more than records

  [[nodiscard]] std::size_t size() const noexcept { return first.size() - 1; }
  [[nodiscard]] std::span<const Halfedge> operator[](std::size_t record) const noexcept {
    return {flips.data() + first[record], flips.data() + first[record + 1]};
  }
};

namespace detail {

/// Records with more flips allocate a bit for each.
inline constexpr std::size_t flips_without_allocation = 512;

/// Flips colours, first the ones that become dashed; returns the increase in solid dual edges.
template <class Mesh>
int flip_colors(Mesh& mesh, std::span<const typename Mesh::Halfedge> flips) {
  Word few[flips_without_allocation / word_bits] = {};
  std::vector<Word> many;
  if (flips.size() > flips_without_allocation) many.resize(flips.size() / word_bits + 1, 0);
  const std::span<Word> done = many.empty() ? std::span<Word>(few) : std::span<Word>(many);
  int more = 0;
  for (std::size_t i = 0; i < flips.size(); ++i) {
    RESTRIP_ASSERT(knows(mesh, flips[i]), "flips of a baked record", describe(Refusal::no_such_edge));
    RESTRIP_ASSERT(!mesh.on_boundary(flips[i]) && !mesh.on_boundary(mesh.opposite(flips[i])), "flips of a baked record",
                   describe(Refusal::boundary_edge));
    if (!mesh.solid(flips[i])) continue;
    done[i / word_bits] |= bit(i % word_bits);
    mesh.set_solid(flips[i], false);
    --more;
  }
  for (std::size_t i = 0; i < flips.size(); ++i) {
    if (has(done[i / word_bits], i % word_bits)) continue;
    mesh.set_solid(flips[i], true);
    ++more;
  }
  return more;
}

/// Before a collapse: the two halves of an edge that is merged, on one side of the chord.
template <class Mesh>
struct FallingEdge {
  bool triangle = false;  ///< whether the chord has one on this side
  bool solid = false;
  typename Mesh::Halfedge before{};  ///< the halfedge before the joined one, in a triangle that stays

  FallingEdge(const Mesh& mesh, typename Mesh::Halfedge chord) {
    if (mesh.on_boundary(chord)) return;
    triangle = true;
    const auto half = mesh.next(chord);
    solid = mesh.solid(half);
    // The joined edge keeps the name of one of its halves, which only the mesh knows: find it from a neighbour that
    // stays.
    if (solid) before = mesh.next(mesh.next(mesh.opposite(half)));
  }
  void color(Mesh& mesh) const {
    if (solid) mesh.set_solid(mesh.next(before), true);
  }
};

}  // namespace detail

/// Splits a vertex, colours the mesh plainly and flips `flips`, halfedges of the mesh after the split. Preconditions:
/// as for split(), and the mesh is in the state for which the flips were baked; of the latter, debug builds check only
/// that each flip is a dual edge of the mesh. `name`: the new vertex, for meshes that let the caller name it. Takes the
/// time of the mesh operation, and is linear in the flips. Allocates only what the mesh needs to grow, and one bit for
/// each flip of a record with more than 512. After an exception the colouring is valid (mesh.hpp), but later flips no
/// longer fit it. `valence` and `isolated` of the result are 0, because counting them would take longer than the flips.
template <SplittableMesh Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_baked(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                             std::span<const typename Mesh::Halfedge> flips, Name... name) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(mesh, where, name...), "split_baked");
  using Spokes = typename VertexSplit<typename Mesh::Halfedge>::Spokes;
  const bool left = where.spokes != Spokes::right_only && mesh.solid(where.left);
  const bool right = where.spokes != Spokes::left_only && mesh.solid(where.right);
  const auto chord = mesh.insert_vertex(where, name...);
  const auto color_both_halves = [&mesh](typename Mesh::Halfedge side) {
    const auto half = mesh.next(side);
    mesh.set_solid(half, true);
    mesh.set_solid(mesh.next(half), true);
  };
  if (left) color_both_halves(chord);
  if (right) color_both_halves(mesh.opposite(chord));
  const int triangles = where.spokes == Spokes::both ? 2 : 1;
  return {{triangles - int{left} - int{right} - detail::flip_colors(mesh, flips), 0, 0}, chord, 0};
}

/// The inverse: flips `flips`, collapses the edge of `chord` = v_s -> v_t into v_s, and gives each merged edge the
/// colour that its halves then have. Preconditions and cost as above.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse_baked(Mesh& mesh, typename Mesh::Halfedge chord,
                                                std::span<const typename Mesh::Halfedge> flips) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(mesh, chord), "collapse_baked");
  const int more = detail::flip_colors(mesh, flips);
  const detail::FallingEdge<Mesh> left(mesh, chord);
  const detail::FallingEdge<Mesh> right(mesh, mesh.opposite(chord));
  const auto spoke = mesh.remove_vertex(chord);
  left.color(mesh);
  right.color(mesh);
  const int triangles = int{left.triangle} + int{right.triangle};
  return {{int{left.solid} + int{right.solid} - triangles - more, 0, 0}, spoke, 0};
}

/// Plays the records of one baked mesh, and knows whether their flips still fit.
///
/// In step, record `level()` may be split and record `level() - 1` collapsed, by their flips. Any other operation is
/// out of order. It is done by the rules (split_and_join, collapse_and_join), and so is every later one, because
/// colours and names then differ from the baked ones. The colouring stays valid, its strips get shorter as they do
/// under the rules, and the Rewrite is complete. To get back into step, restore the mesh and its colours to a baked
/// level (most easily the base) and call restart().
template <class Mesh>
requires SplittableMesh<Mesh> && CollapsibleMesh<Mesh>
class BakedPlayer {
 public:
  using Halfedge = typename Mesh::Halfedge;

  /// Mesh and records must outlive the player. `level`: records played so far.
  BakedPlayer(Mesh& mesh, const BakedRecords<Halfedge>& records, std::size_t level = 0) noexcept
      : mesh_(&mesh), records_(&records), level_(level) {}

  /// False once something was played out of order.
  [[nodiscard]] bool in_step() const noexcept { return in_step_; }
  /// Records played so far, while in step.
  [[nodiscard]] std::size_t level() const noexcept { return level_; }
  /// Whether this record may be split (collapsed) by its flips.
  [[nodiscard]] bool can_split(std::size_t record) const noexcept {
    return in_step_ && record == level_ && record < records_->size();
  }
  [[nodiscard]] bool can_collapse(std::size_t record) const noexcept { return in_step_ && record + 1 == level_; }

  /// After an exception the player is out of step.
  Rewrite<Halfedge> split(std::size_t record, const VertexSplit<Halfedge>& where, auto... name) {
    RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(*mesh_, where, name...), "BakedPlayer::split");
    if (can_split(record)) {
      leave_step();
      const auto done = split_baked(*mesh_, where, (*records_)[record], name...);
      restart(level_ + 1);
      return done;
    }
    leave_step();
    return split_and_join(*mesh_, where, name...);
  }
  Rewrite<Halfedge> collapse(std::size_t record, Halfedge chord) {
    RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(*mesh_, chord), "BakedPlayer::collapse");
    if (can_collapse(record)) {
      leave_step();
      const auto done = collapse_baked(*mesh_, chord, (*records_)[record]);
      restart(level_ - 1);
      return done;
    }
    leave_step();
    return collapse_and_join(*mesh_, chord);
  }

  /// Call before changing the mesh or its colours in any other way.
  void leave_step() noexcept { in_step_ = false; }
  /// Declares that the mesh and its colours are at this baked level again.
  void restart(std::size_t level = 0) noexcept {
    level_ = level;
    in_step_ = true;
  }

 private:
  Mesh* mesh_;
  const BakedRecords<Halfedge>* records_;
  std::size_t level_;
  bool in_step_ = true;
};

}  // namespace restrip
