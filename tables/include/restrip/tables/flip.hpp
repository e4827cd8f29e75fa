// Rules of the flip: 25 valid configurations.
// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target `regenerate`.
// Format 1, explained in restrip/tables/format.hpp.
#pragma once

#include "restrip/tables/format.hpp"

namespace restrip::tables {

inline constexpr FlipTable flip{
    16, 17, 18, 19, 20, 5, 20, 19, 24, 17, 10, 19, 28, 28, 28, 19, 16, 17, 18, 255, 20, 21, 6, 255, 24, 9, 26, 255, 255,
    255, 255, 255,
};

}  // namespace restrip::tables
