// The patch of every fan family as one row of elements: the fan's triangles in order, with the inserted ones among
// them. Element m and element m+1 are joined by inner edge m; in a ring the last element is joined to the first as
// well. With a chord, its bit follows the edges. Open and closed fans are rows without inserted elements.
#pragma once

#include <cstddef>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"

namespace restrip::detail {

// Positions out of range are a programming error, found in debug builds.
inline constexpr const char* no_such_fan = "k is out of range: 1 <= k; on masks, k <= max_word_valence";
inline constexpr const char* no_such_closed_fan = "k is out of range: 3 <= k; on masks, k <= max_word_valence";
inline constexpr const char* no_such_split = "the position is out of range: 3 <= k <= max_word_valence, 1 <= a < k";
inline constexpr const char* no_such_arc = "the position is out of range: 1 <= a < k; on masks, k <= max_word_valence";
inline constexpr const char* no_such_gaps = "the position is out of range: i < j <= k; on masks, k <= max_word_valence";
inline constexpr const char* no_such_gap =
    "the position is out of range: 1 <= k, i <= k; on masks, k <= max_word_valence";

struct Layout {
  std::size_t k = 0;               // triangles of the fan, that is, ports
  std::size_t inserted = nowhere;  // element A
  std::size_t opposite = nowhere;  // element D, always after A
  bool ring = false;

  constexpr bool has_chord() const noexcept { return opposite != nowhere; }
  constexpr std::size_t size() const noexcept { return k + (inserted != nowhere) + (opposite != nowhere); }
  constexpr std::size_t edges() const noexcept { return ring ? size() : size() - 1; }
  constexpr std::size_t chord() const noexcept { return edges(); }
  constexpr std::size_t colors() const noexcept { return edges() + has_chord(); }

  constexpr bool is_fan(std::size_t element) const noexcept { return element != inserted && element != opposite; }

  // The element of the triangle that owns a port, and back.
  constexpr std::size_t element(std::size_t port) const noexcept {
    const std::size_t below_d = port + (port >= inserted);
    return below_d + (below_d >= opposite);
  }
  constexpr std::size_t port(std::size_t element) const noexcept {
    return element - (element > inserted) - (element > opposite);
  }

  // Ports as a mask over elements, and back. A comes before D, so its zero goes in first and leaves last.
  constexpr Word spread(Word ports) const noexcept { return insert_zero(insert_zero(ports, inserted), opposite); }
  constexpr Word gather(Word elements) const noexcept { return remove_bit(remove_bit(elements, opposite), inserted); }
};

constexpr Layout closed_fan(std::size_t k) noexcept {
  RESTRIP_ASSERT(k >= 1, "closed fan", no_such_fan);
  return {k, nowhere, nowhere, true};
}

constexpr Layout open_fan(std::size_t k) noexcept {
  RESTRIP_ASSERT(k >= 1, "open fan", no_such_fan);
  return {k, nowhere, nowhere, false};
}

constexpr Layout ring_with_chord(std::size_t k, std::size_t a) noexcept {
  RESTRIP_ASSERT(1 <= a && a < k, "ring with chord", no_such_arc);
  return {k, 0, a + 1, true};
}

constexpr Layout path_with_chord(std::size_t k, std::size_t i, std::size_t j) noexcept {
  RESTRIP_ASSERT(i < j && j <= k, "path with chord", no_such_gaps);
  return {k, i, j + 1, false};
}

constexpr Layout path(std::size_t k, std::size_t i) noexcept {
  RESTRIP_ASSERT(k >= 1 && i <= k, "path", no_such_gap);
  return {k, i, nowhere, false};
}

/// Isolated triangles of a patch with these colours.
constexpr int isolated(const Layout& patch, Word inner, Word ports) noexcept {
  const Word edges = inner & low_bits(patch.edges());
  const Word wrap = edges >> (patch.size() - 1);  // of a ring; a path lacks this edge
  Word touched = edges | edges << 1 | wrap | patch.spread(ports);
  if (patch.has_chord() && has(inner, patch.chord())) touched |= bit(patch.inserted) | bit(patch.opposite);
  return static_cast<int>(patch.size()) - count_bits(touched & low_bits(patch.size()));
}

constexpr int isolated(const Layout& patch, BitSpan inner, BitSpan ports) noexcept {
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
