// What a soup is: counts of everything a strip cares about, from the definitions, without our mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meshes/mend.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

/// The strips that a file has.
struct StripsInFile {
  std::size_t strips = 0;   ///< cut where two triangles that follow each other share no dual edge
  std::size_t cut = 0;      ///< so many times
  std::size_t indices = 0;  ///< of the file, with one between two strips
};

/// Degenerate faces (a corner twice) are counted as such and take no part in any other count but `triangles`.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t used_vertices = 0;  ///< corners of some triangle
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t polygons = 0;            ///< faces of more than three corners, cut into triangles when read
  std::size_t stubs = 0;               ///< faces of fewer than three corners, left out when read
  std::size_t degenerate_faces = 0;    ///< faces with a corner twice
  std::size_t duplicate_faces = 0;     ///< faces with the same three corners as an earlier one, in any order
  std::size_t boundary_edges = 0;      ///< edges of one triangle
  std::size_t boundary_loops = 0;      ///< closed walks along boundary edges (open ones where the mesh is not manifold)
  std::size_t non_manifold_edges = 0;  ///< edges of three triangles or more
  std::size_t inconsistent_edges = 0;  ///< edges of two triangles that disagree in orientation
  std::size_t bow_tie_vertices = 0;    ///< vertices whose triangles fall into several groups that share no edge
  std::size_t coincident_vertices = 0;    ///< used vertices at the place of an earlier one
  std::size_t components = 0;             ///< pieces that share no vertex
  std::int64_t euler_characteristic = 0;  ///< used vertices - edges + triangles
  /// Genus of all components together; only where it makes sense: an oriented manifold (no count above from
  /// `degenerate_faces` to `bow_tie_vertices`, the boundary apart, is positive).
  std::optional<std::int64_t> genus;
  std::vector<std::size_t> triangles_per_vertex;  ///< [n]: used vertices of n triangles
  std::optional<StripsInFile> strips;             ///< where the file has some

  /// Nothing here stands in the way of an operation anywhere on the mesh.
  [[nodiscard]] bool manifold() const noexcept { return genus.has_value(); }
};

/// Time: sorting the edges; memory: about 60 bytes a triangle.
[[nodiscard]] MeshReport report_on(const Soup& soup);

/// A table for people, and an object for programs. `mended`: what was changed before.
[[nodiscard]] std::string as_text(const MeshReport& report, const std::string& name, const Mended& mended = {});
[[nodiscard]] std::string as_json(const MeshReport& report, const Mended& mended = {});

}  // namespace restrip::tools
