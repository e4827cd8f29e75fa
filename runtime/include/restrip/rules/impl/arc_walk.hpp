// A walk over one arc of a fan by the automaton of all valences (restrip/tables/automaton.hpp): forwards from class to
// class, backwards from case to case. restrip/tables/automaton_format.hpp says what classes, cases, letters and links
// are, and how the arcs of each operation are cut.
#pragma once

#include <cstddef>
#include <cstdint>

#include "restrip/rules/bits.hpp"
#include "restrip/tables/automaton.hpp"

namespace restrip::detail {

/// The key of a fan as letters: 0 not solid, 1 solid, 2 solid and may be joined to the solid port before it.
struct WordLetters {
  Word ports = 0;
  Word joined = 0;  ///< of solid ports

  /// With exactly two solid ports in a closed fan either bit of `joined` stands for the pair, from both sides.
  static constexpr WordLetters of_closed(Word ports, Word joined) noexcept {
    const Word but_one = ports & (ports - 1);
    const bool two = but_one != 0 && (but_one & (but_one - 1)) == 0;
    return {ports, two && (joined & ports) != 0 ? ports : joined & ports};
  }
  /// In an open fan nothing lies before the first solid port.
  static constexpr WordLetters of_open(Word ports, Word joined) noexcept {
    return {ports, joined & (ports & (ports - 1))};
  }
  [[nodiscard]] constexpr unsigned operator[](std::size_t i) const noexcept {
    return static_cast<unsigned>((ports >> i & 1) + (joined >> i & 1));
  }
};

/// The letters of fans of any size.
struct LongLetters {
  BitSpan ports;
  BitSpan joined;
  bool pair = false;            ///< exactly two solid ports, which are joined
  std::size_t first = nowhere;  ///< in an open fan, the first solid port

  static constexpr LongLetters of_closed(std::size_t k, BitSpan ports, BitSpan joined) noexcept {
    const std::size_t one = ports.first_set(0, k);
    const std::size_t two = one == nowhere ? nowhere : ports.first_set(one + 1, k);
    const bool exactly_two = two != nowhere && ports.first_set(two + 1, k) == nowhere;
    return {ports, joined, exactly_two && (joined[one] || joined[two]), nowhere};
  }
  static constexpr LongLetters of_open(std::size_t k, BitSpan ports, BitSpan joined) noexcept {
    return {ports, joined, false, ports.first_set(0, k)};
  }
  [[nodiscard]] constexpr unsigned operator[](std::size_t i) const noexcept {
    return !ports[i] ? 0 : pair || (joined[i] && i != first) ? 2 : 1;
  }
};

/// A letter after a class, as a number.
using ArcEntry = std::uint16_t;

/// An arc with any number of letters.
template <const auto& automaton = tables::automaton>
class ArcWalk {
 public:
  /// `room` gets an entry for each letter and must outlive the walk.
  constexpr explicit ArcWalk(ArcEntry* room) noexcept : entries_(room) {}

  constexpr void read(unsigned letter) noexcept {
    const auto entry = static_cast<ArcEntry>(automaton.letters * class_ + letter);
    entries_[size_++] = entry;
    class_ = automaton.next[entry];
  }
  template <class Letters>
  constexpr void read(const Letters& letters, std::size_t from, std::size_t to) noexcept {
    for (std::size_t i = from; i < to; ++i) read(letters[i]);
  }

  /// The class of the arc read so far.
  [[nodiscard]] constexpr std::size_t arc_class() const noexcept { return class_; }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

  /// Calls link(m, solid) for the links from the last to the second, m = the number of letters to the left; returns
  /// whether the first is solid. `end` is the case of the whole arc.
  template <class Link>
  constexpr bool for_each_link(unsigned end, Link&& link) const noexcept {
    for (std::size_t m = size_; m > 0; --m) {
      link(m, (end & automaton.solid) != 0);
      end = before(m - 1, end);
    }
    return (end & automaton.solid) != 0;
  }

  /// The case before letter m, from the case after it.
  [[nodiscard]] constexpr unsigned before(std::size_t m, unsigned end) const noexcept {
    return static_cast<unsigned>(automaton.before[entries_[m]] >> (4 * end) & 15U);
  }

