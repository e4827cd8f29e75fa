// A new vertex on an interior edge: the two triangles next to it become four.
// Written by `restrip-generate rules` from the operation file of bisect. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint16_t, 32, 2, 4> bisect_rules{
    {{2, 1},
    {4, 4},
    4,
    false,
    {
    112, 113, 210, 227, 212, 85, 86, 87, 120, 89, 90, 91, 188, 93, 94, 95, 112, 113, 210, 65535, 212, 85, 214, 65535,
    120, 121, 90, 65535, 65535, 65535, 65535, 65535,
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
