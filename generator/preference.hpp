// What makes one sound recolouring better than another: criteria that are compared in turn, each a weighted sum of
// counts (docs/operation-file.md, "Cost").
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "coloring.hpp"
#include "patch.hpp"

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
[[nodiscard]] Preference fewest_strips();

/// No preference has more criteria.
inline constexpr std::size_t most_criteria = 8;

/// What the criteria add up to; smaller is better, compared in turn.
using CriterionValues = std::array<std::int64_t, most_criteria>;

/// CriterionValues of a coloring of `after` whose ports `kept` are solid, out of the ports that were. Depends on the
/// patch alone, never on the machine.
[[nodiscard]] CriterionValues values_of(const Preference& preference, const Side& after, const Coloring& coloring,
                                        const Outcome& outcome, Mask ports, Mask kept);

}  // namespace restrip::generator
