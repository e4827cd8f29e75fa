#include "meshes/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "common/bad_input.hpp"
#include "files/reading.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/write_obj.hpp"
#include "meshes/write_ply.hpp"

namespace restrip::tools {
namespace {

std::string off_of(const Soup& soup) {
  std::string text = fmt::format("OFF\n{} {} 0\n", soup.points.size(), soup.triangles.size());
  auto out = std::back_inserter(text);
  for (const Point& p : soup.points) fmt::format_to(out, "{} {} {}\n", p.x, p.y, p.z);
  for (const Corners& t : soup.triangles) fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

/// The attribute bytes and the normal are zero: programs compute normals from the corners.
std::string stl_of(const Soup& soup) {
  std::string bytes(80, ' ');
  bytes.reserve(84 + 50 * soup.triangles.size());
  put(bytes, static_cast<std::uint32_t>(soup.triangles.size()));
  for (const Corners& t : soup.triangles) {
    bytes.append(12, '\0');
    for (const std::uint32_t corner : t) put(bytes, soup.points[corner]);
    bytes.append(2, '\0');
  }
  return bytes;
}

using Reader =
    std::function<Soup(std::string_view bytes, const std::filesystem::path& file, ReadAttributes attributes)>;

struct ReadFormat {
  const char* extension;
  Reader read;
};

const std::vector<ReadFormat>& read_formats() {
  const auto with_attributes = [](Soup (*read)(std::string_view, const std::string&, ReadAttributes)) -> Reader {
    return [read](std::string_view bytes, const std::filesystem::path& file, ReadAttributes attributes) {
      return read(bytes, file.string(), attributes);
    };
  };
  const auto alone = [](Soup (*read)(std::string_view, const std::string&)) -> Reader {
    return [read](std::string_view bytes, const std::filesystem::path& file, ReadAttributes /*attributes*/) {
      return read(bytes, file.string());
    };
  };
  const Reader gltf = [](std::string_view bytes, const std::filesystem::path& file, ReadAttributes attributes) {
    const auto beside = [&file](const std::string& buffer) { return files::read_whole(file.parent_path() / buffer); };
    return read_gltf(bytes, file.string(), beside, attributes);
  };
  static const std::vector<ReadFormat> formats{
      {".obj", with_attributes(read_obj)}, {".off", alone(read_off)}, {".ply", with_attributes(read_ply)},
      {".stl", alone(read_stl)},           {".gltf", gltf},           {".glb", gltf}};
  return formats;
}

}  // namespace

std::vector<std::string> read_mesh_extensions() {
  std::vector<std::string> extensions;
  for (const ReadFormat& format : read_formats()) extensions.emplace_back(format.extension);
  return extensions;
}

Soup read_mesh(const std::filesystem::path& file, ReadAttributes attributes) {
  const std::string extension = files::extension_of(file);
  const auto& formats = read_formats();
  const auto format = std::find_if(formats.begin(), formats.end(),
                                   [&](const ReadFormat& candidate) { return candidate.extension == extension; });
  const auto refuse_extension = [&] {
    throw BadInput(fmt::format("{}: unknown extension '{}'; meshes are read from {}", file.string(), extension,
                               fmt::join(read_mesh_extensions(), ", ")));
  };
  std::error_code error;
  const auto kind = std::filesystem::status(file, error).type();
  const bool there = kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::directory;
  if (format == formats.end() && there) refuse_extension();  // before it is read, as it may never end
  const std::string bytes = files::read_whole(file);
  if (format == formats.end()) refuse_extension();
  if (bytes.empty()) throw BadInput(fmt::format("{}: the file is empty", file.string()));
  return format->read(bytes, file, attributes);
}

std::vector<std::string> written_mesh_extensions() { return {".obj", ".off", ".ply", ".stl"}; }

std::string mesh_bytes(const Soup& soup, const std::string& extension) {
  if (extension == ".obj") return obj_bytes(soup);
  if (extension == ".off") return off_of(soup);
  if (extension == ".ply") return ply_bytes(soup);
  if (extension == ".stl") return stl_of(soup);
  throw BadInput(fmt::format("unknown extension '{}'; meshes are written as {}", extension,
                             fmt::join(written_mesh_extensions(), ", ")));
}

bool holds_attribute(const std::string& extension, const Attribute& attribute) {
  if (extension == ".glb") return true;
  const std::string& name = attribute.name;
  return (extension == ".obj" || extension == ".ply") &&
         (name == "NORMAL" || name == "TEXCOORD_0" || name == "COLOR_0");
}

}  // namespace restrip::tools
