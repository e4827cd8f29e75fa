#include "automaton/witnesses.hpp"

#include <fmt/format.h>

#include <deque>

namespace restrip::verify {

std::vector<std::optional<std::string>> shortest_arcs(std::size_t classes, std::string_view letters,
                                                      const StepTo& step_to) {
  std::vector<std::optional<std::string>> shortest(classes);
  std::deque<std::size_t> waiting{0};
  shortest[0] = "";
  while (!waiting.empty()) {
    const std::size_t c = waiting.front();
    waiting.pop_front();
    for (std::size_t letter = 0; letter < letters.size(); ++letter) {
      const std::optional<std::size_t> to = step_to(c, letter);
      if (!to || shortest[*to]) continue;
      shortest[*to] = *shortest[c] + letters[letter];
      waiting.push_back(*to);
    }
  }
  return shortest;
}

std::string witness_fault(std::size_t c, const std::string& stated, const std::optional<std::string>& shortest) {
  if (!shortest) return fmt::format("wrong witness: no arc leads to class {}", c);
  if (*shortest == stated) return {};
  return fmt::format("wrong witness: {} for class {}, the shortest is {}", stated, c, *shortest);
}

}  // namespace restrip::verify
