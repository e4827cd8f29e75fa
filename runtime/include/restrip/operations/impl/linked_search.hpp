// The best recolouring for what is known about the strips outside, for fans without a table of linked rules: any closed
// or open fan whose colours fit one word. Included by linked.hpp.
//
// The automaton (exact.hpp) finds the best recolouring that joins only given pairs of neighbouring ports. So start with
// all pairs given. If the answer may close a cycle outside, every sound recolouring lacks one of the pairs on that
// cycle: remove each of them in turn, and search on. Branches that cannot be better than the best sound answer so far
// are cut off. A pair that the chord joins over ports between them cannot be named in a key; then all edges from one
// port over the chord to the other are given, and the rest are open fans.
//
// Only pairs next to ports that are joined outside, or out of sight, are ever removed. So for a given number of such
// ports the automaton runs a bounded number of times, and never more than max_answers times. If that is too few, which
// takes many cycles at once, the answer is the best one found, sound and at least as good as the rule.
#pragma once

#include <bit>
#include <cstddef>

#include "restrip/operations/impl/outlook.hpp"
#include "restrip/rules/bits.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/key.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::detail {

/// The number of times that the automaton may run for one rule.
inline constexpr int max_answers = 200;

template <class LookOut>
class LinkedSearch {
 public:
  /// `after` the operation; `before` are the pairs joined before it.
  constexpr LinkedSearch(const Layout& after, Word ports, const InnerPairs& before, LookOut& look_out)
      : after_(after),
        ports_(ports),
        joined_before_(before.joined),
        outlook_(after.k, 0, ports, pairs_of<WordPairs>(ports, before.joined, before.over_chord), look_out) {}

  /// The colours of the inner edges.
  constexpr Word best() {
    narrow({}, ports_, 0);
    if (after_.has_chord()) bridge_ports();
    if (gave_up()) {
      const exact::Recoloring local = best_recoloring(after_, ports_, joined_before_);
      if (better(local.value, best_.value)) best_ = local;
    }
    return best_.colors;
  }
  /// After best(): whether max_answers were too few.
  [[nodiscard]] constexpr bool gave_up() const noexcept { return answers_left_ < 0; }

 private:
  /// The ports at the two ends of a path over the chord, if such a path is required, as elements of the row, and
  /// whether it reaches A and D from below.
  struct Bridge {
    std::size_t at_a = nowhere;
    std::size_t at_d = nowhere;
    bool below_a = false;
    bool below_d = false;
  };

  static constexpr bool better(const exact::Value& one, const exact::Value& other) noexcept {
    return one.solid != other.solid ? one.solid > other.solid : one.isolated < other.isolated;
  }

  /// Considers all recolourings that join only the neighbours `may_join` and the ends of the bridge. Those that lack
  /// one of `keep` have already been considered.
  constexpr void narrow(const Bridge& bridge, Word may_join, Word keep) {
    if (--answers_left_ < 0) return;
    const exact::Recoloring found =
        bridge.at_a != nowhere ? bridged(bridge, may_join) : best_recoloring(after_, ports_, may_join);
    if (!better(found.value, best_.value)) return;
    const InnerPairs pairs = inner_pairs(after_, found.colors, ports_);
    const Word path = outlook_.may_close(pairs_of<WordPairs>(ports_, pairs.joined, pairs.over_chord));
    if (path == 0) {
      best_ = found;
      return;
    }
    const bool two = count_bits(ports_) == 2;  // either bit stands for their pair
    for (Word rest = pairs.joined & path & ~keep; rest != 0; rest &= rest - 1) {
      const Word pair = two ? ports_ : rest & (~rest + 1);
      narrow(bridge, may_join & ~pair, keep);
      if (gave_up() || !better(found.value, best_.value)) return;
      keep |= pair;
    }
  }

  /// All edges of the bridge, and on either side of it and of A and D an open fan.
  constexpr exact::Recoloring bridged(const Bridge& bridge, Word may_join) const noexcept {
    const std::size_t a = after_.inserted;
    const std::size_t d = after_.opposite;
    const std::size_t size = after_.size();
    // From element `from` up to element `to`; zero is one round further when it is the end.
    const auto edges = [](std::size_t from, std::size_t to) { return low_bits(to) & ~low_bits(from); };
    exact::Recoloring result;
    Word& colors = result.colors;
    colors = bit(after_.chord());
    colors |= bridge.below_a ? edges(bridge.at_a, a == 0 ? size : a) : edges(a, bridge.at_a);
    colors |= bridge.below_d ? edges(bridge.at_d, d) : edges(d, bridge.at_d);
    const auto fan = [&](std::size_t from, std::size_t to) {
      if (from >= to) return;
      const std::size_t first = after_.port(from);
      const std::size_t k = to - from;
      colors |= exact::best_fan_collapse(k, ports_ >> first & low_bits(k), may_join >> first & low_bits(k)).colors
                << from;
    };
    if (a > 0) fan(0, bridge.below_a ? bridge.at_a : a);
    fan(bridge.below_a ? a + 1 : bridge.at_a + 1, bridge.below_d ? bridge.at_d : d);
    fan(bridge.below_d ? d + 1 : bridge.at_d + 1, a == 0 && bridge.below_a ? bridge.at_a : size);
    result.value = {count_bits(colors), isolated(after_, colors, ports_)};
    return result;
  }

  /// Every pair that only the chord can join: the nearest ports on either side of A and of D.
  constexpr void bridge_ports() {
    const std::size_t a = after_.inserted;
    const std::size_t d = after_.opposite;
    const Word elements = after_.spread(ports_);
    const auto most = static_cast<int>(2 * after_.size()) - count_bits(ports_);  // ends of solid edges
    const Word below_a = after_.ring ? elements & ~low_bits(d) : elements & low_bits(a);
    const Word between = elements & low_bits(d) & ~low_bits(a);
    const Word above_d = elements & ~low_bits(d);
    for (const bool from_below_a : {false, true})
      for (const bool from_below_d : {false, true}) {
        const Word one = from_below_a ? std::bit_floor(below_a) : between & (~between + 1);
        const Word other = from_below_d ? std::bit_floor(between) : above_d & (~above_d + 1);
        if (one == 0 || other == 0 || one == other || name_of_pair(after_, one | other, elements) != 0) continue;
        if (2 * best_.value.solid + 1 >= most) return;  // nothing can be better
        narrow({static_cast<std::size_t>(std::countr_zero(one)), static_cast<std::size_t>(std::countr_zero(other)),
                from_below_a, from_below_d},
               ports_, 0);
      }
  }

  Layout after_;
  Word ports_;
  Word joined_before_;
  Outlook<WordPairs, LookOut> outlook_;
  exact::Recoloring best_{0, {-1, 0}};
  int answers_left_ = max_answers;
};

/// The rule for any family but the flip. Colours that no valid stripification has get the answer of the rules.
template <class LookOut>
constexpr Rule searched_rule(const Layout& before, Word colors, const Layout& after, Word ports, LookOut& look_out) {
  const int nodes = static_cast<int>(after.size()) - static_cast<int>(before.size());
  if (!valid(before, colors, ports)) return {0, nodes + count_bits(colors), false};
  return rule(LinkedSearch<LookOut>(after, ports, inner_pairs(before, colors, ports), look_out).best(), colors, nodes);
}

}  // namespace restrip::detail
