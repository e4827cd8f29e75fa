// A vertex with three triangles around it goes: three triangles become one.
// Written by `restrip-generate rules` from the operation file of join-faces. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint8_t, 64, 3, 1> join_faces_rules{
    {{3, 3},
    {1, 0},
    3,
    false,
    {
    0, 1, 2, 1, 4, 1, 2, 1, 0, 1, 2, 3, 4, 1, 2, 3, 0, 1, 2, 1, 4, 1, 6, 6, 0, 1, 255, 255, 4, 5, 255, 255, 0, 1, 2, 1,
    4, 5, 2, 5, 0, 255, 2, 255, 4, 255, 6, 255, 0, 1, 2, 3, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255,
    }},
    4,
    {{
    {0, 0, {0, 1, 2}, {2, 64, 0}}, {0, 0, {1, 0, 3}, {2, 1, 66}}, {0, 2, {0, 2, 3}, {0, 65, 1}},
    }},
    {{
    {0, 0, {1, 2, 3}, {64, 65, 66}},
    }},
};

}  // namespace restrip::tables
