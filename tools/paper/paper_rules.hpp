// Figures 6, 7 and 8 of the paper, made from the shipped tables: where a vertex can be split, the rules of the
// 4-vertex, and where a triangle would stay alone if no strip were cut.
#pragma once

#include <cstddef>
#include <vector>

#include "restrip/rules/rules.hpp"

namespace restrip::tools {

/// All split positions of closed fans of up to `most_k` triangles: floor(k / 2) for each k from 3.
[[nodiscard]] std::vector<SplitPosition> split_positions(std::size_t most_k);

/// A configuration and its rule, one for each orbit under the symmetries that keep the split position: the mirror that
/// swaps the ends of each arc and, where the arcs are equal, the half turn.
struct RuleOfOrbit {
  SplitPosition at;
  Word loop = 0;
  Word ports = 0;
  Word inner = 0;  ///< what the rule makes of it
  int strips = 0;  ///< change
  int isolated = 0;
  std::size_t orbit = 1;  ///< how many configurations it stands for
};

/// Every valid configuration, reduced; the representative is the lowest (loop, ports) of its orbit.
[[nodiscard]] std::vector<RuleOfOrbit> reduced_rules(SplitPosition at);

/// Orbits of the loop colours alone, as the paper's figure 7 counts them; the loop that is all solid, a cycle, is among
/// them.
[[nodiscard]] std::size_t loop_orbits(SplitPosition at);

/// One rule for each orbit of loop colours: that with a solid port at every triangle that has room for one.
[[nodiscard]] std::vector<RuleOfOrbit> rules_with_full_ports(SplitPosition at);

/// What keeping every passing strip whole would cost (figure 8). A strip *passes* when it enters the patch by one port
/// and leaves it by another; to keep it whole, a recolouring joins the same pairs of ports as before: P' = P.
struct LonelyRule {
  RuleOfOrbit rule;  ///< what the tables say instead
  Word whole = 0;    ///< the best that keeps the passing strips whole: fewest isolated, most solid edges, lowest
  int isolated_if_whole = 0;  ///< change in the number of isolated triangles under it: positive
};

struct LonelyCount {
  SplitPosition at;
  std::size_t valid = 0;         ///< configurations
  std::size_t lonely = 0;        ///< of them must isolate a triangle if P' = P
  std::size_t isolated = 0;      ///< of those are isolated by the rule as well
  std::size_t adding_strip = 0;  ///< of the lonely: the rule leaves one strip more than before
  std::vector<LonelyRule> orbits;
};

/// Tries every recolouring: about a second for k = 8, four times that for each k more.
[[nodiscard]] LonelyCount lonely_configurations(SplitPosition at);

/// All of figures 6, 7 and 8.
struct RuleFigures {
  std::vector<SplitPosition> positions;  ///< 15 to k = 8, 4 more for k = 9
  struct FourVertex {
    SplitPosition at;
    std::size_t loops = 0;             ///< orbits of loop colours
    std::vector<RuleOfOrbit> by_loop;  ///< one each, but for the cycle, with full ports
    std::vector<RuleOfOrbit> all;      ///< of valid configurations
  };
  std::vector<FourVertex> four;
  std::vector<LonelyCount> lonely;  ///< k = 3 … 8
};
[[nodiscard]] RuleFigures rule_figures();

}  // namespace restrip::tools
