// What the certificates and the JSON of both automata are written with.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace restrip::generator {

/// The text of an automaton's certificate, with the number of its rows.
struct AutomatonCertificate {
  std::string text;
  std::size_t rows = 0;
};

/// Rows one after the other, counted.
class Rows {
 public:
  template <class... Words>
  void add(fmt::format_string<Words...> row, Words&&... words) {
    fmt::format_to(std::back_inserter(text_), row, std::forward<Words>(words)...);
    text_ += '\n';
    ++count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// The rows as a section of a certificate.
  [[nodiscard]] std::string section(std::string_view name) const {
    return fmt::format("section {}\nclaim rows {}\n{}", name, count_, text_);
  }

 private:
  std::string text_;
  std::size_t count_ = 0;
};

[[nodiscard]] inline std::string witness_text(const std::string& witness) { return witness.empty() ? "-" : witness; }

template <class Step>
[[nodiscard]] const Step& step_of(const std::optional<Step>& step) {
  return step.value();
}
template <class Step>
[[nodiscard]] const Step& step_of(const Step& step) {
  return step;
}

/// The colours of the links of a class's witness in its case k, from left to right. `letters` are those of the
/// automaton, by which the steps of its classes go; right_is_solid(k) tells whether the right link of a case is solid.
template <class Automaton, class Letters, class RightIsSolid>
[[nodiscard]] std::vector<bool> witness_links(const Automaton& automaton, const Letters& letters,
                                              const std::string& witness, unsigned k, RightIsSolid right_is_solid) {
  std::vector<decltype(step_of(automaton.classes[0].steps[0]).before)> before;
  std::size_t at = 0;
  for (const char name : witness) {
    const auto letter =
        std::find_if(letters.begin(), letters.end(), [name](const auto one) { return text_of(one) == name; });
    const auto& step = step_of(automaton.classes[at].steps[static_cast<std::size_t>(letter - letters.begin())]);
    before.push_back(step.before);
    at = step.to;
  }
  std::vector<bool> links{right_is_solid(k)};
  for (auto cases = before.rbegin(); cases != before.rend(); ++cases) {
    k = (*cases)[k];
    links.push_back(right_is_solid(k));
  }
  std::reverse(links.begin(), links.end());
  return links;
}

}  // namespace restrip::generator
