// Which recolourings are sound with the strips outside, as far as these have been followed. Included by linked.hpp.
//
// Let Q be the pairs of ports that strips outside join, and P' the pairs that a recolouring joins inside. The strips
// stay paths exactly when P' and Q together close no cycle (docs/explanation/theory.md). A cycle must use a pair of P'
// that was not joined before, so from each such pair P' and Q are followed alternately until the path ends.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "restrip/rules/bits.hpp"
#include "restrip/rules/rules.hpp"
#include "restrip/tables/linked.hpp"

namespace restrip {

/// Results of following a strip outward, other than the port through which it returns.
inline constexpr int strip_ends = -1;    ///< the strip ends outside
inline constexpr int out_of_sight = -2;  ///< it was followed as far as `reach` allows

namespace detail {

/// A pairing as the tables have it: four bits for each port, its partner, or itself when it has none.
using PackedPairing = std::remove_cv_t<decltype(tables::pairings)>::value_type;
static_assert(tables::linked_split.first.size() == table_max_k + 1 &&
              std::size_t{4} * table_max_k <= 8 * sizeof(PackedPairing));

/// Ports in pairs, of fans that have tables.
struct TablePairs {
  static constexpr std::size_t max_ports = table_max_k;
  PackedPairing bits = static_cast<PackedPairing>(0xfedcba9876543210U);

  /// The port that this one is joined to, or itself.
  [[nodiscard]] constexpr std::size_t partner(std::size_t i) const noexcept { return bits >> (4 * i) & 15U; }
  constexpr void join(std::size_t i, std::size_t j) noexcept {
    const auto exchange = static_cast<PackedPairing>(i ^ j);
    bits ^= exchange << (4 * i) | exchange << (4 * j);
  }
  friend constexpr bool operator==(TablePairs, TablePairs) noexcept = default;
};

/// Pairs of ports of fans whose colours fit one word.
struct WordPairs {
  static constexpr std::size_t max_ports = max_word_valence;
  std::int8_t partners[max_ports] = {};  ///< how much further the partner is, so that ports without one have zero

  [[nodiscard]] constexpr std::size_t partner(std::size_t i) const noexcept {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + partners[i]);
  }
  constexpr void join(std::size_t i, std::size_t j) noexcept {
    const int further = static_cast<int>(j) - static_cast<int>(i);
    partners[i] = static_cast<std::int8_t>(further);
    partners[j] = static_cast<std::int8_t>(-further);
  }
  friend constexpr bool operator==(const WordPairs&, const WordPairs&) noexcept = default;
};

/// The pairs that `joined` names, as in a key, and at most one more that it cannot name.
template <class Pairs>
constexpr Pairs pairs_of(Word ports, Word joined, Word pair) {
  Pairs pairs;
  const auto add = [&pairs](std::size_t i, std::size_t j) {
    if (pairs.partner(i) == i) pairs.join(i, j);  // both bits of `joined` may name one pair
  };
  if (pair != 0)
    add(static_cast<std::size_t>(std::countr_zero(pair)), static_cast<std::size_t>(std::bit_width(pair)) - 1);
  if (joined == 0) return pairs;
  // The other pairs are neighbours among the solid ports.
  std::size_t previous = word_bits - 1 - static_cast<std::size_t>(std::countl_zero(ports));
  for (Word rest = ports; rest != 0; rest &= rest - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(rest));
    if (has(joined, i)) add(previous, i);
    previous = i;
  }
  return pairs;
}

/// Decides which recolourings are sound, and follows strips outward only if necessary: each port at most once.
template <class Pairs, class LookOut>
class Outlook {
 public:
  /// Ports are counted from `by` on, in a fan of k <= Pairs::max_ports triangles; `before` are the pairs joined before.
  constexpr Outlook(std::size_t k, std::size_t by, Word ports, const Pairs& before, LookOut& look_out)
      : k_(k), by_(by), ports_(ports), look_out_(&look_out), before_(before) {
    for (auto& port : beyond_) port = not_asked;
  }

  /// Zero if joining these pairs certainly closes no cycle. Else the ports of a path that may close a cycle, as in
  /// every recolouring that joins the same pairs of these ports.
  constexpr Word may_close(const Pairs& after) {
    if (after == before_ || after == Pairs{}) return 0;
    for (Word rest = ports_; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      const std::size_t j = after.partner(i);
      Word path = 0;
      if (j > i && before_.partner(i) != j && !stays_open(after, i, j, path)) return path;
    }
    return 0;
  }

 private:
  static constexpr std::int8_t not_asked = -3;
  static constexpr std::int8_t comes_back = -4;

  constexpr int beyond(std::size_t i) {
    if (beyond_[i] == not_asked) {
      const auto turn = [this](std::size_t port) { return port >= k_ ? port - k_ : port; };
      const int seen = (*look_out_)(turn(i + by_));
      const int port = seen < 0 ? seen : static_cast<int>(turn(static_cast<std::size_t>(seen) + k_ - by_));
      beyond_[i] = static_cast<std::int8_t>(port);
      if (port >= 0) beyond_[static_cast<std::size_t>(port)] = static_cast<std::int8_t>(i);
    }
    return beyond_[i];
  }

  // Leaves through port `at` and follows the path: strip_ends, comes_back to `home`, or the port where it goes out of
  // sight. Adds the ports through which it leaves and returns to `path`.
  constexpr int follow(const Pairs& pairs, std::size_t at, std::size_t home, Word& path) {
    for (;;) {
      path |= bit(at);
      const int back = beyond(at);
      if (back == out_of_sight) return static_cast<int>(at);
      if (back == strip_ends) return strip_ends;
      const auto port = static_cast<std::size_t>(back);
      path |= bit(port);
      if (port == home) return comes_back;
      at = pairs.partner(port);
      if (at == port) return strip_ends;
    }
  }

  constexpr bool stays_open(const Pairs& after, std::size_t i, std::size_t j, Word& path) {
    const int one = follow(after, j, i, path);
    if (one < 0) return one == strip_ends;
    const int two = follow(after, i, j, path);
    if (two < 0) return two == strip_ends;
    // Both ends are out of sight and may be joined there, unless they were the two ends of a path before.
    const auto start = static_cast<std::size_t>(one);
    const std::size_t inside = before_.partner(start);
    Word ignored = 0;
    return inside != start &&
           (inside == static_cast<std::size_t>(two) || follow(before_, inside, start, ignored) == two);
  }

  std::size_t k_;
  std::size_t by_;
  Word ports_;
  LookOut* look_out_;
  Pairs before_;
  std::int8_t beyond_[Pairs::max_ports] = {};
};

}  // namespace detail
}  // namespace restrip
