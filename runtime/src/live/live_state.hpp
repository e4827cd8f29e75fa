// What LiveMesh::save() writes, and packing. docs/reference/file-formats.md has the format.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "restrip/live_mesh.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strip_format.hpp"

namespace restrip::detail {

class LiveState {
 public:
  /// What a saved mesh consists of. Of the options, policy, cost, format and layout.
  struct Saved {
    StripMesh mesh;
    LiveOptions options;
  };

  [[nodiscard]] static std::vector<std::byte> write(const StripMesh& mesh, const LiveOptions& options);
  /// Throws std::invalid_argument with the reason.
  [[nodiscard]] static Saved read(std::span<const std::byte> bytes);

  /// Gives triangles and vertices the lowest numbers, in their order, and drops vertices without triangles. After an
  /// exception nothing has changed. The watch of the mesh is not notified.
  [[nodiscard]] static Renumbering pack(StripMesh& mesh);

 private:
  static void renumber(StripMesh& mesh, std::span<const Triangle> triangles, std::size_t triangle_bound,
                       std::span<const Vertex> vertices, std::size_t vertex_bound);
};

}  // namespace restrip::detail
