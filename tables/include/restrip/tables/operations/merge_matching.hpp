// A vertex with four triangles around it goes, where triangles are paired.
// Written by `restrip-generate rules` from the operation file of merge-matching. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr OperationTable<std::uint8_t, 16> merge_matching{
    {4, 4},
    {2, 1},
    4,
    true,
    {
    16, 1, 2, 1, 4, 5, 6, 5, 8, 9, 10, 10, 4, 5, 10, 5,
    }};

}  // namespace restrip::tables
