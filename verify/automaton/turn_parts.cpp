#include "turn_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "arcs_around.hpp"
#include "automaton_mutants.hpp"

namespace restrip::verify {
namespace {

/// Weights that tell apart what a cost is made of.
constexpr TurnWeights telling{100, 1, 10000};

std::size_t number_without_turns(std::size_t c) { return number_of(without_turns(turn_case(c))).value(); }

/// Corners at A and D: the two ends of the chord, each the hub of one arc, and the corners of the rim.
enum class AroundCorner { none, hub_of_first, hub_of_second, rim_at_a, rim_at_d };

/// About which corner the end triangle of an arc is passed.
AroundCorner end_corner(char reach, bool second, AroundCorner rim) {
  switch (corner_at_link(reach)) {
    case TurnCorner::hub:
      return second ? AroundCorner::hub_of_second : AroundCorner::hub_of_first;
    case TurnCorner::rim:
      return rim;
    default:
      return AroundCorner::none;
  }
}

/// About which corner A or D is passed: the one that its two solid edges share.
AroundCorner passed(bool link_of_first, bool link_of_second, bool chord, AroundCorner rim) {
  if (link_of_first && link_of_second) return rim;
  if (link_of_first && chord) return AroundCorner::hub_of_first;
  if (link_of_second && chord) return AroundCorner::hub_of_second;
  return AroundCorner::none;
}

bool swaps(AroundCorner one, AroundCorner other) { return one != AroundCorner::none && one == other; }

TurnWay way_around(std::size_t first, std::size_t second, bool chord, const TurnWeights& weights) {
  const Around plain = around(number_without_turns(first), number_without_turns(second), chord);
  TurnWay way;
  way.legal = plain.legal;
  if (!way.legal) return way;
  const auto number = [](ArcEnd end) { return (end.second_arc ? 2U : 0U) + (end.right ? 1U : 0U); };
  for (const auto& [one, other] : plain.joined) way.joined |= pair_of_ends(number(one), number(other));
  const Case x = turn_case(first);
  const Case y = turn_case(second);
  const AroundCorner at_a = passed(x.left != '-', y.right != '-', chord, AroundCorner::rim_at_a);
  const AroundCorner at_d = passed(x.right != '-', y.left != '-', chord, AroundCorner::rim_at_d);
  const int swap_count = (x.left != '-' && swaps(at_a, end_corner(x.left, false, AroundCorner::rim_at_a)) ? 1 : 0) +
                         (x.right != '-' && swaps(at_d, end_corner(x.right, false, AroundCorner::rim_at_d)) ? 1 : 0) +
                         (y.left != '-' && swaps(at_d, end_corner(y.left, true, AroundCorner::rim_at_d)) ? 1 : 0) +
                         (y.right != '-' && swaps(at_a, end_corner(y.right, true, AroundCorner::rim_at_a)) ? 1 : 0) +
                         (chord && swaps(at_a, at_d) && !mutated(AutomatonMutant::turns_no_swap_at_chord) ? 1 : 0);
  way.cost =
      weights.swap * swap_count - weights.restart * plain.worth.solid - weights.isolated * plain.worth.fewer_isolated;
  return way;
}

/// A has no chord here, and is passed about its corner on the rim.
TurnWay way_around_one(std::size_t before, std::size_t behind, const TurnWeights& weights) {
  const Case x = turn_case(before);
  const Case y = turn_case(behind);
  TurnWay way;
  way.legal = x.left == '-' && y.right == '-';
  if (!way.legal) return way;
  const auto to_port = [](char reach) { return reach == 'p' || reach == 'q'; };
  if (to_port(x.right) && to_port(y.left)) way.joined = single(0);
  const bool through = x.right != '-' && y.left != '-';
  const auto swap_at = [&](char reach) { return through && corner_at_link(reach) == TurnCorner::rim ? 1 : 0; };
  way.cost = weights.swap * (swap_at(x.right) + swap_at(y.left)) - (x.right != '-' ? weights.restart : 0) +
             (x.right == '-' && y.left == '-' ? weights.isolated : 0);
  return way;
}

/// The two links are one edge: a strand over it that leaves by ports at both ends joins them, one that goes through is
/// a cycle.
TurnWay way_closed(std::size_t c, const TurnWeights& weights) {
  const Case k = turn_case(c);
  TurnWay way;
  way.legal = (k.left == '-') == (k.right == '-') && k.left != 't';
  if (!way.legal) return way;
  const auto to_port = [](char reach) { return reach == 'p' || reach == 'q'; };
  if (to_port(k.left) && to_port(k.right)) way.joined = single(0);
  if (k.left != '-' && corner_at_link(k.left) != TurnCorner::none && corner_at_link(k.left) == corner_at_link(k.right))
    way.cost = weights.swap;
  return way;
}

}  // namespace

TurnJoints::TurnJoints(std::size_t longest) : joints_(2 * turn_cases * turn_cases) {
  std::vector<std::string> words{""};
  for (std::size_t length = 1; length <= longest; ++length) {
    std::vector<std::string> longer;
    for (const std::string& word : words)
      for (const char letter : turn_letters) longer.push_back(word + letter);
    words = std::move(longer);
    if (length < 2) continue;
    for (const std::string& word : words)
      for (Mask links = 0; links < mask_count(static_cast<unsigned>(length) + 1); ++links)
        observe(word, links, length < longest);
  }
}

void TurnJoints::observe(const std::string& word, Mask links, bool may_be_new) {
  const auto last = static_cast<unsigned>(word.size() - 1);
  const std::string_view before = std::string_view(word).substr(0, last);
  const std::string_view triangle = std::string_view(word).substr(last);
  const Mask before_links = low_part(links, last + 1);
  const Mask triangle_links = high_part(links, last);
  const TurnColoring arc = turn_coloring(before, before_links, telling);
  const TurnColoring alone = turn_coloring(triangle, triangle_links, telling);
  if (!arc.sound || !alone.sound) return;
  ++colorings_;
  const TurnColoring whole = turn_coloring(word, links, telling);
  const int more = whole.cost - arc.cost - alone.cost;
  const TurnJoint seen = whole.sound ? TurnJoint{true, whole.arc_case, more == telling.swap} : TurnJoint{};
  std::optional<TurnJoint>& known =
      joints_[2 * (turn_cases * arc.arc_case + alone.arc_case) + (turn_joined(triangle[0]) ? 1U : 0U)];
  const auto fail = [&](const char* what) {
    failures_.add(fmt::format("the arc {} with the links {:x}: {}", word, links, what));
  };
  if (whole.sound && more != 0 && more != telling.swap) fail("its cost is not that of its parts and of their link");
  if (known && *known != seen) fail("the cases of its parts do not tell the case of the whole");
  if (!known && !may_be_new) fail("cases that shorter arcs do not have");
  known = seen;
}

Mask pair_of_ends(unsigned one, unsigned other) {
  const unsigned low = std::min(one, other);
  const unsigned high = std::max(one, other);
  return static_cast<Mask>(PortPairs::of(low, high).bits);  // of four ends
}

TurnWays::TurnWays(const TurnWeights& weights) {
  for (std::size_t x = 0; x < turn_cases; ++x)
    for (std::size_t y = 0; y < turn_cases; ++y) {
      for (const bool chord : {false, true}) around_.push_back(way_around(x, y, chord, weights));
      one_between_.push_back(way_around_one(x, y, weights));
    }
  for (std::size_t c = 0; c < turn_cases; ++c) closed_.push_back(way_closed(c, weights));
}

}  // namespace restrip::verify
