// A new vertex on an interior edge, where triangles are paired.
// Written by `restrip-generate rules` from the operation file of bisect-matching. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr OperationTable<std::uint16_t, 16> bisect_matching{
    {2, 1},
    {4, 4},
    4,
    true,
    {
    80, 33, 130, 65535, 132, 5, 134, 65535, 40, 41, 10, 65535, 65535, 65535, 65535, 65535,
    }};

}  // namespace restrip::tables
