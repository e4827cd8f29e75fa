// The stage `tables` for fans: packs the keys of each valence into few cells by row displacement (see
// tables/include/restrip/tables/format.hpp).
#pragma once

#include <vector>

#include "certify/certificate.hpp"

namespace restrip::generator {

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

}  // namespace restrip::generator
