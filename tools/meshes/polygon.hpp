// Cuts polygons of a file into triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Cuts polygons; one object for all polygons of a file, since the work is limited for the whole file.
class PolygonCutter {
 public:
  explicit PolygonCutter(std::span<const Point> points) : points_(points) {}

  /// Replaces `fan`, the n - 2 triangles around the first corner of a polygon, if the fan leaves the polygon or has a
  /// triangle without area. The triangles that replace it have the same corners and orientation, and cover the polygon
  /// once if it is simple and nearly flat; corners may lie on a straight line or at one place. Otherwise, for example
  /// if the outline crosses itself, they are some triangles with these corners. Returns false, and leaves the fan, once
  /// the file has taken too much time. Expected O(n log n), at worst quadratic.
  bool cut(std::span<Corners> fan);

 private:
  struct Flat {
    double x = 0;
    double y = 0;
  };

  /// Fills `flat_` with the corners as seen along the coordinate axis nearest to the normal, counter-clockwise.
  /// Returns false if the polygon has no area.
  bool flatten();
  /// Positive if corners a, b, c turn left.
  [[nodiscard]] double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  [[nodiscard]] bool is_convex_fan() const;
  /// Whether b and its neighbours form a triangle that contains no other corner.
  [[nodiscard]] bool is_ear(std::uint32_t b);
  [[nodiscard]] bool may_block(std::uint32_t corner) const {
    return turn(before_[corner], corner, after_[corner]) <= 0;
  }

  std::span<const Point> points_;
  std::uint64_t tests_ = 0;  // of a corner against an ear
  // Of one polygon.
  std::vector<std::uint32_t> vertices_;
  std::vector<Flat> flat_;
  std::vector<std::uint32_t> before_;  // a ring of the corners that are left
  std::vector<std::uint32_t> after_;
  std::vector<std::uint32_t> reflex_;  // corners that were not convex at the beginning, by their x
};

}  // namespace restrip::tools
