// The flip of an edge, where triangles are paired.
// Written by `restrip-generate rules` from the operation file of flip-matching. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint8_t, 16, 2, 2> flip_matching_rules{
    {{2, 1},
    {2, 1},
    4,
    true,
    {
    16, 1, 2, 255, 4, 5, 2, 255, 8, 1, 10, 255, 255, 255, 255, 255,
    }},
    4,
    {{
    {0, 0, {0, 1, 2}, {0, 64, 65}}, {0, 0, {1, 0, 3}, {0, 66, 67}},
    }},
    {{
    {0, 0, {2, 0, 3}, {65, 66, 0}}, {0, 2, {2, 3, 1}, {0, 67, 64}},
    }},
};

}  // namespace restrip::tables
