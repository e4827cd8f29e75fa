// Counts everything that concerns strips in a soup, from the definitions, without our mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "meshes/mend.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {

/// The strips in a file.
struct StripsInFile {
  std::size_t strips = 0;   ///< cut where consecutive triangles share no dual edge
  std::size_t cut = 0;      ///< number of cuts
  std::size_t indices = 0;  ///< of the file, with one between two strips
};

/// Degenerate faces (a corner twice) count in `degenerate_faces` and `triangles` only.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t used_vertices = 0;  ///< vertices of some triangle
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t polygons = 0;               ///< faces with more than three corners, triangulated when read
  std::size_t stubs = 0;                  ///< faces with fewer than three corners, left out when read
  std::size_t degenerate_faces = 0;       ///< faces with a corner twice
  std::size_t duplicate_faces = 0;        ///< faces with the same three corners as an earlier one, in any order
  std::size_t boundary_edges = 0;         ///< edges of one triangle
  std::size_t boundary_loops = 0;         ///< closed walks along boundary edges (open if the mesh is not manifold)
  std::size_t non_manifold_edges = 0;     ///< edges of three triangles or more
  std::size_t inconsistent_edges = 0;     ///< edges of two triangles that disagree in orientation
  std::size_t bow_tie_vertices = 0;       ///< vertices whose triangles form several groups that share no edge
  std::size_t coincident_vertices = 0;    ///< used vertices at the position of an earlier one
  std::size_t components = 0;             ///< vertex-connected components
  std::int64_t euler_characteristic = 0;  ///< used vertices - edges + triangles
  /// Genus of all components together. Defined only for an oriented manifold (every count from `degenerate_faces` to
  /// `bow_tie_vertices`, except the boundary, is 0).
  std::optional<std::int64_t> genus;
  std::vector<std::size_t> triangles_per_vertex;  ///< [n]: used vertices of n triangles
  std::optional<StripsInFile> strips;             ///< if the file has any

  /// Whether every operation is possible everywhere on the mesh, apart from its own preconditions.
  [[nodiscard]] bool manifold() const noexcept { return genus.has_value(); }
};

/// Sorts the edges; about 60 bytes of memory per triangle.
[[nodiscard]] MeshReport report_on(const Soup& soup);

/// As a table, and as a JSON object. `mended`: what was changed before.
[[nodiscard]] std::string as_text(const MeshReport& report, const std::string& name, const Mended& mended = {});
[[nodiscard]] nlohmann::ordered_json as_json(const MeshReport& report, const Mended& mended = {});

}  // namespace restrip::tools
