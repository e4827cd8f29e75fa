#include "arc.hpp"

#include <algorithm>

#include "automaton_mutants.hpp"

namespace restrip::verify {
namespace {

/// An arc in one colouring.
class ColoredArc {
 public:
  ColoredArc(std::string_view word, Mask links) : word_(word), links_(links) {}

  bool legal() const {
    for (std::size_t i = 0; i < word_.size(); ++i)
      if (degree(i) > (word_[i] == 'b' ? 0 : 2) && !mutated(AutomatonMutant::automaton_loosen_degree)) return false;
    return joins_only_what_it_may();
  }

  Case arc_case() const {
    if (!solid(0) && !solid(word_.size())) return {'-', '-'};
    return {solid(0) ? reach_from_left() : '-', solid(word_.size()) ? reach_from_right() : '-'};
  }

  Worth worth() const {
    Worth worth;
    for (std::size_t i = 0; i < word_.size(); ++i) {
      worth.solid += solid(i) ? 1 : 0;
      worth.fewer_isolated -= word_[i] != 'b' && degree(i) == 0 ? 1 : 0;
    }
    return worth;
  }

 private:
  bool solid(std::size_t link) const { return is_solid(links_, static_cast<unsigned>(link)); }
  bool port(std::size_t i) const { return word_[i] == 's' || word_[i] == 'j'; }
  int degree(std::size_t i) const { return (solid(i) ? 1 : 0) + (solid(i + 1) ? 1 : 0) + (port(i) ? 1 : 0); }

  /// From port to port, along the links to the right.
  bool joins_only_what_it_may() const {
    for (std::size_t i = 0; i < word_.size(); ++i) {
      if (!port(i)) continue;
      std::size_t at = i;
      while (at < word_.size() && solid(at + 1)) {
        ++at;
        if (at == word_.size()) break;
        if (port(at)) {
          if (word_[at] != 'j') return false;
          break;
        }
      }
    }
    return true;
  }

  char reach_from_left() const {
    std::size_t at = 0;
    while (at < word_.size() && !port(at) && solid(at + 1)) ++at;
    if (at == word_.size()) return 't';
    return port(at) ? 'p' : 'e';
  }

  char reach_from_right() const {
    std::size_t at = word_.size();
    while (at > 0 && !port(at - 1) && solid(at - 1)) --at;
    if (at == 0) return 't';
    return port(at - 1) ? 'p' : 'e';
  }

  std::string_view word_;
  Mask links_;
};

void keep_better(std::optional<Worth>& best, Worth worth) {
  if (!best || *best < worth) best = worth;
}

}  // namespace

std::optional<std::size_t> number_of(Case c) {
  const auto* const found = std::find(all_cases.begin(), all_cases.end(), c);
  if (found == all_cases.end()) return {};
  return static_cast<std::size_t>(found - all_cases.begin());
}

Worth best_of(const Worths& worths) {
  std::optional<Worth> best;
  for (const auto& worth : worths)
    if (worth) keep_better(best, *worth);
  return best.value();
}

void for_each_coloring(std::string_view word, const std::function<void(const ArcColoring&)>& visit) {
  const Mask end = mask_count(static_cast<unsigned>(word.size()) + 1);
  for (Mask links = 0; links < end; ++links) {
    const ColoredArc arc(word, links);
    if (!arc.legal()) continue;
    visit({links, number_of(arc.arc_case()).value(), arc.worth()});
  }
}

Worths worths_of(std::string_view word) {
  Worths worths;
  for_each_coloring(word, [&](const ArcColoring& c) { keep_better(worths[c.arc_case], c.worth); });
  return worths;
}

Origins origins_of(std::string_view word) {
  Origins origins;
  std::array<Worths, all_cases.size()> by_origin;  // by case, then by the case before
  const std::string_view shorter = word.substr(0, word.size() - 1);
  const Mask kept = mask_count(static_cast<unsigned>(word.size())) - 1;
  for_each_coloring(word, [&](const ArcColoring& c) {
    const ColoredArc before(shorter, c.links & kept);
    keep_better(by_origin[c.arc_case][number_of(before.arc_case()).value()], c.worth);
  });
  for (std::size_t c = 0; c < all_cases.size(); ++c) {
    for (const auto& worth : by_origin[c])
      if (worth) keep_better(origins.worths[c], *worth);
    for (unsigned before = 0; before < all_cases.size(); ++before)
      if (by_origin[c][before] && by_origin[c][before] == origins.worths[c]) origins.from[c] |= single(before);
  }
  return origins;
}

}  // namespace restrip::verify
