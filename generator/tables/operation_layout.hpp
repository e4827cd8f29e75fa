// The table of an operation or a family, common to all languages: entries as explained in
// tables/include/restrip/tables/operation_format.hpp, and for each position the size of the patch and the start of its
// entries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/certificate.hpp"

namespace restrip::generator {

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
