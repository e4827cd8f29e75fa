// A new vertex inside a triangle: one triangle becomes three.
// Written by `restrip-generate rules` from the operation file of split-face. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr SurfaceOperation<std::uint8_t, 8, 1, 3> split_face_rules{
    {{1, 0},
    {3, 3},
    3,
    false,
    {
    24, 25, 42, 51, 44, 29, 46, 255,
    }},
    4,
    {{
    {0, 0, {0, 1, 2}, {64, 65, 66}},
    }},
    {{
    {0, 0, {0, 1, 3}, {64, 0, 2}}, {0, 1, {3, 1, 2}, {0, 65, 1}}, {0, 2, {0, 3, 2}, {2, 1, 66}},
    }},
};

}  // namespace restrip::tables
