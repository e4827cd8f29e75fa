#include "tables/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <set>

#include "operations/operation_layout.hpp"
#include "tables/number_lines.hpp"

namespace restrip::generator {
namespace {

std::string banner(const std::string& what) {
  return fmt::format(
      "// {}\n// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target "
      "`regenerate`.\n"
      "// Format 1, explained in restrip/tables/format.hpp.\n#pragma once\n\n#include "
      "\"restrip/tables/format.hpp\"\n\n"
      "namespace restrip::tables {{\n\n",
      what);
}

constexpr const char* footer = "\n}  // namespace restrip::tables\n";

}  // namespace

std::string identifier(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string rows_header(const Packing& packing, unsigned max_k) {
  return banner("Where the rows of keys start, index 1 << k | ports.") +
         fmt::format("inline constexpr RowStarts<{}> closed_rows{{\n", max_k) + numbers(packing.start) + "};\n" +
         footer;
}

RulesHeader rules_header(const Certificate& family, const Packing& packing, unsigned max_k) {
  const Section& first = family.sections.at(0);
  if (first.position.family->numbers.empty()) {
    // FlipTable of restrip/tables/format.hpp is the table of an operation with one position.
    const OperationLayout layout = operation_layout({{first.position, &first}});
    const auto none = std::count(layout.entries.begin(), layout.entries.end(), layout.none());
    const auto valid = static_cast<std::ptrdiff_t>(layout.entries.size()) - none;
    return {banner(fmt::format("Rules of the {}: {} valid configurations.", family.name, valid)) +
                fmt::format("inline constexpr FlipTable {}{{\n", identifier(family.name)) + numbers(layout.entries) +
                "};\n" + footer,
            layout.bytes()};
  }
  const RuleBlocks blocks = fill(family.sections, packing, max_k);
  const bool wide = *std::max_element(blocks.rules.begin(), blocks.rules.end()) > 0xff;
  std::string text = banner(
      fmt::format("Rules of the family {}: {} in {} blocks.", family.name, family.rows(), family.sections.size()));
  text += fmt::format("inline constexpr RuleTable<{}, {}, {}> {}{{\n", wide ? "std::uint16_t" : "std::uint8_t", max_k,
                      blocks.rules.size(), identifier(family.name));
  text += "    {" + numbers(blocks.first).substr(4) + "    },\n    {" + numbers(blocks.cells).substr(4) +
          "    },\n    {\n" + numbers(blocks.rules) + "    },\n};\n";
  return {text + footer, blocks.rules.size() * (wide ? 2 : 1)};
}

}  // namespace restrip::generator
