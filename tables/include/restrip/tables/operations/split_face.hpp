// A new vertex inside a triangle: one triangle becomes three.
// Written by `restrip-generate rules` from the operation file of split-face. Do not edit.
// Explained in restrip/tables/operation_format.hpp.
#pragma once

#include "restrip/tables/operation_format.hpp"

namespace restrip::tables {

inline constexpr OperationTable<std::uint8_t, 8> split_face{
    {1, 0},
    {3, 3},
    3,
    false,
    {
    24, 25, 42, 51, 44, 29, 46, 255,
    }};

}  // namespace restrip::tables
