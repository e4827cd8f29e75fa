// Operations that pass the colours on as they are. Included by keeper.hpp.
//
// A new triangle on a solid dual edge lengthens the strip that it cuts; a strip that passes through a triangle that
// goes closes up; other operations follow their rules. What that changes is told, and where a search should begin.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/descent.hpp"
#include "restrip/search/impl/surroundings.hpp"

namespace restrip::detail {

/// The edges of a closed fan that are swaps. Two triangles that follow each other along the loop turn the same way when
/// both go on along the loop, or both leave it by their ports.
constexpr Word fan_swaps(std::size_t k, Word loop, Word ports) noexcept {
  return loop & ((turned_down(loop, 1, k) & turned_down(loop, k - 1, k)) | (ports & turned_down(ports, 1, k)));
}

/// The number of swaps on the inner edges of a ring with chord. A and D lie the other way round: where a strip goes on
/// along the ring they turn outwards, as fan triangles do by their ports.
constexpr int ring_swaps(std::size_t k, std::size_t a, Word inner, Word fan_ports) noexcept {
  const std::size_t n = k + 2;
  const Word ring = inner & low_bits(n);
  const Word inserted = bit(0) | bit(a + 1);
  const Word ports = (fan_ports & low_bits(a)) << 1 | (fan_ports >> a) << (a + 2);
  const Word chord = has(inner, k + 2) ? inserted : 0;
  const Word apart = inserted & ~chord;
  const Word before = turned_down(ring, n - 1, n);  // bit m: the edge before element m; bit m of ring: the one after it
  // Turning outwards or along, for an element whose solid edges are the one after it and another, or before it.
  const Word outwards_from = ports | (before & apart);
  const Word along_from = (before & ~inserted) | chord;
  const Word outwards_to = ports | (ring & apart);
  const Word along_to = (ring & ~inserted) | chord;
  const Word over_chord = (ring & before >> (a + 1)) | (before & ring >> (a + 1));
  return count_bits(
      (ring & ((outwards_from & turned_down(outwards_to, 1, n)) | (along_from & turned_down(along_to, 1, n)))) |
      (over_chord & chord & 1) << n);
}

/// Preconditions of its operations are those of operations.hpp.
template <NumberedMesh Mesh>
class PassedColors {
 public:
  using Halfedge = typename Mesh::Halfedge;

  /// `joints_only`: begin where strips do not go on, not at all triangles of the patch.
  void begin(bool joints_only) {
    change_ = {};
    start_.clear();
    joints_only_ = joints_only;
  }
  template <class... Name>
  Rewrite<Halfedge> split(Mesh& mesh, const VertexSplit<Halfedge>& where, Name... name);
  Rewrite<Halfedge> collapse(Mesh& mesh, Halfedge chord);
  /// An operation that recolours its patch by its rule instead: a step of keeper_steps.hpp.
  template <class Step>
  Rewrite<Halfedge> by_rules(Mesh& mesh, const Step& step);

  /// Since begin().
  [[nodiscard]] const ColoringChange& change() const noexcept { return change_; }
  [[nodiscard]] std::vector<Triangle>& start() noexcept { return start_; }

 private:
  // The strip over the mesh edge where a triangle has been inserted goes through it now.
  static void pass_through(Mesh& mesh, Halfedge inner) {
    const auto first = mesh.next(inner);
    mesh.set_solid(first, true);
    mesh.set_solid(mesh.next(first), true);
  }
  // A swap, if the edge is solid.
  static int swap_at(const Mesh& mesh, Halfedge h) { return mesh.solid(h) && restrip::is_swap(mesh, h) ? 1 : 0; }
  void start_at(const Mesh& mesh, Halfedge h) { start_.push_back(static_cast<Triangle>(mesh.triangle(h))); }
  template <class... Name>
  Rewrite<Halfedge> split_any(Mesh& mesh, const VertexSplit<Halfedge>& where, Name... name);
  Rewrite<Halfedge> collapse_any(Mesh& mesh, Halfedge chord);
  Rewrite<Halfedge> told(Halfedge h, std::size_t valence) const noexcept {
    return {h, static_cast<std::uint32_t>(valence), change_.strips, change_.isolated};
  }

