// Progressive meshes in Hoppe's format, version 2 (the .pm files of his mesh-processing library): lines of text, then
// big-endian records. A face has wedges (a vertex with a normal, a colour, a texture coordinate) for corners; a split
// names a face, a vertex in it, and how far to turn from the left apex to the right one.
//
// Points and connectivity are read, and nothing else. Hoppe's vertices may move when they are split. Ours do not: each
// has the coordinates that it has in the finest mesh.
#pragma once

#include <string>
#include <string_view>

#include "lod/progressive_mesh.hpp"

namespace restrip::tools {

/// Comment lines, and then one that says PM.
[[nodiscard]] bool is_hoppe_pm(std::string_view bytes);
/// Throws BadInput where the bytes are damaged or of another version, and names the first record that is not a split of
/// a manifold (checks.hpp). Time linear in the valences of the vertices that are split.
[[nodiscard]] ProgressiveMesh parse_hoppe_pm(std::string_view bytes, const std::string& name);

}  // namespace restrip::tools
