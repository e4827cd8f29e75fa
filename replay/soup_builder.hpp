// Collects a soup face by face, for the readers of the file formats. Says no where a file contradicts itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "soup.hpp"

namespace restrip::replay {

/// Triangles that a mesh can have (StripMesh keeps a handle and three flags in 32 bits), and vertices.
inline constexpr std::size_t max_triangles = (std::size_t{1} << 29) - 1;
inline constexpr std::size_t max_vertices = (std::size_t{1} << 32) - 2;

class SoupBuilder {
 public:
  /// `name` is the file, for messages.
  explicit SoupBuilder(std::string name) : name_(std::move(name)) {}

  /// Throws BadInput when a coordinate is infinite or no number, or when there are too many.
  void add_point(double x, double y, double z);
  /// Corners may refer to points that come later. Throws BadInput when there are too many.
  void add_face(std::span<const std::uint32_t> corners);
  [[nodiscard]] std::size_t point_count() const noexcept { return soup_.points.size(); }

  /// The soup. Throws BadInput when a face refers to a vertex that the file does not have, or when there is no
  /// triangle.
  [[nodiscard]] Soup finish() &&;

 private:
  std::string name_;
  Soup soup_;
};

}  // namespace restrip::replay
