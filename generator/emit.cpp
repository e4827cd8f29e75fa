#include "emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <set>

#include "number_lines.hpp"
#include "reason.hpp"

namespace restrip::generator {
namespace {

constexpr unsigned header_version = 1;
constexpr unsigned certificate_version = 2;

std::string banner(const std::string& what) {
  return fmt::format(
      "// {}\n// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target "
      "`regenerate`.\n"
      "// Format {}, explained in restrip/tables/format.hpp.\n#pragma once\n\n#include "
      "\"restrip/tables/format.hpp\"\n\n"
      "namespace restrip::tables {{\n\n",
      what, header_version);
}

constexpr const char* footer = "\n}  // namespace restrip::tables\n";

/// A pairing in four bits for each port: its partner, itself when it has none. Eight ports fit 32 bits, sixteen 64.
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

std::string flip_header(const SolvedFamily& family) {
  return banner(fmt::format("Rules of the {}: {} valid configurations.", family.name, family.rows())) +
         fmt::format("inline constexpr FlipTable {}{{\n", identifier(family.name)) +
         numbers(flip_cells(family.sections.at(0))) + "};\n" + footer;
}

/// One number for several positions: counts add up, worst cases are the worst.
Claims sum(const std::vector<Claims>& parts) {
  Claims total = parts.at(0);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Claims& part = parts[i];
    total.configurations += part.configurations;
    total.valid += part.valid;
    total.orbits += part.orbits;
    total.valid_orbits += part.valid_orbits;
    total.costing += part.costing;
    total.worst_strips = std::max(total.worst_strips, part.worst_strips);
    total.worst_isolated = std::max(total.worst_isolated, part.worst_isolated);
  }
  return total;
}

}  // namespace

std::string sealed(std::string text, std::size_t rows) {
  std::uint64_t sum = 0;
  std::uint64_t weighted = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    sum += byte;
    weighted += (i + 1) * byte;
  }
  return text + fmt::format("end {} {} {}\n", rows, sum, weighted);
}

