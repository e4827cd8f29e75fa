#include "tables/layout.hpp"

#include <algorithm>

#include "tables/operation_layout.hpp"

namespace restrip::generator {

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

}  // namespace restrip::generator
