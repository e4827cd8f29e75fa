#include "meshes/rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include "meshes/alike.hpp"

namespace restrip::tools {
namespace {

std::size_t repeated(std::span<const Point> points) {
  const std::vector<std::uint32_t> first = first_alike(points.size(), points);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (first[v] != v) ++count;
  return count;
}

}  // namespace

void put_coordinates(std::string& text, const Point& p) {
  const char* between = "";
  for (const double c : {p.x, p.y, p.z}) {
    text += between;
    if (const auto brief = static_cast<float>(c); static_cast<double>(brief) == c)
      fmt::format_to(std::back_inserter(text), "{}", brief);
    else
      fmt::format_to(std::back_inserter(text), "{}", c);
    between = " ";
  }
}

Rounding rounding_of(std::span<const Point> points) {
  Rounding found;
  if (points.empty()) return found;
  std::vector<Point> rounded;
  rounded.reserve(points.size());
  Point low = points.front();
  Point high = low;
  for (const Point& p : points) {
    const Point& r = rounded.emplace_back(in_32_bits(p));
    found.largest = std::max({found.largest, std::abs(p.x - r.x), std::abs(p.y - r.y), std::abs(p.z - r.z)});
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  if (found.largest == 0) return found;
  found.coinciding = repeated(rounded) - repeated(points);
  const double size = std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
  found.matters = found.coinciding != 0 || found.largest > 1e-6 * size;
  return found;
}

}  // namespace restrip::tools
