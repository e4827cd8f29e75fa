// Tunnelling: joins two strips by a chain of alternating moves.
//
// From the end u of a strip go over a dashed edge to a triangle x, set that edge, and clear a solid edge (x, y): y is
// the new end. If x lies on u's strip, y must be the neighbour of x on u's side (a Pósa rotation); if x lies on another
// strip, y may be either neighbour. No move adds a strip or closes a cycle. If x is itself an end of another strip, no
// edge is cleared, and two strips have become one. (Pósa, "Hamiltonian circuits in random graphs", 1976; Stewart,
// "Tunneling for triangle strips in continuous level-of-detail meshes", 2001; Porcu, Scateni, "An iterative
// stripification algorithm based on dual graph operations", 2003.)
//
// The search simulates such chains breadth-first. A state is a list of *pieces*, stretches of the strips as the locator
// knows them, in the order in which the moves so far would join them. No triangle becomes the new end twice, so a
// search of n states has examined n different ends. If one triangle in d is an end, it takes about d states to find
// one. Only a successful chain, the shortest of those tried, changes colours and locator, or, on request, the chain to
// one state of a search that fails.
#include "search/tunnel.hpp"

#include <algorithm>
#include <tuple>

#include "search/sides.hpp"

namespace restrip {

using detail::lowest_side;

bool Tunnel::join(StripMesh& mesh, StripLocator& locator, Triangle end, std::uint32_t max_states,
                  OnFailure on_failure) {
  RESTRIP_ASSERT(mesh.alive(end) && locator.knows(end), "Tunnel::join",
                 "the triangle is not one of this mesh, or the locator does not know it");
  if (max_states == 0 || locator.strips() < 2 || mesh.solid_degree(end) > 1) return false;
  ++counts_.searches;
  max_states_ = max_states;
  if (seen_.size() < mesh.triangle_bound()) seen_.resize(mesh.triangle_bound(), 0);
  if (++search_ == 0) {
    std::fill(seen_.begin(), seen_.end(), 0U);
    search_ = 1;
  }
  states_.clear();
  used_ = 0;
  seen_[end] = search_;
  const StripLocator::Position at = locator.position(end);
  const bool down = at.order != 0;
  states_.push_back({none, {}, {}, 0, 0, at.strip, false});
  *room_for(states_.back(), 1) = {down ? 0 : at.order, down ? at.order : ~Order{0}, at.strip,
                                  (down ? Piece::down_flag : 0U) | Piece::last_flag};
  states_.back().current = 1;
  bool joined = false;
  for (std::uint32_t s = 0; s < states_.size() && (s == 0 || states_.size() < max_states) && !joined; ++s) {
    lay_out(s);
    const Triangle last = s == 0 ? end : StripMesh::triangle(states_[s].cut);
    // The side of the cut is not among the sides over which a move may go: its colour is still solid.
    for (unsigned dashed = 7U & ~mesh.solid_sides(last); dashed != 0 && !joined; dashed &= dashed - 1) {
      const Halfedge join = lowest_side(last, dashed);
      const Halfedge there = mesh.opposite(join);
      joined = !StripMesh::on_boundary(there) && move(mesh, locator, s, join, StripMesh::triangle(there));
    }
  }
  counts_.states += states_.size();
  counts_.joined += joined ? 1U : 0U;
  if (joined) return true;
  if (on_failure == OnFailure::wander) commit(mesh, locator, static_cast<std::uint32_t>(states_.size() - 1));
  return false;
}

// Adds a state, unless its end was already reached. True when the new end lies next to the end of another strip, and
// the two have been joined: most searches end here, so looking ahead spares expanding half of all states.
bool Tunnel::reach(StripMesh& mesh, StripLocator& locator, const State& state) {
  const Triangle y = StripMesh::triangle(state.cut);
  if (seen_[y] == search_ || states_.size() >= max_states_) return false;
  seen_[y] = search_;
  const auto s = static_cast<std::uint32_t>(states_.size());
  states_.push_back(state);
  for (unsigned dashed = 7U & ~mesh.solid_sides(y); dashed != 0; dashed &= dashed - 1) {
    const Halfedge join = lowest_side(y, dashed);
    const Halfedge there = mesh.opposite(join);
    if (StripMesh::on_boundary(there)) continue;
    const Triangle x = StripMesh::triangle(there);
    if (mesh.solid_degree(x) > 1) continue;
    lay_out(s);
    if (move(mesh, locator, s, join, x)) return true;
  }
  return false;
}

// The moves over one dashed edge, to x. True when one of them has joined two strips.
bool Tunnel::move(StripMesh& mesh, StripLocator& locator, std::uint32_t s, Halfedge join, Triangle x) {
  // A triangle next to x in its strip: the halfedge that leads from it to x.
  struct Neighbor {
    Halfedge towards_x;
    Order order = 0;
  };
  Neighbor next[3];  // two, if the colouring is valid
  unsigned n = 0;
  bool seen_all = true;
  for (unsigned solid = mesh.solid_sides(x); solid != 0; solid &= solid - 1) {
    next[n].towards_x = mesh.opposite(lowest_side(x, solid));
    seen_all = seen_all && seen_[StripMesh::triangle(next[n].towards_x)] == search_;
    ++n;
  }
  if (seen_all && n > 1) return false;
  StripLocator::Position at;
  if (n == 0) {
    at = locator.position(x);
  } else {
    std::tie(at, next[0].order) = locator.position(x, StripMesh::triangle(next[0].towards_x));
    next[1].order = 2 * at.order - next[0].order;  // on the other side, if at all
  }

  const Piece* const pieces = pieces_.data() + states_[s].pieces;
  const std::uint32_t total = states_[s].total;
  const std::uint32_t current = states_[s].current;
  std::uint32_t f = 0;
  while (f < total && (pieces[f].strip != at.strip || !pieces[f].has(at.order))) ++f;
  const bool touched = f < total;  // an earlier move is in the strip of x
  const bool own = f < current;    // it is on the path of the end
  const Piece piece = touched ? pieces[f] : Piece::whole(at.strip);
  // Solid edges that the moves have cut are ignored.
  unsigned kept = 0;
  for (unsigned i = 0; i < n; ++i)
    if (piece.has(next[i].order) && (!own || (next[i].order > at.order) == piece.down())) next[kept++] = next[i];
  if (own) {
    // An earlier move may have made this very edge solid: then x comes next on the path.
    if (f == 1 && pieces[0].low == pieces[0].high && piece.front() == at.order) return false;
  } else {
    const bool joined_in_front = touched && f > current && !pieces[f - 1].last() && piece.front() == at.order;
    const bool joined_at_back = !piece.last() && piece.back() == at.order;
    if (kept + (joined_in_front ? 1U : 0U) + (joined_at_back ? 1U : 0U) < 2) {
      commit(mesh, locator, s, join);
      return true;
    }
  }
  for (unsigned i = 0; i < kept; ++i)
    if (reach(mesh, locator, {s, join, next[i].towards_x, at.order, next[i].order, touched ? f : at.strip, touched}))
      return true;
  return false;
}

Tunnel::Piece* Tunnel::room_for(State& state, std::uint32_t total) {
  state.pieces = used_;
  state.total = total;
  used_ += total;
  if (used_ > pieces_.size()) pieces_.resize(std::max<std::size_t>(used_, pieces_.size() * 2 + 64));
  return pieces_.data() + state.pieces;
}

// Computes the paths of a state from the paths of its parent.
void Tunnel::lay_out(std::uint32_t s) {
  State& state = states_[s];
  if (state.total != 0) return;
  const State& parent = states_[state.parent];
  Piece* out = room_for(state, parent.total + (state.touched ? 1U : 2U));
  const Piece* const old = pieces_.data() + parent.pieces;
  const Piece piece = state.touched ? old[state.where] : Piece::whole(state.where);
  if (state.touched && state.where < parent.current) {
    // x is on the path of the end: the part before x is reversed.
    state.current = parent.current + 1;
    *out++ = piece.from(state.y, piece.down()).turned();
    for (std::uint32_t i = state.where; i-- > 0;) *out++ = old[i].turned();
    *out++ = piece.from(state.x, !piece.down());
    for (std::uint32_t i = state.where + 1; i < parent.total; ++i) *out++ = old[i];
    return;
  }
  // x is on another path: a whole strip, or pieces first ... last of the parent, which earlier moves have put together.
  // The part of it that x stays with is joined to the path so far; the other part, which begins at y, is the path from
  // now on.
  const std::uint32_t at = state.touched ? state.where : parent.total;
  std::uint32_t first = at;
  std::uint32_t last = at;
  if (state.touched) {
    while (first > parent.current && !old[first - 1].last()) --first;
    while (!old[last].last()) ++last;
  }
  const auto front_backwards = [&] {
    for (std::uint32_t i = at; i-- > first;) *out++ = old[i].turned();
  };
  const auto rest_forwards = [&] {
    for (std::uint32_t i = at + 1; i <= last; ++i) *out++ = old[i];
  };
  const bool y_lower = state.y < state.x;
  const bool y_in_front = y_lower != piece.down();
  const Piece freed = piece.from(state.y, !y_lower);
  const Piece stays = piece.from(state.x, y_lower);
  state.current = 1 + (y_in_front ? at - first : last - at);
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

// Makes the moves that lead to a state, and then `last_join`, if any; each leaves a valid colouring.
void Tunnel::commit(StripMesh& mesh, StripLocator& locator, std::uint32_t s, Halfedge last_join) {
  const auto link = [&](Halfedge h) {
    for (const Halfedge side : {h, mesh.opposite(h)})
      counts_.isolated -= mesh.solid_degree(StripMesh::triangle(side)) == 0 ? 1 : 0;
    locator.link(mesh, h);
    ++counts_.moves;
  };
  chain_.clear();
  for (; states_[s].parent != none; s = states_[s].parent) chain_.push_back(s);
  for (auto step = chain_.rbegin(); step != chain_.rend(); ++step) {
    const Halfedge cut = states_[*step].cut;
    locator.cut(mesh, cut);
    for (const Halfedge side : {cut, mesh.opposite(cut)})
      counts_.isolated += mesh.solid_degree(StripMesh::triangle(side)) == 0 ? 1 : 0;
    link(states_[*step].join);
  }
  if (last_join.id != none) link(last_join);
}

// ---- rounds

std::size_t TunnelRounds::run(StripMesh& mesh, StripLocator& locator, Tunnel& tunnel, std::size_t budget,
                              std::size_t enough, const std::function<bool(Triangle)>& worth, detail::Poll* poll) {
  const std::size_t before = tunnel.counts().states;
  std::size_t passed = 0;
  const auto spent = [&] { return tunnel.counts().states - before + passed / 64; };
  while (locator.strips() > enough && spent() < budget) {
    if (next_ >= mesh.triangle_bound()) {
      const std::size_t strips = locator.strips();
      const bool poor = strips + strips / 8 >= strips_at_start_;
      if (poor) states_ = (std::min)(last_, states_ > last_ / 4 ? last_ : states_ * 4);
      strips_at_start_ = strips;
      next_ = 0;
      if (mesh.triangle_count() == 0) break;
    }
    const Triangle t = next_++;
    ++passed;
    if (!mesh.alive(t) || mesh.solid_degree(t) > 1 || (worth && !worth(t))) continue;
    const auto on_failure = states_ >= last_ ? Tunnel::OnFailure::wander : Tunnel::OnFailure::stay;
    tunnel.join(mesh, locator, t, states_, on_failure);
    if (poll != nullptr && poll->stops()) break;
  }
  return spent();
}

}  // namespace restrip
