// A new vertex on an interior edge, where triangles are paired.
// Written by `restrip-generate rules` from the operation file of bisect-matching. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint16_t, 16, 2, 4> bisect_matching_rules{
    {{2, 1},
    {4, 4},
    4,
    true,
    {
    80, 33, 130, 65535, 132, 5, 134, 65535, 40, 41, 10, 65535, 65535, 65535, 65535, 65535,
    }},
    5,
    {{
    {0, 0, {0, 1, 2}, {0, 64, 65}}, {0, 0, {1, 0, 3}, {0, 66, 67}},
    }},
    {{
    {0, 0, {1, 2, 4}, {64, 0, 3}}, {0, 1, {4, 2, 0}, {0, 65, 1}}, {0, 2, {1, 4, 3}, {3, 2, 67}},
    {1, 2, {4, 0, 3}, {1, 66, 2}},
    }},
};

}  // namespace restrip::tables
