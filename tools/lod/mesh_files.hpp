// Mesh files by their names: each is opened once, whatever is in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/named_file.hpp"
#include "common/output.hpp"
#include "lod/mesh_formats.hpp"
#include "meshes/mend.hpp"

namespace restrip::tools {

/// What is in the file, in the format that is named or, where none is, that the bytes are of. Throws BadInput.
[[nodiscard]] ReadMesh read_mesh_file(const NamedFile& file, ReadAttributes attributes = ReadAttributes::no);
/// The mesh in the file: of a progressive or a baked one the finest level.
[[nodiscard]] Soup read_mesh(const NamedFile& file, ReadAttributes attributes = ReadAttributes::no);
/// Reads a mesh, and mends it. Every program that takes a mesh reads it here.
[[nodiscard]] Soup read_mesh(const NamedFile& file, const MendingOptions& options, Mended& mended,
                             ReadAttributes attributes = ReadAttributes::no);

/// Tests an output before the work. Throws BadInput where its name has an extension of another format.
[[nodiscard]] files::Output open_output(const NamedFile& file, const std::vector<std::string>& extensions);

/// The format that a file is to be written in: that which is named or, where none is, `usual`. Throws BadInput when
/// that cannot do it.
[[nodiscard]] const MeshFormat& format_to_write(const NamedFile& file, FormatCan can, std::string_view usual = "");

/// What the format does not hold: attributes, which are left out, and the digits of coordinates.
void note_losses(const Soup& soup, const MeshFormat& format, Mended& mended);

}  // namespace restrip::tools
