// Baked progressive meshes as files, and in glTF files: there the base is an ordinary mesh, and all levels are in an
// extension that viewers may ignore. docs/reference/file-formats.md specifies the format and the extension: compact,
// versioned, with a checksum over every byte.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/baked_format.hpp"
#include "lod/bake.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/strip_file.hpp"

namespace restrip::tools {

/// Throws BadInput if the bytes have another format or version, are truncated or altered, or describe splits or colours
/// that no mesh can have. Plays all records once.
[[nodiscard]] BakedMesh parse_baked(std::string_view bytes, const std::string& name);

/// Renumbers the vertices in order of appearance, as pm_bytes does.
[[nodiscard]] std::string baked_bytes(const BakedMesh& baked);

/// baked_format::fnv1a of characters.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view bytes) noexcept {
  return baked_format::fnv1a(std::span<const char>(bytes));
}

/// A baked mesh, and the bytes that describe it.
struct BakedBytes {
  std::string bytes;
  BakedMesh baked;
  std::vector<std::string> left_out = {};  ///< as Soup::left_out
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
