#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <vector>

#include "meshes/mesh_file.hpp"
#include "meshes/positions.hpp"

namespace restrip::tools {
namespace {

/// 1 - v, with the fewest digits that read back as the same number.
std::string turned_place(double v) {
  const auto exact = static_cast<float>(v);
  const auto brief = static_cast<float>(1 - v);
  if (static_cast<float>(1 - static_cast<double>(brief)) == exact) return fmt::format("{}", brief);
  return fmt::format("{}", 1 - v);
}

}  // namespace

std::string obj_bytes(const Soup& soup) {
  const Attribute* normals = named(soup.attributes, "NORMAL");
  const Attribute* places = named(soup.attributes, "TEXCOORD_0");
  const Attribute* colors = named(soup.attributes, "COLOR_0");
  const std::size_t size = soup.points.size();
  std::string text;
  auto out = std::back_inserter(text);

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
      fmt::format_to(out, " {}", static_cast<float>(colors->meant(v)[c]));
    text += '\n';
  }

  // Writes each value once; returns the number of each vertex's value, counted from 1.
  const auto put_values = [&](const Attribute* attribute, auto&& put) {
    if (attribute == nullptr) return std::vector<std::uint32_t>();
    std::vector<std::uint32_t> number = first_alike(size, {}, std::span(attribute, 1));
    std::uint32_t values = 0;
    for (std::uint32_t v = 0; v < size; ++v) {
      const bool is_first = number[v] == v;
      number[v] = is_first ? ++values : number[number[v]];
      if (is_first) put(attribute->meant(v));
    }
    return number;
  };
  const std::vector<std::uint32_t> vt = put_values(places, [&](const Attribute::Value& value) {
    fmt::format_to(out, "vt {} {}\n", static_cast<float>(value[0]), turned_place(value[1]));
  });
  const std::vector<std::uint32_t> vn = put_values(normals, [&](const Attribute::Value& value) {
    fmt::format_to(out, "vn {} {} {}\n", static_cast<float>(value[0]), static_cast<float>(value[1]),
                   static_cast<float>(value[2]));
  });

  for (const Corners& t : soup.triangles) {
    text += 'f';
    for (const std::uint32_t corner : t) {
      fmt::format_to(out, " {}", v_of[corner]);
      if (places != nullptr) fmt::format_to(out, "/{}", vt[corner]);
      if (normals != nullptr) fmt::format_to(out, "{}{}", places == nullptr ? "//" : "/", vn[corner]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace restrip::tools
