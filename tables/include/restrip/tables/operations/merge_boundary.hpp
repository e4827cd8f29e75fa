// A boundary vertex with two triangles goes: they become one.
// Written by `restrip-generate rules` from the operation file of merge-boundary. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr OperationTable<std::uint8_t, 8> merge_boundary{
    {2, 1},
    {1, 0},
    2,
    false,
    {
    0, 1, 2, 1, 0, 1, 2, 3,
    }};

}  // namespace restrip::tables
