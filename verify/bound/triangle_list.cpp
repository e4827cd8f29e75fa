#include "bound/triangle_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>

#include "model/input.hpp"

namespace restrip::verify {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Takes the first word off a line.
std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

/// A corner v, v/vt, v//vn or v/vt/vn: v counts from 1, or from the last vertex when negative. `vertices` or more when
/// it is none of the vertices so far.
std::uint64_t vertex_of(std::string_view corner, std::uint64_t vertices) {
  const std::string_view digits = corner.substr(0, corner.find('/'));
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size() || number == 0) return vertices;
  return static_cast<std::uint64_t>(number) - (number > 0 ? 1 : -vertices);
}

}  // namespace

TriangleList read_obj(const std::string& path) {
  const std::string text = read_file(path);
  TriangleList list;
  unsigned number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string_view line = std::string_view(text).substr(start, end - start);
    start = end + 1;
    ++number;
    const std::string_view keyword = take_word(line);
    if (keyword == "v" && ++list.vertices == std::numeric_limits<std::uint32_t>::max())
      throw InputError(path, number, "expected fewer vertices, found 2^32 - 1");
    if (keyword != "f") continue;
    std::vector<std::uint32_t> corners;
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const std::uint64_t vertex = vertex_of(word, list.vertices);
      if (vertex >= list.vertices)
        throw InputError(
            path, number,
            fmt::format("expected one of the {} vertices above, found \"{}\"", list.vertices, word.substr(0, 40)));
      corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    if (corners.size() != 3)
      throw InputError(path, number, fmt::format("expected a triangle, found a face of {} corners", corners.size()));
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      ++list.left_out;
    else
      list.triangles.push_back({corners[0], corners[1], corners[2]});
  }
  if (list.triangles.empty()) throw InputError(path, 0, "expected triangles, found none");
  return list;
}

std::uint64_t digest_of(const TriangleList& list) {
  std::uint64_t digest = 0xCBF29CE484222325;
  for (const auto& corners : list.triangles)
    for (const std::uint32_t corner : corners)
      for (unsigned byte = 0; byte < 4; ++byte) digest = (digest ^ (corner >> 8 * byte & 0xFFU)) * 0x100000001B3;
  return digest;
}

}  // namespace restrip::verify
