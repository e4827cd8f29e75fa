#include "meshes/strip_file.hpp"

#include <fmt/format.h>

#include "common/bad_input.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/write_glb.hpp"
#include "meshes/write_obj.hpp"
#include "meshes/write_ply.hpp"

namespace restrip::tools {
namespace {

std::string bare_indices(const StripFile& file) {
  std::string bytes;
  bytes.reserve(4 * file.indices.size());
  for (const std::uint32_t index : file.indices) put(bytes, index);
  return bytes;
}

std::string obj_in_order(const StripFile& file) {
  Soup soup;
  soup.points.assign(file.points.begin(), file.points.end());
  soup.triangles.assign(file.triangles.begin(), file.triangles.end());
  soup.attributes.assign(file.attributes.begin(), file.attributes.end());
  return obj_bytes(soup);
}

}  // namespace

std::vector<std::string> written_strip_extensions() { return {".ply", ".glb", ".obj", ".bin"}; }

std::string strip_bytes(const StripFile& file, const std::string& extension, GltfPrimitives primitives) {
  if (extension == ".ply") return ply_bytes(file.points, file.attributes, file.indices);
  if (extension == ".glb") return glb_bytes(file, primitives);
  if (extension == ".obj") return obj_in_order(file);
  if (extension == ".bin") return bare_indices(file);
  throw BadInput(fmt::format("unknown extension '{}'; strips are written as {}", extension,
                             fmt::join(written_strip_extensions(), ", ")));
}

std::vector<std::string> required_extensions(const std::string& extension, GltfPrimitives primitives,
                                             std::size_t strips) {
  if (extension != ".glb" || primitives != GltfPrimitives::restart || strips < 2) return {};
  return {std::string(restart_extension)};
}

std::string as_text(const std::vector<std::string>& required_extensions, const std::string& name) {
  if (required_extensions.empty()) return {};
  return fmt::format("{}: requires {}, a proposal that few viewers know; the others refuse the file\n", name,
                     fmt::join(required_extensions, ", "));
}

}  // namespace restrip::tools
