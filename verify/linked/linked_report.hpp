#pragma once
// The checks of a linked family, put together and reported claim by claim.

#include "judge/report.hpp"
#include "linked/linked_check.hpp"

namespace restrip::verify {

/// `checks` has one entry for each section, in order.
void report_linked(const LinkedFamily& family, const std::vector<LinkedCheck>& checks, const ClaimListener& listener);

}  // namespace restrip::verify
