// Coordinates are 64 bits wide here. Formats that have 32 round them, which matters far from the origin.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// What rounding to 32 bits does to a mesh.
struct Rounding {
  double largest = 0;          ///< the largest change of a coordinate
  std::size_t coinciding = 0;  ///< vertices that come to lie where others do
  /// Whether it is worth a word: vertices coincide, or move by more than a millionth of the mesh's size.
  bool matters = false;
};

/// "x y z", each in as few digits as lead back to it, as 32 bits where it is a number of these.
void put_coordinates(std::string& text, const Point& p);

/// O(n log n).
[[nodiscard]] Rounding rounding_of(std::span<const Point> points);

}  // namespace restrip::tools
