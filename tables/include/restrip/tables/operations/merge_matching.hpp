// A vertex with four triangles around it goes, where triangles are paired.
// Written by `restrip-generate rules` from the operation file of merge-matching. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint8_t, 16, 4, 2> merge_matching_rules{
    {{4, 4},
    {2, 1},
    4,
    true,
    {
    16, 1, 2, 1, 4, 5, 6, 5, 8, 9, 10, 10, 4, 5, 10, 5,
    }},
    5,
    {{
    {0, 0, {0, 1, 2}, {64, 0, 3}}, {0, 1, {2, 1, 3}, {0, 65, 1}}, {0, 2, {0, 2, 4}, {3, 2, 67}},
    {1, 2, {2, 3, 4}, {1, 66, 2}},
    }},
    {{
    {0, 0, {3, 0, 1}, {0, 64, 65}}, {0, 0, {0, 3, 4}, {0, 66, 67}},
    }},
};

}  // namespace restrip::tables
