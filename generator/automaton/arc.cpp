#include "automaton/arc.hpp"

#include <tuple>

namespace restrip::generator {
namespace {

/// A triangle alone: each case with its value, and the number of its solid edges.
struct Colored {
  Case triangle = both_dashed;
  Value value;
};

/// What a triangle may do with its two links.
struct Choices {
  std::array<Colored, 4> list;
  std::size_t size = 0;
};

constexpr Choices without_port{{{{both_dashed, {0, -1}},
                                 {case_of(Reach::ends, Reach::dashed), {1, 0}},
                                 {case_of(Reach::dashed, Reach::ends), {0, 0}},
                                 {through_case, {1, 0}}}},
                               4};
constexpr Choices with_port{{{{both_dashed, {0, 0}},
                              {case_of(Reach::port, Reach::dashed), {1, 0}},
                              {case_of(Reach::dashed, Reach::port), {0, 0}}}},
                            3};

/// The case of an arc followed by a triangle; nothing where their links have different colours, or where two ports
/// would be joined that may not be.
std::optional<Case> followed(Case arc, Case triangle, bool may_join) {
  const Reach link = right_of(arc);
  const Reach from = left_of(triangle);
  if ((link == Reach::dashed) != (from == Reach::dashed)) return {};
  if (link == Reach::port && from == Reach::port && !may_join) return {};
  if (link == Reach::through && from == Reach::through) return through_case;
  if (link == Reach::through) return triangle;
  if (from == Reach::through) return arc;
  return case_of(left_of(arc), right_of(triangle));
}

/// The tie-break among equal values (docs/automaton.md, "Ties"): the reach of the link in front of the triangle, by
/// whether the triangle has a solid port; smaller is preferred. Found by trying all orders: these agree with the
/// tables' rules most often.
unsigned rank(Case arc, Case triangle, bool has_port) {
  constexpr std::array<unsigned, 4> in_front_of_no_port{0, 1, 3, 2};
  constexpr std::array<unsigned, 4> in_front_of_port{2, 3, 0, 1};
  const auto link = static_cast<std::size_t>(right_of(arc));
  return 4 * (has_port ? in_front_of_port : in_front_of_no_port)[link] + static_cast<unsigned>(left_of(triangle));
}

Appended over_boundary(const Values& arc) {
  Appended result;
  for (const Case c : all_cases) {
    if (right_of(c) != Reach::dashed) continue;
    result.values[c] = arc[c];
    result.before[c] = c;
  }
  return result;
}

}  // namespace

std::string text_of(Case c) {
  constexpr std::string_view reach = "-ept";
  return {reach[static_cast<unsigned>(left_of(c))], reach[static_cast<unsigned>(right_of(c))]};
}

char text_of(Letter letter) { return std::string_view("dsjb")[static_cast<unsigned>(letter)]; }

Values values_of_empty_arc() {
  Values values;
  values[both_dashed] = Value{};
  values[through_case] = Value{};
  return values;
}

Appended append(const Values& arc, Letter letter) {
  if (letter == Letter::boundary) return over_boundary(arc);
  Appended result;
  std::array<unsigned, case_codes> best_rank{};
  const Choices& triangle = letter == Letter::dashed ? without_port : with_port;
  for (const Case c : all_cases) {
    if (!arc[c]) continue;
    for (std::size_t i = 0; i < triangle.size; ++i) {
      const Colored& colored = triangle.list[i];
      const auto both = followed(c, colored.triangle, letter == Letter::joined);
      if (!both) continue;
      const Value value = *arc[c] + colored.value;
      const unsigned own_rank = rank(c, colored.triangle, letter != Letter::dashed);
      std::optional<Value>& best = result.values[*both];
      if (best && (value < *best || (value == *best && own_rank >= best_rank[*both]))) continue;
      best = value;
      best_rank[*both] = own_rank;
      result.before[*both] = c;
    }
  }
  return result;
}

}  // namespace restrip::generator
