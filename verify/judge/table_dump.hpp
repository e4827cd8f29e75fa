#pragma once
// Checks compiled rules, as a program prints their answers (docs/reference/verifiers.md, "Table dump"), configuration
// by configuration: each answer is held against all recolourings of its own patch, and in the positions of a
// certificate it must be the certificate's row.

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certificate/certificate.hpp"
#include "judge/answer_digests.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

/// What the answers of a table are held against.
enum class Against { certificate, own_patch, nothing };
inline constexpr std::size_t against_count = 3;

/// What one table must say. `rows` only where it is held against the certificate; it is held against its own patch then
/// as well.
struct ExpectedTable {
  const Operation* operation = nullptr;
  Against against = Against::nothing;
  const SectionRows* rows = nullptr;
};

/// What one table of lists must say: a line for each port mask, whole, or null for a table that is not compared.
struct ExpectedLists {
  std::string family;    ///< "linked-split"
  std::string position;  ///< "k 3 a 1"
  unsigned ports = 0;
  const std::vector<std::string>* lines = nullptr;
};

struct ExpectedDump {
  bool with_digests = false;   ///< whether digests of the answers are wanted; of shipped operations
  bool tells_isolated = true;  ///< whether every answer reports the change in isolated triangles, or those that want to
  std::vector<ExpectedTable> tables;
  std::vector<ExpectedLists> lists;
};

/// What a table says of a valid configuration: the colours after the operation, and what they change. Compiled tables
/// tell the change in strips; the shipped headers also say that in isolated triangles of the patch, and others may.
struct Answer {
  Colors colors;
  std::optional<int> strips;
  std::optional<int> isolated;
};

/// What was compared.
struct Compared {
  AnswerCounts families;
  Failures differences;  ///< from the rows of a certificate, or between lists
  Failures wrong;        ///< answers that are not sound, or not the best
  Failures told;         ///< answers that tell another change than there is
};

struct DumpComparison {
  std::uint64_t lines = 0;                     ///< entry lines read
  bool tells_changes = true;                   ///< whether answers told what they change, so that it could be judged
  std::array<Compared, against_count> tables;  ///< by Against; those compared with nothing have no differences
  std::array<Compared, against_count> lists;   ///< likewise; never against own_patch
  AnswerDigests digests;                       ///< of all tables, where they are wanted
  std::string fault;                           ///< why the dump could not be read to its end; empty when it could

  const Compared& of(Against against) const { return tables[static_cast<std::size_t>(against)]; }
  const Compared& of_lists(Against against) const { return lists[static_cast<std::size_t>(against)]; }
  /// Nothing wrong and no fault.
  bool agrees() const;
};

/// Reads a dump to its end. Every expected table must occur exactly once, in any order. Goes on after a difference, but
/// not after a line that has no place in a dump.
DumpComparison compare_dump(std::FILE* stream, const ExpectedDump& expected);

/// The same of tables that are at hand; `answer` says what the table of an operation answers, and tells no changes.
using AnswerOf = std::function<std::optional<Answer>(const Operation& operation, Colors configuration)>;
DumpComparison compare_answers(const ExpectedDump& expected, const AnswerOf& answer);

/// Runs the program and compares what it prints; a program that fails is a fault.
DumpComparison compare_dump_of(const std::string& program, const ExpectedDump& expected);

}  // namespace restrip::verify
