// The triangles of a custom operation in a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "restrip/operations/apply.hpp"

namespace restrip::detail {

/// The sides of the triangles that a table has before or after its operation, as they lie in a mesh.
struct PatchSides {
  std::span<const tables::PatchTriangle> triangles;  ///< of the table
  /// The three sides of each triangle, as in the table. Entries after the last triangle have no meaning.
  std::array<std::array<Halfedge, 3>, tables::most_patch_triangles> side;

  /// The entries of `side` that belong to triangles.
  [[nodiscard]] std::span<const std::array<Halfedge, 3>> sides() const& {
    return std::span<const std::array<Halfedge, 3>>(side).first(triangles.size());
  }
  void sides() const&& = delete;
};
/// Finds them from the first side of the first one. They must exist (check_apply()).
[[nodiscard]] PatchSides read_sides(const StripMesh& mesh, std::span<const tables::PatchTriangle> triangles,
                                    Halfedge where);

/// apply() without checks of preconditions.
Rewrite apply_unchecked(StripMesh& mesh, const OperationView& table, Halfedge where, NewVertices* added);
/// The change of the mesh alone; all dual edges inside the patch must be dashed. Returns the first side after it.
Halfedge replace_patch(StripMesh& mesh, const OperationView& table, const PatchSides& patch, NewVertices* added);

}  // namespace restrip::detail
