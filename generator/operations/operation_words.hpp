// The words of operation files for the types of operation.hpp.
#pragma once

#include <array>
#include <string_view>

#include "operations/operation.hpp"

namespace restrip::generator {

/// By the maximum of solid edges at a triangle, from one.
inline constexpr std::array<std::string_view, 3> constraint_words{"matching", "strips", "forest"};

struct CountWord {
  std::string_view word;
  Count count;
  std::string_view among = {};  ///< what it can choose among: "edge", "triangle" or "port"; the member's name has an s
};

/// Every count that a file can name.
inline constexpr std::array<CountWord, 10> count_words{{{"strips", Count::strips},
                                                        {"isolated", Count::isolated},
                                                        {"given_up", Count::given_up},
                                                        {"kept", Count::kept, "port"},
                                                        {"joined", Count::joined},
                                                        {"solid", Count::solid, "edge"},
                                                        {"ends", Count::ends, "triangle"},
                                                        {"ends_at_port", Count::ends_at_port, "triangle"},
                                                        {"neighbouring_ends", Count::neighbouring_ends},
                                                        {"squares", Count::squares}}};

/// The number of members to choose among.
[[nodiscard]] inline std::size_t how_many(std::string_view among, const Side& after) {
  return among == "edge" ? after.edges.size() : among == "triangle" ? after.nodes : among == "port" ? after.ports() : 0;
}

}  // namespace restrip::generator
