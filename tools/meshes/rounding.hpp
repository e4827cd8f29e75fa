// Coordinates have 64 bits here. Formats with 32 bits round them, which matters far from the origin.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// The effect of rounding a mesh to 32 bits.
struct Rounding {
  double largest = 0;          ///< the largest change of a coordinate
  std::size_t coinciding = 0;  ///< vertices that then coincide with others
  /// Whether to report it: vertices coincide, or move by more than a millionth of the mesh's size.
  bool matters = false;
};

/// "x y z", each with the fewest digits that read back as the same number; in 32 bits if that is exact.
void put_coordinates(std::string& text, const Point& p);

/// O(n log n).
[[nodiscard]] Rounding rounding_of(std::span<const Point> points);

}  // namespace restrip::tools
