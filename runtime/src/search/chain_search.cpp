// Chains of moves at strip ends.
//
// A move begins at a triangle in which a strip ends (one with at most one solid edge). A dashed edge of it becomes
// solid:
//  - if a strip ends across that edge as well, the two strips are joined;
//  - otherwise the triangle across it gives up one of its two solid edges. The triangle across that one is a new end,
//    so an exchange moves an end, and changes the cost only by swaps.
// A chain may also begin with a cut: a swap becomes dashed, and with it disappear the swaps next to it. Without cuts a
// single strip of many swaps could not be left: it has two ends, far from almost everything.
// The price of a move follows from at most ten triangles around it.
//
// Outline. A chain continues at the end that its last move made. The search is breadth first over chains, from all
// given ends at once, and then, if they are exhausted, from both sides of each cut; a triangle is the end of one chain
// at most. The first chain that lowers the cost is made, and the search begins again, at the ends that the chain has
// touched first, until a limit on the work is reached.
//
// Invariant. The chain of the state in hand is on the mesh itself, unreported, so prices and walks read nothing but
// colours. Every chain on the mesh leaves a valid colouring: a walk along the strip, from both sides at once to the end
// of the shorter side, has tested each of its moves for cycles.
//
// Cost. An end examined takes the pricing of up to six moves and one such walk.
//
// Source. The moves are the rotations of Pósa ("Hamiltonian circuits in random graphs", 1976) and the moves of
// tunnelling (Stewart, "Tunneling for triangle strips in continuous level-of-detail meshes", 2001), here with a price;
// chains of them are due to Lin and Kernighan (1973).
#include "search/chain_search.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "search/coloring_copy.hpp"
#include "search/sides.hpp"

namespace restrip {
namespace detail {

/// Colours a chain that is undone before the search returns. A watched StripMesh does not report it.
class TrialColors {
 public:
  template <class Mesh>
  static void make(Mesh& mesh, const ChainMove& move) noexcept {
    if (!move.joins()) color(mesh, move.cut, false);
    if (!move.only_cuts()) color(mesh, move.edge, true);
  }
  template <class Mesh>
  static void take_back(Mesh& mesh, const ChainMove& move) noexcept {
    if (!move.only_cuts()) color(mesh, move.edge, false);
    if (!move.joins()) color(mesh, move.cut, true);
  }

