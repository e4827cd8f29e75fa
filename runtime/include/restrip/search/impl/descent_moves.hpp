// Descent, member by member. Included by descent.hpp.
#pragma once

#include <algorithm>
#include <cstddef>

#include "restrip/search/impl/descent.hpp"

namespace restrip {
namespace detail {

/// The solid sides of a triangle other than `side`: bit 0 the next one, bit 1 the one before. So for a side of a strip
/// it says how the strip turns there: 1 or 2, or 0 if it ends.
constexpr unsigned other_sides(unsigned solid, unsigned side) noexcept {
  return (solid | solid << 3) >> (side + 1) & 3U;
}
/// The neighbour that is `turn` sides after h in its triangle, seen from there.
template <ColoredMesh Mesh>
typename Mesh::Halfedge neighbor_at(const Mesh& mesh, typename Mesh::Halfedge h, unsigned turn) {
  if constexpr (SidedMesh<Mesh>) {
    const unsigned side = StripMesh::side(h) + turn;
    return mesh.opposite(StripMesh::halfedge(StripMesh::triangle(h), side >= 3 ? side - 3 : side));
  }
  for (; turn > 0; --turn) h = mesh.next(h);
  return mesh.opposite(h);
}

/// A strip enters the triangle of h over h and turns there by `turn`, not 0: 1 when the edge by which it leaves is a
/// swap.
template <ColoredMesh Mesh>
int swap_beyond(const Mesh& mesh, typename Mesh::Halfedge h, unsigned turn) {
  return int{mesh.other_solid_sides(neighbor_at(mesh, h, turn)) == turn};
}

/// The colours of a few triangles after a move, and of all others as in the mesh.
template <SidedMesh Mesh>
class MoveOverlay {
 public:
  explicit MoveOverlay(const Mesh& mesh) noexcept : mesh_(&mesh) {}

  void change(StripMesh::Halfedge h, bool solid) noexcept {
    for (const StripMesh::Halfedge side : {h, mesh_->opposite(h)}) {
      const Triangle t = StripMesh::triangle(side);
      const std::size_t i = place_of(t);
      if (i == count_) {
        const unsigned colors = mesh_->solid_sides(t);
        entries_[count_++] = {t, colors, colors};
      }
      const unsigned bit = 1U << StripMesh::side(side);
      entries_[i].after = solid ? entries_[i].after | bit : entries_[i].after & ~bit;
    }
  }
  /// Swaps and isolated triangles.
  [[nodiscard]] ColoringChange difference() const noexcept {
    ColoringChange change;
    for (std::size_t i = 0; i < count_; ++i) {
      const Entry& entry = entries_[i];
      change.isolated += int{entry.after == 0} - int{entry.before == 0};
      for (unsigned s = 0; s < 3; ++s) {
        if (((entry.before | entry.after) >> s & 1U) == 0) continue;
        const StripMesh::Halfedge back = mesh_->opposite(StripMesh::halfedge(entry.triangle, s));
        const Triangle other = StripMesh::triangle(back);
        const std::size_t j = place_of(other);
        if (j < i) continue;  // counted there
        const unsigned colors = j < count_ ? 0 : mesh_->solid_sides(other);
        const unsigned before = j < count_ ? entries_[j].before : colors;
        const unsigned after = j < count_ ? entries_[j].after : colors;
        const auto swap = [&](unsigned here, unsigned there) {
          return (here >> s & 1U) != 0 ? is_swap(other_sides(here, s), other_sides(there, StripMesh::side(back))) : 0;
        };
        change.swaps += swap(entry.after, after) - swap(entry.before, before);
      }
    }
    return change;
  }

 private:
  struct Entry {
    Triangle triangle = none;
    unsigned before = 0;
    unsigned after = 0;
  };
  [[nodiscard]] std::size_t place_of(Triangle t) const noexcept {
    std::size_t i = 0;
    while (i < count_ && entries_[i].triangle != t) ++i;
    return i;
  }

