// A walk over one arc of a fan by the index automaton (restrip/tables/index_automaton.hpp): forwards from class to
// class, backwards from case to case; and how arcs meet. restrip/tables/index_automaton_format.hpp says what classes,
// cases, letters and links are.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "restrip/rules/bits.hpp"
#include "restrip/rules/impl/arc_walk.hpp"
#include "restrip/tables/index_automaton.hpp"

namespace restrip::detail {

/// Letters of a key: 0 no solid port; 1, 2, 3 a solid port, by what lies behind it; 4, 5, 6 the same, joined.
/// `Joined` is a WordLetters or a LongLetters, `Bits` a Word or a BitSpan.
template <class Joined, class Bits>
struct TurnLetters {
  Joined joined;
  Bits left;
  Bits right;

  [[nodiscard]] constexpr unsigned operator[](std::size_t i) const noexcept {
    const unsigned port = joined[i];
    if (port == 0) return 0;
    const unsigned turn = at(left, i) ? 1 : at(right, i) ? 2 : 0;
    return 3 * port - 2 + turn;
  }

 private:
  static constexpr bool at(Word mask, std::size_t i) noexcept { return (mask >> i & 1) != 0; }
  static constexpr bool at(BitSpan bits, std::size_t i) noexcept { return bits[i]; }
};
template <class Joined, class Bits>
TurnLetters(Joined, Bits, Bits) -> TurnLetters<Joined, Bits>;

namespace index_case {

inline constexpr unsigned count = 26;
inline constexpr unsigned through = 25;
constexpr unsigned left(unsigned c) noexcept { return c / 5; }
constexpr unsigned right(unsigned c) noexcept { return c == through ? 5 : c % 5; }

// Reaches; those from `along` on go on along the fan.
inline constexpr unsigned dashed = 0;
inline constexpr unsigned port = 2;
inline constexpr unsigned along = 3;
constexpr bool reaches_port(unsigned reach) noexcept { return reach == 2 || reach == 4; }

}  // namespace index_case

/// What must be known of the solid ports of an arc to tell which pairs of end ports are pairs of the key.
struct ArcPorts {
  unsigned count = 0;         ///< 3 stands for three or more
  bool first_joined = false;  ///< the first one is joined to the solid port before it, which lies outside the arc
  bool two_joined = false;    ///< there are exactly two, and they are joined

  constexpr void read(unsigned letter) noexcept {
    if (letter == 0) return;
    const bool is_joined = letter > 3;
    if (count == 0) first_joined = is_joined;
    two_joined = count == 1 && is_joined;
    if (count < 3) ++count;
  }
};

/// An arc with up to as many letters as there is room for.
class IndexArc {
 public:
  using Entry = std::uint16_t;

  /// `room` gets an entry for each letter and must outlive the walk.
  constexpr explicit IndexArc(Entry* room) noexcept : entries_(room) {}

  template <class Letters>
  constexpr void read(const Letters& letters, std::size_t from, std::size_t to) noexcept {
    constexpr const auto& automaton = tables::index_automaton;
    for (std::size_t i = from; i < to; ++i) {
      const unsigned letter = letters[i];
      const auto entry = static_cast<Entry>(7 * class_ + letter);
      entries_[size_++] = entry;
      cost_ += automaton.move_costs[automaton.move[entry]];
      class_ = automaton.next[entry];
      ports_.read(letter);
    }
  }

  [[nodiscard]] constexpr const ArcPorts& ports() const noexcept { return ports_; }

  /// The cases of the class are first_case() to one before last_case().
  [[nodiscard]] constexpr std::size_t first_case() const noexcept { return tables::index_automaton.first[class_]; }
  [[nodiscard]] constexpr std::size_t last_case() const noexcept { return tables::index_automaton.first[class_ + 1]; }
  [[nodiscard]] constexpr int cost(std::size_t c) const noexcept { return cost_ + tables::index_automaton.costs[c]; }

  /// Calls link(m, solid) for the links from the last to the second, m = the number of letters to the left; returns
  /// whether the first is solid. `end` is the case of the whole arc, as in first_case().
  template <class Link>
  constexpr bool for_each_link(std::size_t end, Link&& link) const noexcept {
    constexpr const auto& automaton = tables::index_automaton;
    auto place = static_cast<unsigned>(end - first_case());
    bool solid = index_case::right(automaton.cases[end]) != index_case::dashed;
    for (std::size_t m = size_; m > 0; --m) {
      link(m, solid);
      const std::size_t move = automaton.move[entries_[m - 1]];
      solid = (automaton.links[move] >> place & 1) != 0;
      place = static_cast<unsigned>(automaton.origins[move] >> 4 * place & 15U);
    }
    return solid;
  }

