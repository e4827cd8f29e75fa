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

/// A pairing in four bits for each port: its partner, or itself if it has none. Eight ports fit 32 bits, sixteen 64.
std::uint64_t partners(const std::vector<Mask>& pairs, unsigned max_k) {
  std::uint64_t packed = max_k <= 8 ? 0x76543210 : 0xfedcba9876543210;
  for (const Mask pair : pairs) {
    const int low = std::countr_zero(pair);
    const int high = std::countr_zero(std::bit_floor(pair));
    const auto swap = static_cast<std::uint64_t>(low ^ high);
    packed ^= swap << (4 * low) | swap << (4 * high);
  }
  return packed;
}

}  // namespace

std::string identifier(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string rows_header(const Packing& closed, const Packing& open, unsigned max_k) {
  std::string text = banner("Where the rows of keys start, index 1 << k | ports.");
  for (const auto& [name, packing] : {std::pair{"closed_rows", &closed}, {"open_rows", &open}}) {
    text += fmt::format("inline constexpr RowStarts<{}> {}{{\n", max_k, name);
    text += numbers(packing->start) + "};\n";
  }
  return text + footer;
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

RulesHeader linked_header(const std::vector<Certificate>& families, unsigned max_k) {
  std::set<std::uint64_t> pairings;
  for (const Certificate& family : families)
    for (const Section& section : family.sections)
      for (const Row& row : section.rows) pairings.insert(partners(row.key.joined.masks(), max_k));
  const std::vector<std::uint64_t> pairing(pairings.begin(), pairings.end());
  const bool wide = max_k > 8;
  std::string text = banner("Linked rules: recolourings for what is known of the outside.");
  text += fmt::format("inline constexpr Pairings<{}{}> pairings{{\n{}}};\n", pairing.size(),
                      wide ? fmt::format(", {}", max_k) : "",
                      wide ? numbers(pairing, " {:#018x},") : numbers(pairing, " {:#010x},"));
  std::size_t bytes = pairing.size() * (wide ? 8 : 4);
  for (const Certificate& family : families) {
    std::vector<std::size_t> first(max_k + 1, 0);
    std::vector<std::size_t> start;
    std::vector<std::string> rules;
    for (const Section& section : family.sections) {
      if (first[section.position.k] == 0) first[section.position.k] = start.size();
      std::optional<Mask> ports;
      for (const Row& row : section.rows) {
        if (ports != row.key.ports) start.push_back(rules.size());
        ports = row.key.ports;
        const auto place = std::lower_bound(pairing.begin(), pairing.end(), partners(row.key.joined.masks(), max_k));
        rules.push_back(fmt::format("{{{}, {}}}", row.recoloring, place - pairing.begin()));
      }
    }
    start.push_back(rules.size());
    text += fmt::format(
        "inline constexpr LinkedTable<{}, {}, {}> {}{{\n    {{{}    }},\n    {{\n{}    }},\n    {{{{\n{}    "
        "}}}},\n}};\n",
        max_k, start.size(), rules.size(), identifier(family.name), numbers(first).substr(4), numbers(start),
        numbers(rules));
    bytes += (wide ? 4 : 2) * (first.size() + start.size()) + 4 * rules.size();
  }
  return {text + footer, bytes};
}

}  // namespace restrip::generator
