// A new vertex on a boundary edge: the triangle next to it becomes two.
// Written by `restrip-generate rules` from the operation file of bisect-boundary. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint8_t, 4, 1, 2> bisect_boundary_rules{
    {{1, 0},
    {2, 1},
    2,
    false,
    {
    4, 5, 6, 7,
    }},
    4,
    {{
    {0, 0, {0, 1, 2}, {255, 64, 65}},
    }},
    {{
    {0, 0, {3, 1, 2}, {255, 64, 0}}, {0, 2, {3, 2, 0}, {0, 65, 255}},
    }},
};

}  // namespace restrip::tables
