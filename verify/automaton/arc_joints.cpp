#include "automaton/arc_joints.hpp"

#include <fmt/format.h>

namespace restrip::verify {

ArcJoints::ArcJoints(std::size_t longest) : joints_(2 * case_count * case_count) {
  std::vector<std::string> words{""};
  for (std::size_t length = 1; length <= longest; ++length) {
    std::vector<std::string> longer;
    for (const std::string& word : words)
      for (const char letter : letters)
        if (!is_boundary(letter) || !has_boundary(word)) longer.push_back(word + letter);
    words = std::move(longer);
    if (length < 2) continue;
    for (const std::string& word : words)
      for (Mask links = 0; links < mask_count(static_cast<unsigned>(length) + 1); ++links)
        observe(word, links, length < longest);
  }
}

void ArcJoints::observe(const std::string& word, Mask links, bool may_be_new) {
  const auto last = static_cast<unsigned>(word.size() - 1);
  const std::string_view before = std::string_view(word).substr(0, last);
  const std::string_view letter = std::string_view(word).substr(last);
  const ArcColoring alone = arc_coloring(letter, high_part(links, last));
  if (!alone.sound) return;
  const ArcColoring arc = arc_coloring(before, low_part(links, last + 1));
  if (!arc.sound) return;
  ++colorings_;
  const ArcColoring whole = arc_coloring(word, links);
  const ArcJoint seen = whole.sound ? ArcJoint{true, whole.arc_case} : ArcJoint{};
  std::optional<ArcJoint>& known = joints_[place(arc.arc_case, alone.arc_case, letter[0])];
  const auto fail = [&](const char* what) {
    failures_.add(fmt::format("the arc {} with the links {:x}: {}", word, links, what));
  };
  if (whole.sound && whole.cost != arc.cost + alone.cost) fail("its cost is not the sum of its parts' costs");
  if (known && *known != seen) fail("the cases of its parts do not determine the case of the whole");
  if (!known && !may_be_new) fail("it has cases that shorter arcs do not have");
  known = seen;
}

}  // namespace restrip::verify
