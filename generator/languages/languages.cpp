#include "languages/languages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>

#include "tables/number_lines.hpp"

namespace restrip::generator {
namespace {

/// The operations, one per line; each line begins with `comment`.
std::string operation_lines(const std::string& comment) {
  const auto bits = [](int more) {
    return more == 0 ? std::string("k bits") : fmt::format("k {} {} bits", more < 0 ? '-' : '+', std::abs(more));
  };
  std::string text = fmt::format("{0}   {1:<19}{2:<26}{3:<19}{4:<9}{5}\n", comment, "operation", "position",
                                 "colours before", "ports", "colours after");
  for (const LookUp& look_up : look_ups()) {
    const bool flip = look_up.position.empty();
    text += fmt::format("{}   {:<19}{:<26}{:<19}{:<9}{}\n", comment, look_up.name, look_up.where,
                        (look_up.from_fan ? "loop, " : "inner, ") + (flip ? "1 bit" : bits(look_up.before_bits)),
                        flip ? "4 bits" : "k bits", flip ? "inner, 1 bit; ports, 4 bits" : bits(look_up.after_bits));
  }
  return text;
}

/// The values for every template of the tables; `arrays` is in the language.
Filling tables_filling(const std::string& comment, const TableLayout& layout, const std::string& arrays = {}) {
  return {{"max_k", std::to_string(layout.max_k)},
          {"bytes", std::to_string(layout.bytes())},
          {"operations", operation_lines(comment)},
          {"arrays", arrays}};
}

std::string c_header(const TableLayout& layout) {
  return filled(tables_h, tables_filling("//", layout, c_arrays(layout)));
}

std::string rust_module(const TableLayout& layout) {
  return filled(tables_rs, tables_filling("//!", layout, rust_arrays(layout)));
}

/// Returns a text that does not depend on the tables.
template <const std::string_view& text, class Layout>
std::string as_it_is(const Layout& /*layout*/) {
  return std::string(text);
}

std::string glsl_source(const TableLayout& layout) {
  return shader_text(tables_glsl, glsl_array, tables_filling("//", layout), layout);
}

std::string wgsl_source(const TableLayout& layout) {
  return shader_text(tables_wgsl, wgsl_array, tables_filling("//", layout), layout);
}

/// The content of the file of words.
struct TableWords {
  struct Array {
    std::string name;   ///< of the array, in capitals
    unsigned word = 0;  ///< its first word
    unsigned bits = 8;  ///< of an element
  };
  std::vector<std::uint32_t> words;
  std::vector<Array> arrays;
};

TableWords table_words(const TableLayout& layout) {
  TableWords data{{0}, {}};
  for (const TableArray& array : layout.arrays) {
    data.arrays.push_back({capitals(array.name), static_cast<unsigned>(data.words.size()), array.bits});
    const std::size_t in_a_word = 32 / array.bits;
    for (std::size_t i = 0; i < array.values.size(); ++i) {
      if (i % in_a_word == 0) data.words.push_back(0);
      data.words.back() |= array.values[i] << (i % in_a_word * array.bits);
    }
  }
  std::uint32_t checksum = 0x811c9dc5;
  for (std::size_t i = 1; i < data.words.size(); ++i) checksum = (checksum ^ data.words[i]) * 0x01000193;
  data.words[0] = checksum;
  return data;
}

}  // namespace

const std::map<std::string, std::vector<LanguageFile>>& language_files() {
  static const std::map<std::string, std::vector<LanguageFile>> files{
      {"c++", {}},
      {"c",
       {{".h", c_header, c_operation, c_automaton},
        {"_check.c", as_it_is<tables_check_c>, nullptr, as_it_is<automaton_check_c>}}},
      {"json",
       {{".json", json_tables, json_operation, json_automaton},
        {".mjs", as_it_is<tables_mjs>, nullptr, as_it_is<automaton_mjs>},
        {"_check.mjs", as_it_is<tables_check_mjs>, nullptr, as_it_is<automaton_check_mjs>}}},
      {"rust",
       {{".rs", rust_module, rust_operation, rust_automaton},
        {"_check.rs", as_it_is<tables_check_rs>, nullptr, as_it_is<automaton_check_rs>}}},
      {"glsl",
       {{".glsl", glsl_source, glsl_operation, glsl_automaton},
        {".bin", words_file, operation_words_file, automaton_words_file},
        {"_check.comp", as_it_is<tables_check_comp>, nullptr, as_it_is<automaton_check_comp>}}},
      {"wgsl",
       {{".wgsl", wgsl_source, wgsl_operation, wgsl_automaton},
        {".bin", words_file, operation_words_file, automaton_words_file},
        {"_check.wgsl", as_it_is<tables_check_wgsl>, nullptr, as_it_is<automaton_check_wgsl>}}},
  };
  return files;
}

std::map<std::string, const LanguageFile*> files_in(const std::set<std::string>& languages, const std::string& what) {
  std::map<std::string, const LanguageFile*> files;
  for (const std::string& language : languages)
    for (const LanguageFile& file : language_files().at(language)) files[file.name(what)] = &file;
  return files;
}

std::string LanguageFile::name(const std::string& what) const { return "restrip_" + identifier(what) + extension; }

std::string words_file(const TableLayout& layout) {
  std::string bytes;
  for (const std::uint32_t word : table_words(layout).words)
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
  return bytes;
}

std::string capitals(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

std::string c_arrays(const TableLayout& layout, std::string_view of) {
  std::string text;
  for (const TableArray& array : layout.arrays)
    text += fmt::format("static const uint{}_t restrip_{}{}[{}] = {{\n{}}};\n", array.bits, array.name, of,
                        array.values.size(), numbers(array.values));
  return text;
}

std::string rust_arrays(const TableLayout& layout) {
  std::string text;
  for (const TableArray& array : layout.arrays)
    text += fmt::format("\nconst {}: &[u{}; {}] = &[\n{}];\n", capitals(array.name), array.bits, array.values.size(),
                        numbers(array.values));
  return text;
}

std::string shader_text(std::string_view text, const char* array, Filling filling, const TableLayout& layout,
                        std::string_view of) {
  const TableWords data = table_words(layout);
  for (const TableWords::Array& one : data.arrays)
    filling["arrays"] += fmt::format(fmt::runtime(array), one.name, of, one.word, one.bits);
  filling["words"] = std::to_string(data.words.size());
  filling["checksum"] = fmt::format("{:#010x}", data.words[0]);
  return filled(text, filling);
}

}  // namespace restrip::generator
