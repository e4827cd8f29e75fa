#include "languages/languages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>

namespace restrip::generator {
namespace {

/// The words as a file, little-endian.
std::string words_file(const TableLayout& layout) {
  std::string bytes;
  for (const std::uint32_t word : table_words(layout).words)
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
  return bytes;
}

}  // namespace

const std::map<std::string, std::vector<LanguageFile>>& language_files() {
  static const std::map<std::string, std::vector<LanguageFile>> files{
      {"c++", {}},
      {"c", {{"restrip_tables.h", c_header}}},
      {"json", {{"restrip_tables.json", json_tables}}},
      {"rust", {{"restrip_tables.rs", rust_module}}},
      {"glsl", {{"restrip_tables.glsl", glsl_source}, {"restrip_tables.bin", words_file}}},
      {"wgsl", {{"restrip_tables.wgsl", wgsl_source}, {"restrip_tables.bin", words_file}}},
  };
  return files;
}

std::string language_banner(const std::string& comment, const std::string& language, const TableLayout& layout) {
  return fmt::format(
      "{0} restrip's rule tables up to k = {2}: {3} bytes of data, and the look-up.\n"
      "{0} SPDX-License-Identifier: MIT\n"
      "{0} Copyright (c) 2026 The restrip authors\n"
      "{0} Written by `restrip-generate tables --language {1} --max-k {2}`. Do not edit: change the generator.\n",
      comment, language, layout.max_k, layout.bytes());
}

std::string language_manual(const std::string& comment) {
  const auto bits = [](int more) {
    return more == 0 ? std::string("k bits") : fmt::format("k {} {} bits", more < 0 ? '-' : '+', std::abs(more));
  };
  std::string text = fmt::format("{0}\n{0}   {1:<19}{2:<26}{3:<19}{4:<9}{5}\n", comment, "operation", "position",
                                 "colours before", "ports", "colours after");
  for (const LookUp& look_up : look_ups()) {
    const bool flip = look_up.position.empty();
    text += fmt::format("{}   {:<19}{:<26}{:<19}{:<9}{}\n", comment, look_up.name, look_up.where,
                        (look_up.from_fan ? "loop, " : "inner, ") + (flip ? "1 bit" : bits(look_up.before_bits)),
                        flip ? "4 bits" : "k bits", flip ? "inner, 1 bit; ports, 4 bits" : bits(look_up.after_bits));
  }
  text += fmt::format("{}\n", comment);
  for (const char* line :
       {"Each function takes the colours of a patch before an operation and returns the best colours after it: sound",
        "whatever lies outside the patch, with the fewest strips, and of those with the fewest isolated triangles. "
        "Colours",
        "are masks, bit 0 the lowest, 1 = solid, 0 = dashed; restrip's docs/notation.md says which bit is which edge. "
        "Each",
        "takes O(k) steps."})
    text += fmt::format("{} {}\n", comment, line);
  return text;
}

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

std::string shader_manual(const std::string& comment, const TableWords& data) {
  return fmt::format(
      "{0}\n"
      "{0} The data are in restrip_tables.bin, written by the same command: {1} words of 32 bits, little-endian, to "
      "be\n"
      "{0} copied into a storage buffer as they are. If restrip_words[0] is not RESTRIP_CHECKSUM, file and data do "
      "not\n"
      "{0} belong together.\n"
      "{0}\n"
      "{0} Bad input: for colours that no valid stripification has (three solid edges at a triangle, a solid cycle, "
      "bits\n"
      "{0} outside the patch), and for positions that the tables do not hold (k > RESTRIP_MAX_K, a or gaps out of "
      "range),\n"
      "{0} every member of the answer is 0 and `valid` is false.\n"
      "{0}\n",
      comment, data.words.size());
}

std::string capitals(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

}  // namespace restrip::generator
