#include "automaton/arc.hpp"

#include <string_view>

namespace restrip::generator {
namespace {

constexpr bool turns_left(Letter letter) { return letter == Letter::left || letter == Letter::joined_left; }
constexpr bool turns_right(Letter letter) { return letter == Letter::right || letter == Letter::joined_right; }

/// A triangle alone: what it may do with its two links.
Costs costs_of(Letter letter, const Weights& weights) {
  Costs costs;
  if (has_port(letter)) {
    costs[both_dashed] = 0;
    costs[case_of(Reach::port, Reach::dashed)] = -weights.restart + (turns_left(letter) ? weights.swap : 0);
    costs[case_of(Reach::dashed, Reach::port)] = turns_right(letter) ? weights.swap : 0;
  } else {
    costs[both_dashed] = weights.isolated;
    costs[case_of(Reach::ends, Reach::dashed)] = -weights.restart;
    costs[case_of(Reach::dashed, Reach::ends)] = 0;
    costs[through_case] = -weights.restart;
  }
  return costs;
}

/// The reach of a strand that has passed one triangle more.
constexpr Reach one_further(Reach reach, const Weights& weights) {
  if (!tells_turns(weights)) return reach;
  if (reach == Reach::ends) return Reach::along_ends;
  return reach == Reach::port ? Reach::along_port : reach;
}

/// The case of an arc followed by a triangle; nothing where their links have different colours, or where two ports
/// would be joined that may not be.
std::optional<Case> followed(Case arc, Case triangle, Letter letter, const Weights& weights) {
  const Reach link = right_of(arc);
  const Reach from = left_of(triangle);
  if ((link == Reach::dashed) != (from == Reach::dashed)) return {};
  if (leads_to_port(link) && from == Reach::port && !is_joined(letter)) return {};
  if (link == Reach::through && from == Reach::through) return through_case;
  if (from == Reach::through) return case_of(left_of(arc), one_further(link, weights));
  if (link == Reach::through) return case_of(one_further(from, weights), right_of(triangle));
  return case_of(left_of(arc), right_of(triangle));
}

/// Whether a link between an arc and a triangle is a swap: the strip turns the same way on both sides.
constexpr bool is_swap(Reach link, Reach from) {
  return (link >= Reach::along_ends && from == Reach::through) || (link == Reach::port && from == Reach::port);
}

/// The tie-break among equal costs (docs/explanation/automaton.md, "Ties"): the reach of the link in front of the
/// triangle, by whether the triangle has a solid port; smaller is preferred. Found by trying all orders without turns:
/// these agree with the tables' rules most often.
unsigned rank(Case arc, Case triangle, Letter letter) {
  constexpr std::array<unsigned, 6> in_front_of_no_port{0, 1, 3, 1, 3, 2};
  constexpr std::array<unsigned, 6> in_front_of_port{2, 3, 0, 3, 0, 1};
  const auto link = static_cast<std::size_t>(right_of(arc));
  return 8 * (has_port(letter) ? in_front_of_port : in_front_of_no_port)[link] +
         static_cast<unsigned>(left_of(triangle));
}

Appended over_boundary(const Costs& arc) {
  Appended result;
  for (Case c = 0; c < case_codes; ++c) {
    if (right_is_solid(c)) continue;
    result.costs[c] = arc[c];
    result.before[c] = c;
  }
  return result;
}

/// What it costs at most to have reach `to` at a link in place of `from`.
std::optional<int> exchange_at(Reach from, Reach to, bool right, const Weights& weights) {
  if (from == to) return 0;
  if (from == Reach::dashed) return {};
  switch (to) {
    case Reach::dashed:
      // The arc counts its left link itself. The neighbour may be left without a solid edge.
      return (right ? weights.restart : 0) + weights.isolated;
    case Reach::ends:
      return 0;
    case Reach::along_ends:
      return from == Reach::ends || from == Reach::port ? weights.swap : 0;
    default:
      return {};
  }
}

/// What it costs at most, in any patch, to have the second case in place of the first; nothing where it may not be
/// possible.
std::optional<int> exchange(Case from, Case to, const Weights& weights) {
  if (to == through_case) return {};
  // A strand that goes through may be cut in two, which both continue along the fan.
  const auto reach_of = [](Reach reach) { return reach == Reach::through ? Reach::along_ends : reach; };
  const auto left = exchange_at(reach_of(left_of(from)), left_of(to), false, weights);
  const auto right = exchange_at(reach_of(right_of(from)), right_of(to), true, weights);
  if (!left || !right) return {};
  return *left + *right;
}

}  // namespace

std::vector<Case> cases_of(const Weights& weights) {
  std::vector<Case> cases;
  const auto is_plain = [](Reach reach) { return reach != Reach::along_ends && reach != Reach::along_port; };
  for (Case c = 0; c < case_codes; ++c)
    if (tells_turns(weights) || (is_plain(left_of(c)) && is_plain(right_of(c)))) cases.push_back(c);
  return cases;
}

std::string text_of(Case c) {
  constexpr std::string_view reach = "-epfqt";
  return {reach[static_cast<unsigned>(left_of(c))], reach[static_cast<unsigned>(right_of(c))]};
}

const std::vector<Letter>& letters_of(const Weights& weights) {
  static const std::vector<Letter> without_turns{Letter::dashed, Letter::ends, Letter::joined_ends, Letter::boundary};
  static const std::vector<Letter> with_turns{Letter::dashed,       Letter::ends,        Letter::left,
                                              Letter::right,        Letter::joined_ends, Letter::joined_left,
                                              Letter::joined_right, Letter::boundary};
  return tells_turns(weights) ? with_turns : without_turns;
}

char text_of(Letter letter) { return std::string_view("dslrSLRb")[static_cast<unsigned>(letter)]; }

Costs costs_of_empty_arc() {
  Costs costs;
  costs[both_dashed] = 0;
  costs[through_case] = 0;
  return costs;
}

Appended append_to_empty(Letter letter, const Weights& weights) {
  if (letter == Letter::boundary) return over_boundary(costs_of_empty_arc());
  Appended result{costs_of(letter, weights), {}};
  for (Case c = 0; c < case_codes; ++c) result.before[c] = left_of(c) == Reach::dashed ? both_dashed : through_case;
  return result;
}

Appended append(const Costs& arc, Letter letter, const Weights& weights) {
  if (letter == Letter::boundary) return over_boundary(arc);
  Appended result;
  std::array<unsigned, case_codes> best_rank{};
  const Costs triangle = costs_of(letter, weights);
  for (Case c = 0; c < case_codes; ++c) {
    if (!arc[c]) continue;
    for (Case t = 0; t < case_codes; ++t) {
      if (!triangle[t]) continue;
      const auto both = followed(c, t, letter, weights);
      if (!both) continue;
      const int cost = *arc[c] + *triangle[t] + (is_swap(right_of(c), left_of(t)) ? weights.swap : 0);
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

Costs without_dispensable(const Costs& costs, const Weights& weights) {
  Costs kept = costs;
  for (Case c = 0; c < case_codes; ++c)
    for (Case other = 0; kept[c] && other < case_codes; ++other) {
      if (other == c || !kept[other]) continue;
      const auto loss = exchange(c, other, weights);
      if (loss && *kept[other] + *loss <= *kept[c]) kept[c].reset();
    }
  return kept;
}

}  // namespace restrip::generator
