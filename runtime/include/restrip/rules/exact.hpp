// Rules for fans of any valence, looked up by their key in the automaton of all valences
// (restrip/tables/automaton.hpp): all open fans, and closed ones too large for the tables. For small closed fans they
// are as good as the rules of the tables. docs/explanation/automaton.md says how they are checked.
//
// A recolouring keeps every port. It is sound when every triangle keeps at most two solid edges, nothing inside is a
// solid cycle, and it joins only ports that were joined before. Of all sound recolourings these functions return one
// with the most solid edges, and among these one with the fewest isolated triangles. docs/reference/notation.md has the
// order of preference, the numbering of all bits, and the proof that only (ports, joined) matters. Remaining ties are
// broken in the same way on every machine, but not as in the tables: compare counts with the tables, not colours.
//
// Input. `ports` has k bits. `joined` has k bits as restrip/rules/key.hpp computes them; with exactly two solid ports
// in a closed fan either bit stands for the pair. Bits of `joined` without a solid port are ignored. Any pair of masks
// is safe: for a key that no valid configuration has, the result is still the best recolouring that joins no other
// pairs. All positions are supported (1 <= a < k, gaps i < j), not only the ones listed in docs/reference/notation.md.
// A position out of range is a programming error, found in debug builds (precondition.hpp). k is less than 2^26.
//
// Complexity. Two table reads for each triangle: time linear in k. Words, and bit strings with k <= 64, neither
// allocate nor throw. Longer bit strings make one allocation of two bytes a triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/key.hpp"
#include "restrip/tables/automaton.hpp"

// A walk over one arc of a fan by the automaton of all valences: forwards from class to class, backwards from case to
// case. restrip/tables/automaton_format.hpp says what classes, cases, letters and links are, and how the arcs of each
// operation are cut.

namespace restrip::detail {

/// The key of a fan as letters: 0 not solid, 1 solid, 2 solid and may be joined to the solid port before it.
struct WordLetters {
  Word ports;
  Word joined;  ///< of solid ports

  constexpr WordLetters(const Patch& patch, Word solid, Word may_join) noexcept
      : ports(solid), joined(may_join & solid) {
    const Word but_one = ports & (ports - 1);
    if (!patch.ring)
      joined &= but_one;  // in an open fan nothing lies before the first solid port
    else if (joined != 0 && but_one != 0 && (but_one & (but_one - 1)) == 0)
      joined = ports;  // with exactly two solid ports in a closed fan either bit stands for the pair, from both sides
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

  constexpr LongLetters(const Patch& patch, BitSpan solid, BitSpan may_join) noexcept : ports(solid), joined(may_join) {
    const std::size_t one = ports.first_set(0, patch.k);
    if (!patch.ring) {
      first = one;
      return;
    }
    const std::size_t two = one == nowhere ? nowhere : ports.first_set(one + 1, patch.k);
    const bool exactly_two = two != nowhere && ports.first_set(two + 1, patch.k) == nowhere;
    pair = exactly_two && (joined[one] || joined[two]);
  }
  [[nodiscard]] constexpr unsigned operator[](std::size_t i) const noexcept {
    return !ports[i] ? 0 : pair || (joined[i] && i != first) ? 2 : 1;
  }
};

/// A letter after a class, as a number.
using ArcEntry = std::uint16_t;

/// An arc with any number of letters.
class ArcWalk {
 public:
  /// `room` gets an entry for each letter and must outlive the walk.
  constexpr explicit ArcWalk(ArcEntry* room) noexcept : entries_(room) {}

  constexpr void read(unsigned letter) noexcept {
    const auto entry = static_cast<ArcEntry>(tables::automaton.letters * class_ + letter);
    entries_[size_++] = entry;
    class_ = tables::automaton.next[entry];
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
      link(m, (end & tables::automaton.solid) != 0);
      // The case before letter m - 1, from the case after it.
      end = static_cast<unsigned>(tables::automaton.before[entries_[m - 1]] >> (4 * end) & 15U);
    }
    return (end & tables::automaton.solid) != 0;
  }

