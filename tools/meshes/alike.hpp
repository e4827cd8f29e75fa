// Finds vertices at the same position.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// For each of `count` vertices, the first vertex with the same point and the same attributes. Values are compared bit
/// by bit, except that both zeros are equal. Without points, only the attributes are compared. Sorting bounds the time
/// for any input: O(n log n).
[[nodiscard]] std::vector<std::uint32_t> first_alike(std::size_t count, std::span<const Point> points,
                                                     std::span<const Attribute> attributes = {});

}  // namespace restrip::tools