 private:
  static void color(StripMesh& mesh, StripMesh::Halfedge h, bool solid) noexcept { mesh.color(h, solid); }
  static void color(ColoringCopy& mesh, StripMesh::Halfedge h, bool solid) noexcept { mesh.set_solid(h, solid); }
};

}  // namespace detail

namespace {

using detail::is_strip_end;
using detail::lowest_side;
using Halfedge = StripMesh::Halfedge;

/// The neighbour that is `turn` sides after h in its triangle, seen from there.
template <class Mesh>
Halfedge neighbor_at(const Mesh& mesh, Halfedge h, unsigned turn) noexcept {
  const unsigned side = StripMesh::side(h) + turn;
  return mesh.opposite(StripMesh::halfedge(StripMesh::triangle(h), side >= 3 ? side - 3 : side));
}

}  // namespace

// ---- moves

// Keeps moves_ in order of price; equal prices in the order in which they are offered.
void ChainSearch::offer(const ChainMove& move, std::int32_t highest) noexcept {
  if (move.price > highest) return;
  std::size_t i = move_count_++;
  for (; i > 0 && move.price < moves_[i - 1].price; --i) moves_[i] = moves_[i - 1];
  moves_[i] = move;
}

template <class Mesh>
std::span<const ChainMove> ChainSearch::moves_at(const Mesh& mesh, Triangle end, std::int32_t highest) {
  move_count_ = 0;
  const unsigned solid = mesh.solid_sides(end);
  RESTRIP_ASSERT(is_strip_end(solid), "ChainSearch::moves_at", "no strip ends in the triangle");
  const int isolated = solid == 0 ? -1 : 0;  // change at the end
  Triangle last = none;                      // the triangle before the end in its strip
  unsigned turn_last = 0;                    // of the strip at that triangle, seen from the end
  if (solid != 0) {
    const Halfedge kept = mesh.opposite(lowest_side(end, solid));
    last = StripMesh::triangle(kept);
    turn_last = mesh.other_solid_sides(kept);
  }
  for (unsigned dashed = 7U & ~solid; dashed != 0; dashed &= dashed - 1) {
    const Halfedge edge = lowest_side(end, dashed);
    const Halfedge back = mesh.opposite(edge);
    if (StripMesh::on_boundary(back) || StripMesh::triangle(back) == end) continue;
    const unsigned turn_end = mesh.other_solid_sides(edge);  // of the strip, seen from the edge; 0 if end is isolated
    const int swaps = int{turn_end != 0} & int{turn_last == turn_end};
    if (const unsigned turn = mesh.other_solid_sides(back); turn != 3) {
      // Another strip ends across the edge.
      ChainMove move{edge, {}, {-1, swaps + detail::is_swap(turn_end, turn), isolated}};
      if (turn != 0) {
        const Halfedge kept = neighbor_at(mesh, back, turn);
        // Two triangles that share two edges and follow each other already.
        if (StripMesh::triangle(kept) == end) continue;
        move.change.swaps += int{mesh.other_solid_sides(kept) == turn};
      } else {
        --move.change.isolated;
      }
      move.price = move.change.price(cost_);
      offer(move, highest);
      continue;
    }
    // A strip passes across the edge.
    const std::array<Halfedge, 2> towards{neighbor_at(mesh, back, 1), neighbor_at(mesh, back, 2)};
    if (StripMesh::triangle(towards[0]) == end || StripMesh::triangle(towards[1]) == end) continue;
    const std::array<unsigned, 2> turn{mesh.other_solid_sides(towards[0]), mesh.other_solid_sides(towards[1])};
    for (unsigned keeps = 1; keeps <= 2; ++keeps) {
      const unsigned gives = 3 - keeps;
      const unsigned turn_freed = turn[gives - 1];
      ChainMove move{edge, towards[gives - 1], {}};
      // Three triangles around one vertex are not exchanged: their prices depend on each other.
      if (move.end() == last) continue;
      move.change.isolated = isolated + int{turn_freed == 0};
      move.change.swaps = swaps + detail::is_swap(turn_end, keeps) + int{turn[keeps - 1] == keeps} -
                          int{turn[keeps - 1] == gives} - int{turn_freed == keeps};
      // One more swap may disappear, on the other side of the new end.
      if (move.change.price(cost_) - std::int32_t{cost_.swap} > highest) continue;
      if (turn_freed != 0)
        move.change.swaps -= int{mesh.other_solid_sides(neighbor_at(mesh, move.cut, turn_freed)) == turn_freed};
      move.price = move.change.price(cost_);
      offer(move, highest);
    }
  }
  return {moves_.data(), move_count_};
}

template <class Mesh>
std::optional<ChainMove> ChainSearch::cut_at(const Mesh& mesh, Halfedge h) const noexcept {
  const Halfedge back = mesh.opposite(h);
  const unsigned turn = mesh.other_solid_sides(h);
  const unsigned turn_back = mesh.other_solid_sides(back);
  if (detail::is_swap(turn, turn_back) == 0) return std::nullopt;
  ChainMove move{{}, h, {1, -1, 0}};
  move.change.swaps -= int{mesh.other_solid_sides(neighbor_at(mesh, h, turn)) == turn} +
                       int{mesh.other_solid_sides(neighbor_at(mesh, back, turn_back)) == turn_back};
  move.price = move.change.price(cost_);
  return move;
}

template <class Mesh>
bool ChainSearch::keeps_strips(const Mesh& mesh, const ChainMove& move) {
  if (move.only_cuts()) return true;
  const Halfedge back = mesh.opposite(move.edge);
  const Triangle t = StripMesh::triangle(move.edge);
  const Triangle u = StripMesh::triangle(back);
  const unsigned kept_t = mesh.solid_sides(t);
  unsigned kept_u = mesh.solid_sides(u);
  if (!move.joins()) kept_u &= ~(1U << StripMesh::side(mesh.opposite(move.cut)));
  if (kept_t == 0 || kept_u == 0) return true;
  const Halfedge out = lowest_side(u, kept_u);
  Halfedge from_t = mesh.opposite(lowest_side(t, kept_t));
  Halfedge from_u = mesh.opposite(out);
  // A walk from t reaches u over the edge that u keeps, which closes a cycle, or over the one that it gives up. A walk
  // from u over the edge that it keeps reaches t only in a cycle.
  for (std::uint32_t n = 0; n < max_walk; ++n) {
    if (StripMesh::triangle(from_t) == u) return !(from_t == out);
    if (StripMesh::triangle(from_u) == t) return false;
    counts_.walked += 2;
    const auto next_t = mesh.strip_step(from_t);
    const auto next_u = mesh.strip_step(from_u);
    if (!next_t.continues || !next_u.continues) return true;
    from_t = next_t.in;
    from_u = next_u.in;
  }
  return false;
}

// ---- chains

void ChainSearch::next_mark() noexcept {
  if (++mark_ != 0) return;
  std::fill(marks_.begin(), marks_.end(), 0U);
  mark_ = 1;
}

// The triangle, or the end across its only dashed edge.
template <class Mesh>
void ChainSearch::consider(const Mesh& mesh, Triangle t, std::vector<Triangle>& ends) {
  const unsigned solid = mesh.solid_sides(t);
  // On the boundary the other side is t itself.
  const Triangle end = is_strip_end(solid) ? t : StripMesh::triangle(mesh.opposite(lowest_side(t, 7U & ~solid)));
  if (!is_strip_end(mesh.solid_sides(end)) || marks_[end] == mark_) return;
  marks_[end] = mark_;
  ends.push_back(end);
}

// Puts the chain of s on the mesh in place of the present one. False if its last move would close a cycle.
template <class Mesh>
bool ChainSearch::try_chain(Mesh& mesh, std::uint32_t s) {
  // Parents come before their children, so the later of two states is not an ancestor of the other.
  path_.clear();
  while (s != tried_) {
    if (tried_ == none || (s != none && s > tried_)) {
      path_.push_back(s);
      s = states_[s].parent;
    } else {
      if (states_[tried_].length > 0) detail::TrialColors::take_back(mesh, states_[tried_].move);
      tried_ = states_[tried_].parent;
    }
  }
  for (; !path_.empty(); path_.pop_back()) {
    const State& state = states_[path_.back()];
    if (state.length > 0) {
      if (path_.size() == 1 && !keeps_strips(mesh, state.move)) return false;  // the others have been tested
      detail::TrialColors::make(mesh, state.move);
    }
    tried_ = path_.back();
  }
  return true;
}

// Adds both ends of each cut at a swap of the triangles. True if a cut alone lowers the cost; it has then been made.
template <class Mesh>
bool ChainSearch::add_cuts(Mesh& mesh, std::span<const Triangle> from, std::int32_t highest) {
  if (cost_.swap == 0) return false;  // no cut gains
  for (const Triangle t : from)
    for (unsigned solid = mesh.solid_sides(t); solid != 0; solid &= solid - 1) {
      const Halfedge h = lowest_side(t, solid);
      std::optional<ChainMove> move = cut_at(mesh, h);
      if (!move || move->price > highest) continue;
      if (move->price < 0) {
        make_chain(mesh, none, *move);
        return true;
      }
      for (const Halfedge side : {h, mesh.opposite(h)}) {
        move->cut = side;
        if (marks_[move->end()] == mark_) continue;
        marks_[move->end()] = mark_;
        states_.push_back({none, 1, move->end(), move->price, *move});
      }
    }
  return false;
}

// True if a chain that lowers the cost has been made.
template <class Mesh>
bool ChainSearch::search(Mesh& mesh, std::span<const Triangle> from, const ChainLimits& limits) {
  // A chain on trial must not be left on the mesh by an exception.
  const std::uint64_t most_states =
      ends_.size() + 6 * (from.size() + std::min<std::uint64_t>(last_look_ - counts_.looked, none));
  states_.clear();
  states_.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(most_states, mesh.triangle_bound())));
  path_.reserve(std::min<std::size_t>(states_.capacity(), limits.length + std::size_t{1}));
  chain_.reserve(path_.capacity());
  next_mark();
  for (const Triangle end : ends_) {
    states_.push_back({.end = end});
    marks_[end] = mark_;
  }
  bool cuts_follow = true;
  for (std::uint32_t s = 0; counts_.looked < last_look_; ++s) {
    if (s == states_.size() && std::exchange(cuts_follow, false)) {
      (void)try_chain(mesh, none);
      if (add_cuts(mesh, from, limits.worse)) return true;
    }
    if (s == states_.size()) break;
    if (!try_chain(mesh, s)) continue;
    ++counts_.looked;
    const State state = states_[s];
    const bool last = state.length + 1 >= limits.length;
    for (const ChainMove& move : moves_at(mesh, state.end, (last ? -1 : limits.worse) - state.price)) {
      const std::int32_t price = state.price + move.price;
      if (price < 0) {
        if (!keeps_strips(mesh, move)) continue;
        make_chain(mesh, s, move);
        return true;
      }
      if (move.joins() || marks_[move.end()] == mark_) continue;
      marks_[move.end()] = mark_;
      states_.push_back({s, state.length + 1, move.end(), price, move});
    }
  }
  (void)try_chain(mesh, none);
  return false;
}

