// What `restrip-generate rules` writes.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace restrip::generator {

struct RulesOptions {
  std::vector<std::string> files;          ///< operation files
  std::string out;                         ///< the folder that receives the files of each
  std::optional<unsigned> max_k;           ///< of families, the largest first number; otherwise 8
  std::set<std::string> languages{"c++"};  ///< of language_files(); that of C++ are header and certificate
  bool force = false;                      ///< make them whether or not the folder has them, and keep no record of it
  std::string json;  ///< file for the figures, "-" for standard output in place of the text, or empty
};

/// Solves every operation and writes its files, all at once. Says on standard output what it wrote. Throws
/// std::exception with file and remedy.
void make_rules(const RulesOptions& options);

}  // namespace restrip::generator
