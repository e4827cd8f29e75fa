// The rule tables as plain arrays, from which the files of all languages are written (emit/emit.hpp).
// tables/include/restrip/tables/format.hpp explains the numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/certificate.hpp"

namespace restrip::generator {

// The stage `tables` for fans: packs the keys of each valence into few cells by row displacement (see
// tables/include/restrip/tables/format.hpp).

/// The cells of keys within the block of their valence.
struct Packing {
  std::vector<unsigned> start;  ///< index 1 << k | ports
  std::vector<unsigned> cells;  ///< index k: cells in one block
};

/// The packing serves all sections, valence by valence. First fit, the fullest rows first: deterministic. Flips have no
/// packing.
[[nodiscard]] Packing pack(const std::vector<Certificate>& certificates, unsigned max_k);

/// The values of `joined` under which a look-up may find this key (docs/reference/notation.md, "Key"): bit i is set if
/// solid port i is joined to the solid port before it around the closed fan. If exactly two ports are solid and they
/// are joined, either of their bits alone will do.
[[nodiscard]] std::vector<Mask> spellings(const Key& key);

/// The rules of a family of fans in their cells: members as in RuleTable of restrip/tables/format.hpp.
struct RuleBlocks {
  std::vector<unsigned> first;  ///< index k
  std::vector<unsigned> cells;  ///< index k
  std::vector<Mask> rules;      ///< cells without a key hold 0
};
[[nodiscard]] RuleBlocks fill(const std::vector<Section>& sections, const Packing& packing, unsigned max_k);

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

/// The table of an operation or a family, common to all languages: entries as explained in
/// tables/include/restrip/tables/operation_format.hpp, and for each position the size of the patch and the start of its
/// entries.
struct OperationLayout {
  /// A position and the start of its entries.
  struct At {
    PositionWithPatch position;
    std::size_t first = 0;
  };

  unsigned width = 8;         ///< bits of an entry: 8, 16 or 32
  std::vector<At> positions;  ///< in ascending order of their numbers, or the only one
  std::vector<std::uint32_t> entries;

  [[nodiscard]] const Description& named() const { return *positions.at(0).position.family; }
  [[nodiscard]] bool matching() const { return named().constraint.most_edges == 1; }
  /// The entry of configurations that are not valid.
  [[nodiscard]] std::uint32_t none() const { return ~std::uint32_t{0} >> (32 - width); }
  [[nodiscard]] std::size_t bytes() const { return entries.size() * width / 8; }
};

/// For answered positions of one description, which must outlive the layout.
[[nodiscard]] OperationLayout operation_layout(const std::vector<AnsweredPosition>& positions);

/// For all positions of each description up to max_k, by its certificate, in the order of the certificates.
[[nodiscard]] std::vector<OperationLayout> operation_layouts(const std::vector<Certificate>& certificates,
                                                             const std::vector<Description>& descriptions,
                                                             unsigned max_k);

}  // namespace restrip::generator
