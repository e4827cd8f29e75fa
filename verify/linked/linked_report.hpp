#pragma once
// The checks of a linked family, put together and reported claim by claim.

#include "judge/report.hpp"
#include "linked/linked_check.hpp"

namespace restrip::verify {

/// `sum` is what was found in all sections.
void report_linked(const LinkedFamily& family, const LinkedCheck& sum, const ClaimListener& listener);

}  // namespace restrip::verify
