// Progressive meshes in Hoppe's format, version 2 (the .pm files of his mesh-processing library): lines of text, then
// big-endian records. A face has wedges (a vertex with a normal, a colour, a texture coordinate) for corners; a split
// names a face, a vertex in it, and how far to turn from the left apex to the right one.
//
// Only points and connectivity are read. Hoppe's vertices may move when they are split. Here each vertex has its
// coordinates in the finest mesh from the start.
#pragma once

#include <string>
#include <string_view>

#include "lod/progressive_mesh.hpp"

namespace restrip::tools {

/// Whether the file begins with comment lines and a line that says PM.
[[nodiscard]] bool is_hoppe_pm(std::string_view bytes);
/// Throws BadInput if the bytes are damaged or of another version; names the first record that is not a split of a
/// manifold (checks.hpp). Time is linear in the valences of the split vertices.
[[nodiscard]] ProgressiveMesh parse_hoppe_pm(std::string_view bytes, const std::string& name);

}  // namespace restrip::tools
