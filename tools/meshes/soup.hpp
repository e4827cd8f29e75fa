// A triangle soup: points and triangles as a mesh file lists them, unchecked.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace restrip::tools {

struct Point {
  float x = 0;
  float y = 0;
  float z = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// Three vertices, counter-clockwise.
using Corners = std::array<std::uint32_t, 3>;

/// The same triangle, begun at its smallest corner: equal for equal triangles of equal orientation.
[[nodiscard]] constexpr Corners rotated(const Corners& t) noexcept {
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  if (t[1] <= t[2]) return {t[1], t[2], t[0]};
  return {t[2], t[0], t[1]};
}

/// Every corner is an index into `points`; nothing else is promised: corners may repeat, triangles too.
struct Soup {
  std::vector<Point> points;
  std::vector<Corners> triangles;
  std::size_t polygons =
      0;                  ///< faces of more than three corners; each became a fan of triangles around its first corner
  std::size_t stubs = 0;  ///< faces of fewer than three corners; left out
};

}  // namespace restrip::tools
