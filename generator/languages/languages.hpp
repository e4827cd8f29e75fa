// The rule tables in other languages than C++: one file for each, with the data and a look-up, which is the
// fixed text of a template (templates.hpp). All look-ups offer the same seven functions, one for each operation, from
// the colours before it, in every position with k <= max_k (docs/languages.md).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "layout.hpp"

namespace restrip::generator {

/// A file of a language, and what writes its bytes.
struct LanguageFile {
  std::string name;
  std::string (*bytes)(const TableLayout& layout) = nullptr;
};

/// The files of each language, by its name on the command line; none for "c++", which emit.hpp writes. The shading
/// languages share a file.
[[nodiscard]] const std::map<std::string, std::vector<LanguageFile>>& language_files();

// ---- What the emitters share ----

/// All arrays as one run of 32-bit words, for buffers of shaders. Elements of 8 and 16 bits fill a word from its lowest
/// bit, and each array begins with a word. The first word is the checksum of the others.
struct TableWords {
  struct Array {
    std::string name;   ///< of the array, in capitals
    unsigned word = 0;  ///< where it begins
    unsigned bits = 8;  ///< of an element
  };
  std::vector<std::uint32_t> words;
  std::vector<Array> arrays;
};
[[nodiscard]] TableWords table_words(const TableLayout& layout);

/// In capitals, for constants.
[[nodiscard]] std::string capitals(std::string name);

[[nodiscard]] std::string json_tables(const TableLayout& layout);

}  // namespace restrip::generator