 private:
  ArcEntry* entries_;
  std::size_t size_ = 0;
  std::size_t class_ = 0;
};

/// The cases of two arcs that meet in the inserted triangles A and D.
struct ArcMeeting {
  unsigned first = 0;   ///< the case of the arc from A to D
  unsigned second = 0;  ///< the case of the arc from D to A
  bool chord = false;

  constexpr ArcMeeting(const ArcWalk<>& one, const ArcWalk<>& other) noexcept {
    constexpr const auto& automaton = tables::automaton;
    const std::size_t place =
        automaton.seconds * automaton.first[one.arc_class()] + automaton.second[other.arc_class()];
    const unsigned meeting = automaton.meetings[automaton.meet[place]];
    first = meeting & 15U;
    second = meeting >> 4 & 15U;
    chord = (meeting >> 8 & 1U) != 0;
  }
};

/// The best recolouring of each family: color(edge, solid) is called once for every inner edge. `room` has two more
/// entries than the fan has triangles. Two table reads for each triangle; letters are read once.
template <class Letters, class Color>
constexpr void walk_split(std::size_t k, std::size_t a, const Letters& letters, ArcEntry* room,
                          Color&& color) noexcept {
  ArcWalk<> one(room);
  ArcWalk<> other(room + a);
  one.read(letters, 0, a);
  other.read(letters, a, k);
  const ArcMeeting meeting(one, other);
  color(0, one.for_each_link(meeting.first, color));
  color(a + 1, other.for_each_link(meeting.second, [&](std::size_t m, bool solid) { color(a + 1 + m, solid); }));
  color(k + 2, meeting.chord);
}

template <class Letters, class Color>
constexpr void walk_collapse(std::size_t k, const Letters& letters, ArcEntry* room, Color&& color) noexcept {
  ArcWalk<> whole(room);
  whole.read(letters, 0, k);
  // The first link is the last one, too.
  whole.for_each_link(tables::automaton.closed[whole.arc_class()],
                      [&](std::size_t m, bool solid) { color(m - 1, solid); });
}

/// An arc that begins inside an open fan, goes over the boundary and ends inside. It has `above` triangles before the
/// boundary; its first link is edge `from`, and the edges after the boundary count from 0.
template <class Color>
constexpr void color_around(const ArcWalk<>& arc, unsigned end, std::size_t above, std::size_t from,
                            Color&& color) noexcept {
  const bool first = arc.for_each_link(end, [&](std::size_t m, bool solid) {
    // The two links on the boundary are dashed and are not edges; later links come first in path order.
    if (m < above)
      color(from + m, solid);
    else if (m > above + 1)
      color(m - (above + 2), solid);
  });
  if (above > 0) color(from, first);
}

template <class Letters, class Color>
constexpr void walk_open_split(std::size_t k, std::size_t i, std::size_t j, const Letters& letters, ArcEntry* room,
                               Color&& color) noexcept {
  ArcWalk<> one(room);
  ArcWalk<> other(room + (j - i));
  one.read(letters, i, j);
  other.read(letters, j, k);
  other.read(tables::automaton.boundary);
  other.read(letters, 0, i);
  const ArcMeeting meeting(one, other);
  color(i, one.for_each_link(meeting.first, [&](std::size_t m, bool solid) { color(i + m, solid); }));
  color_around(other, meeting.second, k - j, j + 1, color);
  color(k + 1, meeting.chord);
}

/// An arc between two boundaries: the links there are dashed and are not edges.
template <class Color>
constexpr void color_path(const ArcWalk<>& path, Color&& color) noexcept {
  path.for_each_link(0, [&](std::size_t m, bool solid) {
    if (m < path.size()) color(m - 1, solid);
  });
}

template <class Letters, class Color>
constexpr void walk_boundary_split(std::size_t k, std::size_t i, const Letters& letters, ArcEntry* room,
                                   Color&& color) noexcept {
  ArcWalk<> path(room);
  path.read(letters, 0, i);
  path.read(0);
  path.read(letters, i, k);
  color_path(path, color);
}

template <class Letters, class Color>
constexpr void walk_fan_collapse(std::size_t k, const Letters& letters, ArcEntry* room, Color&& color) noexcept {
  ArcWalk<> path(room);
  path.read(letters, 0, k);
  color_path(path, color);
}

}  // namespace restrip::detail
