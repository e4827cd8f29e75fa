#include "automaton/arc.hpp"

namespace restrip::verify {
namespace {

/// An arc in one colouring: link j lies to the left of triangle j.
class ColoredArc {
 public:
  ColoredArc(std::string_view word, Mask links) : word_(word), links_(links) {}

  bool degrees_legal() const {
    for (std::size_t i = 0; i < word_.size(); ++i)
      if (degree(i) > (is_boundary(word_[i]) ? 0 : 2)) return false;
    return true;
  }

  /// Follows strands from port to port, along the links to the right.
  bool joins_only_what_it_may() const {
    for (std::size_t i = 0; i < word_.size(); ++i) {
      if (!has_port(word_[i])) continue;
      for (std::size_t at = i; at + 1 < word_.size() && solid(at + 1);) {
        ++at;
        if (!has_port(word_[at])) continue;
        if (!is_joined(word_[at])) return false;
        break;
      }
    }
    return true;
  }

  int cost() const {
    int cost = 0;
    for (std::size_t i = 0; i < word_.size(); ++i) {
      if (solid(i)) cost -= strip_cost;
      if (degree(i) == 0 && !is_boundary(word_[i])) cost += isolated_cost;
    }
    return cost;
  }

  Case arc_case() const {
    if (!solid(0) && !solid(word_.size())) return {'-', '-'};
    return {solid(0) ? reach(0, true) : '-', solid(word_.size()) ? reach(word_.size() - 1, false) : '-'};
  }

 private:
  bool solid(std::size_t link) const { return is_solid(links_, static_cast<unsigned>(link)); }
  int degree(std::size_t i) const { return (solid(i) ? 1 : 0) + (solid(i + 1) ? 1 : 0) + (has_port(word_[i]) ? 1 : 0); }

  /// The reach of the strand that enters triangle `at` over a link, from the left or from the right.
  char reach(std::size_t at, bool rightwards) const {
    for (;;) {
      if (has_port(word_[at])) return 'p';
      if (!solid(rightwards ? at + 1 : at)) return 'e';
      if (rightwards ? at + 1 == word_.size() : at == 0) return 't';
      at = rightwards ? at + 1 : at - 1;
    }
  }

  std::string_view word_;
  Mask links_;
};

}  // namespace

std::optional<std::size_t> number_of(Case c) {
  if (c == Case{'t', 't'}) return through;
  const std::size_t left = reaches.find(c.left);
  const std::size_t right = reaches.find(c.right);
  if (left == std::string_view::npos || right == std::string_view::npos) return {};
  return reaches.size() * left + right;
}

std::string ports_in(std::string_view word) {
  std::string ports;
  for (const char letter : word)
    if (has_port(letter)) ports += letter;
  return ports;
}

std::string end_ports(std::string_view word) {
  const std::string ports = ports_in(word);
  return ports.size() < 3 ? ports : ports.substr(0, 1) + "..";
}

int least_of(const Costs& costs) {
  std::optional<int> least;
  for (const auto& cost : costs)
    if (cost && (!least || *cost < *least)) least = cost;
  return least.value();
}

Costs shifted(Costs costs, int by) {
  for (auto& cost : costs)
    if (cost) *cost += by;
  return costs;
}

ArcColoring arc_coloring(std::string_view word, Mask links) {
  const ColoredArc arc(word, links);
  if (!arc.degrees_legal() || !arc.joins_only_what_it_may()) return {};
  return {true, number_of(arc.arc_case()).value(), arc.cost()};
}

}  // namespace restrip::verify
