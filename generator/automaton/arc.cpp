#include "automaton/arc.hpp"

#include <string_view>

namespace restrip::generator {
namespace {

/// A letter alone: the possible colours of its two links.
Costs costs_of(Letter letter) {
  Costs costs;
  costs[both_dashed] = letter == Letter::dashed ? isolated_cost : 0;
  if (has_port(letter)) {
    costs[case_of(Reach::port, Reach::dashed)] = -strip_cost;
    costs[case_of(Reach::dashed, Reach::port)] = 0;
  }
  if (letter == Letter::dashed) {
    costs[case_of(Reach::ends, Reach::dashed)] = -strip_cost;
    costs[case_of(Reach::dashed, Reach::ends)] = 0;
    costs[through_case] = -strip_cost;
  }
  return costs;
}

/// The case of an arc followed by a letter; empty if their links have different colours, or if two ports would be
/// joined that must not be.
std::optional<Case> followed(Case arc, Case triangle, Letter letter) {
  const Reach link = right_of(arc);
  const Reach from = left_of(triangle);
  if ((link == Reach::dashed) != (from == Reach::dashed)) return {};
  if (link == Reach::port && from == Reach::port && letter != Letter::joined) return {};
  if (link == Reach::through && from == Reach::through) return through_case;
  if (from == Reach::through) return case_of(left_of(arc), link);
  if (link == Reach::through) return case_of(from, right_of(triangle));
  return case_of(left_of(arc), right_of(triangle));
}

/// The tie-break among equal costs (docs/explanation/automaton.md, "Ties"): the reach of the link in front of the
/// triangle, by whether the triangle has a solid port; smaller is preferred. Found by trying all orders: this one
/// agrees with the tables' rules most often.
unsigned rank(Case arc, Case triangle, Letter letter) {
  constexpr std::array<unsigned, 4> in_front_of_no_port{0, 1, 3, 2};
  constexpr std::array<unsigned, 4> in_front_of_port{2, 3, 0, 1};
  const auto link = static_cast<std::size_t>(right_of(arc));
  return 4 * (has_port(letter) ? in_front_of_port : in_front_of_no_port)[link] +
         static_cast<unsigned>(left_of(triangle));
}

}  // namespace

std::string text_of(Case c) {
  constexpr std::string_view reach = "-ept";
  return {reach[static_cast<unsigned>(left_of(c))], reach[static_cast<unsigned>(right_of(c))]};
}

char text_of(Letter letter) { return std::string_view("dsSb")[static_cast<unsigned>(letter)]; }

Appended append(const Costs& arc, Letter letter) {
  Appended result;
  std::array<unsigned, case_codes> best_rank{};
  const Costs triangle = costs_of(letter);
  for (Case c = 0; c < case_codes; ++c) {
    if (!arc[c]) continue;
    for (Case t = 0; t < case_codes; ++t) {
      if (!triangle[t]) continue;
      const auto both = followed(c, t, letter);
      if (!both) continue;
      const int cost = *arc[c] + *triangle[t];
      const unsigned own_rank = rank(c, t, letter);
      std::optional<int>& best = result.costs[*both];
      if (best && (cost > *best || (cost == *best && own_rank >= best_rank[*both]))) continue;
      best = cost;
      best_rank[*both] = own_rank;
      result.before[*both] = c;
    }
  }
  return result;
}

}  // namespace restrip::generator
