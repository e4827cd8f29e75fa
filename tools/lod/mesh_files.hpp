// Reads and writes mesh files by name. Each file is opened once, whatever its format.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/output.hpp"
#include "common/reading.hpp"
#include "lod/mesh_formats.hpp"
#include "meshes/mend.hpp"

namespace restrip::tools {

/// A file named on the command line, and its format if the name does not show it: a pipe has no extension.
struct NamedFile {
  std::filesystem::path path;  ///< `-`: standard input, or output
  std::string format;          ///< an extension without the dot; empty: from the name

  NamedFile() = default;
  NamedFile(std::filesystem::path file, std::string as = {}) : path(std::move(file)), format(std::move(as)) {}

  [[nodiscard]] bool empty() const { return path.empty(); }
  /// For messages.
  [[nodiscard]] std::string string() const { return path.string(); }
  /// The extension of the format, in lower case with its dot; empty if unknown.
  [[nodiscard]] std::string extension() const { return format.empty() ? files::extension_of(path) : "." + format; }
};

/// Reads the file in the named format or, if none is named, in the format detected from the bytes. Throws BadInput.
[[nodiscard]] ReadMesh read_mesh_file(const NamedFile& file, ReadAttributes attributes = ReadAttributes::no);
/// The mesh in the file; for a progressive or baked one its finest level.
[[nodiscard]] Soup read_mesh(const NamedFile& file, ReadAttributes attributes = ReadAttributes::no);

/// Tests whether the output can be written, before the work. Throws BadInput if its name has an extension of another
/// format.
[[nodiscard]] files::Output open_output(const NamedFile& file, const std::vector<std::string>& extensions);

/// The output format: the named one or, if none is named, `usual`. Throws BadInput if that format does not support it.
[[nodiscard]] const MeshFormat& format_to_write(const NamedFile& file, FormatCan can, std::string_view usual = "");

/// Leaves out, and notes, the attributes that the format does not hold or forbids; notes digits of coordinates.
void leave_out_losses(Soup& soup, const MeshFormat& format, Mended& mended);

}  // namespace restrip::tools
