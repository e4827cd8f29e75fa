// Binary glTF 2.0, written by hand: points, attributes and one kind of primitives (strip_file.hpp says which).
#pragma once

#include <string>

#include "meshes/strip_file.hpp"

namespace restrip::tools {

/// Throws BadInput where a GLB cannot hold the mesh. KHR_mesh_primitive_restart is required only where a strip follows
/// another one in a primitive.
[[nodiscard]] std::string glb_bytes(const StripFile& file, GltfPrimitives primitives);

}  // namespace restrip::tools
