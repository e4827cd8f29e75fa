// Reads STL, binary (an 80-byte header, a count, 50 bytes a triangle) and text (`vertex x y z`, three per `facet`, in
// upper or lower case; only the name of a solid ends with its line). Many binary files begin with the word "solid" too,
// so the format is detected by the size, then by whether the first bytes are text. The two bytes after a binary facet
// are 0 or, from some programs, its colour.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "common/counted.hpp"
#include "common/printable.hpp"
#include "meshes/little_endian.hpp"
#include "meshes/mesh_file.hpp"
#include "meshes/soup.hpp"
#include "meshes/soup_builder.hpp"
#include "meshes/text_cursor.hpp"

namespace restrip::tools {
namespace {

constexpr std::size_t stl_header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

/// The mesh of these facets, three corners each; corners at the same position are merged.
Soup welded(SoupBuilder soup, const std::vector<Point>& corners) {
  std::vector<std::uint32_t> vertex = first_alike(corners.size(), corners);
  for (const std::uint32_t corner : renumber(vertex))
    soup.add_point(corners[corner].x, corners[corner].y, corners[corner].z);
  for (std::size_t corner = 0; corner < vertex.size(); corner += 3) soup.add_face(std::span(vertex).subspan(corner, 3));
  return std::move(soup).finish();
}

Soup read_binary(std::string_view bytes, const std::string& name, std::size_t facets) {
  SoupBuilder soup(name);
  std::vector<Point> corners;
  const std::size_t end = stl_header_bytes + facets * facet_bytes;
  for (std::size_t at = stl_header_bytes; at < end; at += facet_bytes) {
    if (bytes.substr(at + facet_bytes - 2, 2) != std::string_view("\0\0", 2)) soup.leave_out("COLOR_0");
    for (std::size_t corner = at + 12; corner < at + 48; corner += 12) {
      const auto coordinate = [&](std::size_t axis) {
        return std::bit_cast<float>(little_endian(bytes, corner + 4 * axis));
      };
      corners.push_back({coordinate(0), coordinate(1), coordinate(2)});
    }
  }
  if (end != bytes.size()) soup.leave_out(fmt::format("{} after the facets", counted(bytes.size() - end, "byte")));
  return welded(std::move(soup), corners);
}

bool same_letters(std::string_view word, std::string_view lower_case) {
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// Skips the name of a solid: to the end of the line, or to a facet on the same line.
void skip_name(TextCursor& cursor) {
  for (TextCursor ahead = cursor;; cursor = ahead) {
    const std::string_view word = ahead.word();
    if (word.empty()) return;
    if (same_letters(word, "facet") && same_letters(TextCursor(ahead).word_on_any_line(), "normal")) return;
    if (same_letters(word, "endsolid")) return;
  }
}

Soup read_text(std::string_view bytes, const std::string& name) {
  refuse_long_lines(bytes, name);
  SoupBuilder soup(name);
  std::vector<Point> corners;
  TextCursor cursor(bytes);
  for (std::string_view word = cursor.word_on_any_line(); !word.empty(); word = cursor.word_on_any_line()) {
    const auto is = [&word](std::string_view keyword) { return same_letters(word, keyword); };
    const bool facet_begins_or_ends = is("facet") || is("endfacet") || is("endsolid");
    if (facet_begins_or_ends && corners.size() % 3 != 0)
      throw BadInput(fmt::format("{}:{}: a facet whose number of vertices is not three", name, cursor.line()));
    if (is("solid") || is("endsolid")) {
      skip_name(cursor);
    } else if (is("vertex")) {
      Point& p = corners.emplace_back();
      for (double* coordinate : {&p.x, &p.y, &p.z}) {
        word = cursor.word_on_any_line();
        const auto number = parse<double>(word);
        if (!number)
          throw BadInput(
              fmt::format("{}:{}: a vertex needs three numbers, {}", name, cursor.line(),
                          word.empty() ? "but the file ends" : fmt::format("found '{}'", word.substr(0, 40))));
        if (!std::isfinite(static_cast<float>(*number)))
          throw BadInput(fmt::format("{}:{}: '{}' is infinite or not a number; mend or remove the facet", name,
                                     cursor.line(), word.substr(0, 40)));
        *coordinate = *number;
      }
    } else if (!facet_begins_or_ends && !is("normal") && !is("outer") && !is("loop") && !is("endloop") && !is("end") &&
               !parse<double>(word)) {
      soup.leave_out(fmt::format("`{}`", files::printable_ascii(word.substr(0, 40))));
    }
  }
  if (corners.size() % 3 != 0) throw BadInput(fmt::format("{}: ends inside a facet; is it complete?", name));
  return welded(std::move(soup), corners);
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() > stl_header_bytes &&
         bytes.size() == stl_header_bytes + std::size_t{little_endian(bytes, stl_header_bytes - 4)} * facet_bytes;
}

Soup read_stl(std::string_view bytes, const std::string& name) {
  const bool may_be_binary = bytes.size() >= stl_header_bytes;
  const std::size_t facets = may_be_binary ? little_endian(bytes, stl_header_bytes - 4) : 0;
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
