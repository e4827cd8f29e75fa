// Languages other than C++: the fixed text of templates/, filled in; and JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "emit/emit.hpp"
#include "emit/templates.hpp"

namespace restrip::generator {
namespace {

/// The value of each `@name@` in a template. A placeholder on a separate line stands for whole lines: its value ends
/// with a line break, or is empty.
using Filling = std::map<std::string, std::string>;

/// The template with its placeholders replaced. Replacements are not searched again. Throws std::out_of_range for a
/// placeholder without a value.
std::string filled(std::string_view text, const Filling& filling) {
  constexpr std::string_view name_characters = "abcdefghijklmnopqrstuvwxyz_";
  std::string made;
  for (std::size_t at = text.find('@'); at != std::string_view::npos; at = text.find('@')) {
    const std::size_t end = text.find_first_not_of(name_characters, at + 1);
    if (end == std::string_view::npos || text[end] != '@' || end == at + 1) {  // an attribute of WGSL
      made += text.substr(0, at + 1);
      text.remove_prefix(at + 1);
      continue;
    }
    const bool whole_line = (at == 0 ? made.empty() || made.back() == '\n' : text[at - 1] == '\n') &&
                            end + 1 < text.size() && text[end + 1] == '\n';
    made += text.substr(0, at);
    made += filling.at(std::string(text.substr(at + 1, end - at - 1)));
    text.remove_prefix(end + (whole_line ? 2 : 1));
  }
  return made += text;
}

/// In capitals, for constants.
std::string capitals(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

/// A template of C, filled in with these values and the arrays as constants; `of` ends the name of each.
std::string c_text(std::string_view text, Filling filling, const TableLayout& layout, std::string_view of = {}) {
  for (const TableArray& array : layout.arrays)
    filling["arrays"] += fmt::format("static const uint{}_t restrip_{}{}[{}] = {{\n{}}};\n", array.bits, array.name, of,
                                     array.values.size(), numbers(array.values));
  return filled(text, filling);
}

std::string rust_text(std::string_view text, Filling filling, const TableLayout& layout) {
  for (const TableArray& array : layout.arrays)
    filling["arrays"] += fmt::format("\nconst {}: &[u{}; {}] = &[\n{}];\n", capitals(array.name), array.bits,
                                     array.values.size(), numbers(array.values));
  return filled(text, filling);
}

/// All arrays as one sequence of 32-bit words, for buffers of shaders. Elements of 8 and 16 bits fill a word from its
/// lowest bit, and each array begins with a new word. The first word is the checksum of the others.
std::vector<std::uint32_t> table_words(const TableLayout& layout) {
  std::vector<std::uint32_t> words{0};
  for (const TableArray& array : layout.arrays) {
    const std::size_t in_a_word = 32 / array.bits;
    for (std::size_t i = 0; i < array.values.size(); ++i) {
      if (i % in_a_word == 0) words.push_back(0);
      words.back() |= array.values[i] << (i % in_a_word * array.bits);
    }
  }
  std::uint32_t checksum = 0x811c9dc5;
  for (std::size_t i = 1; i < words.size(); ++i) checksum = (checksum ^ words[i]) * 0x01000193;
  words[0] = checksum;
  return words;
}

/// Each word as four bytes, little-endian.
std::string words_file(const TableLayout& layout) {
  std::string bytes;
  for (const std::uint32_t word : table_words(layout))
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
  return bytes;
}

/// The place of an array in the shading languages: its name, the end of its name, its first word, bits of an element.
constexpr const char* glsl_array = "const uvec2 RESTRIP_{}{} = uvec2({}u, {}u);\n";
constexpr const char* wgsl_array = "const RESTRIP_{}{} = vec2<u32>({}u, {}u);\n";

std::string shader_text(std::string_view text, const char* array, Filling filling, const TableLayout& layout,
                        std::string_view of = {}) {
  std::size_t words = 1;
  for (const TableArray& one : layout.arrays) {
    filling["arrays"] += fmt::format(fmt::runtime(array), capitals(one.name), of, words, one.bits);
    words += (one.bytes() + 3) / 4;
  }
  filling["words"] = std::to_string(words);
  filling["checksum"] = fmt::format("{:#010x}", table_words(layout)[0]);
  return filled(text, filling);
}

/// Returns a text that does not depend on the tables.
template <const std::string_view& text, class Layout>
std::string as_it_is(const Layout& /*layout*/) {
  return std::string(text);
}

// ---- The tables.

/// The values for every template of the tables, except the arrays. The operations are one per line; each line begins
/// with `comment`.
Filling tables_filling(const std::string& comment, const TableLayout& layout) {
  const auto bits = [](int more) {
    return more == 0 ? std::string("k bits") : fmt::format("k {} {} bits", more < 0 ? '-' : '+', std::abs(more));
  };
  std::string operations = fmt::format("{0}   {1:<19}{2:<26}{3:<19}{4:<9}{5}\n", comment, "operation", "position",
                                       "colours before", "ports", "colours after");
  for (const LookUp& look_up : look_ups()) {
    const bool flip = look_up.position.empty();
    operations +=
        fmt::format("{}   {:<19}{:<26}{:<19}{:<9}{}\n", comment, look_up.name, look_up.where,
                    (look_up.from_fan ? "loop, " : "inner, ") + (flip ? "1 bit" : bits(look_up.before_bits)),
                    flip ? "4 bits" : "k bits", flip ? "inner, 1 bit; ports, 4 bits" : bits(look_up.after_bits));
  }
  return {
      {"max_k", std::to_string(layout.max_k)}, {"bytes", std::to_string(layout.bytes())}, {"operations", operations}};
}

// ---- The table of a custom operation or family. All languages have the same arrays, with one element per place. The
// place of a position has its numbers as the digits of one number. Numbers are called at_k if the operation file says
// k, because k may be a word of the language.

/// How a language writes the parts that differ between operations.
struct Dialect {
  const char* comment;    ///< begins a line
  const char* parameter;  ///< of one number, by its name
  const char* outside;    ///< for numbers without a place, by the condition
  const char* place;      ///< by a formula
  const char* no_place;   ///< if there is only one
  const char* suffix;     ///< ends a number
};

/// The largest number of any position.
unsigned largest_number(const OperationLayout& layout) {
  unsigned largest = 0;
  for (const OperationLayout::At& at : layout.positions)
    for (const unsigned number : at.position.numbers()) largest = std::max(largest, number);
  return largest;
}

/// The arrays "edges", "ports", "before", "after", "first" by place, and "entries".
TableLayout arrays_of(const OperationLayout& layout) {
  const std::size_t digits = layout.named().numbers.size();
  const unsigned base = largest_number(layout) + 1;
  std::size_t places = 1;
  for (std::size_t i = 0; i < digits; ++i) places *= base;
  std::vector<std::vector<std::uint32_t>> by_place(5, std::vector<std::uint32_t>(places));
  for (const OperationLayout::At& at : layout.positions) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < digits; ++i) place = place * base + at.position.numbers().at(i);
    const Side& before = at.position.patch.before;
    by_place[0][place] = static_cast<std::uint32_t>(before.edges.size());
    by_place[1][place] = before.ports();
    by_place[2][place] = before.nodes;
    by_place[3][place] = at.position.patch.after.nodes;
    by_place[4][place] = static_cast<std::uint32_t>(at.first);
  }
  return {0,
          {array_of("edges", by_place[0]),
           array_of("ports", by_place[1]),
           array_of("before", by_place[2]),
           array_of("after", by_place[3]),
           array_of("first", by_place[4]),
           {"entries", layout.width, layout.entries}}};
}

/// The values of all templates except the arrays.
Filling operation_filling(const OperationLayout& layout, const Dialect& dialect) {
  const Description& named = layout.named();
  const unsigned largest = largest_number(layout);
  std::string parameters;
  std::string outside;
  std::string place;
  for (const std::string& number : named.numbers) {
    const std::string at = "at_" + number;
    parameters += fmt::format(fmt::runtime(dialect.parameter), at);
    outside += fmt::format("{}{} > {}{}", outside.empty() ? "" : " || ", at, largest, dialect.suffix);
    place = place.empty() ? at : fmt::format("({} * {}{} + {})", place, largest + 1, dialect.suffix, at);
  }
  std::string note;
  if (!named.numbers.empty())
    note += fmt::format("{} Its positions are given by {}, up to {} = {}.\n", dialect.comment,
                        fmt::join(named.numbers, ", "), named.numbers[0], largest);
  if (layout.matching())
    note += fmt::format(
        "{0} A matching's rule depends on the ports alone: the table answers as if `inner` were always valid. Pairs\n"
        "{0} and single triangles count as its strips.\n",
        dialect.comment);
  return {{"about", named.about.empty() ? named.name : named.about},
          {"title", named.name},
          {"name", identifier(named.name)},
          {"capitals", capitals(identifier(named.name))},
          {"note", note},
          {"parameters", parameters},
          {"position", named.numbers.empty() ? dialect.no_place
                                             : fmt::format(fmt::runtime(dialect.outside), outside) +
                                                   fmt::format(fmt::runtime(dialect.place), place)},
          {"configuration", layout.matching() ? "ports" : "(inner << port_count | ports)"},
          {"none", std::to_string(layout.none())}};
}

std::string shader_operation(std::string_view text, const char* array, const OperationLayout& layout,
                             const Dialect& dialect) {
  Filling filling = operation_filling(layout, dialect);
  if (!layout.matching()) filling["configuration"] = "((inner << port_count) | ports)";
  return shader_text(text, array, filling, arrays_of(layout), "_OF_" + filling["capitals"]);
}

std::string c_operation(const OperationLayout& layout) {
  Filling filling =
      operation_filling(layout, {"//", "uint32_t {}, ", "  if ({}) return rule;\n", "  place = {};\n", "", ""});
  return c_text(operation_h, filling, arrays_of(layout), "_of_" + filling["name"]);
}

std::string rust_operation(const OperationLayout& layout) {
  const Filling filling = operation_filling(layout, {"//!", "{}: u32, ", "    if {} {{\n        return None;\n    }}\n",
                                                     "    let place = {} as usize;\n", "    let place = 0;\n", ""});
  return rust_text(operation_rs, filling, arrays_of(layout));
}

std::string glsl_operation(const OperationLayout& layout) {
  return shader_operation(operation_glsl, glsl_array, layout,
                          {"//", "uint {}, ", "  if ({}) return none;\n", "  place = {};\n", "", "u"});
}

std::string wgsl_operation(const OperationLayout& layout) {
  return shader_operation(operation_wgsl, wgsl_array, layout,
                          {"//", "{}: u32, ", "  if ({}) {{\n    return none;\n  }}\n", "  place = {};\n", "", "u"});
}

/// The program that prints all answers of a look-up. `position` is a line of the program: the position as dumps name
/// it, quoted; inner edges, ports, numbers. `argument` is one number in a call.
std::string operation_check(std::string_view text, const char* position, const char* argument,
                            const OperationLayout& layout) {
  const std::string name = identifier(layout.named().name);
  Filling filling{{"name", name}, {"capitals", capitals(name)}, {"positions", ""}, {"arguments", ""}};
  for (const OperationLayout::At& at : layout.positions)
    filling["positions"] += fmt::format(fmt::runtime(position), nlohmann::json(name_of(at.position)).dump(),
                                        layout.matching() ? 0 : at.position.patch.before.edges.size(),
                                        at.position.patch.before.ports(), fmt::join(at.position.numbers(), ", "));
  for (std::size_t i = 0; i < layout.named().numbers.size(); ++i)
    filling["arguments"] += fmt::format(fmt::runtime(argument), i);
  return filled(text, filling);
}

// ---- The automaton of all valences: its arrays, and a look-up by keys.

/// The values for every template of the automaton, except the arrays. A split has three edges more than k.
Filling automaton_filling(const std::string& comment, const AutomatonArrays& automaton, unsigned word_bits) {
  std::string operations = fmt::format("{0}   {1:<16}{2:<28}{3}\n", comment, "operation", "position", "colours after");
  const auto add = [&](const char* name, const char* position, const char* after) {
    operations += fmt::format("{0}   {1:<16}{2:<28}{3}\n", comment, name, position, after);
  };
  add("split", "k >= 3, 1 <= a < k", "inner, k + 3 bits");
  add("collapse", "k >= 3, whatever a", "loop, k bits");
  add("open_split", "k >= 1, 0 <= i < j <= k", "inner, k + 2 bits");
  add("boundary_split", "k >= 1, 0 <= i <= k", "inner, k bits");
  add("fan_collapse", "k >= 1, whatever the gaps", "loop, k - 1 bits: open or boundary collapse");
  return {{"max_k", std::to_string(word_bits - 3)},
          {"bytes", std::to_string(automaton.table.bytes())},
          {"seconds", std::to_string(automaton.seconds)},
          {"operations", operations}};
}

}  // namespace

