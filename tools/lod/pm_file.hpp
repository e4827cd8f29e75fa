// Progressive meshes in OpenMesh's format: "ProgMesh"; uint32 vertices, faces, splits; three float a vertex; three
// uint32 a face; for each split three float (the new vertex), int32 v1, vl, vr. All little-endian. Vertices are
// numbered in the order of appearance. OpenMesh writes a split as v0 -> v1 with v0 new and vl to the left of v0 -> v1;
// as we look along v_s -> v_t = v1 -> v0, its vl is our v_r. -1 stands for a missing apex.
//
// And in Hoppe's format, version 2 (the .pm files of his mesh-processing library): lines of text, then big-endian
// records. A face has wedges (a vertex with a normal, a colour, a texture coordinate) for corners; a split names a
// face, a vertex in it, and how far to turn from the left apex to the right one. Only points and connectivity are read.
// Hoppe's vertices may move when they are split. Here each vertex has its coordinates in the finest mesh from the
// start.
#pragma once

#include <string>
#include <string_view>

#include "lod/progressive_mesh.hpp"

namespace restrip::tools {

/// Of either format. Throws BadInput if the bytes have another format, are truncated, or name vertices that do not
/// exist yet.
[[nodiscard]] ProgressiveMesh parse_pm(std::string_view bytes, const std::string& name);

/// Whether it is Hoppe's format: the file begins with comment lines and a line that says PM.
[[nodiscard]] bool is_hoppe_pm(std::string_view bytes);
/// Throws BadInput if the bytes are damaged or of another version; names the first record that is not a split of a
/// manifold (checks.hpp). Time is linear in the valences of the split vertices.
[[nodiscard]] ProgressiveMesh parse_hoppe_pm(std::string_view bytes, const std::string& name);

/// Renumbers the vertices in order of appearance: first the vertices of the base in the order of its triangles, then
/// the vertex that each split adds. Unused vertices are left out.
[[nodiscard]] ProgressiveMesh numbered_by_appearance(const ProgressiveMesh& mesh);

/// Renumbers the vertices in order of appearance and leaves out unused ones.
[[nodiscard]] std::string pm_bytes(const ProgressiveMesh& mesh);

}  // namespace restrip::tools
