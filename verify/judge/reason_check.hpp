#pragma once
// Reasons: why nothing is better than a rule (docs/reference/certificate.md, "Reasons"). Every set and every case that
// is looked at stands in the file; a set "cannot be all solid" when the colouring in which just it is solid is not
// sound, by the worlds. docs/reference/verifiers.md proves that a reason that passes is one.

#include <string>

#include "certificate/reason_text.hpp"
#include "judge/operation_judge.hpp"

namespace restrip::verify {

/// What is wrong with the reason why nothing is better than this recolouring of a valid configuration; empty when it is
/// one. The operation must be one that may have reasons.
std::string fault_of_reason(const OperationJudge& judge, Colors configuration, Colors recoloring, const Reason& reason);

}  // namespace restrip::verify
