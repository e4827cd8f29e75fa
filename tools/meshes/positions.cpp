#include "meshes/positions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace restrip::tools {
namespace {

std::array<std::uint64_t, 3> bits(const Point& p) {
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
          std::bit_cast<std::uint64_t>(p.z + 0.0)};
}

std::size_t repeated(std::span<const Point> points) {
  const std::vector<std::uint32_t> first = first_alike(points.size(), points);
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (first[v] != v) ++count;
  return count;
}

}  // namespace

std::vector<std::uint32_t> first_alike(std::size_t count, std::span<const Point> points,
                                       std::span<const Attribute> attributes) {
  const auto compare = [&](std::uint32_t a, std::uint32_t b) {
    if (!points.empty()) {
      const auto one = bits(points[a]);
      const auto other = bits(points[b]);
      if (one != other) return one < other ? -1 : 1;
    }
    for (const Attribute& attribute : attributes) {
      const std::size_t size = attribute.value_bytes();
      if (const int order = std::memcmp(&attribute.bytes[a * size], &attribute.bytes[b * size], size); order != 0)
        return order;
    }
    return 0;
  };
  struct Entry {
    std::uint64_t x;  // most points differ in it already
    std::uint32_t vertex;
  };
  std::vector<Entry> order(count);
  for (std::uint32_t v = 0; v < count; ++v) order[v] = {points.empty() ? 0 : bits(points[v])[0], v};
  std::sort(order.begin(), order.end(), [&](const Entry& a, const Entry& b) {
    if (a.x != b.x) return a.x < b.x;
    const int other = compare(a.vertex, b.vertex);
    return other != 0 ? other < 0 : a.vertex < b.vertex;
  });
  std::vector<std::uint32_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t v = order[i].vertex;
    const bool same = i != 0 && order[i - 1].x == order[i].x && compare(order[i - 1].vertex, v) == 0;
    first[v] = same ? first[order[i - 1].vertex] : v;
  }
  return first;
}

std::vector<std::uint32_t> renumber(std::vector<std::uint32_t>& first) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    const bool is_first = first[v] == v;
    first[v] = is_first ? static_cast<std::uint32_t>(kept.size()) : first[first[v]];
    if (is_first) kept.push_back(v);
  }
  return kept;
}

void put_coordinates(std::string& text, const Point& p) {
  const char* between = "";
  for (const double c : {p.x, p.y, p.z}) {
    text += between;
    if (const auto brief = static_cast<float>(c); static_cast<double>(brief) == c)
      text += fmt::format("{}", brief);
    else
      text += fmt::format("{}", c);
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