  const Mesh* mesh_;
  std::size_t count_ = 0;
  std::array<Entry, 6> entries_{};
};

/// One way in which a triangle makes room for an edge.
struct EdgeWay {
  StripMesh::Halfedge given_up{};  // {none}: the triangle has room
  Triangle freed = none;           // across the edge that is cleared
  Triangle beyond = none;          // the next one beyond that
  Triangle kept = none;            // across the edge that is kept
  unsigned turn = 0;               // of the strip at the triangle, seen from the new edge
  int swaps = 0;
  int isolated = 0;
};

/// One triangle of a dashed edge.
struct EdgeEnd {
  std::array<EdgeWay, 2> way{};
  unsigned count = 0;
  int fewest_swaps = 0;  // of all ways
};

// The swaps and isolated triangles that change on this side of a new edge, independently of the other side. The new
// edge itself is not counted.
EdgeEnd end_of_edge(const SidedMesh auto& mesh, StripMesh::Halfedge h) {
  using Halfedge = StripMesh::Halfedge;
  EdgeEnd end;
  const unsigned others = mesh.other_solid_sides(h);
  if (others == 0) {
    end.count = 1;
    end.way[0].isolated = -1;
    return end;
  }
  // Seen from the edge to a neighbour, the strip turns to the other neighbour or, with the new edge, to the opposite.
  if (others != 3) {
    EdgeWay& way = end.way[0];
    end.count = 1;
    const Halfedge kept = neighbor_at(mesh, h, others);
    way.kept = StripMesh::triangle(kept);
    way.turn = others;
    way.swaps = int{mesh.other_solid_sides(kept) == others};
    end.fewest_swaps = way.swaps;
    return end;
  }
  end.count = 2;
  const std::array<Halfedge, 2> towards{neighbor_at(mesh, h, 1), neighbor_at(mesh, h, 2)};
  const std::array<unsigned, 2> turn{mesh.other_solid_sides(towards[0]), mesh.other_solid_sides(towards[1])};
  for (unsigned keeps = 1; keeps <= 2; ++keeps) {
    const unsigned gives = 3 - keeps;
    EdgeWay& way = end.way[keeps - 1];
    way.given_up = towards[gives - 1];
    way.freed = StripMesh::triangle(way.given_up);
    way.kept = StripMesh::triangle(towards[keeps - 1]);
    way.turn = keeps;
    // The freed triangle becomes an end, so it loses the swap on its other side, if any. (A turn of 0 leads back to the
    // triangle of h, whose turns are not 0.)
    const unsigned freed_turn = turn[gives - 1];
    const Halfedge across_freed = neighbor_at(mesh, way.given_up, freed_turn);
    way.beyond = StripMesh::triangle(across_freed);
    way.isolated = int{freed_turn == 0};
    way.swaps = int{turn[keeps - 1] == keeps} - int{turn[keeps - 1] == gives} - int{freed_turn == keeps} -
                int{mesh.other_solid_sides(across_freed) == freed_turn};
  }
  end.fewest_swaps = (std::min)(end.way[0].swaps, end.way[1].swaps);
  return end;
}

}  // namespace detail

std::span<const StripMove> Descent::moves_at(const SidedMesh auto& mesh, Triangle t, std::int32_t highest) {
  RESTRIP_ASSERT(mesh.alive(t), "Descent::moves_at", "the triangle is not one of this mesh");
  find_moves(mesh, t, highest, {});
  return {found_.begin(), found_.end()};
}

// `looked`: triangles whose moves are known to be useless.
void Descent::find_moves(const SidedMesh auto& mesh, Triangle t, std::int32_t highest,
                         std::span<const Triangle> looked) {
  found_.count = 0;
  const unsigned solid = mesh.solid_sides(t);
  for (unsigned dashed = 7U & ~solid; dashed != 0; dashed &= dashed - 1) {
    const Halfedge h = detail::lowest_side(t, dashed);
    const Halfedge back = mesh.opposite(h);
    if (StripMesh::on_boundary(back)) continue;
    const Triangle u = StripMesh::triangle(back);
    if (u == t || std::find(looked.begin(), looked.end(), u) != looked.end()) continue;
    const detail::EdgeEnd here = detail::end_of_edge(mesh, h);
    const int giving = int{here.count == 2} + int{mesh.other_solid_sides(back) == 3};
    // The other side saves at most three swaps, and at most two triangles stop being isolated.
    if (std::int32_t{cost_.restart} * (giving - 1) + std::int32_t{cost_.swap} * (here.fewest_swaps - 3) -
            2 * std::int32_t{cost_.isolated} >
        highest) {
      ++counts_.priced;
      continue;
    }
    const detail::EdgeEnd there = detail::end_of_edge(mesh, back);
    for (unsigned i = 0; i < here.count; ++i) {
      const detail::EdgeWay& a = here.way[i];
      // Two triangles that share two edges and follow each other already.
      if (a.kept == u || a.freed == u) break;
      for (unsigned j = 0; j < there.count; ++j) {
        const detail::EdgeWay& b = there.way[j];
        StripMove move{h, {a.given_up, b.given_up}};
        const bool entangled = (a.freed != none && (a.freed == b.freed || a.freed == b.kept || a.freed == b.beyond)) ||
                               (b.freed != none && b.freed == a.kept);
        if (entangled) {
          detail::MoveOverlay colors(mesh);
          for (const Halfedge g : move.given_up)
            if (g.id != none) colors.change(g, false);
          colors.change(h, true);
          move.change = colors.difference();
        } else {
          move.change.swaps = a.swaps + b.swaps + detail::is_swap(a.turn, b.turn);
          move.change.isolated = a.isolated + b.isolated;
        }
        move.change.strips = giving - 1;
        move.price = move.change.price(cost_);
        ++counts_.priced;
        found_.offer(move, highest);
      }
    }
  }
  // A cut saves at most three swaps.
  if (std::int32_t{cost_.restart} - 3 * std::int32_t{cost_.swap} > highest) return;
  for (unsigned rest = solid; rest != 0; rest &= rest - 1) {
    const Halfedge h = detail::lowest_side(t, rest);
    const Halfedge back = mesh.opposite(h);
    const unsigned turn = mesh.other_solid_sides(h);
    const unsigned turn_back = mesh.other_solid_sides(back);
    StripMove move{h, {}, {1, -detail::is_swap(turn, turn_back), int{turn == 0} + int{turn_back == 0}}};
    if (turn != 0) move.change.swaps -= detail::swap_beyond(mesh, h, turn);
    if (turn_back != 0) move.change.swaps -= detail::swap_beyond(mesh, back, turn_back);
    move.price = move.change.price(cost_);
    ++counts_.priced;
    found_.offer(move, highest);
  }
}

bool Descent::keeps_strips(const SidedMesh auto& mesh, const StripMove& move) {
  if (mesh.solid(move.edge)) return true;
  const Halfedge back = mesh.opposite(move.edge);
  const Triangle t = StripMesh::triangle(move.edge);
  const Triangle u = StripMesh::triangle(back);
  // The edges that the two triangles keep, seen from the other side.
  const auto kept = [&](Triangle triangle, Halfedge given_up) {
    unsigned solid = mesh.solid_sides(triangle);
    if (given_up.id != none) solid &= ~(1U << StripMesh::side(mesh.opposite(given_up)));
    return solid == 0 ? Halfedge{} : mesh.opposite(detail::lowest_side(triangle, solid));
  };
  Halfedge from_t = kept(t, move.given_up[0]);
  Halfedge from_u = kept(u, move.given_up[1]);
  if (from_t.id == none || from_u.id == none) return true;
  const Halfedge into_t = mesh.opposite(from_t);
  const Halfedge into_u = mesh.opposite(from_u);
  for (std::uint32_t n = 0; n < max_walk; ++n) {
    counts_.walked += 2;
    if (StripMesh::triangle(from_t) == u) return !(from_t == into_u);
    if (StripMesh::triangle(from_u) == t) return !(from_u == into_t);
    const auto next_t = mesh.strip_step(from_t);
    const auto next_u = mesh.strip_step(from_u);
    if (!next_t.continues || !next_u.continues) return true;
    from_t = next_t.in;
    from_u = next_u.in;
  }
  return false;  // neither walk has ended
}

void Descent::make(SidedMesh auto& mesh, const StripMove& move) {
  const bool adds = !mesh.solid(move.edge);
  for (const Halfedge h : move.given_up)
    if (h.id != none) mesh.set_solid(h, false);
  mesh.set_solid(move.edge, adds);
  looked_count_ = 0;
  ++counts_.made;
  done_ += move.change;
}

// The triangles of the edges that a move changes.
void Descent::touch(const SidedMesh auto& mesh, const StripMove& move) {
  const auto add = [&](Triangle t) {
    if (std::find(touched_.begin(), touched_.end(), t) == touched_.end()) touched_.push_back(t);
  };
  add(StripMesh::triangle(move.edge));
  add(StripMesh::triangle(mesh.opposite(move.edge)));
  for (const Halfedge h : move.given_up)
    if (h.id != none) add(StripMesh::triangle(h));
}

ColoringChange Descent::run(SidedMesh auto& mesh, std::span<const Triangle> from, const DescentLimits& limits) {
  done_ = {};
  looked_count_ = 0;
  queue_.assign(from.begin(), from.end());
  const std::uint64_t stop = counts_.priced + limits.moves;
  for (std::size_t head = 0; head < queue_.size() && counts_.priced < stop; ++head) {
    const Triangle t = queue_[head];
    touched_.clear();
    const auto looked = std::span<const Triangle>(looked_).first(looked_count_);
    if (std::find(looked.begin(), looked.end(), t) == looked.end()) {
      // The best move at t that lowers the cost, if any.
      find_moves(mesh, t, -1, looked);
      found_.sort();
      const StripMove* const best =
          std::find_if(found_.begin(), found_.end(), [&](const StripMove& move) { return keeps_strips(mesh, move); });
      if (best != found_.end()) {
        make(mesh, *best);
        touch(mesh, *best);
      } else if (looked_count_ < looked_.size()) {
        looked_[looked_count_++] = t;
      }
    }
    if (touched_.empty() && limits.tries != 0) {
      // A move that costs a little, and the best one after it, if together they lower the cost.
      find_moves(mesh, t, limits.worse, {});
      detail::FoundMoves first = found_;
      first.sort();
      std::uint32_t tries = 0;
      for (const StripMove& one : first) {
        if (tries == limits.tries) break;
        if (!keeps_strips(mesh, one)) continue;
        ++tries;
        make(mesh, one);
        touch(mesh, one);
        StripMove best;
        best.price = -one.price;
        for (const Triangle touched : touched_)
          for (const StripMove& two : moves_at(mesh, touched, best.price - 1))
            if (two.price < best.price && keeps_strips(mesh, two)) best = two;
        if (best.edge.id != none) {
          make(mesh, best);
          touch(mesh, best);
          break;
        }
        const bool added = mesh.solid(one.edge);
        mesh.set_solid(one.edge, !added);
        for (const Halfedge h : one.given_up)
          if (h.id != none) mesh.set_solid(h, true);
        done_ += {-one.change.strips, -one.change.swaps, -one.change.isolated};
        touched_.clear();
      }
    }
    queue_.insert(queue_.end(), touched_.begin(), touched_.end());
  }
  return done_;
}

}  // namespace restrip
