// Baking: precomputes the strips of every level of a progressive mesh, with any effort.
#pragma once

#include <cstddef>

#include "lod/progressive_mesh.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/baked.hpp"

namespace restrip::tools {

struct BakeOptions {
  /// Fewest strips: work per record that would add a strip, in edges walked by the search for short trails, about 30 ns
  /// each. Other costs: every 600 buy one more strip end that the search of each record examines.
  std::size_t effort = 250'000;
  Cost cost = Cost::strips();  ///< the cost to minimise at every level
};

/// A progressive mesh with its strips: the base in colours, and for each split the flips of baked.hpp.
struct BakedMesh {
  ProgressiveMesh mesh;
  StripMesh base;
  BakedRecords records;
  BakedPayload payload{};  ///< user data for each record
};

struct BakeReport {
  std::size_t components = 0;     ///< connected components of the dual graph, a lower bound of the strips
  std::size_t base_strips = 0;    ///< strips of the base
  std::size_t most_strips = 0;    ///< over all levels, after every record
  std::size_t top_strips = 0;     ///< of the finest level
  std::size_t top_indices = 0;    ///< of an index buffer of its strips
  std::size_t top_at_least = 0;   ///< strips_at_least() there (trail_search.hpp)
  std::size_t fewest_levels = 0;  ///< levels with one strip per component
  std::size_t states = 0;         ///< search states visited
  double seconds = 0;
};

/// Stripifies the base and walks up. After each split whose connected component has more strips than its lower bound,
/// it searches for the fewest flips that save a strip: first around the split, then by tunnelling from further away.
/// Under other costs, it lowers the cost around each split by chains of moves at strip ends.
/// Throws BadInput, naming the split, if a split is not possible. Deterministic except for `seconds`.
[[nodiscard]] BakedMesh bake(ProgressiveMesh mesh, const BakeOptions& options = {}, BakeReport* report = nullptr);

}  // namespace restrip::tools
