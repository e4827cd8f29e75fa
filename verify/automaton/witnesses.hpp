#pragma once
// The witness of a class is the first of its shortest arcs: found anew from the steps, breadth first.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace restrip::verify {

/// The class behind class `c` and a letter; none where no step has that letter.
using StepTo = std::function<std::optional<std::size_t>(std::size_t c, std::size_t letter)>;

/// The first of the shortest arcs of each class; none for a class that no arc leads to.
std::vector<std::optional<std::string>> shortest_arcs(std::size_t classes, std::string_view letters,
                                                      const StepTo& step_to);

/// What is wrong with the witness that is stated for class `c`; empty if nothing is.
std::string witness_fault(std::size_t c, const std::string& stated, const std::optional<std::string>& shortest);

}  // namespace restrip::verify
