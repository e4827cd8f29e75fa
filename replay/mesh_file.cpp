#include "mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <iterator>

#include "bad_input.hpp"
#include "soup_builder.hpp"
#include "whole_file.hpp"

namespace restrip::replay {
namespace {

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

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
  const std::string extension = extension_of(file);
  const auto reader = extension == ".obj"   ? read_obj
                      : extension == ".off" ? read_off
                      : extension == ".ply" ? read_ply
                      : extension == ".stl" ? read_stl
                                            : nullptr;
  const std::string bytes = read_whole_file(file);
  if (reader == nullptr)
    throw BadInput(fmt::format("{}: unknown extension '{}'; meshes are read from .obj, .off, .ply and .stl",
                               file.string(), extension));
  if (bytes.empty()) throw BadInput(fmt::format("{}: the file is empty", file.string()));
  return reader(bytes, file.string());
}

void write_mesh(const std::filesystem::path& file, const Soup& soup) {
  const std::string extension = extension_of(file);
  if (extension == ".obj")
    write_whole_file(file, obj_of(soup));
  else if (extension == ".off")
    write_whole_file(file, off_of(soup));
  else if (extension == ".ply")
    write_whole_file(file, ply_of(soup));
  else
    throw BadInput(
        fmt::format("{}: unknown extension '{}'; meshes are written as .obj, .off or .ply", file.string(), extension));
}

}  // namespace restrip::replay
