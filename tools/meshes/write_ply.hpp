// PLY out, binary, little-endian: vertices with nx ny nz, s t, red green blue alpha where they have them; faces, or
// strips as Stanford's scans have them (Cyberware's `tristrips`, -1 between strips).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "meshes/soup.hpp"

namespace restrip::tools {

/// Colours are as they are encoded. PLY's t counts from below, glTF and Soup from above: it is turned, by which it may
/// change by 2^-25. Coordinates have 64 bits where the file that was read had them or where rounding to 32 matters
/// (rounding.hpp), else 32.
[[nodiscard]] std::string ply_bytes(const Soup& soup);
/// Throws BadInput where there are more indices than a list of PLY holds.
[[nodiscard]] std::string ply_bytes(std::span<const Point> points, bool is_64_bits,
                                    std::span<const Attribute> attributes, std::span<const std::uint32_t> strips);

}  // namespace restrip::tools
