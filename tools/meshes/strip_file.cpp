#include "meshes/strip_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <limits>

#include "common/bad_input.hpp"
#include "meshes/mesh_file.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t most_values = std::numeric_limits<std::int32_t>::max();

void put(std::string& bytes, std::uint32_t value, unsigned width = 4) {
  for (unsigned i = 0; i < width; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
}

void put_points(std::string& bytes, std::span<const Point> points) {
  for (const Point& p : points)
    for (const float coordinate : {p.x, p.y, p.z}) put(bytes, std::bit_cast<std::uint32_t>(coordinate));
}

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
  put_points(bytes, file.points);
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

/// A run of the index buffer.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// The strips between the restarts.
std::vector<Run> strips_of(std::span<const std::uint32_t> indices) {
  std::vector<Run> runs;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= indices.size(); ++i) {
    if (i < indices.size() && indices[i] != restart_index) continue;
    runs.push_back({first, i - first});
    first = i + 1;
  }
  return runs;
}

/// The least or the greatest coordinates, as glTF wants them said.
std::string bound(std::span<const Point> points, const float& (*of)(const float&, const float&)) {
  Point p = points.front();
  for (const Point& q : points) p = {of(p.x, q.x), of(p.y, q.y), of(p.z, q.z)};
  return fmt::format("[{},{},{}]", p.x, p.y, p.z);
}

/// One chunk of a GLB, filled up to a multiple of four bytes.
void put_chunk(std::string& glb, std::string bytes, std::uint32_t kind, char filling) {
  bytes.resize((bytes.size() + 3) / 4 * 4, filling);
  put(glb, static_cast<std::uint32_t>(bytes.size()));
  put(glb, kind);
  glb += bytes;
}

std::string glb_of(const StripFile& file, GltfPrimitives primitives) {
  if (file.triangles.empty()) throw BadInput("glTF has no mesh without triangles");
  std::vector<std::uint32_t> list;
  std::span<const std::uint32_t> indices = file.indices;
  std::vector<Run> runs{{0, indices.size()}};
  if (primitives == GltfPrimitives::list) {
    for (const Corners& t : file.triangles) list.insert(list.end(), t.begin(), t.end());
    indices = list;
    runs = {{0, list.size()}};
  } else if (primitives == GltfPrimitives::strips) {
    runs = strips_of(indices);
  }
  // The largest value of its width is the restart, or forbidden.
  const unsigned width = file.points.size() < 0xFFFF ? 2 : 4;
  if (12 * file.points.size() + width * indices.size() > most_values)
    throw BadInput(fmt::format("a GLB holds {} bytes at most; write .ply or .bin", most_values));

  std::string binary;
  binary.reserve(12 * file.points.size() + width * indices.size());
  put_points(binary, file.points);
  for (const std::uint32_t index : indices) put(binary, index, width);

  std::string json = R"({"asset":{"version":"2.0","generator":"restrip"},"scene":0,"scenes":[{"nodes":[0]}],)"
                     R"("nodes":[{"mesh":0}],)";
  if (primitives == GltfPrimitives::restart)
    json += R"("extensionsUsed":["KHR_mesh_primitive_restart"],"extensionsRequired":["KHR_mesh_primitive_restart"],)";
  auto out = std::back_inserter(json);
  json += R"("meshes":[{"primitives":[)";
  for (std::size_t i = 0; i < runs.size(); ++i)
    fmt::format_to(out, R"({}{{"attributes":{{"POSITION":0}},"indices":{},"mode":{}}})", i == 0 ? "" : ",", i + 1,
                   primitives == GltfPrimitives::list ? 4 : 5);
  fmt::format_to(
      out, R"(]}}],"accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3","min":{},"max":{}}})",
      file.points.size(), bound(file.points, std::min<float>), bound(file.points, std::max<float>));
  for (const Run& run : runs)
    fmt::format_to(out, R"(,{{"bufferView":1,"byteOffset":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                   width * run.first, width == 2 ? 5123 : 5125, run.count);
  fmt::format_to(
      out,
      R"(],"bufferViews":[{{"buffer":0,"byteLength":{0},"target":34962}},)"
      R"({{"buffer":0,"byteOffset":{0},"byteLength":{1},"target":34963}}],"buffers":[{{"byteLength":{2}}}]}})",
      12 * file.points.size(), width * indices.size(), binary.size());

  std::string chunks;
  put_chunk(chunks, std::move(json), 0x4E4F534A, ' ');     // JSON
  put_chunk(chunks, std::move(binary), 0x004E4942, '\0');  // BIN
  std::string glb = "glTF";
  put(glb, 2);
  put(glb, static_cast<std::uint32_t>(12 + chunks.size()));
  return glb + chunks;
}

}  // namespace

std::vector<std::string> written_strip_extensions() { return {".ply", ".glb", ".obj", ".bin"}; }

std::string strip_bytes(const StripFile& file, const std::string& extension, GltfPrimitives primitives) {
  if (extension == ".ply") return ply_with_strips(file);
  if (extension == ".glb") return glb_of(file, primitives);
  if (extension == ".obj") return obj_in_order(file);
  if (extension == ".bin") return bare_indices(file);
  throw BadInput(fmt::format("unknown extension '{}'; strips are written as {}", extension,
                             fmt::join(written_strip_extensions(), ", ")));
}

}  // namespace restrip::tools
