// Tunnel, member by member. Included by tunnel.hpp.
#pragma once

#include <algorithm>
#include <bit>

#include "restrip/search/tunnel.hpp"

namespace restrip {

template <SidedMesh Mesh>
bool Tunnel::join(Mesh& mesh, StripLocator& locator, Triangle end, std::uint32_t max_states, OnFailure on_failure) {
  RESTRIP_ASSERT(mesh.alive(end) && locator.knows(end), "Tunnel::join",
                 "the triangle is not one of this mesh, or the locator does not know it");
  if (max_states == 0 || locator.strips() < 2 || mesh.solid_degree(end) > 1) return false;
  ++counts_.searches;
  max_states_ = max_states;
  start(mesh, locator, end);
  bool joined = false;
  for (std::uint32_t s = 0; s < states_.size() && (s == 0 || states_.size() < max_states) && !joined; ++s) {
    joined = expand(mesh, locator, s);
  }
  counts_.states += states_.size();
  counts_.joined += joined ? 1U : 0U;
  if (joined) return true;
  if (on_failure == OnFailure::wander) commit(mesh, locator, static_cast<std::uint32_t>(states_.size() - 1));
  return false;
}

template <SidedMesh Mesh>
void Tunnel::start(const Mesh& mesh, const StripLocator& locator, Triangle end) {
  if (seen_.size() < mesh.triangle_bound()) seen_.resize(mesh.triangle_bound(), 0);
  if (++search_ == 0) {
    std::fill(seen_.begin(), seen_.end(), 0U);
    search_ = 1;
  }
  states_.clear();
  used_ = 0;
  start_ = end;
  seen_[end] = search_;
  const StripLocator::Position at = locator.position(end);
  bool down = false;
  for (unsigned s = 0; s < 3; ++s) {
    const Halfedge h = StripMesh::halfedge(end, s);
    if (mesh.solid(h)) down = locator.position(StripMesh::triangle(mesh.opposite(h))).order < at.order;
  }
  states_.push_back({none, {}, {}, 0, 0, at.strip, false});
  *room_for(states_.back(), 1, 1) = {down ? 0 : at.order, down ? at.order : ~Order{0}, at.strip,
                                     (down ? Piece::down_flag : 0U) | Piece::last_flag};
}

// The sides over which a move may go. The side of the cut is not among them: its colour is still solid.
template <SidedMesh Mesh>
unsigned Tunnel::dashed_sides(const Mesh& mesh, Triangle t) noexcept {
  return 7U & ~mesh.solid_sides(t);
}
inline StripMesh::Halfedge Tunnel::lowest(Triangle t, unsigned sides) noexcept {
  return StripMesh::halfedge(t, static_cast<unsigned>(std::countr_zero(sides)));
}

// Adds a state, unless its end was already reached. True when the new end lies next to the end of another strip, and
// the two have been joined: most searches end here, so looking ahead spares expanding half of all states.
template <SidedMesh Mesh>
bool Tunnel::reach(Mesh& mesh, StripLocator& locator, const State& state) {
  const Triangle y = StripMesh::triangle(state.cut);
  if (seen_[y] == search_ || states_.size() >= max_states_) return false;
  seen_[y] = search_;
  const auto s = static_cast<std::uint32_t>(states_.size());
  states_.push_back(state);
  for (unsigned dashed = dashed_sides(mesh, y); dashed != 0; dashed &= dashed - 1) {
    const Halfedge join = lowest(y, dashed);
    const Halfedge there = mesh.opposite(join);
    if (StripMesh::on_boundary(there)) continue;
    const Triangle x = StripMesh::triangle(there);
    if (mesh.solid_degree(x) > 1) continue;
    lay_out(s);
    if (move(mesh, locator, s, join, x)) return true;
  }
  return false;
}

// All moves from a state. True when one of them has joined two strips.
template <SidedMesh Mesh>
bool Tunnel::expand(Mesh& mesh, StripLocator& locator, std::uint32_t s) {
  if (s != 0) lay_out(s);
  const Triangle end = s == 0 ? start_ : StripMesh::triangle(states_[s].cut);
  for (unsigned dashed = dashed_sides(mesh, end); dashed != 0; dashed &= dashed - 1) {
    const Halfedge join = lowest(end, dashed);
    const Halfedge there = mesh.opposite(join);
    if (!StripMesh::on_boundary(there) && move(mesh, locator, s, join, StripMesh::triangle(there))) return true;
  }
  return false;
}

// The moves over one dashed edge, to x.
template <SidedMesh Mesh>
bool Tunnel::move(Mesh& mesh, StripLocator& locator, std::uint32_t s, Halfedge join, Triangle x) {
  Neighbor next[3];  // two, if the colouring is valid
  unsigned n = 0;
  bool seen_all = true;
  for (unsigned solid = mesh.solid_sides(x); solid != 0; solid &= solid - 1) {
    next[n].towards_x = mesh.opposite(lowest(x, solid));
    seen_all = seen_all && seen_[StripMesh::triangle(next[n].towards_x)] == search_;
    ++n;
  }
  if (seen_all && n > 1) return false;
  const StripLocator::Position at = locator.position(x);
  for (unsigned i = 0; i < n; ++i) next[i].order = locator.position(StripMesh::triangle(next[i].towards_x)).order;

  const Piece* const pieces = pieces_.data() + states_[s].pieces;
  const std::uint32_t total = states_[s].total;
  const std::uint32_t current = states_[s].current;
  std::uint32_t f = 0;
  while (f < total && (pieces[f].strip != at.strip || !pieces[f].has(at.order))) ++f;
  if (f == total) {  // a strip that no move has touched
    if (n < 2) {
      commit(mesh, locator, s, join);
      return true;
    }
    for (unsigned i = 0; i < n; ++i)
      if (reach(mesh, locator, {s, join, next[i].towards_x, at.order, next[i].order, at.strip, false})) return true;
    return false;
  }
  // Solid edges that the moves have cut are ignored.
  const Piece piece = pieces[f];
  unsigned kept = 0;
  for (unsigned i = 0; i < n; ++i)
    if (piece.has(next[i].order)) next[kept++] = next[i];
  if (f < current) {
    // An earlier move may have made this very edge solid: then x comes next on the path.
    if (f == 1 && pieces[0].low == pieces[0].high && piece.front() == at.order) return false;
    for (unsigned i = 0; i < kept; ++i)
      if ((next[i].order > at.order) == piece.down() &&
          reach(mesh, locator, {s, join, next[i].towards_x, at.order, next[i].order, f, true}))
        return true;
    return false;
  }
  const bool joined_in_front = f > current && !pieces[f - 1].last() && piece.front() == at.order;
  const bool joined_at_back = !piece.last() && piece.back() == at.order;
  if (kept + (joined_in_front ? 1U : 0U) + (joined_at_back ? 1U : 0U) < 2) {
    commit(mesh, locator, s, join);
    return true;
  }
  for (unsigned i = 0; i < kept; ++i)
    if (reach(mesh, locator, {s, join, next[i].towards_x, at.order, next[i].order, f, true})) return true;
  return false;
}

// Computes the paths of a state from the paths of its parent.
inline void Tunnel::lay_out(std::uint32_t s) {
  const State& state = states_[s];
  if (state.total != 0) return;
  if (!state.touched)
    change_over_whole(s);
  else if (state.where < states_[state.parent].current)
    rotate(s);
  else
    change_over(s);
}

inline Tunnel::Piece* Tunnel::room_for(State& state, std::uint32_t current, std::uint32_t total) {
  state.pieces = used_;
  state.current = current;
  state.total = total;
  used_ += total;
  if (used_ > pieces_.size()) pieces_.resize(std::max<std::size_t>(used_, pieces_.size() * 2 + 64));
  return pieces_.data() + state.pieces;
}

// x is on the path of the end: the part before x is reversed.
inline void Tunnel::rotate(std::uint32_t s) {
  State& state = states_[s];
  const State& parent = states_[state.parent];
  Piece* out = room_for(state, parent.current + 1, parent.total + 1);
  const Piece* const old = pieces_.data() + parent.pieces;
  const std::uint32_t f = state.where;
  const bool down = old[f].down();
  *out++ = old[f].from(state.y, down).turned();
  for (std::uint32_t i = f; i-- > 0;) *out++ = old[i].turned();
  *out++ = old[f].from(state.x, !down);
  for (std::uint32_t i = f + 1; i < parent.total; ++i) *out++ = old[i];
}

// x is on a strip that was still whole. The part of it that x stays with is joined to the path so far; the other part,
// which begins at y, is the path from now on.
inline void Tunnel::change_over_whole(std::uint32_t s) {
  State& state = states_[s];
  const State& parent = states_[state.parent];
  Piece* out = room_for(state, 1, parent.total + 2);
  const Piece* const old = pieces_.data() + parent.pieces;
  constexpr Order top = ~Order{0};
  const bool y_lower = state.y < state.x;
  *out++ = {y_lower ? 0 : state.y, y_lower ? state.y : top, state.where,
            (y_lower ? Piece::down_flag : 0U) | Piece::last_flag};
  for (std::uint32_t i = parent.current; i-- > 0;) *out++ = old[i].turned();
  *out++ = {y_lower ? state.x : 0, y_lower ? top : state.x, state.where,
            (y_lower ? 0U : Piece::down_flag) | Piece::last_flag};
  for (std::uint32_t i = parent.current; i < parent.total; ++i) *out++ = old[i];
}

// The pieces after a move to an x on a path that earlier moves have put together: pieces first ... last of the parent.
inline void Tunnel::change_over(std::uint32_t s) {
  State& state = states_[s];
  const State& parent = states_[state.parent];
  const std::uint32_t at = state.where;
  std::uint32_t first = at;
  std::uint32_t last = at;
  {
    const Piece* const old = pieces_.data() + parent.pieces;
    while (first > parent.current && !old[first - 1].last()) --first;
    while (!old[last].last()) ++last;
  }
  const bool y_lower = state.y < state.x;
  const bool y_in_front = y_lower != pieces_[parent.pieces + at].down();
  Piece* out = room_for(state, 1 + (y_in_front ? at - first : last - at), parent.total + 1);
  const Piece* const old = pieces_.data() + parent.pieces;
  const auto front_backwards = [&] {
    for (std::uint32_t i = at; i-- > first;) *out++ = old[i].turned();
  };
  const auto rest_forwards = [&] {
    for (std::uint32_t i = at + 1; i <= last; ++i) *out++ = old[i];
  };
  const Piece freed = old[at].from(state.y, !y_lower);
  const Piece stays = old[at].from(state.x, y_lower);
  if (y_in_front) {
    *out++ = freed.turned();
    front_backwards();
  } else {
    *out++ = freed;
    rest_forwards();
  }
  out[-1].flags |= Piece::last_flag;
  for (std::uint32_t i = parent.current; i-- > 0;) *out++ = old[i].turned();
  if (y_in_front) {
    *out++ = stays;
    rest_forwards();
  } else {
    *out++ = stays.turned();
    front_backwards();
  }
  out[-1].flags |= Piece::last_flag;
  for (std::uint32_t i = parent.current; i < first; ++i) *out++ = old[i];
  for (std::uint32_t i = last + 1; i < parent.total; ++i) *out++ = old[i];
}

template <SidedMesh Mesh>
void Tunnel::cut(Mesh& mesh, StripLocator& locator, Halfedge h) {
  locator.cut(mesh, h);
  for (const Halfedge side : {h, mesh.opposite(h)})
    counts_.isolated += mesh.solid_degree(StripMesh::triangle(side)) == 0 ? 1 : 0;
}

template <SidedMesh Mesh>
void Tunnel::link(Mesh& mesh, StripLocator& locator, Halfedge h) {
  for (const Halfedge side : {h, mesh.opposite(h)})
    counts_.isolated -= mesh.solid_degree(StripMesh::triangle(side)) == 0 ? 1 : 0;
  locator.link(mesh, h);
  ++counts_.moves;
}

// Makes the moves that lead to a state; each leaves a valid colouring.
template <SidedMesh Mesh>
void Tunnel::commit(Mesh& mesh, StripLocator& locator, std::uint32_t s) {
  chain_.clear();
  for (; states_[s].parent != none; s = states_[s].parent) chain_.push_back(s);
  for (auto step = chain_.rbegin(); step != chain_.rend(); ++step) {
    cut(mesh, locator, states_[*step].cut);
    link(mesh, locator, states_[*step].join);
  }
}

template <SidedMesh Mesh>
void Tunnel::commit(Mesh& mesh, StripLocator& locator, std::uint32_t s, Halfedge last_join) {
  commit(mesh, locator, s);
  link(mesh, locator, last_join);
}

}  // namespace restrip
