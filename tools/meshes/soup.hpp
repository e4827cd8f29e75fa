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

/// As most formats and graphics processors store it.
[[nodiscard]] constexpr Point in_32_bits(const Point& p) noexcept {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// Three vertices, counter-clockwise.
using Corners = std::array<std::uint32_t, 3>;

/// Rotates a triangle to start at its smallest corner: equal for equal triangles of equal orientation.
[[nodiscard]] constexpr Corners rotated(const Corners& t) noexcept {
  if (t[0] <= t[1] && t[0] <= t[2]) return t;
  if (t[1] <= t[2]) return {t[1], t[2], t[0]};
  return {t[2], t[0], t[1]};
}

/// Has a corner twice.
[[nodiscard]] constexpr bool degenerate(const Corners& t) noexcept {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Separates two strips of an index buffer.
inline constexpr std::uint32_t strip_end = 0xFFFF'FFFF;

/// Every corner is an index into `points`. Corners and triangles may repeat.
struct Soup {
  std::vector<Point> points;
  std::vector<Corners> triangles;
  /// The strips of the file, as an index buffer with strip_end between them. They draw all non-degenerate triangles
  /// above, in order; a triangle that the file lists individually is one strip. Empty if the file has no strips.
  std::vector<std::uint32_t> strips = {};
  /// Faces of more than three corners; each became triangles, a fan around its first corner if it is convex.
  std::size_t polygons = 0;
  std::size_t stubs = 0;  ///< faces of fewer than three corners; left out
  /// Attributes of the points, if requested. Two points at one position that differ in them are two vertices: a strip
  /// does not cross from one to the other.
  std::vector<Attribute> attributes = {};
  bool is_64_bits = false;  ///< the file declares its coordinates so (`double` in PLY)
  /// Parts of the file that the soup lacks: attributes by their names in glTF, perhaps with a remark after a blank, and
  /// others in words.
  std::vector<std::string> left_out = {};
};

}  // namespace restrip::tools
