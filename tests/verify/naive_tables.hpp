// Certificates for small fans and custom operations, made in the slowest and most obvious way, and correct and careless
// reasons. It shares only the struct of an operation with the checker that it tests; the patches of fans are
// handwritten from docs/reference/notation.md.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "naive_operation.hpp"

namespace restrip::verify::test {

/// An operation on a fan by its name, such as "open-collapse", at {k, a}, {k, i, j} or {k, i}; any position. "flip" at
/// {}.
Operation operation_by_hand(const std::string& name, const std::vector<unsigned>& position);

struct NaiveSection {
  std::string position;
  bool serves_every_position = false;
  std::vector<NaiveOperation> operations;
};

struct NaiveFamily {
  std::string name;
  std::vector<NaiveSection> sections;
};

std::vector<NaiveFamily> naive_families(int max_k);
/// One operation alone.
NaiveSection naive_section(const Operation& operation);

/// A check that a checker of reasons can omit, to find what it would then accept as a reason.
enum class Careless {
  not_at_all,
  off_by_one,
  only_dashed,  ///< does not count isolated triangles and ports given up
  sound_sets,
  overlapping_sets,
  count_dashed_twice,
  foreign_edges,
  skip_solid_case,
  skip_dashed_case,
  solid_in_both_cases
};

/// The reason why no recolouring is preferred to `after`, as certificates write it. Returns nullopt if it has no
/// reason.
std::optional<std::string> naive_reason(const NaiveOperation& operation, NaiveColors before, NaiveColors after,
                                        Careless careless = Careless::not_at_all);

struct NaiveRow {
  NaiveColors after;
  std::vector<int> by;  ///< of a copy: the image of each port
  std::string because;  ///< reason of a rule; may be empty
};

std::string text_of(NaiveKey key, const NaiveRow& row);

struct NaiveTable {
  std::string family;
  std::string position;
  std::vector<std::pair<std::string, long>> claims;
  std::map<NaiveKey, NaiveRow> rows;
};

/// Calls back for each valid configuration of each operation of the section.
void for_each_valid(const NaiveSection& section, const std::function<void(const NaiveOperation&, NaiveColors)>& visit);

/// nullopt if some configuration has no sound recolouring.
std::optional<NaiveTable> naive_table(const std::string& family, const NaiveSection& section, bool with_reasons);

/// A certificate with these sections.
std::string certificate_text(const std::string& family, const std::vector<NaiveTable>& tables);

/// The answer of a table to a configuration; empty if it has none.
using NaiveAnswers = std::function<std::optional<NaiveColors>(NaiveColors)>;
/// The answers of a certificate's rows.
NaiveAnswers answers_of(const NaiveOperation& operation, const NaiveTable& table);

/// The lines of one table of a dump, which state changes in strips and perhaps in isolated triangles.
std::string table_text(const NaiveOperation& operation, const NaiveAnswers& answers, bool with_isolated);
/// The output of a program that answers with these tables.
std::string dump_text(const std::vector<std::string>& tables);
/// With the rows of one operation's table.
std::string dump_text(const NaiveOperation& operation, const NaiveTable& table);

/// The text followed by an "end" line.
std::string with_end(const std::string& above, std::size_t rows);
/// The text with correct sums in its last line, if that begins with "end"; otherwise unchanged.
std::string with_sums(const std::string& text);

}  // namespace restrip::verify::test
