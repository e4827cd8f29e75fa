// Baked meshes in glTF files: the base is an ordinary mesh, and all levels are in an extension that viewers may ignore.
// docs/reference/file-formats.md specifies the extension.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lod/bake.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/strip_file.hpp"

namespace restrip::tools {

/// A baked mesh, and the bytes that describe it (baked_file.hpp).
struct BakedBytes {
  std::string bytes;
  BakedMesh baked;
  std::vector<std::string> left_out_attributes = {};  ///< other attributes of the base in glTF
};

/// A .glb that draws the base as its strips and holds `baked`, the bytes of a baked mesh, in the extension. The
/// vertices are the vertices of the base, in the same order. The form is stitched unless the options name another.
/// Throws BadInput if the bytes are damaged or exceed what a GLB can hold.
[[nodiscard]] WrittenStrips baked_glb_bytes(std::string_view baked, const StripOptions& options);

/// Reads the extension of a glTF file; empty if no mesh has it. Throws BadInput if the file is damaged, if several
/// meshes have it, or if the file draws something other than the base. `name` is for messages.
[[nodiscard]] std::optional<BakedBytes> parse_baked_gltf(std::string_view bytes, const std::string& name,
                                                         const ReadSibling& sibling);

}  // namespace restrip::tools
