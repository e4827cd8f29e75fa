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
  /// Returns the number of the `v` of each vertex, counted from 1.
  std::vector<std::uint32_t> put_points() {
    std::vector<Attribute> all;
    for (const Attribute* attribute : {normals_, places_, colors_})
      if (attribute != nullptr) all.push_back(*attribute);
    const std::size_t size = soup_.points.size();
    const std::vector<std::uint32_t> first = first_alike(size, soup_.points, all);
    std::vector<std::uint32_t> number =
        first_alike(size, soup_.points, colors_ == nullptr ? std::span<const Attribute>() : std::span(colors_, 1));
    std::uint32_t count = 0;
    auto out = std::back_inserter(text_);
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      // Identical vertices stay separate.
      if (first[v] == v && number[v] != v) {
        number[v] = number[number[v]];
        continue;
      }
      number[v] = ++count;
      text_ += "v ";
      put_coordinates(text_, soup_.points[v]);
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

  /// Writes each value once; returns the number of each vertex's value, counted from 1.
  template <class Put>
  std::vector<std::uint32_t> put_values(const Attribute& attribute, Put&& put) {
    std::vector<std::uint32_t> number = first_alike(soup_.points.size(), {}, std::span(&attribute, 1));
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      const bool is_first = number[v] == v;
      number[v] = is_first ? ++count : number[number[v]];
      if (is_first) put(attribute.meant(v));
    }
    return number;
  }

  const Soup& soup_;
  const Attribute* normals_;
  const Attribute* places_;  // texture coordinates
  const Attribute* colors_;
  std::string text_;
};

}  // namespace

std::string obj_bytes(const Soup& soup) { return ObjWriter(soup).run(); }

}  // namespace restrip::tools
