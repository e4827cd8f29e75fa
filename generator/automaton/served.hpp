// Custom families that the shipped automaton answers: docs/explanation/automaton.md, "Custom families".
#pragma once

#include <string>
#include <vector>

#include "operations/description.hpp"

namespace restrip::generator {

/// A header with the look-up of such a family, which uses restrip/rules/exact.hpp. Throws std::runtime_error with the
/// reason if the automaton does not answer the family.
[[nodiscard]] std::string served_header(const Description& family);

/// Writes the headers of all descriptions in these files, all at once, and reports on standard output.
void make_served_headers(const std::vector<std::string>& files, const std::string& out);

}  // namespace restrip::generator
