// Figures 6, 7 and 8 of the paper.
#include <algorithm>
#include <compare>
#include <map>
#include <utility>

#include "common/disjoint_sets.hpp"
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

/// The colours of a patch as a graph: its triangles, the solid edges between them, and the owners of ports.
class ColoredPatch {
 public:
  static ColoredPatch fan(std::size_t k, Word loop, Word ports) {
    ColoredPatch patch(k, ports);
    for (std::size_t i = 0; i < k; ++i) patch.own_next_port(i);
    for (std::size_t i = 0; i < k; ++i)
      if (has(loop, i)) patch.link(i, (i + 1) % k);
    return patch;
  }
  static ColoredPatch ring(SplitPosition at, Word inner, Word ports) {
    const std::size_t n = at.k + 2;
    ColoredPatch patch(n, ports);
    for (std::size_t i = 0; i < at.k; ++i) patch.own_next_port(i < at.a ? i + 1 : i + 2);
    for (std::size_t j = 0; j < n; ++j)
      if (has(inner, j)) patch.link(j, (j + 1) % n);
    if (has(inner, n)) patch.link(0, at.a + 1);
    return patch;
  }

  /// Valid degrees and no cycle.
  [[nodiscard]] bool valid() const {
    return !cycle_ && std::all_of(degree_.begin(), degree_.end(), [](int d) { return d <= 2; });
  }
  [[nodiscard]] int isolated() const { return static_cast<int>(std::count(degree_.begin(), degree_.end(), 0)); }
  /// The pairs of joined ports as a mask over all pairs.
  [[nodiscard]] Word pairs() {
    Word result = 0;
    std::size_t pair = 0;
    for (std::size_t i = 0; i < owner_.size(); ++i)
      for (std::size_t j = i + 1; j < owner_.size(); ++j, ++pair)
        if (has(ports_, i) && has(ports_, j) && together(owner_[i], owner_[j])) result |= bit(pair);
    return result;
  }

 private:
  ColoredPatch(std::size_t triangles, Word ports) : sets_(triangles), degree_(triangles, 0), ports_(ports) {}
  void own_next_port(std::size_t triangle) {
    if (has(ports_, owner_.size())) ++degree_[triangle];
    owner_.push_back(triangle);
  }
  void link(std::size_t x, std::size_t y) {
    if (!sets_.unite(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))) cycle_ = true;
    ++degree_[x];
    ++degree_[y];
  }
  [[nodiscard]] bool together(std::size_t x, std::size_t y) {
    return sets_.find(static_cast<std::uint32_t>(x)) == sets_.find(static_cast<std::uint32_t>(y));
  }

  DisjointSets sets_;
  std::vector<int> degree_;         // of each triangle, solid ports included
  std::vector<std::size_t> owner_;  // the triangle of each port
  Word ports_;
  bool cycle_ = false;
};

RuleOfOrbit rule_of(SplitPosition at, Word loop, Word ports) {
  const Rule rule = split_rule(at, loop, ports);
  return {at,
          loop,
          ports,
          rule.colors,
          rule.strips,
          ColoredPatch::ring(at, rule.colors, ports).isolated() - ColoredPatch::fan(at.k, loop, ports).isolated(),
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
      ColoredPatch patch = ColoredPatch::ring(at, inner, ports);
      if (!patch.valid()) continue;
      const Best here{patch.isolated(), -count_bits(inner), inner};
      const auto known = best.try_emplace(patch.pairs(), here).first;
      known->second = std::min(known->second, here);
    }
    for (Word loop = 0; loop < bit(at.k); ++loop) {
      if (!closed_fan(at.k).valid(loop, ports)) continue;
      ++result.valid;
      ColoredPatch patch = ColoredPatch::fan(at.k, loop, ports);
      const Best& whole = best.at(patch.pairs());
      const int change = whole.isolated - patch.isolated();
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
