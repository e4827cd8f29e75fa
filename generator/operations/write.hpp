// The commands `restrip-generate rules` and `restrip-generate dump --operation`.
#pragma once

#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace restrip::generator {

struct RulesOptions {
  std::vector<std::string> files;          ///< operation files
  std::string out;                         ///< the output folder
  std::optional<unsigned> max_k;           ///< for families: the largest first number; default 8
  std::set<std::string> languages{"c++"};  ///< of language_files(); C++ has header and certificate
  std::string json;  ///< file for the figures; "-": standard output, instead of the text; or empty
};

/// Solves every operation and writes its files, all at once. Reports on standard output. Throws std::exception with
/// file and remedy.
void make_rules(const RulesOptions& options);

/// The rules of an operation file with one description as CSV, in the columns of docs/reference/verifiers.md, "Rules as
/// CSV": for a family, of every position up to `max_k` (8). Throws as above.
void dump_rules(const std::string& file, std::optional<unsigned> max_k, std::FILE* out);

}  // namespace restrip::generator
