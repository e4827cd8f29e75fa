// Reads STL, binary (an 80-byte header, a count, 50 bytes a triangle) and text (`vertex x y z`, three per `facet`, in
// upper or lower case). Many binary files begin with the word "solid" too, so the format is detected by the size, then
// by whether the first bytes are text. The two bytes after a binary facet are 0 or, from some programs, its colour.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <span>
#include <vector>

#include "common/bad_input.hpp"
#include "common/counted.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/positions.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t stl_header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

std::uint32_t read_u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

/// Merges corners at the same position.
class Welder {
 public:
  explicit Welder(const std::string& name) : soup_(name) {}

  void add_corner(double x, double y, double z) { corners_.push_back({x, y, z}); }
  void leave_out(const std::string& what) { soup_.leave_out(what); }
  [[nodiscard]] bool between_facets() const noexcept { return corners_.size() % 3 == 0; }
  [[nodiscard]] Soup finish() && {
    std::vector<std::uint32_t> vertex = first_alike(corners_.size(), corners_);
    for (std::uint32_t corner = 0; corner < vertex.size(); ++corner) {
      const bool is_first = vertex[corner] == corner;
      vertex[corner] = is_first ? static_cast<std::uint32_t>(soup_.point_count()) : vertex[vertex[corner]];
      if (is_first) soup_.add_point(corners_[corner].x, corners_[corner].y, corners_[corner].z);
    }
    for (std::size_t corner = 0; corner < vertex.size(); corner += 3)
      soup_.add_face(std::span(vertex).subspan(corner, 3));
    return std::move(soup_).finish();
  }

 private:
  SoupBuilder soup_;
  std::vector<Point> corners_;
};

Soup read_binary(std::string_view bytes, const std::string& name, std::size_t facets) {
  Welder welder(name);
  const std::size_t end = stl_header_bytes + facets * facet_bytes;
  for (std::size_t at = stl_header_bytes; at < end; at += facet_bytes) {
    if (bytes.substr(at + facet_bytes - 2, 2) != std::string_view("\0\0", 2)) welder.leave_out("COLOR_0");
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<float, 3> xyz{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        xyz[axis] = std::bit_cast<float>(read_u32(bytes, at + 12 + 12 * corner + 4 * axis));
      welder.add_corner(xyz[0], xyz[1], xyz[2]);
    }
  }
  if (end != bytes.size()) welder.leave_out(fmt::format("{} after the facets", counted(bytes.size() - end, "byte")));
  return std::move(welder).finish();
}

bool same_letters(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

Soup read_text(std::string_view bytes, const std::string& name) {
  refuse_long_lines(bytes, name);
  Welder welder(name);
  TextCursor cursor(bytes);
  for (; !cursor.at_end(); cursor.next_line()) {
    const std::string_view keyword = cursor.word();
    const bool facet_begins_or_ends =
        same_letters(keyword, "facet") || same_letters(keyword, "endfacet") || same_letters(keyword, "endsolid");
    if (facet_begins_or_ends && !welder.between_facets())
      throw BadInput(fmt::format("{}:{}: a facet whose number of vertices is not three", name, cursor.line()));
    if (!same_letters(keyword, "vertex")) continue;
    std::array<double, 3> xyz{};
    for (double& coordinate : xyz) {
      const std::string_view word = cursor.word();
      const auto number = parse<double>(word);
      if (!number)
        throw BadInput(fmt::format("{}:{}: a vertex needs three numbers, {}", name, cursor.line(),
                                   word.empty() ? "but the line ends" : fmt::format("found '{}'", word.substr(0, 40))));
      coordinate = *number;
    }
    welder.add_corner(xyz[0], xyz[1], xyz[2]);
  }
  if (!welder.between_facets()) throw BadInput(fmt::format("{}: ends inside a facet; is it complete?", name));
  return std::move(welder).finish();
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() > stl_header_bytes &&
         bytes.size() == stl_header_bytes + std::size_t{read_u32(bytes, stl_header_bytes - 4)} * facet_bytes;
}

Soup read_stl(std::string_view bytes, const std::string& name) {
  const bool may_be_binary = bytes.size() >= stl_header_bytes;
  const std::size_t facets = may_be_binary ? read_u32(bytes, stl_header_bytes - 4) : 0;
  const std::size_t size = stl_header_bytes + facets * facet_bytes;
  if (may_be_binary && bytes.size() == size) return read_binary(bytes, name, facets);
  // A count below 2^24 contains a zero byte, which text does not.
  const bool is_text = bytes.substr(0, stl_header_bytes).find('\0') == std::string_view::npos;
  TextCursor cursor(bytes);
  if (is_text && same_letters(cursor.word_on_any_line(), "solid")) return read_text(bytes, name);
  if (!is_text && facets != 0 && bytes.size() > size) return read_binary(bytes, name, facets);
  throw BadInput(fmt::format(
      "{}: neither text (no `solid`) nor binary STL of the size that its count of {} facets asks for; is it complete?",
      name, facets));
}

}  // namespace restrip::tools
