// Writers of mesh files, and what their readers (read_NAME.cpp) share. lod/mesh_formats.cpp has the table of formats.
//
// OpenMesh's readers (version 9) are not used because they lose faces silently: its OBJ reader drops repeated corners
// and vertices that it cannot parse, so that all later indices shift; its mesh refuses faces at non-manifold places;
// its OFF reader does not accept leading comments; and a corrupt face count makes it allocate until the process ends.
// The readers here read a file unchanged or refuse it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Returns the bytes of a file in the same folder as the file that names it. Throws if it cannot be read.
using ReadSibling = std::function<std::string(const std::string& file_name)>;

/// Whether to read vertex attributes: all of them in glTF; normals, texture coordinates and colours in OBJ and PLY.
/// Everything else is listed in Soup::left_out.
enum class ReadAttributes { no, yes };

/// Compares the size with the count of facets in the file.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);
/// Reads buffers in other files through `sibling`. `name` is for messages.
[[nodiscard]] Soup read_gltf(std::string_view bytes, const std::string& name, const ReadSibling& sibling,
                             ReadAttributes attributes = ReadAttributes::no);

/// Wavefront OBJ: `v`, followed by colours in the usual extension, `vt`, `vn` and `f`. Numbers read back exactly;
/// colours range from 0 to 1. Vertices at one position that differ only in normals or texture coordinates share a `v`,
/// so that other programs see a connected surface. Identical vertices do not share one. OBJ counts the second texture
/// coordinate from below, glTF and Soup from above, so it is inverted.
[[nodiscard]] std::string obj_bytes(const Soup& soup);
/// PLY, binary little-endian: vertices with nx ny nz, s t, red green blue alpha if present, and faces. Colours keep
/// their encoding. PLY counts t from below, glTF and Soup from above, so it is inverted, which may change it by 2^-25.
/// Coordinates have 64 bits if the input file had them or if rounding to 32 matters (rounding_of()), otherwise 32.
[[nodiscard]] std::string ply_bytes(const Soup& soup);
/// The same with strips as in Stanford's scans (Cyberware's `tristrips`, -1 between strips). Throws BadInput if there
/// are more indices than a PLY list holds.
[[nodiscard]] std::string ply_bytes(std::span<const Point> points, bool is_64_bits,
                                    std::span<const Attribute> attributes, std::span<const std::uint32_t> strips);
/// OFF, as text.
[[nodiscard]] std::string off_bytes(const Soup& soup);
/// STL, binary.
[[nodiscard]] std::string stl_bytes(const Soup& soup);

}  // namespace restrip::tools
