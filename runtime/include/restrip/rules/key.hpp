// Patch: the triangles of a fan, and of what a split makes of it, as one row; whether its colours are valid; and the
// key of its colours, which is all that a rule depends on. docs/reference/notation.md defines patches, numbering and
// key.
//
//   patch.valid(inner, ports)    at most two solid edges at every triangle, no solid cycle, no bit outside the patch.
//   patch.joined(inner, ports)   the mask `joined`: bit i is set when port i is solid and a solid path inside the patch
//                                leads from it to the solid port before it (the nearest in descending order; cyclic in
//                                a closed fan and in a ring with chord).
//
// The key consists of the masks `ports` and `joined`. With exactly two solid ports in a closed fan or a ring, each
// precedes the other, and the pair has two bits. EITHER BIT STANDS FOR THE PAIR: joined() may set one of them or both.
//
// Each function has two versions. The one on masks needs k <= max_word_valence, takes constant time and is constexpr.
// The one on bit strings accepts any k and takes time linear in k. Neither allocates.
//
// Bad input. A position out of range or k beyond the limit is a programming error, found in debug builds
// (precondition.hpp). joined() needs valid colours. For other colours its result has no meaning, but it returns, and
// reads and writes nothing outside its arguments.
#pragma once

#include <cstddef>
#include <initializer_list>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"

namespace restrip {

/// The largest k whose colours fit one word in every family: a ring with chord has k + 3 inner edges.
inline constexpr std::size_t max_word_valence = word_bits - 3;

namespace detail {

// Positions out of range are a programming error, found in debug builds.
inline constexpr const char* no_such_fan = "k is out of range: 1 <= k; on masks, k <= max_word_valence";
inline constexpr const char* no_such_split = "the position is out of range: 3 <= k <= max_word_valence, 1 <= a < k";
inline constexpr const char* no_such_arc = "the position is out of range: 1 <= a < k; on masks, k <= max_word_valence";
inline constexpr const char* no_such_gaps = "the position is out of range: i < j <= k; on masks, k <= max_word_valence";
inline constexpr const char* no_such_gap =
    "the position is out of range: 1 <= k, i <= k; on masks, k <= max_word_valence";

}  // namespace detail

/// A row of elements: the fan's triangles in order, with the inserted ones among them. Element m and element m+1 are
/// joined by inner edge m; in a ring the last element is joined to the first as well. With a chord, its bit follows the
/// edges. Fans are rows without inserted elements.
struct Patch {
  std::size_t k = 0;               ///< triangles of the fan, that is, ports
  std::size_t inserted = nowhere;  ///< element A
  std::size_t opposite = nowhere;  ///< element D, always after A
  bool ring = false;

  constexpr bool has_chord() const noexcept { return opposite != nowhere; }
  constexpr std::size_t size() const noexcept { return k + (inserted != nowhere) + (opposite != nowhere); }
  constexpr std::size_t edges() const noexcept { return ring ? size() : size() - 1; }
  constexpr std::size_t chord() const noexcept { return edges(); }
  /// The number of inner edges, that is, of bits of `inner`.
  constexpr std::size_t colors() const noexcept { return edges() + has_chord(); }

  constexpr bool is_fan(std::size_t element) const noexcept { return element != inserted && element != opposite; }

  /// The element of the triangle that owns a port, and back.
  constexpr std::size_t element(std::size_t port) const noexcept {
    const std::size_t below_d = port + (port >= inserted);
    return below_d + (below_d >= opposite);
  }
  constexpr std::size_t port(std::size_t element) const noexcept {
    return element - (element > inserted) - (element > opposite);
  }

  /// Ports as a mask over elements, and back. A comes before D, so its zero goes in first and leaves last.
  constexpr Word spread(Word ports) const noexcept { return insert_zero(insert_zero(ports, inserted), opposite); }
  constexpr Word gather(Word elements) const noexcept { return remove_bit(remove_bit(elements, opposite), inserted); }

