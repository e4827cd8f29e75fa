#pragma once
// Digests of what tables answer (docs/reference/verifiers.md, "Digests of answers"): a line for each position. So
// look-ups in other languages, which answer where no dump of millions of lines can be printed, are compared with
// answers that were judged.

#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>

#include "judge/report.hpp"
#include "model/operation.hpp"

namespace restrip::verify {

struct Answer;

/// Digests by the words of their lines: "0 3 1 0".
using Digests = std::map<std::string, std::uint32_t>;

/// Those of shipped operations.
class AnswerDigests {
 public:
  /// Counts an answer in; its changes must be told.
  void add(const Operation& operation, Colors configuration, const std::optional<Answer>& answer);
  const Digests& by_position() const { return digests_; }

 private:
  const Operation* last_ = nullptr;
  std::uint32_t* digest_ = nullptr;  ///< of the last operation
  Digests digests_;
};

struct DigestComparison {
  std::uint64_t positions = 0;
  Failures differences;
  std::string fault;  ///< why the lines could not be read; empty when they could
};

/// Every position must have its line, in any order; the last line says that there are no rules elsewhere.
DigestComparison compare_digests(std::FILE* stream, const Digests& expected);

/// Runs the program and compares what it prints; a program that fails is a fault.
DigestComparison compare_digests_of(const std::string& program, const Digests& expected);

}  // namespace restrip::verify
