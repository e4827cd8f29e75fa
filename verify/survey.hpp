#pragma once
// What a colouring of a patch amounts to: its strips, found by walking them from end to end.

#include <cstdint>
#include <string>
#include <vector>

#include "patch.hpp"

namespace restrip::verify {

struct Survey {
  bool valid = false;         ///< degrees at most two and no strip closes; the rest means something only then
  std::uint8_t solid = 0;     ///< solid inner edges
  std::uint8_t isolated = 0;  ///< triangles without a solid edge, ports included
  PortPairs joined;           ///< pairs of ports at the two ends of one strip
};

/// The first reason why a colouring is not valid, in words; empty when it is valid.
std::string fault_of(const Patch& patch, Coloring colors);

/// Walks every strip once. Linear in the patch.
Survey survey(const Patch& patch, Coloring colors);

}  // namespace restrip::verify