  constexpr bool valid(Word inner, Word ports) const noexcept;
  constexpr Word joined(Word inner, Word ports) const noexcept;
  /// On bit strings; bits beyond the patch are not read. `result` must have room for k bits; the words that hold them
  /// are overwritten.
  bool valid(BitSpan inner, BitSpan ports) const noexcept;
  void joined(BitSpan inner, BitSpan ports, MutableBitSpan result) const noexcept;
};

/// Closed fan, k >= 1: inner has k bits.
constexpr Patch closed_fan(std::size_t k) noexcept {
  RESTRIP_ASSERT(k >= 1, "closed_fan", detail::no_such_fan);
  return {k, nowhere, nowhere, true};
}
/// Open fan, k >= 1: inner has k - 1 bits.
constexpr Patch open_fan(std::size_t k) noexcept {
  RESTRIP_ASSERT(k >= 1, "open_fan", detail::no_such_fan);
  return {k, nowhere, nowhere, false};
}
/// Ring with chord, 1 <= a < k: inner has k + 3 bits. A is element 0, D is element a + 1.
constexpr Patch ring_with_chord(std::size_t k, std::size_t a) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k, "ring_with_chord", detail::no_such_arc);
  return {k, 0, a + 1, true};
}
/// Path with chord, 0 <= i < j <= k: inner has k + 2 bits.
constexpr Patch path_with_chord(std::size_t k, std::size_t i, std::size_t j) noexcept {
  RESTRIP_ASSERT(i < j && j <= k, "path_with_chord", detail::no_such_gaps);
  return {k, i, j + 1, false};
}
/// Path, k >= 1, 0 <= i <= k: inner has k bits.
constexpr Patch path(std::size_t k, std::size_t i) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k, "path", detail::no_such_gap);
  return {k, i, nowhere, false};
}

namespace detail {

/// The far end of the strand at an element with exactly one solid edge among `edges`.
constexpr std::size_t strand_end(const Patch& patch, Word edges, std::size_t at) noexcept {
  if (has(edges, at)) return at + static_cast<std::size_t>(std::countr_one(edges >> at));
  if (at == 0) at = patch.size();  // downwards from the first element of a ring
  return at - static_cast<std::size_t>(std::countl_one(edges << (word_bits - at)));
}

/// The two solid ports that a path over the chord joins, as a mask over elements; zero if no such path exists.
constexpr Word ends_over_chord(const Patch& patch, Word edges, Word ports) noexcept {
  const std::size_t a = patch.inserted;
  const std::size_t d = patch.opposite;
  const bool below_a = has(edges, a == 0 ? patch.edges() - 1 : a - 1) && (a != 0 || patch.ring);
  if (below_a == has(edges, a) || has(edges, d - 1) == has(edges, d)) return 0;
  const std::size_t one = strand_end(patch, edges, a);
  const std::size_t two = strand_end(patch, edges, d);
  return one != two && has(ports, one) && has(ports, two) ? bit(one) | bit(two) : 0;
}

/// The bit that names a joined pair in a key; zero if no pair is joined that a key can name. (Without ends all of these
/// masks are zero.)
constexpr Word name_of_pair(const Patch& patch, Word ends, Word ports) noexcept {
  const Word high = std::bit_floor(ends);
  const Word low = ends ^ high;
  const Word within = (high | (high - 1)) & ~(low - 1);
  if ((ports & within) == ends) return high;
  return patch.ring && (ports & ~within) == 0 ? low : 0;
}

/// What a patch joins: the pairs that a key names, and the two ports that a path over the chord joins, which need not
/// be neighbours; zero if none exist.
struct InnerPairs {
  Word joined = 0;
  Word over_chord = 0;
};

/// A strand starts upwards where a solid port meets the solid edge above it. Adding that start to the edges sends a
/// carry through the run of solid edges, which are ones, and it stops at the element where the run ends. Valid
/// colours have at most one start in a run, and it sits at the run's lower end.
[[gnu::always_inline]] constexpr InnerPairs inner_pairs(const Patch& patch, Word inner, Word fan_ports) noexcept {
  RESTRIP_ASSERT(patch.k <= max_word_valence, "Patch::joined", no_such_fan);
  const Word ports = patch.spread(fan_ports);
  const Word edges = inner & low_bits(patch.edges());
  Word ends = edges + (ports & edges);
  if (patch.ring) ends = (ends & low_bits(patch.size())) + (ends >> patch.size());  // the carry goes round
  const Word along = ends & ~edges & ports;
  if (!patch.has_chord() || !has(inner, patch.chord())) return {patch.gather(along), 0};
  const Word pair = ends_over_chord(patch, edges, ports);
  return {patch.gather(along | name_of_pair(patch, pair, ports)), patch.gather(pair)};
}

}  // namespace detail

[[gnu::always_inline]] constexpr Word Patch::joined(Word inner, Word ports) const noexcept {
  return detail::inner_pairs(*this, inner, ports).joined;
}

