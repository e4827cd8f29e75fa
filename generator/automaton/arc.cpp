#include "automaton/arc.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

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

namespace {

/// The four ends of two arcs in ring order; A lies between second_last and first_first, D between the other two.
enum End : unsigned { first_first, first_last, second_first, second_last, ends, at_a = ends, at_d };

/// A pair of ends as one of six bits.
constexpr unsigned end_pair(unsigned x, unsigned y) {
  if (x > y) std::swap(x, y);
  constexpr std::array<unsigned, 3> pairs_before{0, 3, 5};
  return 1U << (pairs_before.at(x) + y - x - 1);
}

constexpr bool is_solid(Reach reach) { return reach != Reach::dashed; }

/// The pairs of ends that reach ports joined by the key.
unsigned joined_ends(const Ports& first, const Ports& second) {
  unsigned pairs = 0;
  const auto add = [&](unsigned x, unsigned y) {
    // The two end ports of an arc with one port are the same.
    const auto ways_to = [&](unsigned end) { return (end < second_first ? first : second).count == 1 ? 2U : 1U; };
    for (unsigned u = 0; u < ways_to(x); ++u)
      for (unsigned v = 0; v < ways_to(y); ++v) pairs |= end_pair(x ^ u, y ^ v);
  };
  if (first.two_joined) add(first_first, first_last);
  if (second.two_joined) add(second_first, second_last);
  if (first.count > 0 && second.count > 0) {
    if (first.first_joined) add(second_last, first_first);
    if (second.first_joined) add(first_last, second_first);
  } else {
    if (first.count > 1 && first.first_joined) add(first_last, first_first);
    if (second.count > 1 && second.first_joined) add(second_last, second_first);
  }
  return pairs;
}

}  // namespace

Ports with_letter(Ports ports, Letter letter) {
  if (!has_port(letter)) return ports;
  if (ports.count == 0) ports.first_joined = letter == Letter::joined;
  ports.two_joined = ports.count == 1 && letter == Letter::joined;
  ports.count = std::min(ports.count + 1, 3U);
  return ports;
}

std::optional<Meetings::Combination> Meetings::combination_of(const Meeting& meeting) {
  const std::array<Reach, ends> reach{left_of(meeting.first), right_of(meeting.first), left_of(meeting.second),
                                      right_of(meeting.second)};
  const auto solid = [&](End end) { return is_solid(reach.at(end)) ? 1 : 0; };
  const int chord = meeting.chord ? 1 : 0;
  const int degree_a = solid(first_first) + solid(second_last) + chord;
  const int degree_d = solid(first_last) + solid(second_first) + chord;
  if (degree_a > 2 || degree_d > 2) return {};
  // Labels of the connected components of ends, A and D under solid edges.
  std::array<unsigned, ends + 2> strand{};
  std::iota(strand.begin(), strand.end(), 0U);
  const auto joins = [&](bool solid_edge, unsigned x, unsigned y) {
    const unsigned from = strand.at(x);
    const unsigned to = strand.at(y);
    if (solid_edge) std::replace(strand.begin(), strand.end(), from, to);
    return !solid_edge || from != to;
  };
  const bool no_cycle = joins(meeting.first == through_case, first_first, first_last) &&
                        joins(meeting.second == through_case, second_first, second_last) &&
                        joins(solid(first_first) != 0, at_a, first_first) &&
                        joins(solid(first_last) != 0, at_d, first_last) &&
                        joins(solid(second_first) != 0, at_d, second_first) &&
                        joins(solid(second_last) != 0, at_a, second_last) && joins(meeting.chord, at_a, at_d);
  if (!no_cycle) return {};
  Combination combination;
  combination.meeting = meeting;
  int joined = 0;
  for (unsigned x = first_first; x < second_last; ++x)
    for (unsigned y = x + 1; y < ends; ++y)
      if (reach.at(x) == Reach::port && reach.at(y) == Reach::port && strand.at(x) == strand.at(y)) {
        combination.joins |= end_pair(x, y);
        ++joined;
      }
  const int isolated = (degree_a == 0 ? 1 : 0) + (degree_d == 0 ? 1 : 0);
  combination.cost = isolated_cost * isolated - strip_cost * (solid(first_last) + solid(second_last) + chord);
  // The tie-break (docs/explanation/automaton.md, "Ties"): the part of the tables' tie-break (tie_break()) that can
  // be evaluated here.
  combination.tie = 64 * (chord + degree_a + degree_d) + 100 * ((degree_a == 1 ? 1 : 0) + (degree_d == 1 ? 1 : 0)) -
                    49 * joined - 53 * static_cast<int>(std::count(reach.begin(), reach.end(), Reach::ends));
  return combination;
}

Meetings::Meetings() {
  for (const Case first : all_cases)
    for (const Case second : all_cases)
      for (const bool chord : {false, true})
        if (const auto combination = combination_of({first, second, chord})) combinations_.push_back(*combination);
  std::stable_sort(combinations_.begin(), combinations_.end(),
                   [](const Combination& x, const Combination& y) { return x.tie < y.tie; });
}

std::size_t Meetings::best(const Arc& first, const Arc& second) const {
  const unsigned joined = joined_ends(first.ports, second.ports);
  std::optional<std::pair<int, std::size_t>> best;  // cost, number
  for (std::size_t number = 0; number < combinations_.size(); ++number) {
    const Combination& combination = combinations_[number];
    const std::optional<int>& one = first.costs[combination.meeting.first];
    const std::optional<int>& other = second.costs[combination.meeting.second];
    if (!one || !other || (combination.joins & ~joined) != 0) continue;
    const int cost = *one + *other + combination.cost;
    if (!best || cost < best->first) best = std::pair{cost, number};
  }
  if (!best) throw std::logic_error("two arcs without a sound recolouring");
  return best->second;
}

Case best_closing(const Arc& arc) {
  const bool ports_joined = arc.ports.count > 1 && (arc.ports.first_joined || arc.ports.two_joined);
  std::optional<Case> best;
  for (const Case c : all_cases) {
    if (!arc.costs[c] || is_solid(left_of(c)) != is_solid(right_of(c)) || c == through_case) continue;
    if (left_of(c) == Reach::port && right_of(c) == Reach::port && !ports_joined) continue;
    if (!best || *arc.costs[c] < *arc.costs[*best]) best = c;
  }
  if (!best) throw std::logic_error("an arc without a sound recolouring");
  return *best;
}

}  // namespace restrip::generator
