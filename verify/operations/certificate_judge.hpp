#pragma once
// The rows and numbers of a certificate against what the definitions give.

#include <array>

#include "operation_certificate.hpp"
#include "report.hpp"
#include "rule_judge.hpp"

namespace restrip::verify::operations {

/// All configurations in turn, each with the row of its key.
struct RowCheck {
  std::uint64_t configurations = 0;
  std::uint64_t valid = 0;
  std::uint64_t with_row = 0;
  std::uint64_t costing = 0;
  std::int64_t worst_strips = 0;
  std::int64_t worst_isolated = 0;
  Failures missing;
  Failures extra;
  Failures wrong_ports;
  Failures unsound;
  std::array<Failures, most_criteria> not_best;
};

RowCheck check_rows(RuleJudge& judge, const OperationCertificate& certificate);

struct KeyCheck {
  std::uint64_t keys = 0;
  std::uint64_t valid = 0;
  Failures wrong;  ///< configurations with one key that fit different worlds, or the same worlds with different keys
};

KeyCheck check_keys(const RuleJudge& judge);

struct OrbitSizes {
  std::uint64_t all = 0;
  std::uint64_t valid = 0;
};

/// Orbits of configurations, counted by merging each with its images.
OrbitSizes count_orbits(const RuleJudge& judge, const PatchSymmetries& symmetries);

/// Copies that follow from no rule, and rules that are not the smallest of their orbit.
Failures wrong_copies(const OperationCertificate& certificate, const PatchSymmetries& symmetries);

Failures wrong_numbers(const OperationCertificate& certificate, const RowCheck& rows, std::uint64_t keys,
                       const OrbitSizes& orbits);

/// The solid ports and joined pairs of a valid configuration.
OperationKey key_of(const OperationFile& operation, Colors configuration);

}  // namespace restrip::verify::operations
