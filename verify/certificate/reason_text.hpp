#pragma once
// A reason as certificates write it (docs/reference/certificate.md, "Reasons"). Whether it is one is checked elsewhere.

#include <string>
#include <vector>

#include "model/input.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

/// Why nothing is preferred to a rule: two cases, an edge solid and the same edge dashed, or sets of edges that cannot
/// all be solid.
struct Reason {
  unsigned edge = 0;
  std::vector<Reason> cases;  ///< solid, dashed; empty for a leaf
  std::vector<Mask> sets;     ///< of a leaf

  /// The reason as the certificate writes it.
  std::string text() const;
};

/// Reads the reason that starts at word `first` of the line and ends with it. Its edges are those below `edges`.
Reason parse_reason(const LineReader& reader, std::size_t first, unsigned edges);

/// The leaves of its tree.
std::size_t cases_of(const Reason& reason);

}  // namespace restrip::verify
