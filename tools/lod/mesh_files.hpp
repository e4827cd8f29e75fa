// Reads and writes mesh files by name. Each file is opened once, whatever its format.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/named_file.hpp"
#include "common/output.hpp"
#include "lod/mesh_formats.hpp"
#include "meshes/mend.hpp"

namespace restrip::tools {

/// Reads the file in the named format or, if none is named, in the format detected from the bytes. Throws BadInput.
[[nodiscard]] ReadMesh read_mesh_file(const NamedFile& file, ReadAttributes attributes = ReadAttributes::no);
/// The mesh in the file; for a progressive or baked one its finest level.
[[nodiscard]] Soup read_mesh(const NamedFile& file, ReadAttributes attributes = ReadAttributes::no);
/// Reads a mesh and mends it. Every program that takes a mesh reads it here.
[[nodiscard]] Soup read_mesh(const NamedFile& file, const MendingOptions& options, Mended& mended,
                             ReadAttributes attributes = ReadAttributes::no);

/// Tests whether the output can be written, before the work. Throws BadInput if its name has an extension of another
/// format.
[[nodiscard]] files::Output open_output(const NamedFile& file, const std::vector<std::string>& extensions);

/// The output format: the named one or, if none is named, `usual`. Throws BadInput if that format does not support it.
[[nodiscard]] const MeshFormat& format_to_write(const NamedFile& file, FormatCan can, std::string_view usual = "");

/// Notes what the format does not hold: attributes that are left out, and digits of coordinates.
void note_losses(const Soup& soup, const MeshFormat& format, Mended& mended);

}  // namespace restrip::tools
