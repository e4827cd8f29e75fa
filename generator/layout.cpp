#include "layout.hpp"

#include <algorithm>

namespace restrip::generator {
namespace {

template <class Number>
TableArray array_of(const std::string& name, const std::vector<Number>& values) {
  TableArray array{name, 8, {values.begin(), values.end()}};
  const std::uint32_t largest = array.values.empty() ? 0 : *std::max_element(array.values.begin(), array.values.end());
  if (largest > 0xff) array.bits = largest > 0xffff ? 32 : 16;
  return array;
}

}  // namespace

const std::vector<LookUp>& look_ups() {
  const std::string closed = "k >= 3, 1 <= a < k";
  const std::string gaps = "k >= 1, 0 <= i < j <= k";
  const std::string gap = "k >= 1, 0 <= i <= k";
  static const std::vector<LookUp> all{
      {"split", {"k", "a"}, closed, "split", "closed_rows", true, 0, 3, 2},
      {"collapse", {"k", "a"}, closed, "collapse", "closed_rows", false, 3, 0, -2},
      {"open_split", {"k", "i", "j"}, gaps, "open_split", "open_rows", true, -1, 2, 2},
      {"open_collapse", {"k", "i", "j"}, gaps, "fan_collapse", "open_rows", false, 2, -1, -2},
      {"boundary_split", {"k", "i"}, gap, "boundary_split", "open_rows", true, -1, 0, 1},
      {"boundary_collapse", {"k", "i"}, gap, "fan_collapse", "open_rows", false, 0, -1, -1},
      {"flip", {}, "", "flip", "", false, 1, 1, 0},
  };
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

TableLayout table_layout(const std::vector<SolvedFamily>& families, const Packing& closed, const Packing& open,
                         unsigned max_k) {
  TableLayout layout{max_k, {array_of("closed_rows", closed.start), array_of("open_rows", open.start)}};
  for (const SolvedFamily& family : families) {
    if (family.name == "flip") {
      layout.arrays.push_back(array_of("flip_rules", flip_cells(family.sections.at(0))));
      continue;
    }
    const Family acts = family.sections.at(0).position.family;
    const bool on_closed = generator::closed(acts);
    const RuleBlocks blocks = fill(family.sections, on_closed ? closed : open, max_k);
    const std::string name = identifier(family.name);
    layout.arrays.push_back(array_of(name + "_first", blocks.first));
    if (!collapses(acts)) layout.arrays.push_back(array_of(name + "_cells", blocks.cells));
    layout.arrays.push_back(array_of(name + "_rules", blocks.rules));
  }
  return layout;
}

}  // namespace restrip::generator
