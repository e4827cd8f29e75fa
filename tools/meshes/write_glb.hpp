// Writes binary glTF 2.0 directly: points, attributes and one kind of primitives.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "meshes/strip_file.hpp"

namespace restrip::tools {

/// Required if a primitive contains several strips.
inline constexpr std::string_view restart_extension = "KHR_mesh_primitive_restart";

/// Whether a primitive contains several strips.
[[nodiscard]] bool restarts(const IndexBuffer& buffer);

/// Further data about the mesh, which viewers may ignore: bytes in a separate buffer view. The mesh has `"extensions":
/// {name: {"bufferView": number}}`.
struct GlbExtension {
  std::string_view name;  ///< empty: no extension
  std::string_view bytes;
};

/// A GLB of these two chunks. Throws BadInput if they are too large.
[[nodiscard]] std::string glb_of_chunks(std::string json, std::string binary);
/// The least and the greatest coordinates, in the form of an accessor.
[[nodiscard]] std::string bounds_of(std::span<const Point> points);

/// Throws BadInput if a GLB cannot hold the mesh.
[[nodiscard]] std::string glb_bytes(const StripFile& file, const GlbExtension& extension = {});

}  // namespace restrip::tools
