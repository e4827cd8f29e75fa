// Baked meshes in glTF files: the base is an ordinary mesh, and all levels are an extension of it that viewers may
// leave unknown. docs/reference/file-formats.md has the extension.
#pragma once

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
  std::vector<std::string> left_out_attributes = {};  ///< what the vertices of its base have besides, in glTF
};

/// A .glb that draws the base as its strips and has `baked`, the bytes of a baked mesh, in the extension. The vertices
/// are those of the base, in their order. The form is stitched unless the options name another. Throws BadInput where
/// the bytes are damaged, or more than a GLB can hold.
[[nodiscard]] WrittenStrips baked_glb_bytes(std::string_view baked, const StripOptions& options);

/// What the extension of a glTF file has. Throws BadInput where the file is damaged, no mesh or more than one has the
/// extension, and where what the file draws is not the base. `name` is for messages.
[[nodiscard]] BakedBytes parse_baked_gltf(std::string_view bytes, const std::string& name, const ReadBeside& beside);

/// Whether the bytes are a glTF file of which a mesh has the extension. Throws BadInput where it is damaged.
[[nodiscard]] bool is_baked_gltf(std::string_view bytes, const std::string& name, const ReadBeside& beside);

}  // namespace restrip::tools
