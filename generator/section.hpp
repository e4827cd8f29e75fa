// A section: all rules of one split position, or of all collapses of a valence, found by exhaustive search and reduced
// by symmetry; with the claims that its certificate makes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "claims.hpp"
#include "configuration.hpp"
#include "family_operation.hpp"
#include "patch.hpp"
#include "search.hpp"
#include "symmetry.hpp"

namespace restrip::generator {

/// A rule: the colours after.
struct Row : Choice {
  Key key;
  int witness = -1;  ///< index of the symmetry that leads to the representative; -1 for the representative itself
};

struct Section {
  Position position;               ///< family and valence, and the place unless they serve every one
  std::vector<Position> serves;    ///< the positions whose configurations these rules answer
  std::vector<Symmetry> symmetry;  ///< those that lead from a copy to its representative
  std::vector<Row> rows;           ///< in ascending order of key
  std::vector<Claims> claims;      ///< for each position served
  Goal goal = Goal::strips;
};

/// The certificates' families, in the order in which they are written; fan-collapse serves both collapses of an open
/// fan.
[[nodiscard]] const std::vector<std::string>& certificate_families();

/// The pairs of ports that a key says were joined before, two bits each.
[[nodiscard]] std::vector<Mask> pairs_before(const Position& position, const Key& key);

/// Every section of a certificate in ascending order of position, as yet without symmetries, rows and claims, for
/// valences up to max_k (at most 13, so that a recolouring has 16 bits).
[[nodiscard]] std::vector<Section> sections_of(const std::string& certificate_family, unsigned max_k);

/// Finds what a section lacks. Threads may solve different sections at the same time.
void solve(Section& section);

/// Every section of a certificate, solved. The work is shared by `threads`; the result does not depend on their number.
[[nodiscard]] std::vector<Section> solve(const std::string& certificate_family, unsigned max_k, unsigned threads);

/// The row of a key that some valid configuration has.
[[nodiscard]] const Row& row_of(const Section& section, const Key& key);

/// What answering a configuration with a row does to the number of strips and of isolated triangles.
struct Change {
  int strips = 0;
  int isolated = 0;
};
[[nodiscard]] Change change_of(const Patch& patch, const Configuration& configuration, const Row& row);

}  // namespace restrip::generator
