// Mesh files: OBJ, OFF, PLY, STL and glTF in, OBJ, OFF, PLY and STL out (with strips, and as glTF: strip_file.hpp).
//
// The readers are our own. OpenMesh's (version 9) lose faces without a word: its OBJ reader drops repeated corners and
// vertices that it cannot parse, so that all later indices shift, its mesh refuses faces at non-manifold places, its
// OFF reader knows no leading comments, and a corrupt face count makes it allocate until the process ends. Here a file
// arrives as it is or is refused.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// The bytes of a file in the folder of the one that names it. Throws when it cannot be read.
using ReadBeside = std::function<std::string(const std::string& file_name)>;

/// Whether to carry what vertices have beside their places: all that is in glTF, and normals, texture coordinates and
/// colours of OBJ and PLY. Of what is not carried Soup::left_out_attributes says that there was some.
enum class ReadAttributes { no, yes };

/// The extensions of the formats that are read.
[[nodiscard]] std::vector<std::string> read_mesh_extensions();
/// Reads a mesh; the format is that of the file's extension, in any case. Throws BadInput.
[[nodiscard]] Soup read_mesh(const std::filesystem::path& file, ReadAttributes attributes = ReadAttributes::no);

/// The extensions of the formats in which meshes are written; PLY is binary.
[[nodiscard]] std::vector<std::string> written_mesh_extensions();
/// The bytes of a mesh file with this extension, in lower case. Throws BadInput when it is none of those.
[[nodiscard]] std::string mesh_bytes(const Soup& soup, const std::string& extension);
/// Whether a file with this extension, of a mesh or of strips (strip_file.hpp), has such an attribute.
[[nodiscard]] bool holds_attribute(const std::string& extension, const Attribute& attribute);

/// The readers, one a format, on the bytes of a file. `name` is for messages.
[[nodiscard]] Soup read_obj(std::string_view bytes, const std::string& name,
                            ReadAttributes attributes = ReadAttributes::no);
[[nodiscard]] Soup read_off(std::string_view bytes, const std::string& name);
[[nodiscard]] Soup read_ply(std::string_view bytes, const std::string& name,
                            ReadAttributes attributes = ReadAttributes::no);
/// Corners at exactly the same place become one vertex (STL has no indices).
[[nodiscard]] Soup read_stl(std::string_view bytes, const std::string& name);
/// Buffers in files of their own are asked of `beside`.
[[nodiscard]] Soup read_gltf(std::string_view bytes, const std::string& name, const ReadBeside& beside,
                             ReadAttributes attributes = ReadAttributes::no);

}  // namespace restrip::tools
