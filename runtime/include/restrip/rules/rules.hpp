// Rules: from the colours before an operation to the best colours after it.
//
// For closed fans of up to table_max_k triangles, and for flips, the answer is read from the generated tables: constant
// time, no branch on the colours, no allocation, constexpr. For larger and for open fans it is read from the automaton
// of all valences (exact.hpp), with two table reads for each triangle. In both cases the recolouring is sound for every
// surrounding mesh, has the most solid edges of all sound recolourings, and among these the fewest isolated triangles
// in the patch. Splits and collapses keep every port. Flips may clear ports, which would occasionally save a strip in
// splits and collapses as well (docs/explanation/theory.md, "Ports given up"). docs/explanation/what-is-proven.md says
// what is proved for which k. Source of the idea: Porcu, Sanna, Scateni, "Rewriting rules for the dual graph of a
// stripified CLOD mesh". docs/reference/notation.md numbers the bits.
//
// Positions are SplitPosition, GapPair and Gap, with k <= max_word_valence. A position out of range is a programming
// error, found in debug builds (precondition.hpp). Colours that no valid stripification has (a triangle with three
// solid edges, a solid cycle) get `valid = false` and all edges dashed, which is always sound to apply.
#pragma once

#include <cstddef>

#include "restrip/precondition.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/key.hpp"
#include "restrip/tables/collapse.hpp"
#include "restrip/tables/flip.hpp"
#include "restrip/tables/rows.hpp"
#include "restrip/tables/split.hpp"

