// Collects a soup face by face, for the readers of the file formats. Says no where a file contradicts itself.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Triangles that a mesh can have (StripMesh keeps a handle and three flags in 32 bits), and vertices.
inline constexpr std::size_t max_triangles = (std::size_t{1} << 29) - 1;
inline constexpr std::uint64_t max_vertices = (std::uint64_t{1} << 32) - 2;

/// Throws BadInput when a line of a text file is longer than `limit` bytes: no line of a mesh is, and what is made of
/// it would take many times its size. `name` is the file.
inline constexpr std::size_t longest_line = std::size_t{64} << 20;
void refuse_long_lines(std::string_view text, const std::string& name, std::size_t limit = longest_line);

class SoupBuilder {
 public:
  /// `name` is the file, for messages.
  explicit SoupBuilder(std::string name) : name_(std::move(name)) {}

  /// Throws BadInput when there are too many.
  void add_point(double x, double y, double z);
  /// The vertex has a value that is not finite, and is given 0 instead. That is an error if a triangle uses the vertex,
  /// and reported otherwise. `what`: "normals that are".
  void doubt(std::size_t vertex, const std::string& what);
  /// Corners may refer to points that come later. Throws BadInput when there are too many.
  void add_face(std::span<const std::uint32_t> corners);
  /// The triangles that a strip of these indices draws, and the strip. A repeated index turns the strip and draws
  /// nothing; fewer than three indices draw nothing either.
  void add_strip(std::span<const std::uint32_t> indices);
  /// The file has this, and the soup has not. Throws BadInput when there are too many.
  void leave_out(const std::string& attribute);
  /// Values for points to come, or the last ones. At the end each attribute must have as many as there are points.
  [[nodiscard]] std::vector<Attribute>& attributes() noexcept { return soup_.attributes; }
  void say_64_bits() noexcept { soup_.is_64_bits = true; }
  [[nodiscard]] std::size_t point_count() const noexcept { return soup_.points.size(); }
  [[nodiscard]] const Point& point(std::size_t number) const { return soup_.points[number]; }

  /// The soup. Throws BadInput when a face refers to a vertex that the file does not have or that has a value that is
  /// not finite, and when no triangle has three different corners.
  [[nodiscard]] Soup finish() &&;

 private:
  void add_triangle(const Corners& corners);
  /// A strip for each of these triangles that is not degenerate.
  void add_strips_of_one(std::size_t first, std::size_t end);
  void begin_strip();
  void settle_doubts();

  std::string name_;
  Soup soup_;
  std::map<std::string, std::vector<std::size_t>> doubts_;  // vertices, by what of them is not finite
};

}  // namespace restrip::tools
