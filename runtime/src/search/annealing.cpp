// Annealing of the colours of a mesh.
//
// Outline. A random change of a few dual edges is accepted if it costs no more, and otherwise with a probability that
// falls with a temperature. A change clears a solid edge, or sets a dashed one and clears one at each end that has two:
// its price follows from six triangles. A triangle is *flawed* if it has fewer than two solid edges or is part of a
// swap that costs something. Only moves at flawed triangles are tried, a few of a hundred triangles once the strips are
// good, in the order of triangle handles: fastest if triangles close on the surface have close handles.
//
// Invariant. The colouring is valid after every move: a walk from both ends of the strip excludes cycles, and refuses
// the move if neither end is found soon.
//
// Cost. Some 60 ns a move. Memory: 15 bytes a triangle.
//
// Source. Kirkpatrick, Gelatt, Vecchi, "Optimization by simulated annealing", 1983.
#include "search/annealing.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <utility>

namespace restrip::detail {

namespace {

/// -log2(x / 2^32) for x > 0, in units of 2^-16: the leading bit, and a straight line between powers of two (Mitchell,
/// "Computer multiplication and division using binary logarithms", 1962). At most 0.09 off, the same everywhere.
constexpr std::uint64_t minus_log2(std::uint32_t x) noexcept {
  const auto place = static_cast<unsigned>(std::bit_width(x)) - 1;
  const std::uint64_t line = std::uint64_t{x} << (31 - place) >> 15 & 0xFFFFU;
  return (std::uint64_t{32 - place} << 16) - line;
}

}  // namespace

void Annealing::keep() {
  const std::uint64_t now = cost(cost_);
  if (!kept_.empty() && now >= least_) return;
  least_ = now;
  kept_ = solid_;
}

void Annealing::cool(std::uint64_t moves, std::uint32_t heat, Poll* poll) {
  // A triangle without a neighbour cannot move.
  flaws_.assign((across_.size() + 63) / 64, 0);
  for (Triangle t = 0; t < across_.size(); ++t)
    if (across_[t] != std::array{none, none, none}) note(t);
  const std::uint64_t most = std::max<std::uint64_t>({cost_.restart, std::uint64_t{3} * cost_.swap, cost_.isolated});
  const std::uint64_t hot = 45'426 * most * heat / 300;  // 45,426 = 2^16 ln 2
  const std::uint64_t stage = moves * 9 / 20 + 1;
  tried_ = 0;
  for (std::uint64_t before = none; tried_ < moves && tried_ != before;) {
    before = tried_;
    // The moves of every flawed triangle once, in the order of their handles, so that memory is read in order. The
    // temperature changes before the first one of every 4,096 triangles.
    std::size_t block = none;
    for (std::size_t word = 0; word < flaws_.size(); ++word) {
      if (flaws_[word] == 0) continue;
      if (std::exchange(block, word / 64) != word / 64) {
        if (poll != nullptr && poll->stops()) return;
        const std::uint64_t at = tried_ / stage;
        const std::uint64_t into = tried_ - at * stage;
        const std::uint64_t last = moves - (std::min)(moves, 2 * stage) + 1;
        if (at < 2)
          temperature_ = (hot >> at) - (hot >> (at + 1)) * into / stage;
        else
          temperature_ = (hot >> 2) * (last - (std::min)(into, last)) / last;
      }
      for (std::uint64_t left = flaws_[word]; left != 0; left &= left - 1) {
        const auto t = static_cast<Triangle>(word * 64 + static_cast<unsigned>(std::countr_zero(left)));
        if (!flawed(t)) {
          flaws_[word] &= ~(left & (0 - left));
          continue;
        }
        for (unsigned s = 0; s < 3; ++s) try_move(t << 2 | s);
      }
    }
  }
}

std::int64_t Annealing::least_change(std::uint32_t h, unsigned before) const noexcept {
  const std::uint32_t g = across(h);
  const unsigned after_g = (g & 3U) == 2 ? 0 : (g & 3U) + 1;
  const unsigned before_g = (g & 3U) == 0 ? 2 : (g & 3U) - 1;
  const std::uint32_t there = across((g & ~3U) | (before != 0 ? before_g : after_g));  // over the edge cleared
  const std::uint32_t kept = across((g & ~3U) | (before != 0 ? after_g : before_g));   // over the one that stays
  const unsigned turn_here = turn(h);
  const unsigned turn_there = turn(there);
  const std::uint32_t before_here = turn_here == 0 ? none : across(other(h));
  const std::uint32_t beyond = turn_there == 0 ? none : across(other(there));
  if (kept >> 2 == h >> 2 || kept >> 2 == there >> 2 || before_here >> 2 == there >> 2 || before_here >> 2 == g >> 2)
    return (std::numeric_limits<std::int64_t>::min)();
  // The turn from the cleared edge to the one that stays. A turn t is 1 or 2; in reverse it is 3 - t.
  const unsigned to_kept = before + 1;
  const unsigned turn_kept = turn(kept);
  int swaps = int{turn_here == to_kept} + int{turn_kept == 3 - to_kept};
  swaps -= int{turn_there == 3 - to_kept} + int{turn_kept == to_kept};
  if (before_here != none) swaps += int{turn(before_here) == turn_here};
  if (beyond != none) swaps -= int{turn(beyond) == turn_there};
  return std::int64_t{cost_.swap} * swaps + std::int64_t{cost_.isolated} * (int{turn_there == 0} - int{turn_here == 0});
}

bool Annealing::flawed(Triangle t) const noexcept {
  if (!full(t)) return true;
  if (cost_.swap == 0) return false;
  const std::uint32_t h = only_side(t);
  return is_swap(h) || is_swap(other(h));
}

// The cost that the solid edge of h adds: its swaps, minus a strip, minus triangles that would be isolated without
// it.
std::int64_t Annealing::price(std::uint32_t h) const noexcept {
  const std::uint32_t a = other(h);
  const std::uint32_t b = other(across(h));
  unsigned swaps = is_swap(h) ? 1U : 0U;
  if (a != none && is_swap(a)) ++swaps;
  if (b != none && is_swap(b)) ++swaps;
  const unsigned alone = (a == none ? 1U : 0U) + (b == none ? 1U : 0U);
  return std::int64_t{cost_.swap} * swaps - cost_.restart - std::int64_t{cost_.isolated} * alone;
}

// Whether t and u may be the two ends of one strip. Walks from both until the shorter walk ends.
bool Annealing::may_be_ends_of_one(Triangle t, Triangle u) const noexcept {
  constexpr unsigned longest_walk = 512;
  if (solid_[t] == 0 || solid_[u] == 0) return false;
  std::uint32_t from_t = only_side(t);
  std::uint32_t from_u = only_side(u);
  for (unsigned steps = 0; steps < longest_walk; ++steps) {
    const std::uint32_t there = across(from_t);
    if (there >> 2 == u) return true;
    from_t = other(there);
    from_u = other(across(from_u));
    if (from_t == none || from_u == none) return false;
  }
  return true;
}

void Annealing::note(Triangle t) noexcept {
  if (flawed(t)) flaws_[t / 64] |= std::uint64_t{1} << t % 64;
}
// t and the triangles before and after it, whose swaps depend on t's colours.
void Annealing::note_around(Triangle t) noexcept {
  note(t);
  for (unsigned s = 0; s < 3; ++s)
    if ((solid_[t] >> s & 1U) != 0) note(across_[t][s] >> 2);
}

// Clears h if it is solid, or else sets it; drops the move if the cost rises by more than chance allows at this
// temperature, or if it would close a cycle.
void Annealing::try_move(std::uint32_t h) {
  const std::uint32_t g = across(h);
  if (g == none) return;
  ++tried_;
  const auto allowed = static_cast<std::int64_t>(temperature_ * minus_log2(random_.bits() | 1U) >> 32);
  std::array<std::uint32_t, 2> cuts{};
  unsigned count = 0;
  std::int64_t change = 0;
  const auto cut = [&](std::uint32_t e) {
    change -= price(e);
    flip(e);
    cuts[count++] = e;
  };
  const auto take_back = [&] {
    while (count > 0) flip(cuts[--count]);
  };
  if (solid(h)) {
    if (-price(h) > allowed) return;
    cut(h);
  } else {
    const std::uint32_t which = random_.bits() >> 30;
    const bool full_here = full(h >> 2);
    const bool full_there = full(g >> 2);
    if (full_here != full_there && (full_here ? least_change(g, which & 1U) : least_change(h, which >> 1)) > allowed)
      return;
    if (full_here) cut((h & ~3U) | ((h & 3U) + 1 + (which & 1U)) % 3);
    // Two triangles may share two sides: then the first cut may have made room in both.
    if (full(g >> 2)) cut((g & ~3U) | ((g & 3U) + 1 + (which >> 1)) % 3);
    bool possible = change - cost_.restart - 2 * std::int64_t{cost_.isolated} <= allowed;
    if (possible) {
      flip(h);
      change += price(h);
      flip(h);
      possible = change <= allowed && !may_be_ends_of_one(h >> 2, g >> 2);
    }
    if (!possible) return take_back();
    flip(h);
  }
  if (change > allowed) return take_back();
  note_around(h >> 2);
  note_around(g >> 2);
  for (unsigned i = 0; i < count; ++i) note(across(cuts[i]) >> 2);
}

}  // namespace restrip::detail
