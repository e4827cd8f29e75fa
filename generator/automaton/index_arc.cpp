#include "automaton/index_arc.hpp"

#include <string_view>

namespace restrip::generator::indices {
namespace {

constexpr bool has_port(Letter letter) { return letter != Letter::dashed; }
constexpr bool joined(Letter letter) { return letter >= Letter::joined_ends; }
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
constexpr Reach one_further(Reach reach) {
  switch (reach) {
    case Reach::ends:
      return Reach::along_ends;
    case Reach::port:
      return Reach::along_port;
    default:
      return reach;
  }
}

/// The case of an arc followed by a triangle; nothing where their links have different colours, or where two ports
/// would be joined that may not be.
std::optional<Case> followed(Case arc, Case triangle, bool may_join) {
  const Reach link = right_of(arc);
  const Reach from = left_of(triangle);
  if ((link == Reach::dashed) != (from == Reach::dashed)) return {};
  if ((link == Reach::port || link == Reach::along_port) && from == Reach::port && !may_join) return {};
  if (link == Reach::through && from == Reach::through) return through_case;
  if (from == Reach::through) return case_of(left_of(arc), one_further(link));
  if (link == Reach::through) return case_of(one_further(from), right_of(triangle));
  return case_of(left_of(arc), right_of(triangle));
}

/// Whether a link between an arc and a triangle is a swap: the strip turns the same way on both sides.
constexpr bool is_swap(Reach link, Reach from) {
  return (link >= Reach::along_ends && from == Reach::through) || (link == Reach::port && from == Reach::port);
}

/// What it costs at most to have reach `to` at a link in place of `from`.
std::optional<int> exchange_at(Reach from, Reach to, bool right, const Weights& weights) {
  if (from == to) return 0;
  if (from == Reach::dashed || to == Reach::through) return {};
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

}  // namespace

std::string text_of(Case c) {
  constexpr std::string_view reach = "-epfqt";
  return {reach[static_cast<unsigned>(left_of(c))], reach[static_cast<unsigned>(right_of(c))]};
}

char text_of(Letter letter) { return std::string_view("dslrSLR")[static_cast<unsigned>(letter)]; }

Costs costs_of_empty_arc() {
  Costs costs;
  costs[both_dashed] = 0;
  costs[through_case] = 0;
  return costs;
}

Appended append_to_empty(Letter letter, const Weights& weights) {
  Appended result{costs_of(letter, weights), {}};
  for (Case c = 0; c < case_codes; ++c) result.before[c] = left_of(c) == Reach::dashed ? both_dashed : through_case;
  return result;
}

Appended append(const Costs& arc, Letter letter, const Weights& weights) {
  Appended result;
  const Costs triangle = costs_of(letter, weights);
  // Later cases have more solid links: among equals they are preferred.
  for (Case c = case_codes; c-- > 0;) {
    if (!arc[c]) continue;
    for (Case t = case_codes; t-- > 0;) {
      if (!triangle[t]) continue;
      const auto both = followed(c, t, joined(letter));
      if (!both) continue;
      const int cost = *arc[c] + *triangle[t] + (is_swap(right_of(c), left_of(t)) ? weights.swap : 0);
      std::optional<int>& best = result.costs[*both];
      if (best && cost >= *best) continue;
      best = cost;
      result.before[*both] = c;
    }
  }
  return result;
}

std::optional<int> exchange(Case from, Case to, const Weights& weights) {
  if (from == to) return 0;
  if (to == through_case) return {};
  // A strand that goes through may be cut in two, which both go on along the fan.
  const auto reach_of = [](Reach reach) { return reach == Reach::through ? Reach::along_ends : reach; };
  const auto left = exchange_at(reach_of(left_of(from)), left_of(to), false, weights);
  const auto right = exchange_at(reach_of(right_of(from)), right_of(to), true, weights);
  if (!left || !right) return {};
  return *left + *right;
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

}  // namespace restrip::generator::indices