 private:
  Entry* entries_;
  std::size_t size_ = 0;
  std::size_t class_ = 0;
  int cost_ = 0;
  ArcPorts ports_;
};

/// The ends of two arcs in ring order A, first, D, second.
enum ArcEnd : unsigned { first_left, first_right, second_left, second_right };

/// Pairs of ends as a mask of six bits.
constexpr unsigned end_pair(unsigned x, unsigned y) noexcept {
  if (x > y) return end_pair(y, x);
  constexpr unsigned before[]{0, 3, 5};
  return 1U << (before[x] + y - x - 1);
}

/// More than the costs of any two colourings of a patch with the same ports differ.
inline constexpr std::int16_t index_unsound = 0x4000;

/// What A, D and the edges that no arc counts add to the costs of two cases.
struct IndexWay {
  std::int16_t cost = index_unsound;
  bool sound = false;      ///< degrees at most two, no cycle
  std::uint8_t joins = 0;  ///< ends whose strands reach ports and are joined
};

/// A triangle without a port between two links, with the chord or without: its swaps at the links.
constexpr int swaps_around(unsigned before, unsigned after, bool chord) noexcept {
  const auto swap = [&](unsigned reach) { return chord ? reach >= index_case::along : reach == index_case::port; };
  const bool passed = chord || (before != index_case::dashed && after != index_case::dashed);
  return passed ? (swap(before) ? 1 : 0) + (swap(after) ? 1 : 0) : 0;
}

constexpr IndexWay index_way(unsigned first, unsigned second, bool chord) noexcept {
  constexpr const auto& automaton = tables::index_automaton;
  const unsigned reach[4]{index_case::left(first), index_case::right(first), index_case::left(second),
                          index_case::right(second)};
  const auto solid = [&](unsigned end) { return reach[end] != index_case::dashed; };
  IndexWay way;
  const int degree_a = (solid(first_left) ? 1 : 0) + (solid(second_right) ? 1 : 0) + (chord ? 1 : 0);
  const int degree_d = (solid(first_right) ? 1 : 0) + (solid(second_left) ? 1 : 0) + (chord ? 1 : 0);
  if (degree_a > 2 || degree_d > 2) return way;
  unsigned strand[6]{0, 1, 2, 3, 4, 5};  // the four ends, A and D
  const auto tie = [&](unsigned x, unsigned y) {
    const unsigned from = strand[x];
    const unsigned to = strand[y];
    if (from == to) return false;
    for (unsigned& s : strand) s = s == from ? to : s;
    return true;
  };
  if (first == index_case::through && !tie(first_left, first_right)) return way;
  if (second == index_case::through && !tie(second_left, second_right)) return way;
  if (solid(first_left) && !tie(4, first_left)) return way;
  if (solid(second_right) && !tie(4, second_right)) return way;
  if (solid(first_right) && !tie(5, first_right)) return way;
  if (solid(second_left) && !tie(5, second_left)) return way;
  if (chord && !tie(4, 5)) return way;
  way.sound = true;
  for (unsigned x = 0; x < 4; ++x)
    for (unsigned y = x + 1; y < 4; ++y)
      if (index_case::reaches_port(reach[x]) && index_case::reaches_port(reach[y]) && strand[x] == strand[y])
        way.joins = static_cast<std::uint8_t>(way.joins | end_pair(x, y));
  int swaps = swaps_around(reach[second_right], reach[first_left], chord) +
              swaps_around(reach[first_right], reach[second_left], chord);
  if (chord && ((solid(first_left) && solid(first_right)) || (solid(second_left) && solid(second_right)))) ++swaps;
  const int edges = (solid(first_right) ? 1 : 0) + (solid(second_right) ? 1 : 0) + (chord ? 1 : 0);
  const int isolated = (degree_a == 0 ? 1 : 0) + (degree_d == 0 ? 1 : 0);
  way.cost =
      static_cast<std::int16_t>(automaton.swap * swaps + automaton.isolated * isolated - automaton.restart * edges);
  return way;
}

/// By case of the first arc, case of the second, chord.
inline constexpr auto index_ways = [] {
  std::array<IndexWay, std::size_t{2} * index_case::count * index_case::count> ways{};
  for (unsigned first = 0; first < index_case::count; ++first)
    for (unsigned second = 0; second < index_case::count; ++second)
      for (unsigned chord = 0; chord < 2; ++chord)
        ways[2 * (index_case::count * first + second) + chord] = index_way(first, second, chord != 0);
  return ways;
}();

/// The pairs of ends that reach ports which the key joins.
constexpr unsigned joined_ends(const ArcPorts& first, const ArcPorts& second) noexcept {
  unsigned pairs = 0;
  // The two end ports of an arc with one port are the same.
  const auto add = [&](unsigned one, unsigned other) {
    const unsigned ones = first.count == 1 ? 2 : 1;
    const unsigned others = second.count == 1 ? 2 : 1;
    for (unsigned x = 0; x < ones; ++x)
      for (unsigned y = 0; y < others; ++y) pairs |= end_pair(one ^ x, other ^ y);
  };
  if (first.two_joined) pairs |= end_pair(first_left, first_right);
  if (second.two_joined) pairs |= end_pair(second_left, second_right);
  if (first.count > 0 && second.count > 0) {
    if (first.first_joined) add(first_left, second_right);
    if (second.first_joined) add(first_right, second_left);
  } else {
    if (first.count > 1 && first.first_joined) pairs |= end_pair(first_left, first_right);
    if (second.count > 1 && second.first_joined) pairs |= end_pair(second_left, second_right);
  }
  return pairs;
}

/// The best so far of what can be had where arcs meet: a case of each, and the cost of all.
struct IndexChoice {
  std::size_t first = 0;
  std::size_t second = 0;
  std::size_t third = 0;
  bool chord = false;
  int cost = 0;
  bool found = false;