const std::map<std::string, std::vector<LanguageFile>>& language_files() {
  static const LanguageFile words{".bin", words_file, [](const OperationLayout& o) { return words_file(arrays_of(o)); },
                                  [](const AutomatonArrays& a) { return words_file(a.table); }};
  static const std::map<std::string, std::vector<LanguageFile>> files{
      {"c++", {}},
      {"c",
       {{".h", [](const TableLayout& t) { return c_text(tables_h, tables_filling("//", t), t); }, c_operation,
         [](const AutomatonArrays& a) { return c_text(automaton_h, automaton_filling("//", a, 64), a.table); }},
        {"_check.c", as_it_is<tables_check_c>,
         [](const OperationLayout& o) {
           return operation_check(operation_check_c, "  {{{}, {}, {}, {{{}}}}},\n", "positions[i].at[{}], ", o);
         },
         as_it_is<automaton_check_c>}}},
      {"json",
       {{".json", json_tables, json_operation, json_automaton},
        {".mjs", as_it_is<tables_mjs>, nullptr, as_it_is<automaton_mjs>},
        {"_check.mjs", as_it_is<tables_check_mjs>,
         [](const OperationLayout& o) { return operation_check(operation_check_mjs, "  {},\n", "", o); },
         as_it_is<automaton_check_mjs>}}},
      {"rust",
       {{".rs", [](const TableLayout& t) { return rust_text(tables_rs, tables_filling("//!", t), t); }, rust_operation,
         [](const AutomatonArrays& a) { return rust_text(automaton_rs, automaton_filling("//!", a, 64), a.table); }},
        {"_check.rs", as_it_is<tables_check_rs>,
         [](const OperationLayout& o) {
           return operation_check(operation_check_rs, "    ({}, {}, {}, [{}]),\n", "at[{}], ", o);
         },
         as_it_is<automaton_check_rs>}}},
      {"glsl",
       {{".glsl", [](const TableLayout& t) { return shader_text(tables_glsl, glsl_array, tables_filling("//", t), t); },
         glsl_operation,
         [](const AutomatonArrays& a) {
           return shader_text(automaton_glsl, glsl_array, automaton_filling("//", a, 32), a.table, "_IN_AUTOMATON");
         }},
        words,
        {"_check.comp", as_it_is<tables_check_comp>, nullptr, as_it_is<automaton_check_comp>}}},
      {"wgsl",
       {{".wgsl", [](const TableLayout& t) { return shader_text(tables_wgsl, wgsl_array, tables_filling("//", t), t); },
         wgsl_operation,
         [](const AutomatonArrays& a) {
           return shader_text(automaton_wgsl, wgsl_array, automaton_filling("//", a, 32), a.table, "_IN_AUTOMATON");
         }},
        words,
        {"_check.wgsl", as_it_is<tables_check_wgsl>, nullptr, as_it_is<automaton_check_wgsl>}}},
  };
  return files;
}

