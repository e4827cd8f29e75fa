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
//
// And in glTF files: MANYFOLD_mesh_progressive, a proposal (KhronosGroup/glTF, pull request 2464). The
// base is a mesh that every viewer draws; a record of each vertex split follows at the end of the buffer: v_s, v_l,
// v_r, and a displacement d. The split adds v_t at v_s + d and moves v_s to v_s - d, and adds the triangles (v_s, v_t,
// v_l) and (v_t, v_s, v_r).
//
// The proposal leaves open on which side v_l lies, and which triangles refer to v_t instead of v_s after the split. Its
// two new triangles allow one answer: with counter-clockwise triangles, v_l lies to the left of v_s -> v_t, and the
// triangles counter-clockwise around v_s from v_r to v_l get v_t. Otherwise an edge would have both triangles on one
// side. Record uses the same convention.
//
// Only positions are read and written, and only splits with both v_l and v_r: the proposal has no other records.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lod/progressive_mesh.hpp"
#include "meshes/mesh_file.hpp"

namespace restrip::tools {

/// Of the first two formats. Throws BadInput if the bytes have another format, are truncated, or name vertices that do
/// not exist yet.
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

/// A .glb whose vertices are numbered in order of appearance. Throws BadInput if the mesh has no splits, or if a split
/// is not possible or at a boundary.
[[nodiscard]] std::string progressive_glb_bytes(const ProgressiveMesh& mesh);

/// Empty if no mesh or primitive of the file has the extension. Every vertex has its position in the finest mesh,
/// rounded to 32 bits. Throws BadInput if the file is damaged, has other attributes in its records, or draws anything
/// but one base.
[[nodiscard]] std::optional<ProgressiveMesh> parse_progressive_gltf(std::string_view bytes, const std::string& name,
                                                                    const ReadSibling& sibling);

}  // namespace restrip::tools
