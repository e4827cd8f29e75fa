// Writes PLY, binary little-endian: vertices with nx ny nz, s t, red green blue alpha if present; faces, or strips as
// in Stanford's scans (Cyberware's `tristrips`, -1 between strips).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Colours keep their encoding. PLY counts t from below, glTF and Soup from above, so it is inverted, which may change
/// it by 2^-25. Coordinates have 64 bits if the input file had them or if rounding to 32 matters (rounding.hpp),
/// otherwise 32.
[[nodiscard]] std::string ply_bytes(const Soup& soup);
/// Throws BadInput if there are more indices than a PLY list holds.
[[nodiscard]] std::string ply_bytes(std::span<const Point> points, bool is_64_bits,
                                    std::span<const Attribute> attributes, std::span<const std::uint32_t> strips);

}  // namespace restrip::tools
