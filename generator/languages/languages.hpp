// The rule tables in other languages than C++: one file for each, with the data and a look-up written by hand. All
// look-ups offer the same seven functions, one for each operation, from the colours before it, in every position with
// k <= max_k (docs/languages.md).
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

/// The first lines of a file: what it is, its licence, the command that wrote it. Each begins with `comment`.
[[nodiscard]] std::string language_banner(const std::string& comment, const std::string& language,
                                          const TableLayout& layout);

/// What a user of every look-up must know: operations, bits and limits, in lines that begin with `comment`.
[[nodiscard]] std::string language_manual(const std::string& comment);

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

/// What a user of a shader must know beside language_manual().
[[nodiscard]] std::string shader_manual(const std::string& comment, const TableWords& data);

/// In capitals, for constants.
[[nodiscard]] std::string capitals(std::string name);

// ---- One emitter a language ----

[[nodiscard]] std::string c_header(const TableLayout& layout);
[[nodiscard]] std::string json_tables(const TableLayout& layout);
[[nodiscard]] std::string rust_module(const TableLayout& layout);
[[nodiscard]] std::string glsl_source(const TableLayout& layout);
[[nodiscard]] std::string wgsl_source(const TableLayout& layout);

}  // namespace restrip::generator
