#include "lod/mesh_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <system_error>
#include <utility>

#include "common/bad_input.hpp"
#include "files/reading.hpp"

namespace restrip::tools {

ReadMesh read_mesh_file(const std::filesystem::path& file, ReadAttributes attributes) {
  const std::string extension = files::extension_of(file);
  const auto beside = [&file](const std::string& buffer) { return files::read_whole(file.parent_path() / buffer); };
  std::error_code error;
  const auto kind = std::filesystem::status(file, error).type();
  const bool there = kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::directory;
  const MeshFormat* format = format_named(extension);
  const bool readable = format != nullptr && reads(*format);
  // What cannot be understood is not read, as it may never end.
  const std::string bytes = there && !readable ? "" : files::read_whole(file);
  return parse_mesh(bytes, extension, file.string(), beside, attributes);
}

Soup read_mesh(const std::filesystem::path& file, ReadAttributes attributes) {
  return finest_level(read_mesh_file(file, attributes), file.string());
}

Soup read_mesh(const std::filesystem::path& file, const MendingOptions& options, Mended& mended,
               ReadAttributes attributes) {
  Soup soup = read_mesh(file, attributes);
  mended = mend(soup, file.string(), options);
  return soup;
}

const MeshFormat& format_to_write(const std::filesystem::path& file, FormatCan can, std::string_view usual) {
  const std::string extension = files::extension_of(file);
  const MeshFormat* format = format_named(extension.empty() ? usual : extension);
  if (format == nullptr || !can(*format))
    throw BadInput(fmt::format("{}: has no extension that names a format; name a file that ends in {}", file.string(),
                               fmt::join(extensions_of(can), ", ")));
  return *format;
}

void leave_out_attributes(const Soup& soup, const MeshFormat& format, Mended& mended) {
  for (const Attribute& attribute : soup.attributes)
    if (!format.holds(attribute)) note(mended.left_out_attributes, attribute.name);
}

}  // namespace restrip::tools
