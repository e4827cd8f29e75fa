// A progressive mesh (Hoppe 1996): a coarse mesh and the vertex splits that lead from it to the fine one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "meshes/soup.hpp"
#include "restrip/mesh/split_record.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

using Record = SplitRecord;

struct ProgressiveMesh {
  std::vector<Point> points;               ///< of all vertices
  std::vector<Corners> base;               ///< the triangles of the coarse mesh
  std::vector<Record> splits;              ///< from coarse to fine
  std::string file = {};                   ///< the source, for messages; may be empty
  std::vector<std::string> left_out = {};  ///< as Soup::left_out

  /// The number of triangles of the finest mesh.
  [[nodiscard]] std::size_t fine_triangles() const noexcept {
    std::size_t n = base.size();
    for (const Record& r : splits) n += r.triangles();
    return n;
  }
  /// The number of splits from the base to the first level with at least `triangles` triangles; all splits if none is
  /// as large.
  [[nodiscard]] std::size_t splits_to(std::size_t triangles) const noexcept {
    std::size_t level = 0;
    for (std::size_t n = base.size(); level < splits.size() && n < triangles; ++level) n += splits[level].triangles();
    return level;
  }
};

/// The spokes of the split with this number. Throws BadInput, naming the file and the split, if `now`, the mesh after
/// the previous splits, does not allow it (checks.hpp).
[[nodiscard]] VertexSplit possible_split(const StripMesh& now, const ProgressiveMesh& mesh, std::size_t number);

}  // namespace restrip::tools
