// Progressive meshes in glTF files: MANYFOLD_mesh_progressive, a proposal (KhronosGroup/glTF, pull request 2464). The
// base is a mesh that every viewer draws; a record of each vertex split follows at the end of the buffer: v_s, v_l,
// v_r, and a displacement d. The split adds v_t at v_s + d and moves v_s to v_s - d, and adds the triangles (v_s, v_t,
// v_l) and (v_t, v_s, v_r).
//
// The proposal leaves open on which side v_l lies, and which triangles have v_t in place of v_s afterwards. Its two
// triangles leave one answer: v_l lies to the left of v_s -> v_t where triangles run counter-clockwise, and the
// triangles counter-clockwise around v_s from v_r to v_l get v_t. Otherwise an edge would have both triangles on one
// side. That is how Record has it.
//
// Only positions are read and written, and only splits with both v_l and v_r: the proposal has no other record.
#pragma once

#include <string>
#include <string_view>

#include "lod/progressive_mesh.hpp"
#include "meshes/mesh_file.hpp"

namespace restrip::tools {

inline constexpr std::string_view progressive_extension = "MANYFOLD_mesh_progressive";

/// A .glb whose vertices are numbered in order of appearance. Throws BadInput where a split is not possible or at a
/// boundary, and where none exists.
[[nodiscard]] std::string progressive_glb_bytes(const ProgressiveMesh& mesh);

/// Every vertex has the place that it has in the finest mesh, rounded to 32 bits. Throws BadInput where the file is
/// damaged, has other attributes in its records, or draws something else than one base.
[[nodiscard]] ProgressiveMesh parse_progressive_gltf(std::string_view bytes, const std::string& name,
                                                     const ReadBeside& beside);

/// Whether a mesh or primitive of the file has the extension. Throws BadInput where it is damaged.
[[nodiscard]] bool is_progressive_gltf(std::string_view bytes, const std::string& name, const ReadBeside& beside);

}  // namespace restrip::tools
