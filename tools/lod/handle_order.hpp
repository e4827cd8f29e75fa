// An order of the triangles of a progressive mesh in memory: along the strips of its finest level.
//
// A split takes the next free handles, so triangles lie in memory in the order of the splits: those of a coarse level
// close together, those that lie side by side in the mesh often far apart. Along strips most neighbours are close, at
// the fine levels; the triangles of a coarse level are spread over the memory of all.
#pragma once

#include <vector>

#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// The handles for StripMesh::renumber() of the base, before any split: what is t-th in the order of the splits is
/// handles[t]-th along strips. `base` has the triangles of mesh.base and room for the others. Plays all splits
/// and makes strips of the finest level from scratch (Effort::fast). From a split that is not possible on, triangles
/// keep the order of the splits. Linear time.
[[nodiscard]] std::vector<Triangle> handles_along_strips(const ProgressiveMesh& mesh, StripMesh base);

}  // namespace restrip::tools
