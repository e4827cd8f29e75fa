#pragma once
// The reasons of a certificate: why no sound recolouring is preferred to a rule's. Nothing is searched here: every set
// and every case that is looked at stands in the file. docs/trust.md proves that a reason that passes is one.

#include "judgment.hpp"

namespace restrip::verify {

struct ReasonTally {
  std::uint64_t rules = 0;
  std::uint64_t trees = 0;  ///< reasons of more than one case
  std::size_t most_cases = 0;
  Failures wrong;
};

/// What is wrong with the reason of a `rule` row, in words; empty when nothing is.
std::string fault_of_reason(const Row& row, const Section& section);

/// The reasons of all `rule` rows of a section.
void check_reasons(const Section& section, const SectionRows& rows, const std::string& file, ReasonTally& tally);

}  // namespace restrip::verify
