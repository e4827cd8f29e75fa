#include "meshes/write_obj.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <vector>

#include "meshes/vertex_lookup.hpp"

namespace restrip::tools {
namespace {

/// 1 - v, as few digits as lead back to it.
std::string turned_place(double v) {
  const auto exact = static_cast<float>(v);
  const auto brief = static_cast<float>(1 - v);
  if (static_cast<float>(1 - static_cast<double>(brief)) == exact) return fmt::format("{}", brief);
  return fmt::format("{}", 1 - v);
}

class ObjWriter {
 public:
  explicit ObjWriter(const Soup& soup)
      : soup_(soup),
        normals_(named(soup.attributes, "NORMAL")),
        places_(named(soup.attributes, "TEXCOORD_0")),
        colors_(named(soup.attributes, "COLOR_0")) {}

  std::string run() && {
    const std::vector<std::uint32_t> v = put_points();
    const std::vector<std::uint32_t> vt = places_ == nullptr ? v : put_places();
    const std::vector<std::uint32_t> vn = normals_ == nullptr ? v : put_normals();
    auto out = std::back_inserter(text_);
    for (const Corners& t : soup_.triangles) {
      text_ += 'f';
      for (const std::uint32_t corner : t) {
        fmt::format_to(out, " {}", v[corner]);
        if (places_ != nullptr) fmt::format_to(out, "/{}", vt[corner]);
        if (normals_ != nullptr) fmt::format_to(out, "{}{}", places_ == nullptr ? "//" : "/", vn[corner]);
      }
      text_ += '\n';
    }
    return std::move(text_);
  }

 private:
  /// The number of the `v` of each vertex, counted from 1.
  std::vector<std::uint32_t> put_points() {
    std::vector<Attribute> all;
    for (const Attribute* attribute : {normals_, places_, colors_})
      if (attribute != nullptr) all.push_back(*attribute);
    VertexLookup vertices(all);
    VertexLookup points(colors_ == nullptr ? std::span<const Attribute>() : std::span(colors_, 1));
    std::vector<std::uint32_t> number(soup_.points.size());
    std::uint32_t count = 0;
    auto out = std::back_inserter(text_);
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      const Point& p = soup_.points[v];
      const bool is_first = vertices.put(p, v) == v;  // of those that differ in nothing
      if (const std::uint32_t same = is_first ? points.put(p, v) : v; same != v) {
        number[v] = number[same];
        continue;
      }
      number[v] = ++count;
      fmt::format_to(out, "v {} {} {}", p.x, p.y, p.z);
      for (unsigned c = 0; colors_ != nullptr && c < colors_->components; ++c)
        fmt::format_to(out, " {}", static_cast<float>(colors_->meant(v)[c]));
      text_ += '\n';
    }
    return number;
  }
  std::vector<std::uint32_t> put_places() {
    return put_values(*places_, [this](const Attribute::Value& value) {
      fmt::format_to(std::back_inserter(text_), "vt {} {}\n", static_cast<float>(value[0]), turned_place(value[1]));
    });
  }
  std::vector<std::uint32_t> put_normals() {
    return put_values(*normals_, [this](const Attribute::Value& value) {
      fmt::format_to(std::back_inserter(text_), "vn {} {} {}\n", static_cast<float>(value[0]),
                     static_cast<float>(value[1]), static_cast<float>(value[2]));
    });
  }

  /// Each value once; the number of that of each vertex, counted from 1.
  template <class Put>
  std::vector<std::uint32_t> put_values(const Attribute& attribute, Put&& put) {
    std::unordered_map<std::string, std::uint32_t> number;
    std::vector<std::uint32_t> numbers;
    const std::size_t size = attribute.value_bytes();
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      const auto [at, is_new] =
          number.try_emplace(attribute.bytes.substr(v * size, size), static_cast<std::uint32_t>(number.size() + 1));
      if (is_new) put(attribute.meant(v));
      numbers.push_back(at->second);
    }
    return numbers;
  }

  const Soup& soup_;
  const Attribute* normals_;
  const Attribute* places_;  // in textures
  const Attribute* colors_;
  std::string text_;
};

}  // namespace

std::string obj_bytes(const Soup& soup) { return ObjWriter(soup).run(); }

}  // namespace restrip::tools
