// The key of a configuration, which is all that its rule depends on, and a test whether colours are valid.
// docs/reference/notation.md defines patches, numbering and key.
//
//   joined_PATCH   the mask `joined`: bit i is set when port i is solid and a solid path inside the patch leads from
//                  it to the solid port before it (the nearest in descending order; cyclic in a closed fan and in a
//                  ring with chord).
//   valid_PATCH    at most two solid edges at every triangle, no solid cycle, no bit outside the patch.
//
// PATCH is `closed` or `open` for fans, and `ring` (with chord), `path_with_chord` or `path` for the patches that
// splits make of fans. The key consists of the masks `ports` and `joined`.
//
// With exactly two solid ports in a closed fan or a ring, each precedes the other, and the pair has two bits. EITHER
// BIT STANDS FOR THE PAIR: the functions here may set one of them or both.
//
// Each function has two versions. The one on masks needs k <= max_word_valence, takes constant time and is constexpr.
// The one on bit strings accepts any k and takes time linear in k. Neither allocates.
//
// Bad input. A position out of range or k beyond the limit is a programming error, found in debug builds
// (precondition.hpp). The joined_ functions need valid colours. For other colours their result has no meaning, but they
// return, and read and write nothing outside their arguments.
#pragma once

#include <cstddef>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/impl/key_any_length.hpp"
#include "restrip/rules/impl/layout.hpp"

