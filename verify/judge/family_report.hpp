// Combines the checks of a family's positions and sections and reports them claim by claim.
#pragma once

#include <span>

#include "certificate/certificate.hpp"
#include "judge/operation_judge.hpp"

namespace restrip::verify {

/// The tasks of a family, section by section, position by position. Without a certificate, configurations are only
/// counted.
std::vector<PositionTask> tasks_of(const Family& family, const Certificate* certificate);

/// `checks` has one entry for each of these tasks, in order.
void report_family(const Family& family, const Certificate& certificate, std::span<const PositionCheck> checks,
                   const ClaimListener& listener);

/// Checks that each position without rules is the image of a position that has some, if the family has such positions.
void report_images(const Family& family, const ClaimListener& listener);

}  // namespace restrip::verify