 private:
  ArcEntry* entries_;
  std::size_t size_ = 0;
  std::size_t class_ = 0;
};

/// The best recolouring of a patch after an operation: color(edge, solid) is called once for every inner edge. `room`
/// has two more entries than the fan has triangles. Two table reads for each triangle; letters are read once.
template <class Letters, class Color>
constexpr void walk_arcs(const Patch& patch, const Letters& letters, ArcEntry* room, Color&& color) noexcept {
  constexpr const auto& automaton = tables::automaton;
  const std::size_t k = patch.k;
  if (patch.has_chord()) {
    const std::size_t i = patch.inserted;
    const std::size_t j = patch.opposite - 1;
    ArcWalk one(room);
    ArcWalk other(room + (j - i));
    one.read(letters, i, j);
    other.read(letters, j, k);
    if (!patch.ring) {
      other.read(automaton.boundary);
      other.read(letters, 0, i);
    }
    // The cases of the two arcs, which meet in the inserted triangles A and D, and the chord.
    const std::size_t place =
        automaton.seconds * automaton.first[one.arc_class()] + automaton.second[other.arc_class()];
    const unsigned meeting = automaton.meetings[automaton.meet[place]];
    color(i, one.for_each_link(meeting & 15U, [&](std::size_t m, bool solid) { color(i + m, solid); }));
    // Of a path, the two links on the boundary are dashed and are not edges; later links come first in path order.
    const std::size_t above = k - j;
    const bool first = other.for_each_link(meeting >> 4 & 15U, [&](std::size_t m, bool solid) {
      if (patch.ring || m < above)
        color(j + 1 + m, solid);
      else if (m > above + 1)
        color(m - (above + 2), solid);
    });
    if (above > 0) color(j + 1, first);
    color(patch.chord(), (meeting >> 8 & 1U) != 0);
    return;
  }
  ArcWalk whole(room);
  const bool inserts = patch.inserted != nowhere;
  const std::size_t gap = inserts ? patch.inserted : k;
  whole.read(letters, 0, gap);
  if (inserts) whole.read(0);
  whole.read(letters, gap, k);
  // The first link of a closed fan is the last one, too. Those at the ends of a path are on the boundary.
  const unsigned end = patch.ring ? unsigned{automaton.closed[whole.arc_class()]} : 0U;
  whole.for_each_link(end, [&](std::size_t m, bool solid) {
    if (patch.ring || m < whole.size()) color(m - 1, solid);
  });
}

/// Isolated triangles of a patch with these colours.
constexpr int isolated(const Patch& patch, Word inner, Word ports) noexcept {
  const Word edges = inner & low_bits(patch.edges());
  const Word wrap = edges >> (patch.size() - 1);  // of a ring; a path lacks this edge
  Word touched = edges | edges << 1 | wrap | patch.spread(ports);
  if (patch.has_chord() && has(inner, patch.chord())) touched |= bit(patch.inserted) | bit(patch.opposite);
  return static_cast<int>(patch.size()) - count_bits(touched & low_bits(patch.size()));
}

constexpr int isolated(const Patch& patch, BitSpan inner, BitSpan ports) noexcept {
  int n = 0;
  for (std::size_t m = 0; m < patch.size(); ++m) {
    const bool above = (patch.ring || m + 1 < patch.size()) && inner[m];
    const bool below = m > 0 ? inner[m - 1] : patch.ring && inner[patch.size() - 1];
    const bool third = patch.is_fan(m) ? ports[patch.port(m)] : patch.has_chord() && inner[patch.chord()];
    n += above || below || third ? 0 : 1;
  }
  return n;
}

}  // namespace restrip::detail

namespace restrip::exact {

/// The value of a recolouring: solid inner edges and isolated triangles in the patch after the operation.
struct Value {
  int solid = 0;
  int isolated = 0;

  friend constexpr bool operator==(const Value&, const Value&) noexcept = default;
};

/// A recolouring that fits one word, and its value.
struct Recoloring {
  Word colors = 0;
  Value value;
};

/// For the patch after the operation, on words: k <= max_word_valence. `colors` has patch.colors() bits.
constexpr Recoloring best(const Patch& patch, Word ports, Word joined) noexcept {
  RESTRIP_ASSERT(patch.k <= max_word_valence, "exact::best", detail::no_such_fan);
  detail::ArcEntry room[max_word_valence + 2];
  Recoloring result;
  detail::walk_arcs(patch, detail::WordLetters(patch, ports, joined), room,
                    [&](std::size_t edge, bool solid) { result.colors |= Word{solid} << edge; });
  result.value = {count_bits(result.colors), detail::isolated(patch, result.colors, ports)};
  return result;
}

/// On bit strings: any k. The colours go to the last argument; the words that hold them are overwritten and must not be
/// the words of the key.
inline Value best(const Patch& patch, BitSpan ports, BitSpan joined, MutableBitSpan colors) {
  const auto write = [&](detail::ArcEntry* room) {
    Value value;
    colors.clear(patch.colors());
    detail::walk_arcs(patch, detail::LongLetters(patch, ports, joined), room, [&](std::size_t edge, bool solid) {
      if (!solid) return;
      colors.set(edge);
      ++value.solid;
    });
    value.isolated = detail::isolated(patch, colors, ports);
    return value;
  };
  constexpr std::size_t max_stack_valence = 64;
  if (patch.k <= max_stack_valence) {
    detail::ArcEntry room[max_stack_valence + 2];
    return write(room);
  }
  std::vector<detail::ArcEntry> room(patch.k + 2);
  return write(room.data());
}

}  // namespace restrip::exact
