// Positions of vertices: which coincide, and what is lost when they are rounded. Coordinates have 64 bits here; formats
// with 32 bits round them, which matters far from the origin.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// For each of `count` vertices, the first vertex with the same point and the same attributes. Values are compared bit
/// by bit, except that both zeros are equal. Without points, only the attributes are compared. Sorting bounds the time
/// for any input: O(n log n).
[[nodiscard]] std::vector<std::uint32_t> first_alike(std::size_t count, std::span<const Point> points,
                                                     std::span<const Attribute> attributes = {});

/// Replaces the result of first_alike() by the numbers that vertices get if only the first of those alike remain, which
/// are returned.
std::vector<std::uint32_t> renumber(std::vector<std::uint32_t>& first);

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