  ColoringChange change_;
  bool joints_only_ = false;
  std::vector<Triangle> start_;
  Surroundings<Mesh> around_;
};

template <NumberedMesh Mesh>
template <class... Name>
Rewrite<typename Mesh::Halfedge> PassedColors<Mesh>::split(Mesh& mesh, const VertexSplit<Halfedge>& where,
                                                           Name... name) {
  InteriorChange<Halfedge> move;
  InteriorFan<Halfedge>& fan = move.fan;
  if (where.spokes != VertexSplit<Halfedge>::Spokes::both || !read_interior_fan(mesh, where.left, where.right, fan))
    return split_any(mesh, where, name...);
  // A new triangle is put between two that follow each other, or between two that do not.
  const auto [k, a] = std::pair{fan.k, fan.a};
  const bool left_solid = has(fan.loop, k - 1);
  const bool right_solid = has(fan.loop, a - 1);
  change_.strips = change_.isolated = 2 - int{left_solid} - int{right_solid};
  // A new triangle turns outwards, so that there is a swap where its neighbour's strip comes from a port.
  const Word cut = fan.loop & (bit(k - 1) | bit(a - 1));
  change_.swaps = count_bits(fan.ports & cut) + count_bits(turned_down(fan.ports, 1, k) & cut) -
                  count_bits(fan_swaps(k, fan.loop, fan.ports) & cut);
  if (!joints_only_)
    for (std::size_t i = 0; i < k; ++i) start_at(mesh, fan.spokes[i]);
  const auto in_fan = static_cast<std::ptrdiff_t>(start_.size());
  const auto chord = change_by_split(mesh, where, move, name...);
  for (const auto& [inner, solid] : {std::pair{chord, left_solid}, std::pair{mesh.opposite(chord), right_solid}}) {
    if (solid)
      pass_through(mesh, inner);
    else
      start_at(mesh, inner);
  }
  // What is new comes first.
  std::rotate(start_.begin(), start_.begin() + in_fan, start_.end());
  return told(chord, k);
}

// The same for open and large fans.
template <NumberedMesh Mesh>
template <class... Name>
Rewrite<typename Mesh::Halfedge> PassedColors<Mesh>::split_any(Mesh& mesh, const VertexSplit<Halfedge>& where,
                                                               Name... name) {
  using Spokes = typename VertexSplit<Halfedge>::Spokes;
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  const bool left_solid = has_left && mesh.solid(where.left);
  const bool right_solid = has_right && mesh.solid(where.right);
  if (left_solid) change_.swaps -= swap_at(mesh, where.left);
  if (right_solid) change_.swaps -= swap_at(mesh, where.right);
  fan_triangles(mesh, has_left ? where.left : where.right, start_);
  const std::size_t valence = start_.size();
  if (joints_only_) start_.clear();
  const auto chord = mesh.insert_vertex(where, name...);
  const std::array inserted{std::pair{chord, left_solid}, std::pair{mesh.opposite(chord), right_solid}};
  for (const auto& [inner, solid] : inserted) {
    if (mesh.on_boundary(inner)) continue;
    if (solid) {
      pass_through(mesh, inner);
    } else {
      start_at(mesh, inner);
      change_ += {1, 0, 1};
    }
  }
  for (const auto& [inner, solid] : inserted)
    if (solid) change_.swaps += swap_at(mesh, mesh.next(inner)) + swap_at(mesh, mesh.next(mesh.next(inner)));
  return told(chord, valence);
}

// A strip that passes through a triangle that goes, from one of the sides that stay to the other, closes up. Other
// strips are cut there.
template <NumberedMesh Mesh>
Rewrite<typename Mesh::Halfedge> PassedColors<Mesh>::collapse(Mesh& mesh, Halfedge chord) {
  InteriorChange<Halfedge> move;
  InteriorFan<Halfedge>& fan = move.fan;
  Word ring = 0;
  if (!read_ring(mesh, chord, fan, ring)) return collapse_any(mesh, chord);
  const auto [k, a] = std::pair{fan.k, fan.a};
  const auto back = mesh.opposite(chord);
  // The sides that stay, seen from the triangles that stay: t_{k-1}, t_0, t_{a-1} and t_a.
  const std::array<Halfedge, 4> joints{mesh.opposite(mesh.next(chord)), mesh.opposite(mesh.next(mesh.next(chord))),
                                       mesh.opposite(mesh.next(back)), mesh.opposite(mesh.next(mesh.next(back)))};
  const unsigned passes =
      static_cast<unsigned>(ring >> (k + 1) & ring & 1) | static_cast<unsigned>(ring >> a & ring >> (a + 1) & 1) << 1;
  const Word loop = fan.loop | Word{passes & 1U} << (k - 1) | Word{passes >> 1} << (a - 1);
  change_.strips = count_difference(ring, loop) - 2;
  change_.isolated = count_difference(isolated_closed(k, loop, fan.ports), isolated_ring(k, a, ring, fan.ports));
  change_.swaps = count_bits(fan_swaps(k, loop, fan.ports)) - ring_swaps(k, a, ring, fan.ports);
  // Ports whose strip is cut beside them.
  const Word left = passes & 1U ? 0 : (ring >> (k + 1) & fan.ports >> (k - 1) & 1) | (ring & fan.ports & 1) << 1;
  const Word right =
      passes >> 1 ? 0 : (ring >> a & fan.ports >> (a - 1) & 1) | (ring >> (a + 1) & fan.ports >> a & 1) << 1;
  for (Word rest = left | right << 2; rest != 0; rest &= rest - 1) {
    const Halfedge h = joints[static_cast<std::size_t>(std::countr_zero(rest))];
    change_.swaps -= swap_behind(mesh, h, solid_beside(mesh, h));
  }
  for (std::size_t i = 0; i < 4; ++i)
    if ((passes >> i / 2 & 1U) == 0) start_at(mesh, joints[i]);
  if (!joints_only_)
    for (std::size_t i = 0; i + 1 < k; ++i) start_at(mesh, fan.spokes[i]);
  const auto spoke = change_by_collapse(mesh, chord, move);
  if ((passes & 1U) != 0) mesh.set_solid(spoke, true);
  if (passes >> 1 != 0) mesh.set_solid(turn_ccw(mesh, a > 1 ? fan.spokes[a - 2] : spoke), true);
  return told(spoke, k);
}

// The same for open and large fans.
template <NumberedMesh Mesh>
Rewrite<typename Mesh::Halfedge> PassedColors<Mesh>::collapse_any(Mesh& mesh, Halfedge chord) {
  const auto cut = [&](Halfedge h) {
    change_ += cut_change(mesh, h);
    mesh.set_solid(h, false);
  };
  if (mesh.solid(chord)) cut(chord);
  struct Side {
    Halfedge joint{};  // the two sides that stay, seen from the triangles that stay
    Halfedge other_joint{};
    Halfedge before{};  // the halfedge before the first of them, which keeps its name
    bool passes = false;
  };
  std::array<Side, 2> sides;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto inner = i == 0 ? chord : mesh.opposite(chord);
    if (mesh.on_boundary(inner)) continue;
    const auto first = mesh.next(inner);
    const auto second = mesh.next(first);
    Side& side = sides[i];
    side.joint = mesh.opposite(first);
    side.other_joint = mesh.opposite(second);
    side.passes = mesh.solid(first) && mesh.solid(second);
    if (side.passes) side.before = mesh.next(mesh.next(side.joint));
    if (!side.passes) {
      if (mesh.solid(first)) cut(first);
      if (mesh.solid(second)) cut(second);
      change_ += {-1, 0, -1};
      if (joints_only_)
        for (const auto joint : {side.joint, side.other_joint})
          if (!mesh.on_boundary(joint)) start_at(mesh, joint);
    }
  }
  for (const Side& side : sides)
    if (side.passes) change_.swaps -= swap_at(mesh, side.joint) + swap_at(mesh, side.other_joint);
  const auto spoke = mesh.remove_vertex(chord);
  for (const Side& side : sides)
    if (side.passes) mesh.set_solid(mesh.next(side.before), true);
  for (const Side& side : sides)
    if (side.passes) change_.swaps += swap_at(mesh, mesh.next(side.before));
  std::size_t valence = 0;
  if (joints_only_) {
    valence = fan_size(mesh, spoke, spoke).triangles;
  } else {
    fan_triangles(mesh, spoke, start_);
    valence = start_.size();
  }
  return told(spoke, valence);
}

template <NumberedMesh Mesh>
template <class Step>
Rewrite<typename Mesh::Halfedge> PassedColors<Mesh>::by_rules(Mesh& mesh, const Step& step) {
  start_.clear();
  step.find_patch(mesh, start_);
  around_.clear();
  around_.add(start_);
  around_.add_neighbors(mesh);
  around_.count_before(mesh);
  const Rewrite<Halfedge> done = step.by_rules(mesh);
  step.find_new(mesh, done.halfedge, start_);
  around_.add(start_);
  change_ = around_.change(mesh);
  return told(done.halfedge, done.valence);
}

}  // namespace restrip::detail