[[gnu::always_inline]] constexpr bool Patch::valid(Word inner, Word fan_ports) const noexcept {
  RESTRIP_ASSERT(k <= max_word_valence, "Patch::valid", detail::no_such_fan);
  if ((inner & ~low_bits(colors())) != 0 || (fan_ports & ~low_bits(k)) != 0) return false;
  const Word all = low_bits(edges());
  const Word solid = inner & all;
  const Word below = (solid << 1) | (solid >> (size() - 1));  // a path lacks the edge that closes a ring
  const bool solid_chord = has_chord() && has(inner, chord());
  // The chord is the third edge of A and D, as a port is of the other triangles.
  const Word third = spread(fan_ports) | (solid_chord ? bit(inserted) | bit(opposite) : 0);
  if ((solid & below & third) != 0) return false;
  if (ring && solid == all) return false;
  if (!solid_chord) return true;
  const Word between = low_bits(opposite) & ~low_bits(inserted);
  return (~solid & between) != 0 && (!ring || (~solid & all & ~between) != 0);
}

// ---- On bit strings of any length: a walk, one step an element.

namespace detail {

struct Walker {
  Patch patch;
  BitSpan inner;
  BitSpan ports;

  bool port(std::size_t element) const noexcept { return patch.is_fan(element) && ports[patch.port(element)]; }
  bool above(std::size_t element) const noexcept { return element < patch.edges() && inner[element]; }
  bool below(std::size_t element) const noexcept {
    return element != 0 ? inner[element - 1] : patch.ring && inner[patch.edges() - 1];
  }
  bool chord() const noexcept { return patch.has_chord() && inner[patch.chord()]; }

  // The far end of the strand at an element with exactly one solid edge in the row. In a ring the other one ends it.
  std::size_t strand_end(std::size_t at) const noexcept {
    const std::size_t n = patch.size();
    const bool up = above(at);
    while (up ? above(at) : below(at)) at = up ? (at + 1) % n : (at + n - 1) % n;
    return at;
  }

  bool any_port(std::size_t from, std::size_t to) const noexcept {
    for (std::size_t e = from; e < to; ++e) {
      if (port(e)) return true;
    }
    return false;
  }

  bool all_solid(std::size_t from, std::size_t to) const noexcept {
    for (std::size_t e = from; e < to; ++e) {
      if (!inner[e]) return false;
    }
    return true;
  }

  void joined(MutableBitSpan result) const noexcept {
    result.clear(patch.k);
    const std::size_t n = patch.size();
    bool live = false;  // a strand from a solid port comes in from below
    // The first round only determines whether a strip enters at the start of a ring.
    for (const bool known : {false, true}) {
      for (std::size_t e = 0; e < n; ++e) {
        const bool solid_port = port(e);
        if (known && live && solid_port) result.set(patch.port(e));
        live = above(e) && (live || solid_port);
      }
    }
    if (!chord()) return;
    const std::size_t a = patch.inserted;
    const std::size_t d = patch.opposite;
    if (below(a) == above(a) || below(d) == above(d)) return;
    const std::size_t one = strand_end(a);
    const std::size_t two = strand_end(d);
    const std::size_t low = one < two ? one : two;
    const std::size_t high = one < two ? two : one;
    if (low == high || !port(low) || !port(high)) return;
    if (!any_port(low + 1, high)) {
      result.set(patch.port(high));
    } else if (patch.ring && !any_port(0, low) && !any_port(high + 1, n)) {
      result.set(patch.port(low));
    }
  }

  bool valid() const noexcept {
    const std::size_t n = patch.size();
    for (std::size_t e = 0; e < n; ++e) {
      const bool third = patch.is_fan(e) ? port(e) : chord();
      if (third && above(e) && below(e)) return false;
    }
    if (patch.ring && all_solid(0, patch.edges())) return false;
    if (!chord()) return true;
    if (all_solid(patch.inserted, patch.opposite)) return false;
    return !patch.ring || !all_solid(patch.opposite, patch.edges());  // A is the first element of a ring
  }
};

}  // namespace detail

inline bool Patch::valid(BitSpan inner, BitSpan ports) const noexcept {
  return detail::Walker{*this, inner, ports}.valid();
}
inline void Patch::joined(BitSpan inner, BitSpan ports, MutableBitSpan result) const noexcept {
  detail::Walker{*this, inner, ports}.joined(result);
}

}  // namespace restrip
