// Which vertices are at the same place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// For each of `count` vertices the first one at the same point that has the same attributes: the same bits, the two
/// zeros being one. Without points the attributes alone decide. Sorts, so that no input is slower than others:
/// O(n log n).
[[nodiscard]] std::vector<std::uint32_t> first_alike(std::size_t count, std::span<const Point> points,
                                                     std::span<const Attribute> attributes = {});

}  // namespace restrip::tools
