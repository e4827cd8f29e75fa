// Baking: the strips of every level of a progressive mesh, decided once, with any effort.
#pragma once

#include <cstddef>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "restrip/formats/baked_payload.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/baked.hpp"

namespace restrip::tools {

struct BakeOptions {
  /// Fewest strips: work for a record that would add one, in edges walked by the search for short trails, some 30 ns
  /// each. Other costs: each 3,900 of it are a look at a strip end (end_search.hpp) and a triangle more in an exact
  /// window (window.hpp) for each record; a window has at most 100.
  std::size_t effort = 250'000;
  Cost cost = Cost::strips();  ///< what is to be low at every level
};

/// A progressive mesh with its strips: the base in colours, and for each split the flips of baked.hpp.
struct BakedMesh {
  ProgressiveMesh mesh;
  StripMesh base;
  BakedRecords<StripMesh::Halfedge> records;
  BakedPayload payload{};  ///< of the user's, for each record
};

struct BakeReport {
  std::size_t components = 0;     ///< connected components of the dual graph: fewer strips are impossible
  std::size_t base_strips = 0;    ///< strips of the base
  std::size_t most_strips = 0;    ///< of all levels, every record counted
  std::size_t top_strips = 0;     ///< of the finest level
  std::size_t top_indices = 0;    ///< of a buffer of its strips
  std::size_t top_at_least = 0;   ///< strips_at_least() there (component_strips.hpp)
  std::size_t fewest_levels = 0;  ///< levels with as many strips as components
  std::size_t flips = 0;
  std::size_t states = 0;  ///< searched
  double seconds = 0;
};

/// Stripifies the base and walks up. After each split whose connected component has more strips than it is known to
/// need it looks for the fewest flips that leave one strip less: first around the split, and where that fails, by
/// tunnelling from further away. Under another cost it lowers the cost around each split by chains of moves at strip
/// ends and by an exact window. Throws BadInput when a split cannot be done, naming it. Deterministic but for
/// `seconds`.
[[nodiscard]] BakedMesh bake(ProgressiveMesh mesh, const BakeOptions& options = {}, BakeReport* report = nullptr);

}  // namespace restrip::tools
