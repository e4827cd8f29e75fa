// Progressive meshes in OpenMesh's format: "ProgMesh"; uint32 vertices, faces, splits; three float a vertex; three
// uint32 a face; for each split three float (the new vertex), int32 v1, vl, vr. All little-endian. Vertices are
// numbered in the order of appearance. OpenMesh writes a split as v0 -> v1 with v0 new and vl to the left of v0 -> v1;
// as we look along v_s -> v_t = v1 -> v0, its vl is our v_r. -1 stands for a missing apex.
#pragma once

#include <string>
#include <string_view>

#include "lod/progressive_mesh.hpp"

namespace restrip::tools {

/// Throws BadInput if the bytes have another format, are truncated, or name vertices that do not exist yet. Hoppe's
/// format is read as well (hoppe_pm_file.hpp).
[[nodiscard]] ProgressiveMesh parse_pm(std::string_view bytes, const std::string& name);

/// Renumbers the vertices in order of appearance: first the vertices of the base in the order of its triangles, then
/// the vertex that each split adds. Unused vertices are left out.
[[nodiscard]] ProgressiveMesh numbered_by_appearance(const ProgressiveMesh& mesh);

/// Renumbers the vertices in order of appearance and leaves out unused ones.
[[nodiscard]] std::string pm_bytes(const ProgressiveMesh& mesh);

}  // namespace restrip::tools
