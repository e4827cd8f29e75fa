// What makes one sound recolouring better than another: criteria that are compared in turn, each a weighted sum of
// counts (docs/operation-file.md, "Cost").
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "operations/patch.hpp"

namespace restrip::generator {

/// docs/operation-file.md says what each counts. `swaps` is for fans alone: pairs of neighbours that a strip passes
/// with two turns the same way.
enum class Count {
  strips,
  isolated,
  given_up,
  kept,
  joined,
  solid,
  ends,
  ends_at_port,
  neighbouring_ends,
  squares,
  swaps
};

struct Term {
  static constexpr Mask all = ~Mask{0};

  Count count = Count::strips;
  std::int64_t weight = 1;
  Mask of = all;  ///< edges or nodes of the side after, or ports; for the counts that choose among them
  friend bool operator==(const Term&, const Term&) = default;
};

using Criterion = std::vector<Term>;
using Preference = std::vector<Criterion>;

/// Fewest strips; then fewest isolated triangles, a port given up counting as one; then fewest ports given up.
[[nodiscard]] inline Preference fewest_strips() {
  return {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
}

/// No preference has more criteria.
inline constexpr std::size_t most_criteria = 8;

}  // namespace restrip::generator
