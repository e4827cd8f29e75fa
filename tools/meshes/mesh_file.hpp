// The readers of meshes, OBJ, OFF, PLY, STL and glTF, and the writers of the two simplest formats. Which format a file
// has, and what is written in which, is one table: lod/mesh_formats.hpp.
//
// The readers are our own. OpenMesh's (version 9) lose faces without a word: its OBJ reader drops repeated corners and
// vertices that it cannot parse, so that all later indices shift, its mesh refuses faces at non-manifold places, its
// OFF reader knows no leading comments, and a corrupt face count makes it allocate until the process ends. Here a file
// arrives as it is or is refused.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// The bytes of a file in the folder of the one that names it. Throws when it cannot be read.
using ReadBeside = std::function<std::string(const std::string& file_name)>;

/// Whether to carry what vertices have beside their places: all that is in glTF, and normals, texture coordinates and
/// colours of OBJ and PLY. Of what is not carried Soup::left_out_attributes says that there was some.
enum class ReadAttributes { no, yes };

/// The readers, one a format, on the bytes of a file. `name` is for messages.
[[nodiscard]] Soup read_obj(std::string_view bytes, const std::string& name,
                            ReadAttributes attributes = ReadAttributes::no);
[[nodiscard]] Soup read_off(std::string_view bytes, const std::string& name);
[[nodiscard]] Soup read_ply(std::string_view bytes, const std::string& name,
                            ReadAttributes attributes = ReadAttributes::no);
/// By its size, which its count of facets says.
[[nodiscard]] bool is_binary_stl(std::string_view bytes);
/// Corners at exactly the same place become one vertex (STL has no indices).
[[nodiscard]] Soup read_stl(std::string_view bytes, const std::string& name);
/// Buffers in files of their own are asked of `beside`.
[[nodiscard]] Soup read_gltf(std::string_view bytes, const std::string& name, const ReadBeside& beside,
                             ReadAttributes attributes = ReadAttributes::no);

/// OFF, as text.
[[nodiscard]] std::string off_bytes(const Soup& soup);
/// STL, binary.
[[nodiscard]] std::string stl_bytes(const Soup& soup);

}  // namespace restrip::tools
