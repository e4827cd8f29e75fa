#pragma once
// Checks claims about a section as a whole, after its rows have been judged in each of its positions.

#include <span>

#include "judge/position.hpp"

namespace restrip::verify {

/// A section with its rows and the results of its positions.
struct CheckedSection {
  const Section& section;
  const SectionRows& rows;
  std::span<const PositionCheck> positions;
  const std::string& file;
};

/// Rows whose key belongs to no valid configuration of any position of the section.
Failures extra_rows(const CheckedSection& checked);

/// Checks that every orbit of keys has its `rule` row at its smallest key, and that every other key is a `copy` whose
/// symmetry preserves the operation and maps key and recolouring to the `rule` row.
Failures wrong_copies(const CheckedSection& checked, const Symmetries& symmetries);

/// Recounts the numbers that the section states.
Failures wrong_claims(const CheckedSection& checked);

struct ReasonTally {
  std::uint64_t rules = 0;  ///< rules with a reason
  std::uint64_t trees = 0;  ///< rules whose reason has cases
  std::size_t most_cases = 0;
  Failures wrong;
};
void tally_reasons(const CheckedSection& checked, ReasonTally& tally);

}  // namespace restrip::verify