template <class Mesh>
void ChainSearch::make_chain(Mesh& mesh, std::uint32_t s, const ChainMove& last) {
  const std::size_t examined = std::min<std::size_t>(ends_.size(), s + std::size_t{1});
  chain_.assign(1, last);
  for (; s != none && states_[s].length > 0; s = states_[s].parent) chain_.push_back(states_[s].move);
  (void)try_chain(mesh, none);
  for (auto move = chain_.rbegin(); move != chain_.rend(); ++move) {
    if (!move->joins()) mesh.set_solid(move->cut, false);
    if (!move->only_cuts()) mesh.set_solid(move->edge, true);
    done_ += move->change;
    ++counts_.made;
  }
  // First come the ends not yet examined, then the ones that the chain has touched, then the others.
  next_mark();
  touched_.clear();
  for (const ChainMove& move : chain_) {
    if (!move.joins()) consider(mesh, move.end(), touched_);
    const Halfedge other = move.only_cuts() ? move.cut : move.edge;
    consider(mesh, StripMesh::triangle(other), touched_);
    consider(mesh, StripMesh::triangle(mesh.opposite(other)), touched_);
  }
  std::rotate(ends_.begin(), ends_.begin() + static_cast<std::ptrdiff_t>(examined), ends_.end());
  const auto others = ends_.end() - static_cast<std::ptrdiff_t>(examined);
  ends_.insert(others, touched_.begin(), touched_.end());
  next_mark();
  std::erase_if(ends_, [&](Triangle t) {
    return !is_strip_end(mesh.solid_sides(t)) || std::exchange(marks_[t], mark_) == mark_;
  });
}

