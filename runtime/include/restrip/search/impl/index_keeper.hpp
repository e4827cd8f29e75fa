// IndexKeeper, member by member. Included by index_keeper.hpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "restrip/search/index_keeper.hpp"

namespace restrip {

// ---- the surroundings of a flip
inline void IndexKeeper::Surroundings::add(Triangle t) noexcept {
  const auto end = triangles_.begin() + static_cast<std::ptrdiff_t>(count_);
  if (std::find(triangles_.begin(), end, t) == end) triangles_[count_++] = t;
}
inline void IndexKeeper::Surroundings::add_neighbors(const StripMesh& mesh, Triangle t) noexcept {
  for_each_neighbor(mesh, t, [this](Triangle u) { add(u); });
}

inline ColoringChange IndexKeeper::Surroundings::counted(const StripMesh& mesh) const noexcept {
  ColoringChange count;
  count.strips = static_cast<int>(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    const Triangle t = triangles_[i];
    const unsigned solid = mesh.solid_sides(t);
    count.isolated += int{solid == 0};
    for (unsigned rest = solid; rest != 0; rest &= rest - 1) {
      const Halfedge h = StripMesh::halfedge(t, static_cast<unsigned>(std::countr_zero(rest)));
      const Triangle other = StripMesh::triangle(mesh.opposite(h));
      const auto first = triangles_.begin();
      if (std::find(first, first + static_cast<std::ptrdiff_t>(i), other) != first + static_cast<std::ptrdiff_t>(i))
        continue;  // counted there
      --count.strips;
      count.swaps += int{is_swap(mesh, h)};
    }
  }
  return count;
}

namespace detail {

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

}  // namespace detail

// ---- operations
// One that ends by an exception leaves up_to_date_ false.
inline void IndexKeeper::begin() {
  if (!up_to_date_) rebuild();
  up_to_date_ = false;
  change_ = {};
  start_.clear();
}

// A swap, if the edge is solid.
inline int IndexKeeper::swap_at(Halfedge h) const { return mesh_->solid(h) && is_swap(*mesh_, h) ? 1 : 0; }

inline void IndexKeeper::start_at(Halfedge h) { start_.push_back(StripMesh::triangle(h)); }

inline Rewrite<StripMesh::Halfedge> IndexKeeper::finish(Halfedge h, std::uint32_t valence) {
  if (plan_.from == IndexPlan::From::ring) add_rings(*mesh_, start_, 1);
  change_ += search_.run(*mesh_, start_, plan_.limits);
  strips_ += static_cast<std::size_t>(change_.strips);
  swaps_ += static_cast<std::size_t>(change_.swaps);
  isolated_ += static_cast<std::size_t>(change_.isolated);
  up_to_date_ = true;
  return {h, valence, change_.strips, change_.isolated};
}

// ---- colours passed on

// The strip over the mesh edge where a triangle has been inserted goes through it now.
inline void IndexKeeper::pass_through(Halfedge inner) {
  const Halfedge first = StripMesh::next(inner);
  mesh_->set_solid(first, true);
  mesh_->set_solid(StripMesh::next(first), true);
}

inline Rewrite<StripMesh::Halfedge> IndexKeeper::split(const VertexSplit<Halfedge>& where, Vertex new_vertex) {
  using Spokes = VertexSplit<Halfedge>::Spokes;
  RESTRIP_ASSERT(check_split(*mesh_, where, new_vertex) == Refusal::granted, "IndexKeeper::split",
                 describe(check_split(*mesh_, where, new_vertex)));
  begin();
  detail::InteriorFan<Halfedge> fan;
  if (where.spokes != Spokes::both || !detail::read_interior_fan(*mesh_, where.left, where.right, fan))
    return split_any(where, new_vertex);
  // A new triangle is put between two that follow each other, or between two that do not.
  const auto [k, a] = std::pair{fan.k, fan.a};
  const bool left_solid = has(fan.loop, k - 1);
  const bool right_solid = has(fan.loop, a - 1);
  change_.strips = change_.isolated = 2 - int{left_solid} - int{right_solid};
  // A new triangle turns outwards, so that there is a swap where its neighbour's strip comes from a port.
  const Word cut = fan.loop & (bit(k - 1) | bit(a - 1));
  change_.swaps = count_bits(fan.ports & cut) + count_bits(detail::turned_down(fan.ports, 1, k) & cut) -
                  count_bits(detail::fan_swaps(k, fan.loop, fan.ports) & cut);
  const std::span<const Halfedge> moved(fan.spokes + a - 1, k - a);
  const Halfedge chord = mesh_->insert_vertex(where.left, where.right, moved, new_vertex);
  const Halfedge back = mesh_->opposite(chord);
  if (left_solid) pass_through(chord);
  if (right_solid) pass_through(back);
  if (!left_solid) start_at(chord);
  if (!right_solid) start_at(back);
  if (plan_.from != IndexPlan::From::joints)
    for (std::size_t i = 0; i < k; ++i) start_at(fan.spokes[i]);
  return finish(chord, static_cast<std::uint32_t>(k));
}

// split() in open and in large fans.
inline Rewrite<StripMesh::Halfedge> IndexKeeper::split_any(const VertexSplit<Halfedge>& where, Vertex new_vertex) {
  using Spokes = VertexSplit<Halfedge>::Spokes;
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  const bool left_solid = has_left && mesh_->solid(where.left);
  const bool right_solid = has_right && mesh_->solid(where.right);
  if (left_solid) change_.swaps -= swap_at(where.left);
  if (right_solid) change_.swaps -= swap_at(where.right);
  fan_triangles(*mesh_, has_left ? where.left : where.right, start_);
  const std::size_t valence = start_.size();
  if (plan_.from == IndexPlan::From::joints) start_.clear();
  const Halfedge chord = mesh_->insert_vertex(where, new_vertex);
  const std::array inserted{std::pair{chord, left_solid}, std::pair{mesh_->opposite(chord), right_solid}};
  for (const auto& [inner, solid] : inserted) {
    if (StripMesh::on_boundary(inner)) continue;
    if (solid) {
      pass_through(inner);
    } else {
      start_at(inner);
      change_ += {1, 0, 1};
    }
  }
  for (const auto& [inner, solid] : inserted)
    if (solid) change_.swaps += swap_at(StripMesh::next(inner)) + swap_at(StripMesh::next(StripMesh::next(inner)));
  return finish(chord, static_cast<std::uint32_t>(valence));
}

// A strip that passes through a triangle that goes, from one of the sides that stay to the other, closes up. Other
// strips are cut there.
inline Rewrite<StripMesh::Halfedge> IndexKeeper::collapse(Halfedge chord) {
  RESTRIP_ASSERT(check_collapse(*mesh_, chord) == Refusal::granted, "IndexKeeper::collapse",
                 describe(check_collapse(*mesh_, chord)));
  begin();
  detail::InteriorFan<Halfedge> fan;
  Word ring = 0;
  if (!detail::read_ring(*mesh_, chord, fan, ring)) return collapse_any(chord);
  const auto [k, a] = std::pair{fan.k, fan.a};
  const Halfedge back = mesh_->opposite(chord);
  // The sides that stay, seen from the triangles that stay: t_{k-1}, t_0, t_{a-1} and t_a.
  const std::array<Halfedge, 4> joints{
      mesh_->opposite(StripMesh::next(chord)), mesh_->opposite(StripMesh::next(StripMesh::next(chord))),
      mesh_->opposite(StripMesh::next(back)), mesh_->opposite(StripMesh::next(StripMesh::next(back)))};
  const unsigned passes =
      static_cast<unsigned>(ring >> (k + 1) & ring & 1) | static_cast<unsigned>(ring >> a & ring >> (a + 1) & 1) << 1;
  const Word loop = fan.loop | Word{passes & 1U} << (k - 1) | Word{passes >> 1} << (a - 1);
  change_.strips = count_difference(ring, loop) - 2;
  change_.isolated =
      count_difference(detail::isolated_closed(k, loop, fan.ports), detail::isolated_ring(k, a, ring, fan.ports));
  change_.swaps = count_bits(detail::fan_swaps(k, loop, fan.ports)) - detail::ring_swaps(k, a, ring, fan.ports);
  // Ports whose strip is cut beside them.
  const Word left = passes & 1U ? 0 : (ring >> (k + 1) & fan.ports >> (k - 1) & 1) | (ring & fan.ports & 1) << 1;
  const Word right =
      passes >> 1 ? 0 : (ring >> a & fan.ports >> (a - 1) & 1) | (ring >> (a + 1) & fan.ports >> a & 1) << 1;
  for (Word rest = left | right << 2; rest != 0; rest &= rest - 1) {
    const Halfedge h = joints[static_cast<std::size_t>(std::countr_zero(rest))];
    change_.swaps -= detail::swap_behind(*mesh_, h, mesh_->solid_beside(h));
  }
  const Halfedge spoke = mesh_->remove_vertex(chord, std::span<const Halfedge>(fan.spokes + a - 1, k - a));
  if ((passes & 1U) != 0) mesh_->set_solid(joints[0], true);
  if (passes >> 1 != 0) mesh_->set_solid(joints[2], true);
  for (std::size_t i = 0; i < 4; ++i)
    if ((passes >> i / 2 & 1U) == 0) start_at(joints[i]);
  if (plan_.from != IndexPlan::From::joints)
    for (std::size_t i = 0; i + 1 < k; ++i) start_at(fan.spokes[i]);
  return finish(spoke, static_cast<std::uint32_t>(k));
}

// collapse() onto open and large fans.
inline Rewrite<StripMesh::Halfedge> IndexKeeper::collapse_any(Halfedge chord) {
  std::array<Halfedge, 4> joints{};  // seen from the triangles that stay, two for each that goes
  std::array<bool, 2> passes{};
  const auto cut = [&](Halfedge h) {
    change_ += detail::cut_change(*mesh_, h);
    mesh_->set_solid(h, false);
  };
  if (mesh_->solid(chord)) cut(chord);
  for (std::size_t i = 0; i < 2; ++i) {
    const Halfedge inner = i == 0 ? chord : mesh_->opposite(chord);
    if (StripMesh::on_boundary(inner)) continue;
    const Halfedge first = StripMesh::next(inner);
    const Halfedge second = StripMesh::next(first);
    joints[2 * i] = mesh_->opposite(first);
    joints[2 * i + 1] = mesh_->opposite(second);
    passes[i] = mesh_->solid(first) && mesh_->solid(second);
    if (passes[i]) continue;
    if (mesh_->solid(first)) cut(first);
    if (mesh_->solid(second)) cut(second);
    change_ += {-1, 0, -1};
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (passes[i / 2]) change_.swaps -= swap_at(joints[i]);
  const Halfedge spoke = mesh_->remove_vertex(chord);
  for (std::size_t i = 0; i < 2; ++i)
    if (passes[i]) mesh_->set_solid(joints[2 * i], true);
  for (std::size_t i = 0; i < 2; ++i)
    if (passes[i]) change_.swaps += swap_at(joints[2 * i]);
  fan_triangles(*mesh_, spoke, start_);
  const std::size_t valence = start_.size();
  if (plan_.from == IndexPlan::From::joints) {
    start_.clear();
    for (std::size_t i = 0; i < 4; ++i)
      if (joints[i].id != none && !StripMesh::on_boundary(joints[i]) && !passes[i / 2]) start_at(joints[i]);
  }
  return finish(spoke, static_cast<std::uint32_t>(valence));
}

inline Rewrite<StripMesh::Halfedge> IndexKeeper::flip(Halfedge h) {
  RESTRIP_ASSERT(check_flip(*mesh_, h) == Refusal::granted, "IndexKeeper::flip", describe(check_flip(*mesh_, h)));
  begin();
  start_.assign({StripMesh::triangle(h), StripMesh::triangle(mesh_->opposite(h))});
  Surroundings around;
  for (const Triangle t : start_) around.add(t);
  for (const Triangle t : start_) around.add_neighbors(*mesh_, t);
  const ColoringChange before = around.counted(*mesh_);
  const Rewrite<Halfedge> done = restrip::flip(*mesh_, h);
  change_ = around.counted(*mesh_);
  change_ += {-before.strips, -before.swaps, -before.isolated};
  return finish(done.halfedge, done.valence);
}

inline std::size_t IndexKeeper::improve(std::size_t budget) {
  begin();
  const std::uint64_t stop = descent_.counts().priced + budget;
  ColoringChange sum;
  constexpr std::size_t at_once = 256;
  std::size_t left = mesh_->triangle_bound();
  while (left > 0 && descent_.counts().priced < stop) {
    start_.clear();
    for (; left > 0 && start_.size() < at_once; --left) {
      if (next_ >= mesh_->triangle_bound()) next_ = 0;
      if (mesh_->alive(next_)) start_.push_back(next_);
      ++next_;
    }
    const auto moves = static_cast<std::uint32_t>(std::min<std::uint64_t>(stop - descent_.counts().priced, 1U << 20));
    sum += descent_.run(*mesh_, start_, {.moves = moves, .tries = 4, .worse = 1});
  }
  const std::size_t before = cost();
  strips_ += static_cast<std::size_t>(sum.strips);
  swaps_ += static_cast<std::size_t>(sum.swaps);
  isolated_ += static_cast<std::size_t>(sum.isolated);
  change_ = sum;
  up_to_date_ = true;
  return before - cost();
}

inline void IndexKeeper::rebuild() {
  up_to_date_ = false;
  strips_ = count_strips(*mesh_);
  swaps_ = isolated_ = 0;
  for (Triangle t = 0; t < mesh_->triangle_bound(); ++t) {
    if (!mesh_->alive(t)) continue;
    const unsigned solid = mesh_->solid_sides(t);
    isolated_ += solid == 0 ? 1 : 0;
    for (unsigned rest = solid; rest != 0; rest &= rest - 1) {
      const Halfedge h = StripMesh::halfedge(t, static_cast<unsigned>(std::countr_zero(rest)));
      if (h.id < mesh_->opposite(h).id && is_swap(*mesh_, h)) ++swaps_;
    }
  }
  up_to_date_ = true;
}

}  // namespace restrip