namespace restrip {

/// The largest valence of a closed fan that has tables: 8 in the shipped tables, or the --max-k of `restrip-generate
/// tables` (docs/reference/tables.md).
inline constexpr unsigned table_max_k = tables::split.first.size() - 1;

/// The place of a split or collapse in a closed fan of k >= 3 triangles: A before t_0, D before t_a, 1 <= a < k.
struct SplitPosition {
  std::size_t k = 0;
  std::size_t a = 0;
};

/// The place of a split or collapse in an open fan of k >= 1 triangles, two triangles in gaps i < j <= k.
struct GapPair {
  std::size_t k = 0;
  std::size_t i = 0;
  std::size_t j = 0;
};

/// The place of a split or collapse in an open fan of k >= 1 triangles, one triangle in gap i <= k.
struct Gap {
  std::size_t k = 0;
  std::size_t i = 0;
};

/// A recolouring: `colors` are the inner edges after the operation, `strips` the change in the number of strips.
struct Rule {
  Word colors = 0;
  int strips = 0;
  bool valid = false;
};

/// The recolouring of a flip: the new inner edge, and the ports that stay solid (a flip may have to clear some).
struct FlipRule {
  bool inner = false;
  unsigned ports = 0;
  int strips = 0;
  bool valid = false;
};

namespace detail {

/// Turns an n-bit ring so that bit `by` becomes bit 0; 0 <= by < n < 64.
constexpr Word turned_down(Word mask, std::size_t by, std::size_t n) noexcept {
  return (mask >> by | mask << (n - by)) & low_bits(n);
}

constexpr bool in_closed_fan(SplitPosition at) noexcept {
  return at.k >= 3 && 1 <= at.a && at.a < at.k && at.k <= max_word_valence;
}

/// Ports of a ring with chord as a mask over its elements: A is element 0, D is element a + 1.
constexpr Word ring_ports(std::size_t a, Word ports) noexcept {
  return (ports & low_bits(a)) << 1 | (ports >> a) << (a + 2);
}

/// The isolated triangles of a closed fan, and of a ring with chord (by element).
constexpr Word isolated_closed(std::size_t k, Word loop, Word ports) noexcept {
  return low_bits(k) & ~(loop | loop << 1 | loop >> (k - 1) | ports);
}

constexpr Word isolated_ring(std::size_t k, std::size_t a, Word inner, Word ports) noexcept {
  const Word all = low_bits(k + 2);
  const Word edges = inner & all;
  const Word chord = inner >> (k + 2) & 1;
  return all & ~(edges | edges << 1 | edges >> (k + 1) | ring_ports(a, ports) | chord | chord << (a + 1));
}

/// Likewise the triangles with at most one solid edge: strip ends and isolated ones.
constexpr Word ends_closed(std::size_t k, Word loop, Word ports) noexcept {
  const Word below = loop << 1 | loop >> (k - 1);
  return low_bits(k) & ~((loop & below) | (loop & ports) | (below & ports));
}

constexpr Word ends_ring(std::size_t k, std::size_t a, Word inner, Word ports) noexcept {
  const Word edges = inner & low_bits(k + 2);
  const Word below = edges << 1 | edges >> (k + 1);
  const Word chord = inner >> (k + 2) & 1;
  const Word third = ring_ports(a, ports) | chord | chord << (a + 1);
  return low_bits(k + 2) & ~((edges & below) | (edges & third) | (below & third));
}

template <class Table>
constexpr Word cell(const Table& table, std::size_t k, std::size_t place, Word ports, Word joined) noexcept {
  const std::size_t row = tables::closed_rows[static_cast<std::size_t>(bit(k) | ports)];
  return table.rules[table.first[k] + place * table.cells[k] + row + static_cast<std::size_t>(joined)];
}

/// The table's answer to a key of a closed fan of at most table_max_k triangles.
constexpr Word split_cell(std::size_t k, std::size_t a, Word ports, Word joined) noexcept {
  // The tables begin with the shorter arc. If the first arc is longer, A and D are exchanged and the ring is turned
  // back. Without branches, because which arc is shorter is effectively random.
  const bool exchange = 2 * a > k;
  const std::size_t by = exchange ? a : 0;
  const std::size_t arc = exchange ? k - a : a;
  const Word inner = cell(tables::split, k, arc - 1, turned_down(ports, by, k), turned_down(joined, by, k));
  return turned_down(inner & low_bits(k + 2), exchange ? arc + 1 : 0, k + 2) | (inner & bit(k + 2));
}

}  // namespace detail

/// The rule from `inner`, the colours of a patch before an operation, to the colours after it. One of the patches is a
/// fan, the other one is made of it by a split at any position; k <= max_word_valence. The functions below are this one
/// for the operations by name.
[[gnu::always_inline, nodiscard]] constexpr Rule rule(const Patch& before, const Patch& after, Word inner,
                                                      Word ports) noexcept {
  const int nodes = static_cast<int>(after.size()) - static_cast<int>(before.size());
  if (!before.valid(inner, ports)) return {0, nodes + count_bits(inner), false};
  const Word joined = before.joined(inner, ports);
  const Word colors = !after.ring || after.k < 3 || after.k > table_max_k ? exact::best(after, ports, joined).colors
                      : after.has_chord() ? detail::split_cell(after.k, after.opposite - 1, ports, joined)
                                          : detail::cell(tables::collapse, after.k, 0, ports, joined);
  return {colors, nodes - count_difference(colors, inner), true};
}

/// Split of a closed fan: `loop` and `ports` have k bits, the answer k + 3.
[[nodiscard]] constexpr Rule split_rule(SplitPosition at, Word loop, Word ports) noexcept {
  RESTRIP_ASSERT(detail::in_closed_fan(at), "split_rule", detail::no_such_split);
  return rule(closed_fan(at.k), ring_with_chord(at.k, at.a), loop, ports);
}
/// Collapse onto a closed fan: `inner` has k + 3 bits, `ports` k, the answer k.
[[nodiscard]] constexpr Rule collapse_rule(SplitPosition at, Word inner, Word ports) noexcept {
  RESTRIP_ASSERT(detail::in_closed_fan(at), "collapse_rule", detail::no_such_split);
  return rule(ring_with_chord(at.k, at.a), closed_fan(at.k), inner, ports);
}
/// Split of an open fan, two triangles: `loop` has k - 1 bits, `ports` k, the answer k + 2.
[[nodiscard]] constexpr Rule open_split_rule(GapPair at, Word loop, Word ports) noexcept {
  return rule(open_fan(at.k), path_with_chord(at.k, at.i, at.j), loop, ports);
}
/// Split of an open fan along its boundary, one triangle: `loop` has k - 1 bits, `ports` k, the answer k.
[[nodiscard]] constexpr Rule boundary_split_rule(Gap at, Word loop, Word ports) noexcept {
  return rule(open_fan(at.k), path(at.k, at.i), loop, ports);
}
/// Collapse onto an open fan, two triangles removed: `inner` has k + 2 bits, `ports` k, the answer k - 1.
[[nodiscard]] constexpr Rule open_collapse_rule(GapPair at, Word inner, Word ports) noexcept {
  return rule(path_with_chord(at.k, at.i, at.j), open_fan(at.k), inner, ports);
}
/// Collapse onto an open fan, one triangle removed: `inner` and `ports` have k bits, the answer k - 1.
[[nodiscard]] constexpr Rule boundary_collapse_rule(Gap at, Word inner, Word ports) noexcept {
  return rule(path(at.k, at.i), open_fan(at.k), inner, ports);
}

/// Flip: four ports, counter-clockwise; p_0 and p_1 belong to one triangle before, p_1 and p_2 after.
[[nodiscard]] constexpr FlipRule flip_rule(bool inner, unsigned ports) noexcept {
  const unsigned entry = tables::flip[static_cast<std::size_t>(inner) << 4 | (ports & 15U)];
  const int before = static_cast<int>(inner) + count_bits(ports & 15U);
  if (entry == 0xff) return {false, 0, before, false};
  return {(entry >> 4) != 0, entry & 15U, before - count_bits(entry), true};
}

namespace detail {

/// The change in the number of isolated triangles among the two triangles of a flip.
constexpr int isolated_by_flip(bool inner, unsigned ports, const FlipRule& rule) noexcept {
  const auto isolated_one = [](bool edge, unsigned p, unsigned one, unsigned other) {
    return edge || (p >> one & 1U) != 0 || (p >> other & 1U) != 0 ? 0 : 1;
  };
  // The new triangles own ports 1, 2 and 3, 0.
  return isolated_one(rule.inner, rule.ports, 1, 2) + isolated_one(rule.inner, rule.ports, 3, 0) -
         isolated_one(inner, ports, 0, 1) - isolated_one(inner, ports, 2, 3);
}

}  // namespace detail

}  // namespace restrip
