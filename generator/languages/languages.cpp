#include "languages/languages.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace restrip::generator {

const std::map<std::string, std::vector<LanguageFile>>& language_files() {
  static const std::map<std::string, std::vector<LanguageFile>> files{
      {"c++", {}},
      {"c", {{"restrip_tables.h", c_header}}},
      {"json", {{"restrip_tables.json", json_tables}}},
      {"rust", {{"restrip_tables.rs", rust_module}}},
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

}  // namespace restrip::generator