namespace restrip {

/// The largest k whose colours fit one word in every family: a ring with chord has k + 3 inner edges.
inline constexpr std::size_t max_word_valence = word_bits - 3;

namespace detail {

/// The far end of the strand at an element with exactly one solid edge among `edges`.
constexpr std::size_t strand_end(const Layout& patch, Word edges, std::size_t at) noexcept {
  if (has(edges, at)) return at + static_cast<std::size_t>(std::countr_one(edges >> at));
  if (at == 0) at = patch.size();  // downwards from the first element of a ring
  return at - static_cast<std::size_t>(std::countl_one(edges << (word_bits - at)));
}

/// The two solid ports that a path over the chord joins, as a mask over elements; zero if no such path exists.
constexpr Word ends_over_chord(const Layout& patch, Word edges, Word ports) noexcept {
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
constexpr Word name_of_pair(const Layout& patch, Word ends, Word ports) noexcept {
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
constexpr InnerPairs inner_pairs(const Layout& patch, Word inner, Word fan_ports) noexcept {
  RESTRIP_ASSERT(patch.k <= max_word_valence, "key of a mask", no_such_fan);
  const Word ports = patch.spread(fan_ports);
  const Word edges = inner & low_bits(patch.edges());
  Word ends = edges + (ports & edges);
  if (patch.ring) ends = (ends & low_bits(patch.size())) + (ends >> patch.size());  // the carry goes round
  const Word along = ends & ~edges & ports;
  if (!patch.has_chord() || !has(inner, patch.chord())) return {patch.gather(along), 0};
  const Word pair = ends_over_chord(patch, edges, ports);
  return {patch.gather(along | name_of_pair(patch, pair, ports)), patch.gather(pair)};
}

constexpr Word joined(const Layout& patch, Word inner, Word fan_ports) noexcept {
  return inner_pairs(patch, inner, fan_ports).joined;
}

constexpr bool valid(const Layout& patch, Word inner, Word fan_ports) noexcept {
  RESTRIP_ASSERT(patch.k <= max_word_valence, "key of a mask", no_such_fan);
  if ((inner & ~low_bits(patch.colors())) != 0 || (fan_ports & ~low_bits(patch.k)) != 0) return false;
  const Word edges = inner & low_bits(patch.edges());
  const Word below = (edges << 1) | (edges >> (patch.size() - 1));  // a path lacks the edge that closes a ring
  const bool chord = patch.has_chord() && has(inner, patch.chord());
  // The chord is the third edge of A and D, as a port is of the other triangles.
  const Word third = patch.spread(fan_ports) | (chord ? bit(patch.inserted) | bit(patch.opposite) : 0);
  if ((edges & below & third) != 0) return false;
  if (patch.ring && edges == low_bits(patch.edges())) return false;
  if (!chord) return true;
  const Word between = low_bits(patch.opposite) & ~low_bits(patch.inserted);
  const Word around = low_bits(patch.edges()) & ~between;
  return (~edges & between) != 0 && (!patch.ring || (~edges & around) != 0);
}

}  // namespace detail

// ---- Masks: k <= max_word_valence, constant time ----

/// Ordinary splits and collapses use closed fans and rings, so their formulas are written out. They are the
// general formulas above with the places of A and D put in.

// Closed fan, k >= 3: loop has k bits.
constexpr Word joined_closed(std::size_t k, Word loop, Word ports) noexcept {
  RESTRIP_ASSERT(k >= 3 && k <= max_word_valence, "joined_closed", detail::no_such_closed_fan);
  const Word ends = loop + (ports & loop);
  return ((ends & low_bits(k)) + (ends >> k)) & ~loop & ports;
}
constexpr bool valid_closed(std::size_t k, Word loop, Word ports) noexcept {
  RESTRIP_ASSERT(k >= 3 && k <= max_word_valence, "valid_closed", detail::no_such_closed_fan);
  const Word all = low_bits(k);
  const Word below = loop << 1 | loop >> (k - 1);
  return ((loop | ports) & ~all) == 0 && (loop & below & ports) == 0 && loop != all;
}

// Open fan, k >= 1: loop has k - 1 bits.
constexpr Word joined_open(std::size_t k, Word loop, Word ports) noexcept {
  RESTRIP_ASSERT(k >= 1 && k <= max_word_valence, "joined_open", detail::no_such_fan);
  return detail::joined(detail::open_fan(k), loop, ports);
}
constexpr bool valid_open(std::size_t k, Word loop, Word ports) noexcept {
  RESTRIP_ASSERT(k >= 1 && k <= max_word_valence, "valid_open", detail::no_such_fan);
  return detail::valid(detail::open_fan(k), loop, ports);
}

/// Ports of a ring with chord as a mask over its elements: A is element 0, D is element a + 1.
constexpr Word ring_ports(std::size_t a, Word ports) noexcept {
  return (ports & low_bits(a)) << 1 | (ports >> a) << (a + 2);
}

namespace detail {

/// inner_pairs() of a ring with chord, both at once. (GCC 12 at -O3 gets `over_chord` wrong if it is computed again
/// separately.)
constexpr InnerPairs ring_pairs(std::size_t k, std::size_t a, Word inner, Word ports) noexcept {
  const Word edges = inner & low_bits(k + 2);
  const Word elements = ring_ports(a, ports);
  const Word ends = edges + (elements & edges);
  const auto back = [a](Word of_elements) { return (of_elements >> 1 & low_bits(a)) | (of_elements >> (a + 2)) << a; };
  const Word along = ((ends & low_bits(k + 2)) + (ends >> (k + 2))) & ~edges & elements;
  if (!has(inner, k + 2)) return {back(along), 0};
  const Layout ring = ring_with_chord(k, a);
  const Word pair = ends_over_chord(ring, edges, elements);
  return {back(along | name_of_pair(ring, pair, elements)), back(pair)};
}

}  // namespace detail

// Ring with chord, 1 <= a < k: inner has k + 3 bits.
constexpr Word joined_ring(std::size_t k, std::size_t a, Word inner, Word ports) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k && k <= max_word_valence, "joined_ring", detail::no_such_arc);
  return detail::ring_pairs(k, a, inner, ports).joined;
}
constexpr bool valid_ring(std::size_t k, std::size_t a, Word inner, Word ports) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k && k <= max_word_valence, "valid_ring", detail::no_such_arc);
  const Word all = low_bits(k + 2);
  const Word edges = inner & all;
  const Word chord = inner >> (k + 2) & 1;
  const Word below = edges << 1 | edges >> (k + 1);
  const Word third = ring_ports(a, ports) | chord | chord << (a + 1);
  if ((inner & ~low_bits(k + 3)) != 0 || (ports & ~low_bits(k)) != 0) return false;
  if ((edges & below & third) != 0 || edges == all) return false;
  const Word first_arc = low_bits(a + 1);
  return chord == 0 || ((~edges & first_arc) != 0 && (~edges & all & ~first_arc) != 0);
}

