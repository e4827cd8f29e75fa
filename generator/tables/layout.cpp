#include "tables/layout.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <set>

namespace restrip::generator {

std::vector<Mask> spellings(const Key& key) {
  Mask joined = 0;
  for (const Mask pair : key.joined.masks())
    for (Mask one = pair; one != 0; one &= one - 1) {
      const Mask port = one & (~one + 1);
      // The nearest solid port before it around the fan.
      const Mask below = key.ports & (port - 1);
      const Mask others = key.ports & ~port;
      if ((pair & std::bit_floor(below != 0 ? below : others)) != 0) joined |= port;
    }
  // Both bits are set only if each of two ports is the other's predecessor.
  if (std::popcount(key.ports) != 2 || joined != key.ports) return {joined};
  return {joined, std::bit_floor(joined), joined & (~joined + 1)};
}

RuleBlocks fill(const std::vector<Section>& sections, const Packing& packing, unsigned max_k) {
  RuleBlocks blocks{std::vector<unsigned>(max_k + 1, 0), std::vector<unsigned>(max_k + 1, 0), {}};
  unsigned last_k = 0;
  for (const Section& section : sections) {
    const unsigned k = section.position.k;
    if (k != last_k) blocks.first[k] = static_cast<unsigned>(blocks.rules.size());
    last_k = k;
    blocks.cells[k] = packing.cells[k];
    const std::size_t block = blocks.rules.size();
    blocks.rules.resize(block + packing.cells[k], 0);
    for (const Row& row : section.rows)
      for (const Mask joined : spellings(row.key))
        blocks.rules[block + packing.start[std::size_t{1} << k | row.key.ports] + joined] = row.recoloring;
  }
  return blocks;
}

Packing pack(const std::vector<Certificate>& certificates, unsigned max_k) {
  std::vector<const Section*> sections;
  for (const Certificate& certificate : certificates)
    for (const Section& section : certificate.sections)
      if (!section.position.family->numbers.empty()) sections.push_back(&section);
  Packing packing{std::vector<unsigned>(std::size_t{2} << max_k, 0), std::vector<unsigned>(max_k + 1, 0)};
  for (unsigned k = 1; k <= max_k; ++k) {
    std::map<Mask, std::set<Mask>> columns;
    for (const Section* section : sections) {
      if (section->position.k != k) continue;
      for (const Row& row : section->rows)
        for (const Mask joined : spellings(row.key)) columns[row.key.ports].insert(joined);
    }
    std::vector<Mask> order;
    order.reserve(columns.size());
    for (const auto& [ports, row] : columns) order.push_back(ports);
    std::stable_sort(order.begin(), order.end(), [&](Mask x, Mask y) { return columns[x].size() > columns[y].size(); });
    std::vector<bool> taken;
    for (const Mask ports : order) {
      const auto& row = columns[ports];
      const auto fits = [&](unsigned start) {
        return std::none_of(row.begin(), row.end(),
                            [&](Mask c) { return start + c < taken.size() && taken[start + c]; });
      };
      unsigned start = 0;
      while (!fits(start)) ++start;
      taken.resize(std::max<std::size_t>(taken.size(), start + *row.rbegin() + 1), false);
      for (const Mask c : row) taken[start + c] = true;
      packing.start[std::size_t{1} << k | ports] = start;
    }
    packing.cells[k] = static_cast<unsigned>(taken.size());
  }
  return packing;
}

std::vector<LookUp> look_ups() {
  std::vector<LookUp> all;
  for (const Description& family : tabled_families()) {
    // Independent of the position, so any position will do.
    const Patch patch = make_patch(positions(family, smallest_valence(family)).at(0));
    const int k = family.numbers.empty() ? 0 : static_cast<int>(patch.before.owner.size());
    const int added = static_cast<int>(patch.after.nodes) - static_cast<int>(patch.before.nodes);
    all.push_back({identifier(family.name), family.numbers, family.range, identifier(family.certificate), added > 0,
                   static_cast<int>(patch.before.edges.size()) - k, static_cast<int>(patch.after.edges.size()) - k,
                   added});
  }
  return all;
}

std::size_t TableLayout::bytes() const {
  std::size_t sum = 0;
  for (const TableArray& array : arrays) sum += array.bytes();
  return sum;
}

const TableArray* TableLayout::find(const std::string& name) const {
  const auto found =
      std::find_if(arrays.begin(), arrays.end(), [&](const TableArray& array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

TableLayout table_layout(const std::vector<Certificate>& rules, const Packing& packing, unsigned max_k) {
  TableLayout layout{max_k, {array_of("closed_rows", packing.start)}};
  for (const Certificate& family : rules) {
    const Description& acts = *family.sections.at(0).position.family;
    if (acts.numbers.empty()) {
      const Section& only = family.sections.at(0);
      layout.arrays.push_back(
          array_of(identifier(family.name) + "_rules", operation_layout({{only.serves.at(0), &only}}).entries));
      continue;
    }
    const RuleBlocks blocks = fill(family.sections, packing, max_k);
    const std::string name = identifier(family.name);
    layout.arrays.push_back(array_of(name + "_first", blocks.first));
    if (!serves_every_position(acts)) layout.arrays.push_back(array_of(name + "_cells", blocks.cells));
    layout.arrays.push_back(array_of(name + "_rules", blocks.rules));
  }
  return layout;
}

OperationLayout operation_layout(const std::vector<AnsweredPosition>& positions) {
  OperationLayout layout;
  // An entry has at least one bit more than a rule, so that all ones means none.
  std::size_t bits = 0;
  for (const auto& [position, section] : positions) {
    layout.positions.push_back({position, 0});
    bits = std::max(bits, position.patch.after.edges.size() + position.patch.after.owner.size());
  }
  layout.width = bits < 8 ? 8 : bits < 16 ? 16 : 32;
  // For matchings, whose keys are the ports, entry P serves every colouring.
  const bool matching = layout.matching();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Operation operation = operation_at(positions[i].position, positions[i].position.patch);
    const Side& before = operation.patch.before;
    const unsigned ports = before.ports();
    const std::size_t first = layout.entries.size();
    layout.positions[i].first = first;
    layout.entries.resize(first + (std::size_t{1} << (matching ? ports : before.edges.size() + ports)), layout.none());
    for_each_valid(operation, [&](const Configuration& c) {
      const Row& row = row_of(*positions[i].section, c.ports, c.outcome.joined);
      layout.entries[first + (matching ? c.ports : std::size_t{c.before} << ports | c.ports)] =
          row.recoloring << ports | row.kept;
    });
  }
  return layout;
}

std::vector<OperationLayout> operation_layouts(const std::vector<Certificate>& certificates,
                                               const std::vector<Description>& descriptions, unsigned max_k) {
  std::vector<OperationLayout> layouts;
  for (const Certificate& certificate : certificates)
    for (const Description& description : descriptions)
      if (description.certificate == certificate.name)
        layouts.push_back(operation_layout(answers_of(description, certificate.sections, max_k).positions));
  return layouts;
}

}  // namespace restrip::generator
