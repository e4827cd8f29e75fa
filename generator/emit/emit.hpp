// The stage `emit` of the generator's pipeline: the files of all languages, and their names before the work.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "automaton/automaton.hpp"
#include "certify/certificate.hpp"
#include "common/output.hpp"
#include "describe/description.hpp"
#include "tables/layout.hpp"

namespace restrip::generator {

// Numbers in lines of at most 120 characters, as generated headers write them.

template <class Number>
std::string numbers(const std::vector<Number>& values, const char* spelling = " {},") {
  std::string text;
  std::string line = "   ";
  for (const Number& value : values) {
    const std::string word = fmt::format(fmt::runtime(spelling), value);
    if (line.size() + word.size() > 120) {
      text += line + "\n";
      line = "   ";
    }
    line += word;
  }
  return text + line + "\n";
}

// The generated constexpr headers. Same input, same bytes.

/// restrip/tables/rows.hpp: the start of the rows of keys.
[[nodiscard]] std::string rows_header(const Packing& packing, unsigned max_k);

/// A header and the size of its read-only data.
struct RulesHeader {
  std::string text;
  std::size_t bytes = 0;
};

/// restrip/tables/FAMILY.hpp.
[[nodiscard]] RulesHeader rules_header(const Certificate& family, const Packing& packing, unsigned max_k);

/// restrip/tables/automaton.hpp.
[[nodiscard]] RulesHeader automaton_header(const Automaton& automaton);

/// restrip/tables/operations/NAME.hpp: docs/reference/operation-file.md, "Table".
[[nodiscard]] std::string operation_header(const OperationLayout& layout);

// The rule tables in languages other than C++: for each language a file with the data and a look-up, which is the fixed
// text of a template (templates.hpp), and a program that queries the look-up exhaustively and prints digests. All
// look-ups have the same seven functions, one for each operation, which take the colours before it, in every position
// with k <= max_k (docs/how-to/other-languages.md).

/// A file of a language, and the function that makes its bytes.
struct LanguageFile {
  std::string extension;  ///< ".h"
  std::string (*of_tables)(const TableLayout& layout) = nullptr;
  std::string (*of_operation)(const OperationLayout& layout) =
      nullptr;  ///< for a custom operation or family; may be null
  std::string (*of_automaton)(const AutomatonArrays& automaton) = nullptr;
};

/// The files of each language, by its name on the command line; none for "c++", whose files are written by the
/// functions above. The shading languages share a file.
[[nodiscard]] const std::map<std::string, std::vector<LanguageFile>>& language_files();

/// The files of several languages, each once, by name: "restrip_tables.h" for "tables".
[[nodiscard]] std::map<std::string, const LanguageFile*> files_in(const std::set<std::string>& languages,
                                                                  const std::string& stem);

// The files of JSON (languages.cpp).
[[nodiscard]] std::string json_tables(const TableLayout& layout);
[[nodiscard]] std::string json_operation(const OperationLayout& layout);
[[nodiscard]] std::string json_automaton(const AutomatonArrays& automaton);

/// Names of language_files(); C++ has headers, certificates and MANIFEST.
using Languages = std::set<std::string>;
using Names = std::vector<std::filesystem::path>;

/// Files and a report of them. Same input, same bytes.
struct Emitted {
  std::vector<files::NamedBytes> files;
  std::string text;
  std::string json;
};

/// The shipped families. MANIFEST comes last and lists the C++ files, which restrip-verify reads.
[[nodiscard]] Names names_of_tables(const std::vector<Description>& families, const Languages& languages);
[[nodiscard]] Emitted emit_tables(const std::vector<Certificate>& certificates, const Packing& packing, unsigned max_k,
                                  const Languages& languages);

/// Custom operations and families, each with a layout.
[[nodiscard]] Names names_of_operations(const std::vector<Description>& descriptions, const Languages& languages);
[[nodiscard]] Emitted emit_operations(const std::vector<Certificate>& certificates,
                                      const std::vector<OperationLayout>& layouts, const Languages& languages);

/// The automaton.
[[nodiscard]] Names names_of_automaton(const Languages& languages);
[[nodiscard]] Emitted emit_automaton(const Automaton& automaton, const Languages& languages);

// Custom families that the shipped automaton answers: docs/explanation/automaton.md, "Custom families".

/// A header with the look-up of such a family, which uses restrip/rules/exact.hpp. Throws std::runtime_error with the
/// reason if the automaton does not answer the family.
[[nodiscard]] std::string served_header(const Description& family);

}  // namespace restrip::generator
