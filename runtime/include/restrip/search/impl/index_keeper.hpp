// IndexKeeper, member by member. Included by index_keeper.hpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "restrip/search/index_keeper.hpp"

namespace restrip {

// ---- the place of an operation
inline void IndexKeeper::Place::add(Triangle t) noexcept {
  const auto end = triangles_.begin() + static_cast<std::ptrdiff_t>(count_);
  if (std::find(triangles_.begin(), end, t) == end) triangles_[count_++] = t;
}
inline void IndexKeeper::Place::add_neighbors(const StripMesh& mesh, Triangle t) noexcept {
  for (unsigned s = 0; s < 3; ++s)
    if (const Halfedge back = mesh.opposite(StripMesh::halfedge(t, s)); !StripMesh::on_boundary(back))
      add(StripMesh::triangle(back));
}

inline ColoringChange IndexKeeper::Place::counted(const StripMesh& mesh) const noexcept {
  ColoringChange count;
  count.strips = static_cast<int>(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    const Triangle t = triangles_[i];
    const unsigned solid = mesh.solid_sides(t);
    count.isolated += int{solid == 0};
    for (unsigned rest = solid; rest != 0; rest &= rest - 1) {
      const auto side = static_cast<unsigned>(std::countr_zero(rest));
      const Halfedge back = mesh.opposite(StripMesh::halfedge(t, side));
      const Triangle other = StripMesh::triangle(back);
      const auto first = triangles_.begin();
      if (std::find(first, first + static_cast<std::ptrdiff_t>(i), other) != first + static_cast<std::ptrdiff_t>(i))
        continue;  // counted there
      --count.strips;
      count.swaps += detail::is_swap(detail::other_sides(solid, side),
                                     detail::other_sides(mesh.solid_sides(other), StripMesh::side(back)));
    }
  }
  return count;
}

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

inline Rewrite<StripMesh::Halfedge> IndexKeeper::finish(Halfedge h, std::uint32_t valence) {
  change_ += descent_.run(*mesh_, start_, plan_.limits);
  strips_ += static_cast<std::size_t>(change_.strips);
  swaps_ += static_cast<std::size_t>(change_.swaps);
  isolated_ += static_cast<std::size_t>(change_.isolated);
  up_to_date_ = true;
  return {h, valence, change_.strips, change_.isolated};
}

inline Rewrite<StripMesh::Halfedge> IndexKeeper::split(const VertexSplit<Halfedge>& where, Vertex new_vertex) {
  using Spokes = VertexSplit<Halfedge>::Spokes;
  RESTRIP_ASSERT(check_split(*mesh_, where, new_vertex) == Refusal::granted, "IndexKeeper::split",
                 describe(check_split(*mesh_, where, new_vertex)));
  begin();
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  // A new triangle is put between two that follow each other, or between two that do not.
  const bool left_solid = has_left && mesh_->solid(where.left);
  const bool right_solid = has_right && mesh_->solid(where.right);

  const bool whole = plan_.from == DescentPlan::From::patch;
  if (left_solid) change_.swaps -= swap_at(where.left);
  if (right_solid) change_.swaps -= swap_at(where.right);
  detail::InteriorFan<Halfedge> fan;
  std::size_t valence = 0;
  Halfedge chord;
  if (has_left && has_right && detail::read_interior_fan(*mesh_, where.left, where.right, fan)) {
    valence = fan.k;
    if (whole)
      for (std::size_t i = 0; i < fan.k; ++i) start_.push_back(StripMesh::triangle(fan.spokes[i]));
    const std::span<const Halfedge> moved(fan.spokes + fan.a - 1, fan.k - fan.a);
    chord = mesh_->insert_vertex(where.left, where.right, moved, new_vertex);
  } else {
    fan_triangles(*mesh_, has_left ? where.left : where.right, start_);
    valence = start_.size();
    if (!whole) start_.clear();
    chord = mesh_->insert_vertex(where, new_vertex);
  }
  const Halfedge back = mesh_->opposite(chord);
  for (const auto& [inner, solid] : {std::pair{chord, left_solid}, {back, right_solid}}) {
    if (StripMesh::on_boundary(inner)) continue;
    start_.push_back(StripMesh::triangle(inner));
    if (!solid) {
      change_ += {1, 0, 1};
      continue;
    }
    const Halfedge first = StripMesh::next(inner);
    const Halfedge second = StripMesh::next(first);
    mesh_->set_solid(first, true);
    mesh_->set_solid(second, true);
  }
  for (const auto& [inner, solid] : {std::pair{chord, left_solid}, {back, right_solid}})
    if (solid) change_.swaps += swap_at(StripMesh::next(inner)) + swap_at(StripMesh::next(StripMesh::next(inner)));
  return finish(chord, static_cast<std::uint32_t>(valence));
}

inline Rewrite<StripMesh::Halfedge> IndexKeeper::collapse(Halfedge chord) {
  RESTRIP_ASSERT(check_collapse(*mesh_, chord) == Refusal::granted, "IndexKeeper::collapse",
                 describe(check_collapse(*mesh_, chord)));
  begin();
  // A strip that passes through a triangle that goes, from one of the sides that stay to the other, closes up. Other
  // strips are cut there.
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

  detail::InteriorFan<Halfedge> fan;
  Word ring = 0;
  Halfedge spoke;
  const bool interior = detail::read_ring(*mesh_, chord, fan, ring);
  if (interior)
    spoke = mesh_->remove_vertex(chord, std::span<const Halfedge>(fan.spokes + fan.a - 1, fan.k - fan.a));
  else
    spoke = mesh_->remove_vertex(chord);
  for (std::size_t i = 0; i < 2; ++i)
    if (passes[i]) mesh_->set_solid(joints[2 * i], true);
  for (std::size_t i = 0; i < 2; ++i)
    if (passes[i]) change_.swaps += swap_at(joints[2 * i]);
  const bool whole = plan_.from == DescentPlan::From::patch;
  if (!interior || whole) fan_triangles(*mesh_, spoke, start_);
  const std::size_t valence = interior ? fan.k : start_.size();
  if (!whole) {
    start_.clear();
    for (const Halfedge h : joints)
      if (h.id != none && !StripMesh::on_boundary(h)) start_.push_back(StripMesh::triangle(h));
  }
  return finish(spoke, static_cast<std::uint32_t>(valence));
}

inline Rewrite<StripMesh::Halfedge> IndexKeeper::flip(Halfedge h) {
  RESTRIP_ASSERT(check_flip(*mesh_, h) == Refusal::granted, "IndexKeeper::flip", describe(check_flip(*mesh_, h)));
  begin();
  start_.assign({StripMesh::triangle(h), StripMesh::triangle(mesh_->opposite(h))});
  Place place;
  for (const Triangle t : start_) place.add(t);
  for (const Triangle t : start_) place.add_neighbors(*mesh_, t);
  const ColoringChange before = place.counted(*mesh_);
  const Rewrite<Halfedge> done = restrip::flip(*mesh_, h);
  change_ = place.counted(*mesh_);
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
