// The rule tables in languages other than C++: for each language a file with the data and a look-up, which is the fixed
// text of a template (templates.hpp), and a program that queries the look-up exhaustively and prints digests. All
// look-ups have the same seven functions, one for each operation, which take the colours before it, in every position
// with k <= max_k (docs/how-to/other-languages.md).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "automaton/emit_automaton.hpp"
#include "languages/templates.hpp"
#include "operations/operation_layout.hpp"
#include "tables/layout.hpp"

namespace restrip::generator {

/// A file of a language, and the function that makes its bytes.
struct LanguageFile {
  std::string extension;  ///< ".h"
  std::string (*of_tables)(const TableLayout& layout) = nullptr;
  std::string (*of_operation)(const OperationLayout& layout) =
      nullptr;  ///< for a custom operation or family; may be null
  std::string (*of_automaton)(const AutomatonArrays& automaton) = nullptr;

  /// "restrip_tables.h", or for an operation "restrip_bisect.h".
  [[nodiscard]] std::string name(const std::string& what = "tables") const;
};

/// The files of each language, by its name on the command line; none for "c++", whose files are written by emit.hpp and
/// operations/operation_layout.hpp. The shading languages share a file.
[[nodiscard]] const std::map<std::string, std::vector<LanguageFile>>& language_files();

/// The files of several languages by name, each once; `what` as for LanguageFile::name.
[[nodiscard]] std::map<std::string, const LanguageFile*> files_in(const std::set<std::string>& languages,
                                                                  const std::string& what);

// ---- Shared by the emitters ----

/// In capitals, for constants.
[[nodiscard]] std::string capitals(std::string name);

/// The arrays as constants of the language; `of` ends the name of each.
[[nodiscard]] std::string c_arrays(const TableLayout& layout, std::string_view of = {});
[[nodiscard]] std::string rust_arrays(const TableLayout& layout);

/// The place of an array in the shading languages: its name, the end of its name, its first word, bits of an element.
inline constexpr const char* glsl_array = "const uvec2 RESTRIP_{}{} = uvec2({}u, {}u);\n";
inline constexpr const char* wgsl_array = "const RESTRIP_{}{} = vec2<u32>({}u, {}u);\n";
/// A template of a shading language, filled in with these values and the layout's words.
[[nodiscard]] std::string shader_text(std::string_view text, const char* array, Filling filling,
                                      const TableLayout& layout, std::string_view of = {});

/// All arrays as one sequence of 32-bit words, for buffers of shaders: each word as four bytes, little-endian. Elements
/// of 8 and 16 bits fill a word from its lowest bit, and each array begins with a new word. The first word is the
/// checksum of the others.
[[nodiscard]] std::string words_file(const TableLayout& layout);

[[nodiscard]] std::string json_tables(const TableLayout& layout);
[[nodiscard]] std::string json_operation(const OperationLayout& layout);

// The table of a custom operation, or a family (operation_files.cpp).

[[nodiscard]] std::string c_operation(const OperationLayout& layout);
[[nodiscard]] std::string rust_operation(const OperationLayout& layout);
[[nodiscard]] std::string glsl_operation(const OperationLayout& layout);
[[nodiscard]] std::string wgsl_operation(const OperationLayout& layout);
[[nodiscard]] std::string operation_words_file(const OperationLayout& layout);

// The automaton of all valences (automaton_files.cpp).

[[nodiscard]] std::string c_automaton(const AutomatonArrays& automaton);
[[nodiscard]] std::string rust_automaton(const AutomatonArrays& automaton);
[[nodiscard]] std::string glsl_automaton(const AutomatonArrays& automaton);
[[nodiscard]] std::string wgsl_automaton(const AutomatonArrays& automaton);
[[nodiscard]] std::string json_automaton(const AutomatonArrays& automaton);
[[nodiscard]] std::string automaton_words_file(const AutomatonArrays& automaton);

}  // namespace restrip::generator
