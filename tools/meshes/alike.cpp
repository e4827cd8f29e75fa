#include "meshes/alike.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace restrip::tools {
namespace {

std::array<std::uint64_t, 3> bits(const Point& p) {
  return {std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
          std::bit_cast<std::uint64_t>(p.z + 0.0)};
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

}  // namespace restrip::tools
