// Custom families that the shipped automaton answers: docs/explanation/automaton.md, "Custom families".
#pragma once

#include <string>

#include "describe/description.hpp"

namespace restrip::generator {

/// A header with the look-up of such a family, which uses restrip/rules/exact.hpp. Throws std::runtime_error with the
/// reason if the automaton does not answer the family.
[[nodiscard]] std::string served_header(const Description& family);

}  // namespace restrip::generator
