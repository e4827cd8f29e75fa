// Colorings of one side of a patch as bit masks: legal inner edges, and the ports that they join.
#pragma once

#include <array>
#include <bit>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "describe/operation.hpp"

namespace restrip::generator {

// Sets of pairs of at most sixteen ports, and the keys of rules, which contain them.

/// Ordered by the last pair in which two sets differ. Pairs are in ascending order of the smaller port and, for equal
/// smaller ports, in descending order of the larger one. In a closed fan, whose pairs are consecutive solid ports, this
/// is the order of the keys of the tables.
class PortPairs {
 public:
  void add(unsigned low, unsigned high) {
    const unsigned place = place_of(low, high);
    words_[1 - place / 64] |= std::uint64_t{1} << place % 64;
  }
  [[nodiscard]] bool within(const PortPairs& others) const {
    return ((words_[0] & ~others.words_[0]) | (words_[1] & ~others.words_[1])) == 0;
  }
  [[nodiscard]] unsigned size() const {
    return static_cast<unsigned>(std::popcount(words_[0]) + std::popcount(words_[1]));
  }
  PortPairs& operator|=(const PortPairs& others) {
    for (unsigned i = 0; i < words_.size(); ++i) words_[i] |= others.words_[i];
    return *this;
  }
  PortPairs& operator&=(const PortPairs& others) {
    for (unsigned i = 0; i < words_.size(); ++i) words_[i] &= others.words_[i];
    return *this;
  }
  friend auto operator<=>(const PortPairs&, const PortPairs&) = default;

  /// Two bits each.
  [[nodiscard]] std::vector<Mask> masks() const;
  /// The images of the pairs.
  [[nodiscard]] PortPairs moved(const std::vector<unsigned>& to) const;

  /// As certificates write it: bit j (j - 1) / 2 + i is the pair of ports i < j.
  [[nodiscard]] std::string text() const;

 private:
  static constexpr unsigned most = 16;
  static constexpr unsigned place_of(unsigned low, unsigned high) {
    return low * (2 * most - low - 1) / 2 + most - 1 - high;
  }
  static constexpr unsigned written_place_of(unsigned low, unsigned high) { return high * (high - 1) / 2 + low; }
  struct Pair {
    std::uint8_t low = 0;
    std::uint8_t high = 0;
  };
  static const std::array<Pair, most*(most - 1) / 2> pair_at;
  template <class Visit>
  void visit(Visit&& visit) const {
    for (unsigned word = 0; word < 2; ++word)
      for (std::uint64_t rest = words_[1 - word]; rest != 0; rest &= rest - 1) {
        const Pair pair = pair_at[64 * word + static_cast<unsigned>(std::countr_zero(rest))];
        visit(unsigned{pair.low}, unsigned{pair.high});
      }
  }

  std::array<std::uint64_t, 2> words_{};  ///< high, low
};

/// What a rule needs to know of the colours before: the solid ports, and which pairs of them are joined, among the
/// pairs that some recolouring could join (docs/reference/operation-file.md, "What a rule must be").
struct Key {
  Mask ports = 0;
  PortPairs joined;
  friend auto operator<=>(const Key&, const Key&) = default;
};

/// Ports of one node of which at most `room` may be solid.
struct Crowd {
  Mask ports = 0;
  int room = 0;
};

/// A legal coloring of the inner edges: degrees within the constraint, no solid cycle; with derived data for the
/// search.
struct Coloring {
  Mask inner = 0;
  Mask full = 0;              ///< ports that must be dashed: all solid edges of their node are inside
  std::vector<Crowd> crowds;  ///< nodes that have room for a port, but not for all their ports
  std::vector<Mask> strips;   ///< for each strip, the ports of its nodes; strips without ports are left out
  std::vector<Mask> lonely;   ///< for each node without a solid inner edge, its ports
};

/// All legal colorings of the inner edges of a side, in ascending order of their masks.
[[nodiscard]] std::vector<Coloring> legal_colorings(const Side& side, Constraint constraint);

/// A legal coloring together with the colours of the ports.
struct Outcome {
  unsigned solid = 0;     ///< solid inner edges
  unsigned isolated = 0;  ///< isolated triangles
  PortPairs joined;
};

/// Empty if the ports give some triangle too many solid edges.
[[nodiscard]] std::optional<Outcome> with_ports(const Coloring& coloring, Mask ports);

}  // namespace restrip::generator
