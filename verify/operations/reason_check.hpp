#pragma once
// The reasons of an operation's certificate: why nothing is better than a rule. Every set and every case that is looked
// at stands in the file; a set "cannot be all solid" when the colouring in which just it is solid is not sound, by the
// worlds. docs/trust.md proves that a reason that passes is one.

#include "operation_certificate.hpp"
#include "report.hpp"
#include "rule_judge.hpp"

namespace restrip::verify::operations {

struct ReasonCheck {
  std::uint64_t reasons = 0;
  std::size_t most_cases = 0;
  Failures wrong;
};

/// Checks the reasons of an operation that may have them.
ReasonCheck check_rule_reasons(const RuleJudge& judge, const OperationCertificate& certificate);

}  // namespace restrip::verify::operations
