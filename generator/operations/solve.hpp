// The rules of an operation file: the best recolouring for every key, reduced by the symmetries that nauty finds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "claims.hpp"
#include "operations/operation_file.hpp"
#include "search.hpp"
#include "symmetry.hpp"

namespace restrip::generator {

/// Solid ports, and the pairs of them that were joined: bit j (j - 1) / 2 + i stands for {i, j}, i < j.
struct OperationKey {
  Mask ports = 0;
  Mask joined = 0;
  friend auto operator<=>(const OperationKey&, const OperationKey&) = default;
};

/// The pairs of a key, two bits each.
[[nodiscard]] std::vector<Mask> pairs_of(Mask joined);

struct OperationRow {
  OperationKey key;
  Choice choice;
  int witness = -1;  ///< index of the symmetry that leads to the representative; -1 for the representative itself
};

struct OperationRules {
  std::vector<PatchMap> symmetry;
  std::vector<OperationRow> rows;  ///< in ascending order of key
  Claims claims;
  /// The table: index `before << ports | P`, or P alone for matchings; -1 where the configuration is not valid.
  std::vector<std::int32_t> entries;
};

/// The symmetries of a patch under which what may be given up and the preference stay what they are.
[[nodiscard]] std::vector<PatchMap> symmetries_of(const Operation& operation);

/// Walks all 2^(edges before + ports) configurations and searches all recolourings of each key. Throws
/// std::runtime_error, naming operation and configuration, when one has no sound recolouring. Shows progress on a
/// terminal.
[[nodiscard]] OperationRules solve(const NamedOperation& named);

}  // namespace restrip::generator
