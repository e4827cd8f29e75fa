// The operations on fans by number, with all answers of restrip::exact for them, and the keys of the patches that they
// leave, in their canonical form (restrip/rules/key.hpp).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "naive_patch.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/key.hpp"

namespace restrip {

/// The canonical form of `joined`, for closed fans and rings: with exactly two solid ports either both bits are set or
/// none. Do not call this for open fans and paths, where every `joined` is canonical.
constexpr Word canonical_joined(Word ports, Word joined) noexcept {
  return joined != 0 && std::popcount(ports) == 2 ? ports : joined;
}

}  // namespace restrip

namespace restrip::exact {

struct FanOperation {
  static constexpr const char* names[] = {"split", "collapse", "open split", "boundary split", "fan collapse"};

  int family = 0;
  std::size_t k = 0;
  std::size_t i = 0;  // a, or the first gap
  std::size_t j = 0;

  naive::Patch patch() const {
    if (family == 0) return naive::ring_with_chord(k, i);
    if (family == 1) return naive::closed_fan(k);
    if (family == 2) return naive::path_with_chord(k, i, j);
    if (family == 3) return naive::path(k, i);
    return naive::open_fan(k);
  }

  // Of a split.
  FanOperation inverse() const { return {family == 0 ? 1 : 4, k, 0, 0}; }

  // The patch that it leaves.
  restrip::Patch after() const {
    if (family == 0) return ring_with_chord(k, i);
    if (family == 1) return closed_fan(k);
    if (family == 2) return path_with_chord(k, i, j);
    if (family == 3) return path(k, i);
    return open_fan(k);
  }

  std::string text() const {
    return std::string(names[family]) + " k " + std::to_string(k) + " at " + std::to_string(i) + " " +
           std::to_string(j);
  }
};

// At every position.
inline std::vector<FanOperation> fan_operations(int family, std::size_t k) {
  if (family == 1 || family == 4) return {{family, k, 0, 0}};
  std::vector<FanOperation> all;
  for (std::size_t i = family == 0 ? 1 : 0; i < (family == 3 ? k + 1 : k); ++i) {
    if (family != 2) all.push_back({family, k, i, 0});
    for (std::size_t j = i + 1; family == 2 && j <= k; ++j) all.push_back({family, k, i, j});
  }
  return all;
}

// A random position, more often at either end.
inline FanOperation random_operation(std::mt19937_64& random, std::size_t k) {
  FanOperation operation{static_cast<int>(random() % 5), k, 0, 0};
  operation.i = operation.family == 0 ? 1 + random() % (k - 1) : random() % k;
  operation.j = operation.i + 1 + random() % (k - operation.i);
  if (operation.family != 0 && random() % 4 == 0) operation.i = 0;
  if (random() % 4 == 0) operation.j = k;
  return operation;
}

struct RandomKey {
  naive::Bits ports;
  naive::Bits joined;

  // Between a handful of ports and all of them, and each pair joined seldom or nearly always.
  RandomKey(std::mt19937_64& random, std::size_t k) : ports(k), joined(k) {
    const std::uint64_t solid_of_64 = random() % 3 == 0 ? random() % 4 : random() % 65;
    const std::uint64_t joined_of_8 = random() % 9;
    for (std::size_t x = 0; x < k; ++x) {
      ports[x] = random() % 64 < solid_of_64;
      joined[x] = ports[x] && random() % 8 < joined_of_8;
    }
  }
};

}  // namespace restrip::exact
