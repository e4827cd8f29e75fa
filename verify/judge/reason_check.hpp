// Checks reasons: why nothing is better than a rule (docs/reference/certificate.md, "Reasons"). All sets and cases are
// in the file. A set "cannot be all solid" if the colouring in which exactly it is solid is not sound, by the worlds.
// docs/reference/verifiers.md proves that a reason that passes is valid.
#pragma once

#include <string>

#include "certificate/certificate.hpp"
#include "judge/operation_judge.hpp"

namespace restrip::verify {

/// The fault of a reason why nothing is better than this recolouring of a valid configuration; empty if the reason is
/// valid. Precondition: the operation may have reasons.
std::string fault_of_reason(const OperationJudge& judge, Colors configuration, Colors recoloring, const Reason& reason);

}  // namespace restrip::verify
