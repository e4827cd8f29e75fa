#include "meshes/strip_file.hpp"

#include <fmt/format.h>

#include <limits>

#include "common/bad_input.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/write_glb.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t most_values = std::numeric_limits<std::int32_t>::max();

std::string bare_indices(const StripFile& file) {
  std::string bytes;
  bytes.reserve(4 * file.indices.size());
  for (const std::uint32_t index : file.indices) put(bytes, index);
  return bytes;
}

std::string ply_with_strips(const StripFile& file) {
  if (file.indices.size() > most_values || file.points.size() > most_values)
    throw BadInput(fmt::format("a PLY list holds {} indices at most; write .bin", most_values));
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n",
      file.points.size());
  bytes.reserve(bytes.size() + 12 * file.points.size() + 4 * (1 + file.indices.size()));
  for (const Point& p : file.points) put(bytes, p);
  put(bytes, static_cast<std::uint32_t>(file.indices.size()));
  static_assert(restart_index == static_cast<std::uint32_t>(-1));
  return bytes + bare_indices(file);
}

std::string obj_in_order(const StripFile& file) {
  Soup soup;
  soup.points.assign(file.points.begin(), file.points.end());
  soup.triangles.assign(file.triangles.begin(), file.triangles.end());
  return mesh_bytes(soup, ".obj");
}

}  // namespace

std::vector<std::string> written_strip_extensions() { return {".ply", ".glb", ".obj", ".bin"}; }

bool holds_attributes(const std::string& extension) { return extension == ".glb"; }

std::string strip_bytes(const StripFile& file, const std::string& extension, GltfPrimitives primitives) {
  if (extension == ".ply") return ply_with_strips(file);
  if (extension == ".glb") return glb_bytes(file, primitives);
  if (extension == ".obj") return obj_in_order(file);
  if (extension == ".bin") return bare_indices(file);
  throw BadInput(fmt::format("unknown extension '{}'; strips are written as {}", extension,
                             fmt::join(written_strip_extensions(), ", ")));
}

}  // namespace restrip::tools
