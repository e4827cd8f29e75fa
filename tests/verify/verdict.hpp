// The checker's verdict on tables: in memory for one section, or through files for a folder or an operation.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/description.hpp"
#include "naive_tables.hpp"

namespace restrip::verify::test {

/// How often each fault occurs, by the claim under which a checker must report it. No entry: never.
using Crimes = std::map<std::string, std::uint64_t>;

/// Fans of the corpus have at most this many triangles.
inline constexpr unsigned corpus_max_k = 4;

struct Verdict {
  int exit_code = 0;  ///< 0 every claim holds, 1 some claim fails, 2 bad input, as the program exits
  Crimes crimes;      ///< failures of each claim that fails
  std::string text;   ///< failing claims with their first counterexamples, or the input error

  bool says(const std::string& expected) const { return text.find(expected) != std::string::npos; }
};

/// The verdict on a certificate of this family.
Verdict verdict_of(const std::string& certificate, const Family& family);

/// The verdict on a certificate with only this section.
Verdict verdict_of(const NaiveTable& table);

/// The verdict on a folder with MANIFEST and certificates/.
Verdict verdict_of(const std::filesystem::path& tables_dir);

/// The operation files in tests/corpus/operations.
extern const std::vector<std::string> corpus_operations;
std::string corpus_path(const std::string& name);
Operation corpus_operation(const std::string& name);

/// The verdict on an operation's file on disk, or on its text, with certificates and a dump as texts.
Verdict verdict_on(const std::string& operation_path, const std::optional<std::string>& certificate,
                   const std::optional<std::string>& dump);

Verdict verdict_on_text(const std::string& operation, const std::optional<std::string>& certificate,
                        const std::optional<std::string>& dump);

}  // namespace restrip::verify::test