template <class Mesh>
ColoringChange ChainSearch::run(Mesh& mesh, std::span<const Triangle> from, const ChainLimits& limits) {
  done_ = {};
  if (marks_.size() < mesh.triangle_bound()) marks_.resize(mesh.triangle_bound() + mesh.triangle_bound() / 4, 0);
  next_mark();
  ends_.clear();
  for (const Triangle t : from) {
    RESTRIP_ASSERT(mesh.alive(t), "ChainSearch::run", "a triangle is not one of this mesh");
    consider(mesh, t, ends_);
  }
  last_look_ = counts_.looked + limits.looks;
  while (counts_.looked < last_look_ && search(mesh, from, limits)) {
  }
  return done_;
}

template <class Mesh>
bool ChainSearch::may_begin(const Mesh& mesh, Triangle t, const ChainLimits& limits) {
  const unsigned solid = mesh.solid_sides(t);
  if (is_strip_end(solid)) return true;
  for (unsigned sides = limits.length > 1 ? solid : 0; sides != 0; sides &= sides - 1) {
    const Halfedge h = lowest_side(t, sides);
    if (detail::is_swap(mesh.other_solid_sides(h), mesh.other_solid_sides(mesh.opposite(h))) != 0) return true;
  }
  return false;
}

template <class Mesh>
ColoringChange ChainSearch::run_everywhere(Mesh& mesh, const ChainLimits& limits, detail::Poll& poll) {
  ColoringChange sum;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t) && may_begin(mesh, t, limits) && !poll.stops()) sum += run(mesh, {&t, 1}, limits);
  return sum;
}

template ColoringChange ChainSearch::run(StripMesh&, std::span<const Triangle>, const ChainLimits&);
template ColoringChange ChainSearch::run(detail::ColoringCopy&, std::span<const Triangle>, const ChainLimits&);
template ColoringChange ChainSearch::run_everywhere(detail::ColoringCopy&, const ChainLimits&, detail::Poll&);
template std::span<const ChainMove> ChainSearch::moves_at(const StripMesh&, Triangle, std::int32_t);
template bool ChainSearch::may_begin(const StripMesh&, Triangle, const ChainLimits&);
template std::optional<ChainMove> ChainSearch::cut_at(const StripMesh&, Halfedge) const noexcept;
template bool ChainSearch::keeps_strips(const StripMesh&, const ChainMove&);

}  // namespace restrip
