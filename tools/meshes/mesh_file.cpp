#include "meshes/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>

#include "common/bad_input.hpp"
#include "files/reading.hpp"
#include "meshes/soup_builder.hpp"

namespace restrip::tools {
namespace {

std::string obj_of(const Soup& soup) {
  std::string text;
  auto out = std::back_inserter(text);
  for (const Point& p : soup.points) fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
  for (const Corners& t : soup.triangles) fmt::format_to(out, "f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string off_of(const Soup& soup) {
  std::string text = fmt::format("OFF\n{} {} 0\n", soup.points.size(), soup.triangles.size());
  auto out = std::back_inserter(text);
  for (const Point& p : soup.points) fmt::format_to(out, "{} {} {}\n", p.x, p.y, p.z);
  for (const Corners& t : soup.triangles) fmt::format_to(out, "3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

std::string ply_of(const Soup& soup) {
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
      soup.points.size(), soup.triangles.size());
  bytes.reserve(bytes.size() + 12 * soup.points.size() + 13 * soup.triangles.size());
  const auto put = [&bytes](std::uint32_t value) {
    for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
  };
  for (const Point& p : soup.points)
    for (const float coordinate : {p.x, p.y, p.z}) put(std::bit_cast<std::uint32_t>(coordinate));
  for (const Corners& t : soup.triangles) {
    bytes.push_back(3);
    for (const std::uint32_t corner : t) put(corner);
  }
  return bytes;
}

}  // namespace

Soup read_mesh(const std::filesystem::path& file) {
  const std::string extension = files::extension_of(file);
  const auto reader = extension == ".obj"   ? read_obj
                      : extension == ".off" ? read_off
                      : extension == ".ply" ? read_ply
                      : extension == ".stl" ? read_stl
                                            : nullptr;
  const auto refuse_extension = [&] {
    throw BadInput(fmt::format("{}: unknown extension '{}'; meshes are read from .obj, .off, .ply and .stl",
                               file.string(), extension));
  };
  std::error_code error;
  const auto kind = std::filesystem::status(file, error).type();
  const bool there = kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::directory;
  if (reader == nullptr && there) refuse_extension();  // before it is read, as it may never end
  const std::string bytes = files::read_whole(file);
  if (reader == nullptr) refuse_extension();
  if (bytes.empty()) throw BadInput(fmt::format("{}: the file is empty", file.string()));
  return reader(bytes, file.string());
}

std::vector<std::string> written_mesh_extensions() { return {".obj", ".off", ".ply"}; }

std::string mesh_bytes(const Soup& soup, const std::string& extension) {
  if (extension == ".obj") return obj_of(soup);
  if (extension == ".off") return off_of(soup);
  if (extension == ".ply") return ply_of(soup);
  throw BadInput(fmt::format("unknown extension '{}'; meshes are written as {}", extension,
                             fmt::join(written_mesh_extensions(), ", ")));
}

}  // namespace restrip::tools
