#include "lod/mesh_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <system_error>

namespace restrip::tools {

ReadMesh read_mesh_file(const NamedFile& file, ReadAttributes attributes) {
  const std::string extension = file.extension();
  const auto sibling = [&file](const std::string& buffer) {
    return files::read_whole(file.path.parent_path() / buffer);
  };
  std::error_code error;
  const auto kind = std::filesystem::status(file.path, error).type();
  const bool there = kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::directory;
  const MeshFormat* format = format_named(extension);
  const bool readable = extension.empty() || (format != nullptr && reads(*format));
  // An unknown format is not read, since the input may be endless.
  const std::string bytes = there && !readable ? "" : files::read_whole(file.path);
  return parse_mesh(bytes, extension, file.string(), sibling, attributes);
}

Soup read_mesh(const NamedFile& file, ReadAttributes attributes) {
  return finest_level(read_mesh_file(file, attributes));
}

files::Output open_output(const NamedFile& file, const std::vector<std::string>& extensions) {
  if (file.format.empty()) return files::Output(file.path, {extensions});
  const bool has_extension = !files::extension_of(file.path).empty();
  return files::Output(file.path, {has_extension ? std::vector{file.extension()} : std::vector<std::string>()});
}

const MeshFormat& format_to_write(const NamedFile& file, FormatCan can, std::string_view usual) {
  const std::string extension = file.extension();
  const MeshFormat* format = format_named(extension.empty() ? usual : extension);
  if (format == nullptr || !can(*format))
    throw BadInput(fmt::format("{}: its format is not known; name it by --to, or a file that ends in {}", file.string(),
                               fmt::join(extensions_of(can), ", ")));
  return *format;
}

void leave_out_losses(Soup& soup, const MeshFormat& format, Mended& mended) {
  if (format.rounds) mended.rounding = rounding_of(soup.points);
  std::erase_if(soup.attributes, [&](const Attribute& attribute) {
    const bool lost = !format.holds(attribute);
    if (lost) note(mended.left_out, attribute.name);
    return lost;
  });
  if (format.attributes != MeshFormat::Attributes::all) return;
  for (const std::string& removed : remove_invalid(soup.attributes)) note(mended.left_out, removed);
}

}  // namespace restrip::tools
