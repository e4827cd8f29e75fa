#include <fmt/format.h>

#include <bit>
#include <iterator>
#include <limits>

#include "common/bad_input.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/positions.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t most_values = std::numeric_limits<std::int32_t>::max();

const char* name_of(ComponentType type) {
  if (type == ComponentType::unsigned_byte) return "uchar";
  return type == ComponentType::unsigned_short ? "ushort" : "float";
}

/// The whole file, except `elements`, the rest of its header, and the bytes that follow the vertices.
std::string ply_of_vertices(std::span<const Point> points, bool is_64_bits, std::span<const Attribute> attributes,
                            const std::string& elements) {
  const Attribute* normals = named(attributes, "NORMAL");
  const Attribute* places = named(attributes, "TEXCOORD_0");
  const Attribute* colors = named(attributes, "COLOR_0");
  const bool is_wide = is_64_bits || rounding_of(points).matters;
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {0}\nproperty {1} x\nproperty {1} y\nproperty {1} z\n",
      points.size(), is_wide ? "double" : "float");
  if (normals != nullptr) bytes += "property float nx\nproperty float ny\nproperty float nz\n";
  if (places != nullptr) bytes += "property float s\nproperty float t\n";
  constexpr const char* channels[] = {"red", "green", "blue", "alpha"};
  for (unsigned c = 0; colors != nullptr && c < colors->components; ++c)
    fmt::format_to(std::back_inserter(bytes), "property {} {}\n", name_of(colors->type), channels[c]);
  bytes += elements + "end_header\n";
  bytes.reserve(bytes.size() + 52 * points.size());
  const auto put_real = [&bytes](double value) { put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value))); };
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (is_wide) {
      for (const double c : {points[v].x, points[v].y, points[v].z}) {
        const auto bits = std::bit_cast<std::uint64_t>(c);
        put(bytes, static_cast<std::uint32_t>(bits)), put(bytes, static_cast<std::uint32_t>(bits >> 32U));
      }
    } else {
      put(bytes, points[v]);
    }
    for (unsigned c = 0; normals != nullptr && c < 3; ++c) put_real(normals->value(v)[c]);
    if (places != nullptr) {
      const Attribute::Value at = places->meant(v);
      put_real(at[0]);
      put_real(1 - at[1]);
    }
    if (colors != nullptr) bytes.append(colors->bytes, v * colors->value_bytes(), colors->value_bytes());
  }
  return bytes;
}

}  // namespace

std::string ply_bytes(const Soup& soup) {
  std::string bytes =
      ply_of_vertices(soup.points, soup.is_64_bits, soup.attributes,
                      fmt::format("element face {}\nproperty list uchar uint vertex_indices\n", soup.triangles.size()));
  bytes.reserve(bytes.size() + 13 * soup.triangles.size());
  for (const Corners& t : soup.triangles) {
    bytes.push_back(3);
    for (const std::uint32_t corner : t) put(bytes, corner);
  }
  return bytes;
}

std::string ply_bytes(std::span<const Point> points, bool is_64_bits, std::span<const Attribute> attributes,
                      std::span<const std::uint32_t> strips) {
  if (strips.size() > most_values || points.size() > most_values)
    throw BadInput(fmt::format("a PLY list holds {} indices at most; write .bin", most_values));
  std::string bytes =
      ply_of_vertices(points, is_64_bits, attributes, "element tristrips 1\nproperty list int int vertex_indices\n");
  bytes.reserve(bytes.size() + 4 * (1 + strips.size()));
  put(bytes, static_cast<std::uint32_t>(strips.size()));
  static_assert(strip_end == static_cast<std::uint32_t>(-1));
  for (const std::uint32_t index : strips) put(bytes, index);
  return bytes;
}

}  // namespace restrip::tools