  constexpr void offer(const IndexChoice& other) noexcept {
    if (!found || other.cost < cost) *this = other;
  }
};

/// The best recolouring of each family: color(edge, solid) is called once for every inner edge; returns its cost, each
/// solid inner edge counted as minus `restart`. `room` has an entry for each triangle of the fan.
template <class Letters, class Color>
constexpr int walk_index_split(std::size_t k, std::size_t a, const Letters& letters, IndexArc::Entry* room,
                               Color&& color) noexcept {
  constexpr const auto& cases = tables::index_automaton.cases;
  IndexArc one(room);
  IndexArc other(room + a);
  one.read(letters, 0, a);
  other.read(letters, a, k);
  const unsigned forbidden = ~joined_ends(one.ports(), other.ports());
  // Cost and choice in one number: the least is found without branches, which would mispredict.
  constexpr std::int64_t choices = std::int64_t{1} << 33;
  std::int64_t best = std::numeric_limits<std::int64_t>::max();
  for (std::size_t x = one.first_case(); x < one.last_case(); ++x)
    for (std::size_t y = other.first_case(); y < other.last_case(); ++y)
      for (const unsigned dashed_chord : {0U, 1U}) {
        const IndexWay& way = index_ways[2 * (index_case::count * cases[x] + cases[y]) + 1 - dashed_chord];
        const int cost = one.cost(x) + other.cost(y) + way.cost + ((way.joins & forbidden) != 0 ? index_unsound : 0);
        best = std::min(best, choices * cost + static_cast<std::int64_t>(x << 17 | y << 1 | dashed_chord));
      }
  const auto choice = static_cast<std::size_t>(best & (choices - 1));
  color(0, one.for_each_link(choice >> 17, color));
  color(a + 1, other.for_each_link(choice >> 1 & 0xffff, [&](std::size_t m, bool solid) { color(a + 1 + m, solid); }));
  color(k + 2, (choice & 1) == 0);
  return static_cast<int>((best - static_cast<std::int64_t>(choice)) / choices);
}

template <class Letters, class Color>
constexpr int walk_index_collapse(std::size_t k, const Letters& letters, IndexArc::Entry* room,
                                  Color&& color) noexcept {
  constexpr const auto& automaton = tables::index_automaton;
  IndexArc whole(room);
  whole.read(letters, 0, k);
  const ArcPorts& ports = whole.ports();
  const bool may_join = ports.count > 1 && (ports.first_joined || ports.two_joined);
  IndexChoice best;
  for (std::size_t c = whole.first_case(); c < whole.last_case(); ++c) {
    const unsigned left = index_case::left(automaton.cases[c]);
    const unsigned right = index_case::right(automaton.cases[c]);
    if ((left == index_case::dashed) != (right == index_case::dashed) || automaton.cases[c] == index_case::through)
      continue;
    if (index_case::reaches_port(left) && index_case::reaches_port(right) && !may_join) continue;
    const bool swap = (left == index_case::port && right == index_case::port) ||
                      (left >= index_case::along && right >= index_case::along);
    best.offer({c, 0, 0, false, whole.cost(c) + (swap ? automaton.swap : 0), true});
  }
  // The first link is the last one, too.
  whole.for_each_link(best.first, [&](std::size_t m, bool solid) { color(m - 1, solid); });
  return best.cost;
}

template <class Letters, class Color>
constexpr int walk_index_open_split(std::size_t k, std::size_t i, std::size_t j, const Letters& letters,
                                    IndexArc::Entry* room, Color&& color) noexcept {
  constexpr const auto& cases = tables::index_automaton.cases;
  IndexArc below(room);
  IndexArc one(room + i);
  IndexArc above(room + j);
  below.read(letters, 0, i);
  one.read(letters, i, j);
  above.read(letters, j, k);
  // In ring order the second arc is what lies above D, the boundary, what lies below A.
  ArcPorts around = above.ports();
  if (around.count == 0) around = below.ports();
  around.count = above.ports().count + below.ports().count;
  around.two_joined = false;
  const unsigned forbidden = ~joined_ends(one.ports(), around);
  IndexChoice best;
  for (std::size_t y = above.first_case(); y < above.last_case(); ++y) {
    if (index_case::right(cases[y]) != index_case::dashed) continue;
    for (std::size_t z = below.first_case(); z < below.last_case(); ++z) {
      if (index_case::left(cases[z]) != index_case::dashed) continue;
      const unsigned second = 5 * index_case::left(cases[y]) + index_case::right(cases[z]);
      for (std::size_t x = one.first_case(); x < one.last_case(); ++x)
        for (const bool chord : {true, false}) {
          const IndexWay& way = index_ways[2 * (index_case::count * cases[x] + second) + (chord ? 1 : 0)];
          if (way.sound && (way.joins & forbidden) == 0)
            best.offer({x, y, z, chord, one.cost(x) + above.cost(y) + below.cost(z) + way.cost, true});
        }
    }
  }
  // An arc's link at the boundary is no edge.
  below.for_each_link(best.third, [&](std::size_t m, bool solid) { color(m - 1, solid); });
  color(i, one.for_each_link(best.first, [&](std::size_t m, bool solid) { color(i + m, solid); }));
  const bool behind_d = above.for_each_link(best.second, [&](std::size_t m, bool solid) {
    if (m < k - j) color(j + 1 + m, solid);
  });
  if (j < k) color(j + 1, behind_d);
  color(k + 1, best.chord);
  return best.cost;
}

template <class Letters, class Color>
constexpr int walk_index_boundary_split(std::size_t k, std::size_t i, const Letters& letters, IndexArc::Entry* room,
                                        Color&& color) noexcept {
  constexpr const auto& automaton = tables::index_automaton;
  IndexArc below(room);
  IndexArc above(room + i);
  below.read(letters, 0, i);
  above.read(letters, i, k);
  IndexChoice best;
  for (std::size_t x = below.first_case(); x < below.last_case(); ++x) {
    if (index_case::left(automaton.cases[x]) != index_case::dashed) continue;
    const unsigned before = index_case::right(automaton.cases[x]);
    for (std::size_t y = above.first_case(); y < above.last_case(); ++y) {
      if (index_case::right(automaton.cases[y]) != index_case::dashed) continue;
      const unsigned after = index_case::left(automaton.cases[y]);
      if (index_case::reaches_port(before) && index_case::reaches_port(after) && !above.ports().first_joined) continue;
      const bool isolated = before == index_case::dashed && after == index_case::dashed;
      const int cost = automaton.swap * swaps_around(before, after, false) + (isolated ? automaton.isolated : 0) -
                       (before != index_case::dashed ? automaton.restart : 0);
      best.offer({x, y, 0, false, below.cost(x) + above.cost(y) + cost, true});
    }
  }
  below.for_each_link(best.first, [&](std::size_t m, bool solid) { color(m - 1, solid); });
  const bool behind_a = above.for_each_link(best.second, [&](std::size_t m, bool solid) {
    if (m < k - i) color(i + m, solid);
  });
  if (i < k) color(i, behind_a);
  return best.cost;
}

template <class Letters, class Color>
constexpr int walk_index_fan_collapse(std::size_t k, const Letters& letters, IndexArc::Entry* room,
                                      Color&& color) noexcept {
  IndexArc whole(room);
  whole.read(letters, 0, k);
  // Every class has the case with both links dashed, and it comes first.
  const std::size_t dashed = whole.first_case();
  whole.for_each_link(dashed, [&](std::size_t m, bool solid) {
    if (m < k) color(m - 1, solid);
  });
  return whole.cost(dashed);
}

}  // namespace restrip::detail
