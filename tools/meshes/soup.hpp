// A triangle soup: points and triangles as a mesh file lists them, unchecked.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meshes/attributes.hpp"

namespace restrip::tools {

struct Point {
  double x = 0;
  double y = 0;
  double z = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

/// As most formats and graphics processors have it.
[[nodiscard]] constexpr Point in_32_bits(const Point& p) noexcept {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// Three vertices, counter-clockwise.
using Corners = std::array<std::uint32_t, 3>;

/// A triangle begun at its smallest corner: equal for equal triangles of equal orientation.
[[nodiscard]] constexpr Corners rotated(const Corners& t) noexcept {
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  if (t[1] <= t[2]) return {t[1], t[2], t[0]};
  return {t[2], t[0], t[1]};
}

/// A corner twice.
[[nodiscard]] constexpr bool degenerate(const Corners& t) noexcept {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Between two strips of an index buffer.
inline constexpr std::uint32_t strip_end = 0xFFFF'FFFF;

/// Every corner is an index into `points`; nothing else is promised: corners may repeat, triangles too.
struct Soup {
  std::vector<Point> points;
  std::vector<Corners> triangles;
  /// The strips of a file that has some, as an index buffer with strip_end between them: it draws the triangles above
  /// that are not degenerate, in their order. What the file lists one by one is a strip each. Empty: none exist.
  std::vector<std::uint32_t> strips = {};
  /// Faces of more than three corners; each became a fan of triangles around its first corner.
  std::size_t polygons = 0;
  std::size_t stubs = 0;  ///< faces of fewer than three corners; left out
  /// What each point has beside its place, where that was asked for. Two points at one place that differ in these are
  /// two vertices: a strip does not go from one to the other.
  std::vector<Attribute> attributes = {};
  bool is_64_bits = false;                            ///< the file says so of its coordinates (`double` in PLY)
  std::vector<std::string> left_out_attributes = {};  ///< names of those that the file has, and the soup has not
};

}  // namespace restrip::tools