std::map<std::string, const LanguageFile*> files_in(const std::set<std::string>& languages, const std::string& stem) {
  // A program that checks an operation is not restrip_rule_of_NAME_check: an operation may be called NAME-check.
  const auto name_of = [&stem](std::string_view extension) {
    constexpr std::string_view rule = "rule_of_";
    constexpr std::string_view check = "_check";
    if (stem.starts_with(rule) && extension.starts_with(check))
      return fmt::format("restrip_check_of_{}{}", stem.substr(rule.size()), extension.substr(check.size()));
    return fmt::format("restrip_{}{}", stem, extension);
  };
  std::map<std::string, const LanguageFile*> files;
  for (const std::string& language : languages)
    for (const LanguageFile& file : language_files().at(language)) files[name_of(file.extension)] = &file;
  return files;
}

// The tables as JSON; docs/tables.schema.json is the schema. The table of an operation is as in
// docs/how-to/other-languages.md.

namespace {

/// A member whose value is an array of numbers; removes the last comma of `numbers`.
std::string json_numbers(const TableArray& array, const std::string& key) {
  std::string text = numbers(array.values);
  text.erase(text.find_last_of(','), 1);
  return fmt::format("\"{}\": [\n{}]", key, text);
}

}  // namespace

std::string json_tables(const TableLayout& layout) {
  std::string text = fmt::format(
      "{{\n\"format\": \"restrip-tables\",\n\"version\": 2,\n"
      "\"license\": \"MIT, Copyright (c) 2026 The restrip authors\",\n"
      "\"command\": \"restrip-generate tables --language json --max-k {0}\",\n\"max_k\": {0},\n\"operations\": [",
      layout.max_k);
  std::string between = "\n    ";
  for (const LookUp& look_up : look_ups()) {
    std::string position;
    for (const std::string& number : look_up.position)
      position += fmt::format("{}\"{}\"", position.empty() ? "" : ", ", number);
    text += fmt::format(
        "{}{{\"name\": \"{}\", \"position\": [{}], \"family\": \"{}\", \"from_fan\": {}, \"before_bits\": {}, "
        "\"after_bits\": {}, \"triangles\": {}}}",
        between, look_up.name, position, look_up.family, look_up.from_fan, look_up.before_bits, look_up.after_bits,
        look_up.triangles);
    between = ",\n    ";
  }
  text += "\n],\n" + json_numbers(*layout.find("closed_rows"), "rows") + ",\n\"families\": {";
  between = "\n";
  std::set<std::string> written;
  for (const LookUp& look_up : look_ups()) {
    if (look_up.position.empty() || !written.insert(look_up.family).second) continue;
    text += fmt::format("{}\"{}\": {{", between, look_up.family);
    between = "\n";
    for (const char* part : {"first", "cells", "rules"})
      if (const TableArray* array = layout.find(look_up.family + "_" + part)) {
        text += between + json_numbers(*array, part);
        between = ",\n";
      }
    text += "\n}";
    between = ",\n";
  }
  return text + "\n},\n" + json_numbers(*layout.find("flip_rules"), "flip") + "\n}\n";
}

