#pragma once
// Digests of the answers of tables (docs/reference/verifiers.md, "Digests of answers"): one line per position. They
// compare look-ups in other languages, which cannot print dumps of millions of lines, with judged answers.

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

/// The digests of shipped operations.
class AnswerDigests {
 public:
  /// Adds an answer, whose changes must be known.
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
  std::string fault;  ///< why the lines could not be read; otherwise empty
};

/// Every position must have a line, in any order; the last line says that no rules exist elsewhere.
DigestComparison compare_digests(std::FILE* stream, const Digests& expected);

/// Runs the program and compares its output; a failing program is a fault.
DigestComparison compare_digests_of(const std::string& program, const Digests& expected);

}  // namespace restrip::verify
