// A new vertex on an interior edge: the two triangles beside it become four.
// Written by `restrip-generate rules` from the operation file of bisect. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr OperationTable<std::uint16_t, 32> bisect{
    {2, 1},
    {4, 4},
    4,
    false,
    {
    112, 113, 210, 227, 212, 85, 86, 87, 120, 89, 90, 91, 188, 93, 94, 95, 112, 113, 210, 65535, 212, 85, 214, 65535,
    120, 121, 90, 65535, 65535, 65535, 65535, 65535,
    }};

}  // namespace restrip::tables
