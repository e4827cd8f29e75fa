// How much is lost by not looking outside the patch. A local rule is the best of the recolourings that keep the ports
// and are safe whatever the rest of the mesh looks like; in a given mesh a bolder recolouring of the same patch, with
// the same ports, is often safe as well. This counts how often.
#pragma once

#include <cstddef>

#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// The largest fans that are compared.
inline constexpr std::size_t max_compared_valence = 16;

/// Operations of one kind, splits or collapses, on closed fans of at most max_compared_valence triangles.
struct Boldness {
  std::size_t operations = 0;
  std::size_t costing = 0;           ///< the local rule adds a strip, compared with the change in triangles alone
  std::size_t costing_at_best = 0;   ///< so does the best recolouring of the patch that is valid in this mesh
  std::size_t bolder = 0;            ///< that one keeps more strips together than the local rule
  std::size_t missed_by_linked = 0;  ///< and more than the linked rule, which follows strips only so far
};

struct BoldnessReport {
  Boldness splits;
  Boldness collapses;
};

/// Plays the progressive mesh up and down again by local rules, starting with the colours of `base`, and compares each
/// rule with the best recolouring in that mesh, found by following every strip that leaves the patch to its end.
[[nodiscard]] BoldnessReport count_bolder(const ProgressiveMesh& mesh, const StripMesh& base);

}  // namespace restrip::tools
