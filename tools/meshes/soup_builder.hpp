// Builds a soup face by face, for the readers of the file formats. Refuses files that contradict themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Limits: StripMesh keeps a handle and three flags in 32 bits.
inline constexpr std::size_t max_triangles = (std::size_t{1} << 29) - 1;
inline constexpr std::uint64_t max_vertices = (std::uint64_t{1} << 32) - 2;

/// Throws BadInput if a line of a text file is longer than this. No real mesh has such a line, and parsing it would
/// take many times its size. `name` is the file.
inline constexpr std::size_t longest_line = std::size_t{64} << 20;
void refuse_long_lines(std::string_view text, const std::string& name);

class SoupBuilder {
 public:
  /// `name` is the file, for messages.
  explicit SoupBuilder(std::string name) : name_(std::move(name)) {}

  /// `line` is that of the point in the file, 0 if it has none. Throws BadInput if there are too many.
  void add_point(double x, double y, double z, std::size_t line = 0);
  /// The value of an attribute at a vertex, or a neutral one if it is not finite. If a triangle uses such a vertex, the
  /// attribute is left out in the end.
  [[nodiscard]] Attribute::Value usable(const Attribute::Value& value, std::size_t vertex,
                                        const std::string& attribute);
  /// Corners may refer to later points. Throws BadInput if there are too many.
  void add_face(std::span<const std::uint32_t> corners);
  /// Adds the triangles of a strip, and the strip. A repeated index turns the strip and draws nothing; fewer than three
  /// indices draw nothing either.
  void add_strip(std::span<const std::uint32_t> indices);
  /// Notes a part of the file that the soup lacks (Soup::left_out).
  void leave_out(const std::string& part);
  /// The attributes of points, to be filled by the caller. At the end each must have one value per point.
  [[nodiscard]] std::vector<Attribute>& attributes() noexcept { return soup_.attributes; }
  void say_64_bits() noexcept { soup_.is_64_bits = true; }
  [[nodiscard]] std::size_t point_count() const noexcept { return soup_.points.size(); }
  [[nodiscard]] const Point& point(std::size_t number) const { return soup_.points[number]; }

  /// Returns the soup, its polygons cut into triangles. Throws BadInput if a face refers to a missing vertex or to one
  /// with a coordinate that is not finite, or if every triangle is degenerate.
  [[nodiscard]] Soup finish() &&;

 private:
  /// Of consecutive triangles: a polygon, or a strip with its first index in `strips_`.
  struct Run {
    std::size_t first = 0;
    std::size_t end = 0;
    std::size_t index = 0;
  };

  /// A vertex with a coordinate that is not finite.
  struct LostPoint {
    std::size_t vertex = 0;
    std::size_t line = 0;
  };

  [[noreturn]] void refuse(const std::string& why) const;
  void add_triangle(const Corners& corners);
  void settle_doubts();
  void cut_polygons();
  /// The strips of the file; a triangle in none of them is one strip.
  [[nodiscard]] std::vector<std::uint32_t> all_strips() const;

  std::string name_;
  Soup soup_;
  std::vector<LostPoint> lost_points_;
  std::map<std::string, std::vector<std::size_t>> doubts_;  // vertices, by attribute
  std::vector<Run> polygons_;
  std::vector<Run> strip_runs_;
  std::vector<std::uint32_t> strips_;  // one after the other
};

// Cuts polygons of a file into triangles.

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
