// Progressive meshes in glTF files: MANYFOLD_mesh_progressive, a proposal (KhronosGroup/glTF, pull request 2464). The
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

inline constexpr std::string_view progressive_extension = "MANYFOLD_mesh_progressive";

/// A .glb whose vertices are numbered in order of appearance. Throws BadInput if the mesh has no splits, or if a split
/// is not possible or at a boundary.
[[nodiscard]] std::string progressive_glb_bytes(const ProgressiveMesh& mesh);

/// Empty if no mesh or primitive of the file has the extension. Every vertex has its position in the finest mesh,
/// rounded to 32 bits. Throws BadInput if the file is damaged, has other attributes in its records, or draws anything
/// but one base.
[[nodiscard]] std::optional<ProgressiveMesh> parse_progressive_gltf(std::string_view bytes, const std::string& name,
                                                                    const ReadSibling& sibling);

}  // namespace restrip::tools
