// All bit shifts of the verifier. Elsewhere, functions with names access colours.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace restrip::verify {

/// Colours of a row of dual edges in the notation of certificates: bit i is edge i, 1 = solid.
using Mask = std::uint32_t;

constexpr Mask single(unsigned i) { return Mask{1} << i; }
constexpr bool is_solid(Mask mask, unsigned i) { return (mask >> i & 1U) != 0; }
constexpr unsigned solid_count(Mask mask) { return static_cast<unsigned>(std::popcount(mask)); }
/// The lowest solid edge only.
constexpr Mask lowest(Mask mask) { return mask & (~mask + 1); }
constexpr bool is_subset(Mask part, Mask whole) { return (part & ~whole) == 0; }

/// The number of masks with `bits` bits; also the first number that is not such a mask.
constexpr Mask mask_count(unsigned bits) { return Mask{1} << bits; }
constexpr std::uint64_t wide_mask_count(unsigned bits) { return std::uint64_t{1} << bits; }

/// Two masks as one number; `low_bits` is the width of the second. Ascending like the pair (high, low).
constexpr Mask concatenated(Mask high, Mask low, unsigned low_bits) { return high << low_bits | low; }
constexpr Mask high_part(Mask both, unsigned low_bits) { return both >> low_bits; }
constexpr Mask low_part(Mask both, unsigned low_bits) { return both & (mask_count(low_bits) - 1); }

/// Four bits of a number; place 0 is the lowest.
constexpr std::uint64_t four_bits(std::uint64_t number, std::uint64_t place) { return number >> 4 * place & 15U; }

__extension__ using WideMask = unsigned __int128;

/// A set of unordered pairs of ports, at most sixteen ports: bit j(j-1)/2 + i stands for {i, j}, i < j.
struct PortPairs {
  WideMask bits = 0;

  static constexpr PortPairs of(unsigned one, unsigned other) {
    const unsigned low = one < other ? one : other;
    const unsigned high = one < other ? other : one;
    return {WideMask{1} << (high * (high - 1) / 2 + low)};
  }
  constexpr void add(unsigned one, unsigned other) { bits |= of(one, other).bits; }
  constexpr bool has(unsigned one, unsigned other) const { return (bits & of(one, other).bits) != 0; }
  constexpr void add(PortPairs more) { bits |= more.bits; }
  /// The pairs that are in both sets.
  constexpr PortPairs both(PortPairs other) const { return {bits & other.bits}; }
  constexpr unsigned count() const {
    return static_cast<unsigned>(std::popcount(static_cast<std::uint64_t>(bits >> 64U)) +
                                 std::popcount(static_cast<std::uint64_t>(bits)));
  }
  constexpr bool within(PortPairs whole) const { return (bits & ~whole.bits) == 0; }
  friend constexpr bool operator==(PortPairs, PortPairs) = default;
  friend constexpr auto operator<=>(PortPairs, PortPairs) = default;
};

/// Mixes three numbers as docs/reference/verifiers.md, "Digests of answers", defines.
constexpr std::uint32_t mixed_number(Mask before, Mask ports, std::uint32_t answer) {
  std::uint32_t h = answer ^ before * 0x9e3779b1U ^ ports * 0x85ebca77U;
  h = (h ^ h >> 16U) * 0x85ebca6bU;
  h = (h ^ h >> 13U) * 0xc2b2ae35U;
  return h ^ h >> 16U;
}
/// A configuration with its answer: colours and the change in strips.
constexpr std::uint32_t mixed(Mask before, Mask ports, Mask colors, int strips) {
  return mixed_number(before, ports, 0x80000000U | static_cast<std::uint32_t>(strips + 8) << 16U | colors);
}

/// The key of a configuration (docs/reference/operation-file.md, "What a rule must be"): what a rule needs to know.
struct Key {
  Mask ports = 0;    ///< the solid ports
  PortPairs joined;  ///< pairs of them that are joined and that some recolouring joins
  friend constexpr bool operator==(Key, Key) = default;
  friend constexpr auto operator<=>(Key, Key) = default;
};

using Permutation = std::vector<unsigned>;  ///< destinations

inline Mask moved(Mask mask, const Permutation& permutation) {
  Mask result = 0;
  for (unsigned i = 0; i < permutation.size(); ++i)
    if (is_solid(mask, i)) result |= single(permutation[i]);
  return result;
}

inline Key moved(Key key, const Permutation& ports) {
  Key result{moved(key.ports, ports), {}};
  for (unsigned j = 1; j < ports.size(); ++j)
    for (unsigned i = 0; i < j; ++i)
      if (key.joined.has(i, j)) result.joined.add(ports[i], ports[j]);
  return result;
}

}  // namespace restrip::verify
