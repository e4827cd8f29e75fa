#include "automaton/arc.hpp"

namespace restrip::verify {
namespace {

/// An arc with corners in one colouring: triangle i has the corners hub, rim i and rim i + 1; link j is the edge from
/// the hub to rim j, and triangle i's port the edge from rim i to rim i + 1.
class TurningArc {
 public:
  TurningArc(std::string_view word, Mask links) : word_(word), links_(links) {}

  bool degrees_legal() const {
    for (std::size_t i = 0; i < word_.size(); ++i)
      if (degree(i) > (is_boundary(word_[i]) ? 0 : 2)) return false;
    return true;
  }

  /// From port to port, along the links to the right.
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

  int cost(const Weights& weights) const {
    int cost = 0;
    for (std::size_t i = 0; i < word_.size(); ++i) {
      if (solid(i)) cost -= weights.restart;
      if (degree(i) == 0 && !is_boundary(word_[i])) cost += weights.isolated;
      const int corner = passed_about(i);
      if (corner == nowhere) continue;
      if (i > 0 && solid(i) && passed_about(i - 1) == corner) cost += weights.swap;
      if (has_port(word_[i]) && behind_port(i) == corner) cost += weights.swap;
    }
    return cost;
  }

  Case arc_case() const {
    if (!solid(0) && !solid(word_.size())) return {'-', '-'};
    return {solid(0) ? reach(0, true) : '-', solid(word_.size()) ? reach(word_.size() - 1, false) : '-'};
  }

 private:
  static constexpr int nowhere = -2;
  static constexpr int hub = -1;

  bool solid(std::size_t link) const { return is_solid(links_, static_cast<unsigned>(link)); }
  int degree(std::size_t i) const { return (solid(i) ? 1 : 0) + (solid(i + 1) ? 1 : 0) + (has_port(word_[i]) ? 1 : 0); }

  int passed_about(std::size_t i) const {
    if (degree(i) != 2) return nowhere;
    if (solid(i) && solid(i + 1)) return hub;
    return static_cast<int>(solid(i) ? i : i + 1);
  }

  int behind_port(std::size_t i) const {
    switch (word_[i]) {
      case 'l':
      case 'L':
        return static_cast<int>(i);
      case 'r':
      case 'R':
        return static_cast<int>(i + 1);
      default:
        return nowhere - 1;
    }
  }

  /// The reach of the strand that enters triangle `at` over a link, from the left or from the right.
  char reach(std::size_t at, bool rightwards) const {
    if (has_port(word_[at])) return 'p';
    if (!solid(rightwards ? at + 1 : at)) return 'e';
    for (;;) {
      if (rightwards ? at + 1 == word_.size() : at == 0) return 't';
      at = rightwards ? at + 1 : at - 1;
      if (has_port(word_[at])) return 'q';
      if (!solid(rightwards ? at + 1 : at)) return 'f';
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
    if (has_port(letter)) ports += is_joined(letter) ? 'S' : 's';
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

ArcColoring arc_coloring(std::string_view word, Mask links, const Weights& weights) {
  const TurningArc arc(word, links);
  if (!arc.degrees_legal() || !arc.joins_only_what_it_may()) return {};
  const auto told = [&](char reach) {
    if (weights.tells_turns()) return reach;
    return reach == 'f' ? 'e' : reach == 'q' ? 'p' : reach;
  };
  const Case c = arc.arc_case();
  return {true, number_of({told(c.left), told(c.right)}).value(), arc.cost(weights)};
}

ArcCorner corner_at_link(char reach) {
  switch (reach) {
    case 'p':
      return ArcCorner::rim;
    case 'f':
    case 'q':
    case 't':
      return ArcCorner::hub;
    default:
      return ArcCorner::none;
  }
}

}  // namespace restrip::verify
