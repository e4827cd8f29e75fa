// The rule tables as plain arrays, from which the files of all languages are written (emit/languages.hpp).
// tables/include/restrip/tables/format.hpp explains the numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tables/packing.hpp"

namespace restrip::generator {

struct TableArray {
  std::string name;   ///< "closed_rows", "split_first", "split_cells", "split_rules", …, "flip_rules"
  unsigned bits = 8;  ///< of an element, 8, 16 or 32: the fewest that hold its values
  std::vector<std::uint32_t> values;

  [[nodiscard]] std::size_t bytes() const { return values.size() * bits / 8; }
};

/// Makes an array with the fewest bits.
template <class Number>
[[nodiscard]] TableArray array_of(const std::string& name, const std::vector<Number>& values) {
  TableArray array{name, 8, {values.begin(), values.end()}};
  const std::uint32_t largest = array.values.empty() ? 0 : *std::max_element(array.values.begin(), array.values.end());
  if (largest > 0xff) array.bits = largest > 0xffff ? 32 : 16;
  return array;
}

struct TableLayout {
  unsigned max_k = 0;
  std::vector<TableArray> arrays;

  [[nodiscard]] std::size_t bytes() const;
  /// Null if the array does not exist.
  [[nodiscard]] const TableArray* find(const std::string& name) const;
};

/// An operation answered by the tables: the inputs of a look-up, and the rules that it reads
/// (docs/reference/notation.md).
struct LookUp {
  std::string name;
  std::vector<std::string> position;  ///< the numbers of a position, k first; empty for the flip
  std::string where;                  ///< their ranges, as text
  std::string
      family;  ///< "F" of the arrays F_first, F_rules, and, if the position matters, F_cells; for F_rules alone: flip
  bool from_fan = false;  ///< whether the colours before are the fan's, so that triangles are added
  int before_bits = 0;    ///< bits of the colours before, minus k; for the flip, all
  int after_bits = 0;     ///< the same after
  int triangles = 0;      ///< triangles after minus triangles before
};

/// One for each family with a table, in the order of tables/families.json.
[[nodiscard]] std::vector<LookUp> look_ups();

/// The families of rules, with the packing of their keys.
[[nodiscard]] TableLayout table_layout(const std::vector<Certificate>& rules, const Packing& packing, unsigned max_k);

}  // namespace restrip::generator
