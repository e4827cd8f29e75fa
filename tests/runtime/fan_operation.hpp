// The operations on fans by number, with all answers of restrip::exact for them, and the keys of the patches that they
// leave, in their canonical form (restrip/rules/key.hpp).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "naive_patch.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/key.hpp"

namespace naive {

// The best recolouring by looking at all of them, for every key of one patch.

using Mask = std::uint64_t;

// One colouring of the patch that is valid as far as the inner edges go, with what the ports must be asked.
struct Coloring {
  Mask inner = 0;
  Mask full = 0;    // fan triangles with two solid inner edges: no solid port there
  Mask single = 0;  // fan triangles with none: isolated unless the port is solid
  int solid = 0;
  int isolated = 0;                                       // inserted triangles without a solid edge
  std::vector<std::pair<std::size_t, std::size_t>> ends;  // fan triangles at the two ends of one strand
};

class ExhaustiveSearch {
 public:
  explicit ExhaustiveSearch(const Patch& patch) : patch_(patch), index_(std::size_t{1} << patch.edges.size(), npos) {
    for (Mask inner = 0; inner < index_.size(); ++inner) {
      if (const std::optional<Coloring> coloring = coloring_of(inner)) {
        index_[inner] = colorings_.size();
        colorings_.push_back(*coloring);
      }
    }
  }

  // After this, best(joined) answers for every canonical `joined` of these ports.
  void solve(Mask ports) {
    const std::size_t k = patch_.port_node.size();
    const Bits port_bits = bits_of(ports, k);
    before_.assign(k, k);
    for (std::size_t i = 0; i < k; ++i) {
      if (port_bits[i]) before_[i] = port_before(patch_, port_bits, i);
    }
    ports_ = ports;
    best_.assign(std::size_t{1} << k, std::numeric_limits<long>::min());
    for (const Coloring& coloring : colorings_)
      if (const std::optional<Mask> needed = needs(coloring))
        best_[*needed] = std::max(best_[*needed], value(coloring));
    // A key with more pairs allows everything that a key with fewer pairs allows.
    for (Mask joined = 0; joined < best_.size(); ++joined) {
      for (std::size_t i = 0; i < k; ++i) {
        if (((joined >> i) & 1) != 0) best_[joined] = std::max(best_[joined], best_[joined & ~(Mask{1} << i)]);
      }
    }
  }

  long best(Mask joined) const { return best_[joined]; }

  // The canonical key of colours before an operation under the solved ports, if they are valid: the pairs of neighbours
  // that they join. No recolouring of a fan joins other ports.
  std::optional<Mask> key(Mask inner) const {
    if (inner >= index_.size() || index_[inner] == npos) return std::nullopt;
    const Coloring& coloring = colorings_[index_[inner]];
    if ((coloring.full & ports_) != 0) return std::nullopt;
    Mask joined = 0;
    for (const auto& [i, j] : coloring.ends) {
      if (((ports_ >> i) & (ports_ >> j) & 1) == 0) continue;
      if (before_[i] == j) joined |= Mask{1} << i;
      if (before_[j] == i) joined |= Mask{1} << j;
    }
    return joined;
  }

  // The value of a recolouring under the solved ports, if it is sound for this key.
  std::optional<long> judge(Mask inner, Mask joined) const {
    if (inner >= index_.size() || index_[inner] == npos) return std::nullopt;
    const Coloring& coloring = colorings_[index_[inner]];
    const std::optional<Mask> needed = needs(coloring);
    if (!needed || (*needed & ~joined) != 0) return std::nullopt;
    return value(coloring);
  }

 private:
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  std::optional<Coloring> coloring_of(Mask inner) const {
    Coloring result;
    result.inner = inner;
    UnionFind strands(patch_.nodes);
    std::vector<int> degree(patch_.nodes, 0);
    for (std::size_t e = 0; e < patch_.edges.size(); ++e) {
      if (((inner >> e) & 1) == 0) continue;
      const auto [u, v] = patch_.edges[e];
      ++result.solid;
      if (++degree[u] > 2 || ++degree[v] > 2 || !strands.unite(u, v)) return std::nullopt;
    }
    result.isolated = static_cast<int>(std::count(degree.begin(), degree.end(), 0));
    for (std::size_t i = 0; i < patch_.port_node.size(); ++i) {
      const std::size_t u = patch_.port_node[i];
      if (degree[u] == 2) result.full |= Mask{1} << i;
      if (degree[u] == 0) {
        result.single |= Mask{1} << i;
        --result.isolated;
      }
      for (std::size_t j = i + 1; j < patch_.port_node.size() && degree[u] == 1; ++j) {
        const std::size_t v = patch_.port_node[j];
        if (degree[v] == 1 && strands.find(u) == strands.find(v)) result.ends.emplace_back(i, j);
      }
    }
    return result;
  }

  long value(const Coloring& coloring) const {
    return coloring.solid * 1'000'000L - coloring.isolated - std::popcount(coloring.single & ~ports_);
  }

  // The canonical key that allows exactly what the colouring joins, or nothing when no key allows it.
  std::optional<Mask> needs(const Coloring& coloring) const {
    if ((coloring.full & ports_) != 0) return std::nullopt;
    Mask needed = 0;
    for (const auto& [i, j] : coloring.ends) {
      if (((ports_ >> i) & (ports_ >> j) & 1) == 0) continue;
      if (before_[i] != j && before_[j] != i) return std::nullopt;
      if (before_[i] == j) needed |= Mask{1} << i;
      if (before_[j] == i) needed |= Mask{1} << j;
    }
    return needed;
  }

  Patch patch_;
  std::vector<Coloring> colorings_;
  std::vector<std::size_t> index_;
  Mask ports_ = 0;
  std::vector<std::size_t> before_;
  std::vector<long> best_;
};

}  // namespace naive

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
