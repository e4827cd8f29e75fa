// The rule tables in languages other than C++: for each language a file with the data and a look-up, which is the fixed
// text of a template (templates.hpp), and a program that queries the look-up exhaustively and prints digests. All
// look-ups have the same seven functions, one for each operation, which take the colours before it, in every position
// with k <= max_k (docs/how-to/other-languages.md).
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "automaton/automaton_layout.hpp"
#include "tables/layout.hpp"
#include "tables/operation_layout.hpp"

namespace restrip::generator {

/// A file of a language, and the function that makes its bytes.
struct LanguageFile {
  std::string extension;  ///< ".h"
  std::string (*of_tables)(const TableLayout& layout) = nullptr;
  std::string (*of_operation)(const OperationLayout& layout) =
      nullptr;  ///< for a custom operation or family; may be null
  std::string (*of_automaton)(const AutomatonArrays& automaton) = nullptr;
};

/// The files of each language, by its name on the command line; none for "c++", whose files are written by cpp.hpp. The
/// shading languages share a file.
[[nodiscard]] const std::map<std::string, std::vector<LanguageFile>>& language_files();

/// The files of several languages, each once, by name: "restrip_tables.h" for "tables".
[[nodiscard]] std::map<std::string, const LanguageFile*> files_in(const std::set<std::string>& languages,
                                                                  const std::string& stem);

// The files of JSON (json.cpp).
[[nodiscard]] std::string json_tables(const TableLayout& layout);
[[nodiscard]] std::string json_operation(const OperationLayout& layout);
[[nodiscard]] std::string json_automaton(const AutomatonArrays& automaton);

}  // namespace restrip::generator
