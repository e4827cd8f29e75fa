#pragma once
// The compiled table of an operation, as a program prints its answers (docs/operation-file.md, "Dump"): every answer is
// judged by itself, and compared with the certificate if there is one.

#include <cstdio>
#include <string>

#include "operation_certificate.hpp"
#include "report.hpp"
#include "rule_judge.hpp"

namespace restrip::verify::operations {

struct OperationDumpCheck {
  std::uint64_t entries = 0;
  std::uint64_t answers = 0;   ///< of valid configurations
  Failures wrong;              ///< answers that are not right, or none where there must be one
  Failures other_than_stated;  ///< than the certificate has it
  std::string fault;           ///< why the dump could not be read to its end; empty when it could
};

/// Goes on after a wrong answer, but not after a line that has no place in a dump. `certificate` may be null.
OperationDumpCheck check_operation_dump(std::FILE* stream, RuleJudge& judge, const OperationCertificate* certificate);

/// Runs the program and judges what it prints; a program that fails is a fault.
OperationDumpCheck check_operation_dump_of(const std::string& program, RuleJudge& judge,
                                           const OperationCertificate* certificate);

}  // namespace restrip::verify::operations
