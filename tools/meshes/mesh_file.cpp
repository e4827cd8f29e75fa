// The writers; each reader has a file of its own.
#include "meshes/mesh_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "meshes/little_endian.hpp"
#include "meshes/soup.hpp"

namespace restrip::tools {
namespace {

/// 1 - v, with the fewest digits that read back as the same number.
std::string turned_place(double v) {
  const auto exact = static_cast<float>(v);
  const auto brief = static_cast<float>(1 - v);
  if (static_cast<float>(1 - static_cast<double>(brief)) == exact) return fmt::format("{}", brief);
  return fmt::format("{}", 1 - v);
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
    bytes += fmt::format("property {} {}\n",
                         colors->type == ComponentType::unsigned_byte    ? "uchar"
                         : colors->type == ComponentType::unsigned_short ? "ushort"
                                                                         : "float",
                         channels[c]);
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

std::string obj_bytes(const Soup& soup) {
  const Attribute* normals = named(soup.attributes, "NORMAL");
  const Attribute* places = named(soup.attributes, "TEXCOORD_0");
  const Attribute* colors = named(soup.attributes, "COLOR_0");
  const std::size_t size = soup.points.size();
  std::string text;

  // The number of the `v` of each vertex, counted from 1.
  std::vector<Attribute> all;
  for (const Attribute* attribute : {normals, places, colors})
    if (attribute != nullptr) all.push_back(*attribute);
  const std::vector<std::uint32_t> first = first_alike(size, soup.points, all);
  std::vector<std::uint32_t> v_of =
      first_alike(size, soup.points, colors == nullptr ? std::span<const Attribute>() : std::span(colors, 1));
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < size; ++v) {
    // Identical vertices stay separate.
    if (first[v] == v && v_of[v] != v) {
      v_of[v] = v_of[v_of[v]];
      continue;
    }
    v_of[v] = ++count;
    text += "v ";
    put_coordinates(text, soup.points[v]);
    for (unsigned c = 0; colors != nullptr && c < colors->components; ++c)
      text += fmt::format(" {}", static_cast<float>(colors->meant(v)[c]));
    text += '\n';
  }

  // Writes each value once; returns the number of each vertex's value.
  const auto put_values = [&](const Attribute* attribute, auto&& put) {
    if (attribute == nullptr) return std::vector<std::uint32_t>();
    std::vector<std::uint32_t> number = first_alike(size, {}, std::span(attribute, 1));
    for (const std::uint32_t v : renumber(number)) put(attribute->meant(v));
    return number;
  };
  const std::vector<std::uint32_t> vt = put_values(places, [&](const Attribute::Value& value) {
    text += fmt::format("vt {} {}\n", static_cast<float>(value[0]), turned_place(value[1]));
  });
  const std::vector<std::uint32_t> vn = put_values(normals, [&](const Attribute::Value& value) {
    text += fmt::format("vn {} {} {}\n", static_cast<float>(value[0]), static_cast<float>(value[1]),
                        static_cast<float>(value[2]));
  });

  for (const Corners& t : soup.triangles) {
    text += 'f';
    for (const std::uint32_t corner : t) {
      text += fmt::format(" {}", v_of[corner]);
      if (places != nullptr) text += fmt::format("/{}", vt[corner] + 1);
      if (normals != nullptr) text += fmt::format("{}{}", places == nullptr ? "//" : "/", vn[corner] + 1);
    }
    text += '\n';
  }
  return text;
}

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
  constexpr std::size_t most_values = std::numeric_limits<std::int32_t>::max();
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

std::string off_bytes(const Soup& soup) {
  std::string text = fmt::format("OFF\n{} {} 0\n", soup.points.size(), soup.triangles.size());
  for (const Point& p : soup.points) {
    put_coordinates(text, p);
    text += '\n';
  }
  for (const Corners& t : soup.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

/// The attribute bytes and the normal are zero: programs compute normals from the corners.
std::string stl_bytes(const Soup& soup) {
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

}  // namespace restrip::tools
