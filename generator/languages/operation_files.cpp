// The table of a custom operation or family, with its look-up: the fixed text of templates/operation.*. All languages
// have the same arrays, with one element per place. The place of a position has its numbers as the digits of one
// number. Numbers are called at_k if the operation file says k, because k may be a word of the language.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "languages/languages.hpp"
#include "tables/emit.hpp"

namespace restrip::generator {
namespace {

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
  const std::size_t numbers = layout.named().numbers.size();
  const unsigned base = largest_number(layout) + 1;
  std::size_t places = 1;
  for (std::size_t i = 0; i < numbers; ++i) places *= base;
  std::vector<std::vector<std::uint32_t>> by_place(5, std::vector<std::uint32_t>(places));
  for (const OperationLayout::At& at : layout.positions) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < numbers; ++i) place = place * base + at.position.numbers().at(i);
    const Side& before = at.patch.before;
    by_place[0][place] = static_cast<std::uint32_t>(before.edges.size());
    by_place[1][place] = before.ports();
    by_place[2][place] = before.nodes;
    by_place[3][place] = at.patch.after.nodes;
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

}  // namespace

std::string c_operation(const OperationLayout& layout) {
  Filling filling =
      operation_filling(layout, {"//", "uint32_t {}, ", "  if ({}) return rule;\n", "  place = {};\n", "", ""});
  filling["arrays"] = c_arrays(arrays_of(layout), "_of_" + filling["name"]);
  return filled(operation_h, filling);
}

std::string rust_operation(const OperationLayout& layout) {
  Filling filling = operation_filling(layout, {"//!", "{}: u32, ", "    if {} {{\n        return None;\n    }}\n",
                                               "    let place = {} as usize;\n", "    let place = 0;\n", ""});
  filling["arrays"] = rust_arrays(arrays_of(layout));
  return filled(operation_rs, filling);
}

std::string glsl_operation(const OperationLayout& layout) {
  return shader_operation(operation_glsl, glsl_array, layout,
                          {"//", "uint {}, ", "  if ({}) return none;\n", "  place = {};\n", "", "u"});
}

std::string wgsl_operation(const OperationLayout& layout) {
  return shader_operation(operation_wgsl, wgsl_array, layout,
                          {"//", "{}: u32, ", "  if ({}) {{\n    return none;\n  }}\n", "  place = {};\n", "", "u"});
}

std::string operation_words_file(const OperationLayout& layout) { return words_file(arrays_of(layout)); }

}  // namespace restrip::generator
