// The words of operation files for the types of operation.hpp.
#pragma once

#include <array>
#include <string_view>

#include "operations/operation.hpp"

namespace restrip::generator {

/// By the maximum of solid edges at a triangle, from one.
inline constexpr std::array<std::string_view, 3> constraint_words{"matching", "strips", "forest"};

/// Every count, in the order of Count.
inline constexpr std::array<std::string_view, 10> count_words{
    "strips", "isolated",     "given_up",          "kept",   "joined", "solid",
    "ends",   "ends_at_port", "neighbouring_ends", "squares"};

/// What each count can choose among: "edge", "triangle" or "port"; the member's name has an s.
inline constexpr std::array<std::string_view, 10> count_among{"",     "",         "",         "port", "",
                                                              "edge", "triangle", "triangle", "",     ""};

/// The number of members to choose among.
[[nodiscard]] inline std::size_t how_many(std::string_view among, const Side& after) {
  return among == "edge" ? after.edges.size() : among == "triangle" ? after.nodes : among == "port" ? after.ports() : 0;
}

}  // namespace restrip::generator
