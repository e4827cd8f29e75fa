// The table of an operation or a family, common to all languages: entries as explained in
// tables/include/restrip/tables/operation_format.hpp, and for each position the size of the patch and the start of its
// entries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "solve/section.hpp"

namespace restrip::generator {

/// A position and the solved section whose rows answer its configurations.
struct AnsweredPosition {
  Position position;
  const Section* section = nullptr;
};

struct OperationLayout {
  /// A position and the start of its entries.
  struct At {
    Position position;
    Patch patch;
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

/// For the positions of one description, which must outlive the layout.
[[nodiscard]] OperationLayout operation_layout(const std::vector<AnsweredPosition>& positions);

/// The header in C++: docs/reference/operation-file.md, "Table".
[[nodiscard]] std::string operation_header(const OperationLayout& layout);

}  // namespace restrip::generator
