// Checks compiled rules, as a program prints their answers (docs/reference/verifiers.md, "Table dump"), configuration
// by configuration. Each answer is compared with all recolourings of its patch, and in the positions of a certificate
// it must be the certificate's row.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certificate/certificate.hpp"
#include "judge/report.hpp"
#include "model/operation.hpp"

namespace restrip::verify {

// Digests of the answers of tables (docs/reference/verifiers.md, "Digests of answers"): one line per position. They
// compare look-ups in other languages, which cannot print dumps of millions of lines, with judged answers.

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

/// What the answers of a table are compared with.
enum class Against { certificate, own_patch, nothing };
inline constexpr std::size_t against_count = 3;

/// The expected answers of one table. `rows` is set only if it is compared with the certificate; it is then compared
/// with its own patch as well.
struct ExpectedTable {
  const Operation* operation = nullptr;
  Against against = Against::nothing;
  const SectionRows* rows = nullptr;
  bool has_digest = true;  ///< look-ups in other languages have it
};

struct ExpectedDump {
  bool with_digests = false;    ///< whether to compute digests of the answers, for shipped operations
  bool states_isolated = true;  ///< whether every answer must state the change in isolated triangles; otherwise it may
  std::vector<ExpectedTable> tables;
};

/// The answer of a table for a valid configuration: the colours after the operation, and their changes. Compiled tables
/// state the change in strips; the shipped headers also state the change in isolated triangles of the patch, and others
/// may.
struct Answer {
  Colors colors;
  std::optional<int> strips;
  std::optional<int> isolated;
};

/// The results of a comparison.
struct Compared {
  AnswerCounts families;
  Failures differences;  ///< from the rows of a certificate
  Failures wrong;        ///< answers that are not sound, or not the best
};

struct DumpComparison {
  std::uint64_t lines = 0;                     ///< entry lines read
  bool states_changes = true;                  ///< whether answers stated their changes, so that these could be judged
  std::array<Compared, against_count> tables;  ///< by Against; tables compared with nothing have no differences
  Failures misstated;                          ///< answers that state a wrong change
  Failures beyond;                             ///< answers that exceed a bound of the description
  AnswerCount bounded;                         ///< answers that were compared with bounds
  Digests digests;                             ///< of all tables, if requested
  std::string fault;                           ///< why the dump could not be read to its end; otherwise empty

  const Compared& of(Against against) const { return tables[static_cast<std::size_t>(against)]; }
  /// Whether the dump was read and nothing is wrong.
  bool agrees() const;
};

/// Reads a dump to its end. Every expected table must occur exactly once, in any order. Continues after a difference,
/// but not after a line that does not belong in a dump.
DumpComparison compare_dump(std::FILE* stream, const ExpectedDump& expected);

/// The same for tables in memory; `answer` returns the answer of an operation's table, without changes.
using AnswerOf = std::function<std::optional<Answer>(const Operation& operation, Colors configuration)>;
DumpComparison compare_answers(const ExpectedDump& expected, const AnswerOf& answer);

/// Runs the program and compares its output; a failing program is a fault.
DumpComparison compare_dump_of(const std::string& program, const ExpectedDump& expected);

}  // namespace restrip::verify
