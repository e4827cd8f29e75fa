// Binary glTF 2.0, written by hand: points, attributes and one kind of primitives.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "meshes/strip_file.hpp"

namespace restrip::tools {

/// Required where a strip follows another one in a primitive.
inline constexpr std::string_view restart_extension = "KHR_mesh_primitive_restart";

/// Does a strip follow another one in a primitive?
[[nodiscard]] bool restarts(const IndexBuffer& buffer);

/// Something more that is known of the mesh, which viewers may leave unknown: bytes in a buffer view of their own. In
/// the mesh it is `"extensions": {name: {"bufferView": number}}`.
struct GlbExtension {
  std::string_view name;  ///< empty: none exists
  std::string_view bytes;
};

/// A GLB of these two chunks. Throws BadInput where they are too large.
[[nodiscard]] std::string glb_of_chunks(std::string json, std::string binary);
/// The least and the greatest coordinates, as an accessor says them.
[[nodiscard]] std::string bounds_of(std::span<const Point> points);

/// Throws BadInput where a GLB cannot hold the mesh.
[[nodiscard]] std::string glb_bytes(const StripFile& file, const GlbExtension& extension = {});

}  // namespace restrip::tools
