// The exceptions for colourings that turn out not to be valid while they are read.
#pragma once

#include <stdexcept>

#include "restrip/precondition.hpp"

namespace restrip::detail {

[[noreturn]] inline void throw_three_solid_edges() {
  RESTRIP_THROW(std::invalid_argument, "restrip: the colouring is not valid: a triangle has three solid dual edges");
}
[[noreturn]] inline void throw_solid_cycle() {
  RESTRIP_THROW(std::invalid_argument, "restrip: the colouring is not valid: solid dual edges close a cycle");
}

}  // namespace restrip::detail
