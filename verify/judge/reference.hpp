#pragma once
// Figures published in docs/explanation/theory.md (section 6), counted there by an independent program. They are typed
// on purpose, for comparison.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace restrip::verify {

struct ReferenceCount {
  std::string_view operation;  ///< Operation::name()
  std::uint64_t configurations;
  std::uint64_t valid;
  std::optional<std::uint64_t> orbits;
  std::optional<std::uint64_t> valid_orbits;
  std::uint64_t costing;
};

inline constexpr std::array<ReferenceCount, 26> reference_counts = {{
    {"split k 3 a 1", 64, 44, 40, 27, 0},
    {"split k 4 a 1", 256, 160, 144, 88, 0},
    {"split k 4 a 2", 256, 160, 84, 55, 2},
    {"split k 5 a 1", 1024, 572, 544, 305, 0},
    {"split k 5 a 2", 1024, 572, 544, 305, 6},
    {"split k 6 a 1", 4096, 2040, 2112, 1050, 0},
    {"split k 6 a 2", 4096, 2040, 2112, 1064, 14},
    {"split k 6 a 3", 4096, 2040, 1104, 558, 19},
    {"split k 7 a 1", 16384, 7268, 8320, 3703, 0},
    {"split k 7 a 2", 16384, 7268, 8320, 3703, 40},
    {"split k 7 a 3", 16384, 7268, 8320, 3703, 44},
    {"split k 8 a 1", 65536, 25888, 33024, 13052, 0},
    {"split k 8 a 2", 65536, 25888, 33024, 13102, 102},
    {"split k 8 a 3", 65536, 25888, 33024, 13052, 118},
    {"split k 8 a 4", 65536, 25888, 16704, 6670, 110},
    {"collapse k 3 a 1", 512, 278, {}, {}, 0},
    {"collapse k 4 a 1", 2048, 998, {}, {}, 1},
    {"collapse k 4 a 2", 2048, 1016, {}, {}, 4},
    {"collapse k 5 a 1", 8192, 3562, {}, {}, 7},
    {"collapse k 5 a 2", 8192, 3640, {}, {}, 28},
    {"collapse k 6 a 1", 32768, 12694, {}, {}, 23},
    {"collapse k 6 a 2", 32768, 12988, {}, {}, 83},
    {"collapse k 6 a 3", 32768, 13032, {}, {}, 104},
    {"collapse k 7 a 1", 131072, 45218, {}, {}, 67},
    {"collapse k 7 a 2", 131072, 46280, {}, {}, 238},
    {"collapse k 7 a 3", 131072, 46492, {}, {}, 321},
}};

}  // namespace restrip::verify
