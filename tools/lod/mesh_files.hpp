// Mesh files by their names: each is opened once, whatever is in it.
#pragma once

#include <filesystem>
#include <string_view>

#include "lod/mesh_formats.hpp"
#include "meshes/mend.hpp"

namespace restrip::tools {

/// What is in the file, in the format of its extension, in any case. Throws BadInput.
[[nodiscard]] ReadMesh read_mesh_file(const std::filesystem::path& file,
                                      ReadAttributes attributes = ReadAttributes::no);
/// The mesh in the file: of a progressive or a baked one the finest level.
[[nodiscard]] Soup read_mesh(const std::filesystem::path& file, ReadAttributes attributes = ReadAttributes::no);
/// Reads a mesh, and mends it. Every program that takes a mesh reads it here.
[[nodiscard]] Soup read_mesh(const std::filesystem::path& file, const MendingOptions& options, Mended& mended,
                             ReadAttributes attributes = ReadAttributes::no);

/// The format that a file is to be written in: that of its extension or, where it has none, as a device, that of
/// `usual`. Throws BadInput when that can not do it.
[[nodiscard]] const MeshFormat& format_to_write(const std::filesystem::path& file, FormatCan can,
                                                std::string_view usual = "");

/// The attributes of the soup that the format does not hold are left out as well.
void leave_out_attributes(const Soup& soup, const MeshFormat& format, Mended& mended);

}  // namespace restrip::tools
