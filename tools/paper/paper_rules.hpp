// Figures 6, 7 and 8 of the paper, computed from the shipped tables: where a vertex can be split, the rules of the
// 4-vertex, and where a triangle would stay isolated if no strip were cut.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/rules/rules.hpp"

namespace restrip::tools {

/// All split positions of closed fans of up to `most_k` triangles: floor(k / 2) for each k from 3.
[[nodiscard]] std::vector<SplitPosition> split_positions(std::size_t most_k);

/// A configuration and its rule, one per orbit under the symmetries that keep the split position: the mirror that swaps
/// the ends of each arc and, if the arcs are equal, the half turn.
struct RuleOfOrbit {
  SplitPosition at;
  Word loop = 0;
  Word ports = 0;
  Word inner = 0;  ///< the colours chosen by the rule
  int strips = 0;  ///< change in the number of strips
  int isolated = 0;
  std::size_t orbit = 1;  ///< number of configurations in the orbit
};

/// Every valid configuration, reduced; the representative is the lowest (loop, ports) of its orbit.
[[nodiscard]] std::vector<RuleOfOrbit> reduced_rules(SplitPosition at);

/// Orbits of the loop colours alone, as the paper's figure 7 counts them. It includes the fully solid loop, a cycle.
[[nodiscard]] std::size_t loop_orbits(SplitPosition at);

/// One rule for each orbit of loop colours: with a solid port at every triangle that can have one.
[[nodiscard]] std::vector<RuleOfOrbit> rules_with_full_ports(SplitPosition at);

/// The cost of keeping every passing strip whole (figure 8). A strip *passes* if it enters the patch by one port and
/// leaves it by another. To keep it whole, a recolouring joins the same pairs of ports as before: P' = P.
struct LonelyRule {
  RuleOfOrbit rule;  ///< the rule in the tables
  Word whole =
      0;  ///< the best recolouring that keeps the passing strips whole: fewest isolated, most solid edges, lowest
  int isolated_if_whole = 0;  ///< change in the number of isolated triangles under it: positive
};

struct LonelyCount {
  SplitPosition at;
  std::size_t valid = 0;         ///< configurations
  std::size_t lonely = 0;        ///< configurations that must isolate a triangle if P' = P
  std::size_t isolated = 0;      ///< lonely configurations in which the rule isolates one too
  std::size_t adding_strip = 0;  ///< lonely configurations in which the rule adds a strip
  std::vector<LonelyRule> orbits;
};

/// Tries every recolouring: about a second for k = 8, and four times longer for each further k.
[[nodiscard]] LonelyCount lonely_configurations(SplitPosition at);

/// All of figures 6, 7 and 8.
struct RuleFigures {
  std::vector<SplitPosition> positions;  ///< 15 to k = 8, 4 more for k = 9
  struct FourVertex {
    SplitPosition at;
    std::size_t loops = 0;             ///< orbits of loop colours
    std::vector<RuleOfOrbit> by_loop;  ///< one each, except for the cycle, with full ports
    std::vector<RuleOfOrbit> all;      ///< of valid configurations
  };
  std::vector<FourVertex> four;
  std::vector<LonelyCount> lonely;  ///< k = 3 … 8
};
[[nodiscard]] RuleFigures rule_figures();

}  // namespace restrip::tools
