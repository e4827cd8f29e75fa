#include "turn_arc.hpp"

#include <algorithm>

#include "automaton_mutants.hpp"

namespace restrip::verify {
namespace {

/// An arc with corners in one colouring: triangle i has the corners hub, rim i and rim i + 1; link j is the edge from
/// the hub to rim j, and triangle i's port the edge from rim i to rim i + 1.
class TurningArc {
 public:
  TurningArc(std::string_view word, Mask links) : word_(word), links_(links) {}

  bool degrees_legal() const {
    for (std::size_t i = 0; i < word_.size(); ++i)
      if (degree(i) > 2) return false;
    return true;
  }

  /// From port to port, along the links to the right.
  bool joins_only_what_it_may() const {
    for (std::size_t i = 0; i < word_.size(); ++i) {
      if (!turn_port(word_[i])) continue;
      for (std::size_t at = i; at + 1 < word_.size() && solid(at + 1);) {
        ++at;
        if (!turn_port(word_[at])) continue;
        if (!turn_joined(word_[at])) return false;
        break;
      }
    }
    return true;
  }

  int cost(const TurnWeights& weights) const {
    int cost = 0;
    for (std::size_t i = 0; i < word_.size(); ++i) {
      if (solid(i)) cost -= weights.restart;
      if (degree(i) == 0) cost += weights.isolated;
      const int corner = passed_about(i);
      if (corner == nowhere) continue;
      if (i > 0 && solid(i) && passed_about(i - 1) == corner) cost += weights.swap;
      if (mutated(AutomatonMutant::turns_no_swap_at_ports)) continue;
      if (turn_port(word_[i]) && behind_port(i) == corner) cost += weights.swap;
    }
    return cost;
  }

  Case arc_case() const {
    return {solid(0) ? reach(0, true) : '-', solid(word_.size()) ? reach(word_.size() - 1, false) : '-'};
  }

 private:
  static constexpr int nowhere = -2;
  static constexpr int hub = -1;

  bool solid(std::size_t link) const { return is_solid(links_, static_cast<unsigned>(link)); }
  int degree(std::size_t i) const {
    return (solid(i) ? 1 : 0) + (solid(i + 1) ? 1 : 0) + (turn_port(word_[i]) ? 1 : 0);
  }

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

  /// Of the strand that enters triangle `at` over a link, from the left or from the right.
  char reach(std::size_t at, bool rightwards) const {
    if (turn_port(word_[at])) return 'p';
    if (!solid(rightwards ? at + 1 : at)) return 'e';
    while (true) {
      if (rightwards ? at + 1 == word_.size() : at == 0) return 't';
      at = rightwards ? at + 1 : at - 1;
      if (turn_port(word_[at])) return 'q';
      if (!solid(rightwards ? at + 1 : at)) return 'f';
    }
  }

  std::string_view word_;
  Mask links_;
};

}  // namespace

std::optional<std::size_t> turn_number(Case c) {
  for (std::size_t number = 0; number < turn_cases; ++number)
    if (turn_case(number) == c) return number;
  return {};
}

Case without_turns(Case c) {
  const auto plain = [](char reach) { return reach == 'f' ? 'e' : reach == 'q' ? 'p' : reach; };
  return {plain(c.left), plain(c.right)};
}

int least_of(const TurnCosts& costs) {
  std::optional<int> least;
  for (const auto& cost : costs)
    if (cost && (!least || *cost < *least)) least = cost;
  return least.value();
}

TurnColoring turn_coloring(std::string_view word, Mask links, const TurnWeights& weights) {
  const TurningArc arc(word, links);
  return {arc.degrees_legal() && arc.joins_only_what_it_may(), turn_number(arc.arc_case()).value(), arc.cost(weights)};
}

TurnCorner corner_at_link(char reach) {
  switch (reach) {
    case 'p':
      return TurnCorner::rim;
    case 'f':
    case 'q':
    case 't':
      return TurnCorner::hub;
    default:
      return TurnCorner::none;
  }
}

}  // namespace restrip::verify
