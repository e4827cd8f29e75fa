// Digests of the answers of tables (docs/reference/verifiers.md, "Digests of answers"): one line per position. They
// compare look-ups in other languages, which cannot print dumps of millions of lines, with judged answers.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "judge/report.hpp"
#include "model/operation.hpp"

namespace restrip::verify {

struct Answer;

/// Digests by the words of their lines: "0 3 1 0".
using Digests = std::map<std::string, std::uint32_t>;

/// The words of a shipped operation: its number, and its position as three numbers; unused ones are 0.
std::string digest_words(const Operation& operation);
/// What an answer, whose changes must be known, adds to the digest of its operation.
std::uint32_t digest_of(const Operation& operation, Colors configuration, const std::optional<Answer>& answer);

struct DigestComparison {
  std::uint64_t positions = 0;
  Failures differences;
  std::string fault;  ///< why the lines could not be read; otherwise empty
};

/// Runs the program and compares its output; a failing program is a fault. Every position must have a line, in any
/// order; the last line says that no rules exist elsewhere.
DigestComparison compare_digests_of(const std::string& program, const Digests& expected);

}  // namespace restrip::verify
