#pragma once
// The text form of reasons in certificates (docs/reference/certificate.md, "Reasons"). Their validity is checked
// elsewhere.

#include <string>
#include <vector>

#include "model/input.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

/// Why no recolouring is preferred to a rule: either two cases (an edge solid, and the same edge dashed), or sets of
/// edges that cannot all be solid.
struct Reason {
  unsigned edge = 0;
  std::vector<Reason> cases;  ///< solid, dashed; empty for a leaf
  std::vector<Mask> sets;     ///< of a leaf

  /// The reason as the certificate writes it.
  std::string text() const;
};

/// Reads the reason from word `first` to the end of the line. Its edges are below `edges`.
Reason parse_reason(const LineReader& reader, std::size_t first, unsigned edges);

/// The number of leaves of its tree.
std::size_t cases_of(const Reason& reason);

}  // namespace restrip::verify