std::string identifier(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::size_t SolvedFamily::rows() const {
  std::size_t n = 0;
  for (const Section& section : sections) n += section.rows.size();
  return n;
}

std::string rows_header(const Packing& closed, const Packing& open, unsigned max_k) {
  std::string text = banner("Where the rows of keys start, index 1 << k | ports.");
  for (const auto& [name, packing] : {std::pair{"closed_rows", &closed}, {"open_rows", &open}}) {
    text += fmt::format("inline constexpr RowStarts<{}> {}{{\n", max_k, name);
    text += numbers(packing->start) + "};\n";
  }
  return text + footer;
}

RulesHeader rules_header(const SolvedFamily& family, const Packing& packing, unsigned max_k) {
  if (family.sections.at(0).position.family->keyed_by_inner) return {flip_header(family), 32};
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

std::size_t LinkedFamily::alternatives() const {
  std::size_t n = 0;
  for (const LinkedSection& section : sections)
    for (const std::vector<Alternative>& list : section.lists) n += list.size();
  return n;
}

RulesHeader linked_header(const std::vector<LinkedFamily>& families, unsigned max_k) {
  std::set<std::uint64_t> pairings;
  for (const LinkedFamily& family : families)
    for (const LinkedSection& section : family.sections)
      for (const std::vector<Alternative>& list : section.lists)
        for (const Alternative& alternative : list) pairings.insert(partners(alternative.pairs, max_k));
  const std::vector<std::uint64_t> pairing(pairings.begin(), pairings.end());
  const bool wide = max_k > 8;
  std::string text = banner("Linked rules: recolourings for what is known of the outside.");
  text += fmt::format("inline constexpr Pairings<{}{}> pairings{{\n{}}};\n", pairing.size(),
                      wide ? fmt::format(", {}", max_k) : "",
                      wide ? numbers(pairing, " {:#018x},") : numbers(pairing, " {:#010x},"));
  std::size_t bytes = pairing.size() * (wide ? 8 : 4);
  for (const LinkedFamily& family : families) {
    std::vector<std::size_t> first(max_k + 1, 0);
    std::vector<std::size_t> start;
    std::size_t count = 0;
    Lines rules;
    for (const LinkedSection& section : family.sections) {
      if (first[section.position.k] == 0) first[section.position.k] = start.size();
      for (const std::vector<Alternative>& list : section.lists) {
        start.push_back(count);
        for (const Alternative& alternative : list) {
          const auto place = std::lower_bound(pairing.begin(), pairing.end(), partners(alternative.pairs, max_k));
          rules.add(fmt::format(" {{{}, {}}},", alternative.recoloring, place - pairing.begin()));
          ++count;
        }
      }
    }
    start.push_back(count);
    text += fmt::format(
        "inline constexpr LinkedTable<{}, {}, {}> linked_{}{{\n    {{{}    }},\n    {{\n{}    }},\n    {{{{\n{}    "
        "}}}},\n}};\n",
        max_k, start.size(), count, identifier(family.name), numbers(first).substr(4), numbers(start), rules.text());
    bytes += (wide ? 4 : 2) * (first.size() + start.size()) + 4 * count;
  }
  return {text + footer, bytes};
}

std::string position_text(const Position& position) {
  std::string text = position.family->section;
  for (std::size_t i = 0; i < position.family->numbers.size(); ++i) {
    const std::string name = fmt::format("{{{}}}", position.family->numbers[i]);
    if (const std::size_t at = text.find(name); at != std::string::npos)
      text.replace(at, name.size(), std::to_string(position.numbers().at(i)));
  }
  return text;
}

std::string section_text(const Section& section) {
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "section {}\n", position_text(section.position));
  const Claims claims = sum(section.claims);
  fmt::format_to(out, "claim configurations {}\nclaim valid {}\nclaim orbits {}\nclaim valid-orbits {}\n",
                 claims.configurations, claims.valid, claims.orbits, claims.valid_orbits);
  fmt::format_to(out, "claim costing {}\nclaim worst-strips {}\nclaim worst-isolated {}\n", claims.costing,
                 claims.worst_strips, claims.worst_isolated);
  const Reasoner reasoner(operation_of(section.position, Sight::patch, section.goal));
  for (const Row& row : section.rows) {
    fmt::format_to(out, "{} {:x} {:x} ", row.witness < 0 ? "rule" : "copy", row.key.ports, row.key.joined);
    if (section.position.family->gives_ports_up)
      fmt::format_to(out, "{:x} {:x}", row.kept, row.recoloring);
    else
      fmt::format_to(out, "{:x}", row.recoloring);
    if (row.witness >= 0)
      fmt::format_to(out, " by {}", section.symmetry[static_cast<std::size_t>(row.witness)].name());
    else
      fmt::format_to(out, " because {}",
                     reasoner.find(row.key.ports, pairs_before(section.position, row.key), row).reason.text());
    text += '\n';
  }
  return text;
}

std::string section_text(const LinkedSection& section) {
  std::string text;
  auto out = std::back_inserter(text);
  std::size_t alternatives = 0;
  std::size_t longest = 0;
  for (const std::vector<Alternative>& list : section.lists) {
    alternatives += list.size();
    longest = std::max(longest, list.size());
  }
  fmt::format_to(out, "section {}\nclaim lists {}\nclaim alternatives {}\nclaim longest {}\n",
                 position_text(section.position), section.lists.size(), alternatives, longest);
  for (std::size_t ports = 0; ports < section.lists.size(); ++ports)
    for (const Alternative& alternative : section.lists[ports])
      fmt::format_to(out, "alternative {:x} {:x}\n", ports, alternative.recoloring);
  return text;
}

std::string certificate(const std::string& family, const std::vector<std::string>& texts, std::size_t rows) {
  std::string text = fmt::format("restrip-certificate {}\nfamily {}\n", certificate_version, family);
  for (const std::string& section : texts) text += section;
  return sealed(std::move(text), rows);
}

}  // namespace restrip::generator
