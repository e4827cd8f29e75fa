#pragma once
// Claims about a section as a whole, once its rows have been judged in each of its positions.

#include <span>

#include "judge/position.hpp"

namespace restrip::verify {

/// A section with its rows and what was found in its positions.
struct CheckedSection {
  const Section& section;
  const SectionRows& rows;
  std::span<const PositionCheck> positions;
  const std::string& file;
};

/// Every row's key belongs to a valid configuration of some position of the section.
Failures extra_rows(const CheckedSection& checked);

/// Every orbit of keys has its `rule` row at its smallest key, every other key is a `copy` whose symmetry keeps the
/// operation and takes key and recolouring to those of the `rule` row.
Failures wrong_copies(const CheckedSection& checked, const Symmetries& symmetries);

/// The numbers that the section states, counted again.
Failures wrong_claims(const CheckedSection& checked);

struct ReasonTally {
  std::uint64_t rules = 0;  ///< that have a reason
  std::uint64_t trees = 0;  ///< those with cases
  std::size_t most_cases = 0;
  Failures wrong;
};
void tally_reasons(const CheckedSection& checked, ReasonTally& tally);

}  // namespace restrip::verify