std::string json_automaton(const AutomatonArrays& automaton) {
  std::string text = fmt::format(
      "{{\n\"format\": \"restrip-automaton\",\n\"version\": 2,\n"
      "\"license\": \"MIT, Copyright (c) 2026 The restrip authors\",\n"
      "\"command\": \"restrip-generate automaton --language json\",\n\"seconds\": {}",
      automaton.seconds);
  for (const TableArray& array : automaton.table.arrays) text += ",\n" + json_numbers(array, array.name);
  return text + "\n}\n";
}

std::string json_operation(const OperationLayout& layout) {
  const Description& named = layout.named();
  const auto quoted = [](const std::string& text) { return nlohmann::json(text).dump(); };
  std::vector<std::string> positions;
  const auto listed = [](const std::vector<SurfaceTriangle>& triangles) {
    std::vector<std::string> words;
    words.reserve(triangles.size());
    for (const SurfaceTriangle& t : triangles)
      words.push_back(
          fmt::format("[{}, {}, {}, {}]", t.from, t.from_side, fmt::join(t.vertex, ", "), fmt::join(t.side, ", ")));
    return fmt::format("[{}]", fmt::join(words, ", "));
  };
  for (const OperationLayout::At& at : layout.positions) {
    const PositionNumbers all = at.position.numbers();
    const auto& [before, after, vertices] = at.position.patch.surface;
    const std::string surface =
        fmt::format(",\n     \"vertices\": {}, \"triangles_before\": {}, \"triangles_after\": {}", vertices,
                    listed(before), listed(after));
    const auto size = [](const Side& side) {
      return fmt::format("{{\"triangles\": {}, \"edges\": {}}}", side.nodes, side.edges.size());
    };
    positions.push_back(
        fmt::format("    {{\"numbers\": [{}], \"before\": {}, \"after\": {}, \"ports\": {}, \"first\": {}{}}}",
                    fmt::join(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(named.numbers.size()), ", "),
                    size(at.position.patch.before), size(at.position.patch.after), at.position.patch.before.ports(),
                    at.first, surface));
  }
  return fmt::format(
      "{{\n\"format\": \"restrip-operation-table\",\n\"version\": 1,\n"
      "\"command\": \"restrip-generate rules --language json\",\n\"name\": {},\n\"about\": {},\n\"matching\": {},\n"
      "\"numbers\": {},\n\"positions\": [\n{}\n],\n\"none\": {},\n{}\n}}\n",
      quoted(named.name), quoted(named.about), layout.matching(), nlohmann::json(named.numbers).dump(),
      fmt::join(positions, ",\n"), layout.none(), json_numbers({"entries", layout.width, layout.entries}, "entries"));
}

}  // namespace restrip::generator
