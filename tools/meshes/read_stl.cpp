// STL, binary (80 bytes of anything, a count, 50 bytes a triangle) and text (`vertex x y z`, three for each `facet`).
// Many binary files begin with the word "solid" too, so the size decides.
#include <fmt/format.h>

#include <bit>

#include "common/bad_input.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"
#include "meshes/vertex_lookup.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t stl_header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

std::uint32_t read_u32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return value;
}

/// Gives corners at the same place the same vertex.
class Welder {
 public:
  explicit Welder(const std::string& name) : soup_(name) {}

  void add_corner(double x, double y, double z) {
    const auto next = static_cast<std::uint32_t>(soup_.point_count());
    const std::uint32_t vertex =
        places_.put({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}, next);
    if (vertex == next) soup_.add_point(x, y, z);
    corners_[filled_++] = vertex;
    if (filled_ == 3) {
      soup_.add_face(corners_);
      filled_ = 0;
    }
  }
  [[nodiscard]] bool between_facets() const noexcept { return filled_ == 0; }
  [[nodiscard]] Soup finish() && { return std::move(soup_).finish(); }

 private:
  SoupBuilder soup_;
  VertexLookup places_;
  Corners corners_{};
  unsigned filled_ = 0;
};

Soup read_binary(std::string_view bytes, const std::string& name) {
  Welder welder(name);
  for (std::size_t at = stl_header_bytes; at < bytes.size(); at += facet_bytes)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<float, 3> xyz{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        xyz[axis] = std::bit_cast<float>(read_u32(bytes, at + 12 + 12 * corner + 4 * axis));
      welder.add_corner(xyz[0], xyz[1], xyz[2]);
    }
  return std::move(welder).finish();
}

Soup read_text(std::string_view bytes, const std::string& name) {
  refuse_long_lines(bytes, name);
  Welder welder(name);
  TextCursor cursor(bytes);
  for (; !cursor.at_end(); cursor.next_line()) {
    const std::string_view keyword = cursor.word();
    const bool facet_begins_or_ends = keyword == "facet" || keyword == "endfacet" || keyword == "endsolid";
    if (facet_begins_or_ends && !welder.between_facets())
      throw BadInput(fmt::format("{}:{}: a facet whose number of vertices is not three", name, cursor.line()));
    if (keyword != "vertex") continue;
    std::array<double, 3> xyz{};
    for (double& coordinate : xyz) {
      const std::string_view word = cursor.word();
      const auto number = parse<double>(word);
      if (!number)
        throw BadInput(
            fmt::format("{}:{}: a vertex needs three numbers, found '{}'", name, cursor.line(), word.substr(0, 40)));
      coordinate = *number;
    }
    welder.add_corner(xyz[0], xyz[1], xyz[2]);
  }
  if (!welder.between_facets()) throw BadInput(fmt::format("{}: ends inside a facet; is it complete?", name));
  return std::move(welder).finish();
}

}  // namespace

Soup read_stl(std::string_view bytes, const std::string& name) {
  const bool may_be_binary = bytes.size() >= stl_header_bytes;
  const std::size_t facets = may_be_binary ? read_u32(bytes, stl_header_bytes - 4) : 0;
  if (may_be_binary && bytes.size() == stl_header_bytes + facets * facet_bytes) return read_binary(bytes, name);
  TextCursor cursor(bytes);
  if (cursor.word_on_any_line() == "solid") return read_text(bytes, name);
  throw BadInput(fmt::format(
      "{}: neither text (no `solid`) nor binary STL of the size that its count of {} facets asks for; is it complete?",
      name, facets));
}

}  // namespace restrip::tools