// Path with chord, 0 <= i < j <= k: inner has k + 2 bits.
constexpr Word joined_path_with_chord(std::size_t k, std::size_t i, std::size_t j, Word inner, Word ports) noexcept {
  RESTRIP_ASSERT(i < j && j <= k && k <= max_word_valence, "joined_path_with_chord", detail::no_such_gaps);
  return detail::joined(detail::path_with_chord(k, i, j), inner, ports);
}
constexpr bool valid_path_with_chord(std::size_t k, std::size_t i, std::size_t j, Word inner, Word ports) noexcept {
  RESTRIP_ASSERT(i < j && j <= k && k <= max_word_valence, "valid_path_with_chord", detail::no_such_gaps);
  return detail::valid(detail::path_with_chord(k, i, j), inner, ports);
}

/// Path, 0 <= i <= k: inner has k bits.
constexpr Word joined_path(std::size_t k, std::size_t i, Word inner, Word ports) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k && k <= max_word_valence, "joined_path", detail::no_such_gap);
  return detail::joined(detail::path(k, i), inner, ports);
}
constexpr bool valid_path(std::size_t k, std::size_t i, Word inner, Word ports) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k && k <= max_word_valence, "valid_path", detail::no_such_gap);
  return detail::valid(detail::path(k, i), inner, ports);
}

// ---- Bit strings: any k, linear time ----
//
// `joined` must have room for k bits; the words that hold them are overwritten. Bits beyond the patch are not read.

inline void joined_closed(std::size_t k, BitSpan loop, BitSpan ports, MutableBitSpan joined) noexcept {
  RESTRIP_ASSERT(k >= 3, "joined_closed", detail::no_such_closed_fan);
  detail::Walker{detail::closed_fan(k), loop, ports}.joined(joined);
}
inline bool valid_closed(std::size_t k, BitSpan loop, BitSpan ports) noexcept {
  RESTRIP_ASSERT(k >= 3, "valid_closed", detail::no_such_closed_fan);
  return detail::Walker{detail::closed_fan(k), loop, ports}.valid();
}

inline void joined_open(std::size_t k, BitSpan loop, BitSpan ports, MutableBitSpan joined) noexcept {
  RESTRIP_ASSERT(k >= 1, "joined_open", detail::no_such_fan);
  detail::Walker{detail::open_fan(k), loop, ports}.joined(joined);
}
inline bool valid_open(std::size_t k, BitSpan loop, BitSpan ports) noexcept {
  RESTRIP_ASSERT(k >= 1, "valid_open", detail::no_such_fan);
  return detail::Walker{detail::open_fan(k), loop, ports}.valid();
}

inline void joined_ring(std::size_t k, std::size_t a, BitSpan inner, BitSpan ports, MutableBitSpan joined) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k, "joined_ring", detail::no_such_arc);
  detail::Walker{detail::ring_with_chord(k, a), inner, ports}.joined(joined);
}
inline bool valid_ring(std::size_t k, std::size_t a, BitSpan inner, BitSpan ports) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k, "valid_ring", detail::no_such_arc);
  return detail::Walker{detail::ring_with_chord(k, a), inner, ports}.valid();
}

inline void joined_path_with_chord(std::size_t k, std::size_t i, std::size_t j, BitSpan inner, BitSpan ports,
                                   MutableBitSpan joined) noexcept {
  RESTRIP_ASSERT(i < j && j <= k, "joined_path_with_chord", detail::no_such_gaps);
  detail::Walker{detail::path_with_chord(k, i, j), inner, ports}.joined(joined);
}
inline bool valid_path_with_chord(std::size_t k, std::size_t i, std::size_t j, BitSpan inner, BitSpan ports) noexcept {
  RESTRIP_ASSERT(i < j && j <= k, "valid_path_with_chord", detail::no_such_gaps);
  return detail::Walker{detail::path_with_chord(k, i, j), inner, ports}.valid();
}

inline void joined_path(std::size_t k, std::size_t i, BitSpan inner, BitSpan ports, MutableBitSpan joined) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k, "joined_path", detail::no_such_gap);
  detail::Walker{detail::path(k, i), inner, ports}.joined(joined);
}
inline bool valid_path(std::size_t k, std::size_t i, BitSpan inner, BitSpan ports) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k, "valid_path", detail::no_such_gap);
  return detail::Walker{detail::path(k, i), inner, ports}.valid();
}

}  // namespace restrip
