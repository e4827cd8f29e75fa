// A boundary vertex with two triangles goes: they become one.
// Written by `restrip-generate rules` from the operation file of merge-boundary. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint8_t, 8, 2, 1> merge_boundary_rules{
    {{2, 1},
    {1, 0},
    2,
    false,
    {
    0, 1, 2, 1, 0, 1, 2, 3,
    }},
    4,
    {{
    {0, 0, {0, 1, 2}, {255, 64, 0}}, {0, 2, {0, 2, 3}, {0, 65, 255}},
    }},
    {{
    {0, 0, {3, 1, 2}, {255, 64, 65}},
    }},
};

}  // namespace restrip::tables
