// One vertex split by its vertices: what levels of detail are made of, and how files list them.
#pragma once

#include <cstddef>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// One vertex split; read backward, the collapse of v_t into v_s. v_l is the apex to the left of v_s -> v_t. If the new
/// edge lies on the boundary, v_l or v_r is `none`.
struct SplitRecord {
  Vertex v_s = none;  ///< is split and stays
  Vertex v_t = none;  ///< is new
  Vertex v_l = none;
  Vertex v_r = none;
  /// The number of triangles that the split adds.
  [[nodiscard]] constexpr std::size_t triangles() const noexcept { return v_l != none && v_r != none ? 2 : 1; }
  friend bool operator==(const SplitRecord&, const SplitRecord&) = default;
};

/// The spokes of a split of the mesh as it is before that split. Spokes that do not exist are {none}; check_split
/// refuses them.
[[nodiscard]] inline VertexSplit spokes_of(const StripMesh& mesh, const SplitRecord& split) {
  using Split = VertexSplit;
  if (split.v_r == none) return {mesh.spoke(split.v_s, split.v_l), {}, Split::Spokes::left_only};
  if (split.v_l == none) return {{}, mesh.spoke(split.v_s, split.v_r), Split::Spokes::right_only};
  return {mesh.spoke(split.v_s, split.v_l), mesh.spoke(split.v_s, split.v_r), Split::Spokes::both};
}

/// The record of the collapse of `chord`, v_s -> v_t, before it is done.
[[nodiscard]] inline SplitRecord record_of_collapse(const StripMesh& mesh, Halfedge chord) {
  const auto apex = [&mesh](Halfedge h) { return StripMesh::on_boundary(h) ? none : mesh.to(StripMesh::next(h)); };
  return {mesh.from(chord), mesh.to(chord), apex(chord), apex(mesh.opposite(chord))};
}

}  // namespace restrip
