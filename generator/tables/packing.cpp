#include "tables/packing.hpp"

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

}  // namespace restrip::generator
