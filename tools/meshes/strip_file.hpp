// Strips as a file: PLY with a `tristrips` element, binary glTF, OBJ, or the bare index buffer.
//
//   .ply  binary; one list of indices, -1 between strips, as Stanford's scans have it (Cyberware's `tristrips`)
//   .glb  glTF 2.0; indices of 16 bits where they suffice, else of 32; GltfPrimitives says in which primitives
//   .obj  the triangles in the order of the strips: OBJ knows no strips
//   .bin  the indices alone, 32 bits each, little-endian, 0xFFFFFFFF between strips
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

enum class GltfPrimitives {
  strips,   ///< a primitive for each strip: plain glTF 2.0; each takes some 140 bytes of JSON
  list,     ///< one list of triangles: plain glTF 2.0
  restart,  ///< one primitive for all strips; needs a viewer that knows KHR_mesh_primitive_restart (a draft of 2026)
};

/// An index buffer of strips and what it draws.
struct StripFile {
  std::span<const Point> points;
  std::span<const std::uint32_t> indices;  ///< restart_index between strips
  std::span<const Corners> triangles;      ///< the same, drawn, in order
  /// Attributes of the points. A format holds those of which MeshFormat::holds() (lod/mesh_formats.hpp) says so.
  std::span<const Attribute> attributes = {};
};

/// The bare indices, as .bin has them.
[[nodiscard]] std::string index_bytes(std::span<const std::uint32_t> indices);

/// A sentence with a line feed about the extensions that a viewer must know to open the file of this name; empty when
/// there are none.
[[nodiscard]] std::string as_text(const std::vector<std::string>& required_extensions, const std::string& name);

}  // namespace restrip::tools
