// Figures 6, 7 and 8 of the paper.
#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <utility>

#include "paper/paper.hpp"
#include "restrip/rules/key.hpp"

namespace restrip::tools {
namespace {

/// A symmetry of a closed fan, on its triangles: i -> shift - i or i -> i + shift.
struct Symmetry {
  bool mirror = false;
  std::size_t shift = 0;
};

/// Of loop colours, or of ports. Edge i joins triangles i and i + 1; a mirror exchanges the two.
Word image(const Symmetry& s, Word colors, std::size_t k, bool of_loop) {
  Word result = 0;
  for (std::size_t i = 0; i < k; ++i) {
    const std::size_t from = of_loop && s.mirror ? (i + 1) % k : i;
    if (has(colors, i)) result |= bit((s.mirror ? s.shift + k - from : s.shift + from) % k);
  }
  return result;
}

using Colors = std::pair<Word, Word>;  // loop, ports

std::vector<Colors> orbit_of(SplitPosition at, Word loop, Word ports) {
  const std::size_t flip = at.a + at.k - 1;
  std::vector<Symmetry> symmetries{{false, 0}, {true, flip}};
  if (2 * at.a == at.k) {
    symmetries.push_back({false, at.a});
    symmetries.push_back({true, flip + at.a});
  }
  std::vector<Colors> orbit;
  orbit.reserve(symmetries.size());
  for (const Symmetry& s : symmetries) orbit.emplace_back(image(s, loop, at.k, true), image(s, ports, at.k, false));
  std::sort(orbit.begin(), orbit.end());
  orbit.erase(std::unique(orbit.begin(), orbit.end()), orbit.end());
  return orbit;
}

/// Which ports a patch joins, if a fan can join them, as a mask that differs for different pairs: bit i stands for
/// solid port i and the one before it, which of two ports is the same from either.
std::optional<Word> pairs_of(const Patch& patch, Word inner, Word ports) {
  const detail::InnerPairs pairs = detail::inner_pairs(patch, inner, ports);
  if (pairs.over_chord != 0 && detail::name_of_pair(patch, patch.spread(pairs.over_chord), patch.spread(ports)) == 0)
    return std::nullopt;
  return count_bits(ports) == 2 && pairs.joined != 0 ? ports : pairs.joined;
}

RuleOfOrbit rule_of(SplitPosition at, Word loop, Word ports) {
  const Rule rule = split_rule(at, loop, ports);
  return {at,
          loop,
          ports,
          rule.colors,
          rule.strips,
          detail::isolated(ring_with_chord(at.k, at.a), rule.colors, ports) -
              detail::isolated(closed_fan(at.k), loop, ports),
          orbit_of(at, loop, ports).size()};
}

}  // namespace

std::vector<SplitPosition> split_positions(std::size_t most_k) {
  std::vector<SplitPosition> positions;
  for (std::size_t k = 3; k <= most_k; ++k)
    for (std::size_t a = 1; 2 * a <= k; ++a) positions.push_back({k, a});
  return positions;
}

std::vector<RuleOfOrbit> reduced_rules(SplitPosition at) {
  std::vector<RuleOfOrbit> rules;
  for (Word loop = 0; loop < bit(at.k); ++loop)
    for (Word ports = 0; ports < bit(at.k); ++ports)
      if (closed_fan(at.k).valid(loop, ports) && orbit_of(at, loop, ports).front() == Colors(loop, ports))
        rules.push_back(rule_of(at, loop, ports));
  return rules;
}

std::size_t loop_orbits(SplitPosition at) {
  std::size_t count = 0;
  for (Word loop = 0; loop < bit(at.k); ++loop)
    if (orbit_of(at, loop, 0).front().first == loop) ++count;
  return count;
}

std::vector<RuleOfOrbit> rules_with_full_ports(SplitPosition at) {
  std::vector<RuleOfOrbit> rules;
  for (Word loop = 0; loop + 1 < bit(at.k); ++loop) {
    if (orbit_of(at, loop, 0).front().first != loop) continue;
    Word ports = 0;
    for (std::size_t i = 0; i < at.k; ++i)
      if (!has(loop, i) || !has(loop, (i + at.k - 1) % at.k)) ports |= bit(i);
    rules.push_back(rule_of(at, loop, ports));
  }
  return rules;
}

LonelyCount lonely_configurations(SplitPosition at) {
  LonelyCount result;
  result.at = at;
  const Patch fan = closed_fan(at.k);
  const Patch ring = ring_with_chord(at.k, at.a);
  for (Word ports = 0; ports < bit(at.k); ++ports) {
    // The best recolouring for each pairing of these ports.
    struct Best {
      int isolated = 0;
      int dashed = 0;
      Word inner = 0;
      auto operator<=>(const Best&) const = default;
    };
    std::map<Word, Best> best;
    for (Word inner = 0; inner < bit(at.k + 3); ++inner) {
      if (!ring.valid(inner, ports)) continue;
      const Best here{detail::isolated(ring, inner, ports), -count_bits(inner), inner};
      const std::optional<Word> pairs = pairs_of(ring, inner, ports);
      if (!pairs) continue;
      const auto known = best.try_emplace(*pairs, here).first;
      known->second = std::min(known->second, here);
    }
    for (Word loop = 0; loop < bit(at.k); ++loop) {
      if (!fan.valid(loop, ports)) continue;
      ++result.valid;
      const Best& whole = best.at(pairs_of(fan, loop, ports).value());
      const int change = whole.isolated - detail::isolated(fan, loop, ports);
      if (change <= 0) continue;
      const RuleOfOrbit rule = rule_of(at, loop, ports);
      ++result.lonely;
      if (rule.isolated > 0) ++result.isolated;
      if (rule.strips > 0) ++result.adding_strip;
      if (orbit_of(at, loop, ports).front() == Colors(loop, ports))
        result.orbits.push_back({rule, whole.inner, change});
    }
  }
  return result;
}

RuleFigures rule_figures() {
  constexpr std::size_t drawn_k = 9;
  RuleFigures figures;
  figures.positions = split_positions(drawn_k);
  for (const SplitPosition& at : split_positions(table_max_k)) {
    if (at.k == 4) figures.four.push_back({at, loop_orbits(at), rules_with_full_ports(at), reduced_rules(at)});
    figures.lonely.push_back(lonely_configurations(at));
  }
  return figures;
}

}  // namespace restrip::tools
