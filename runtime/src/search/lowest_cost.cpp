// The engine of a Keeper under a cost that weighs swaps or isolated triangles.
//
// Outline of an operation. (1) A split or collapse takes the previous colours if they cost no more than the rule's
// (rule_choice.cpp); other operations take their rule. (2) A search for chains of moves from the strip ends and the
// swaps of the patch lowers the cost (chain_search.cpp). Background work searches for longer chains from every strip
// end and every swap of the mesh, and ends when it has passed them all without a gain.
//
// Invariant. No step raises the cost: each takes the present colours or cheaper ones.
//
// Cost. The rule; the looks of IndexPlan. Nothing depends on the length of strips but walks that look for solid cycles.
// Fewest strips take 15 to 25 % more indices than fewest indices.
#include "search/lowest_cost.hpp"

#include <algorithm>
#include <vector>

#include "restrip/mesh/walks.hpp"
#include "search/sides.hpp"

namespace restrip::detail {

Rewrite LowestCost::perform(StripMesh& mesh, RuleChoice& choice, Surroundings& around, const Step& step) {
  unsettle();
  choice.begin(plan_.limits.looks != 0, plan_.from == IndexPlan::From::ends);
  std::vector<Triangle>& start = choice.start();
  if (!step.is_fan) {
    step.find_patch(mesh, start);
    around.clear();
    around.add(start);
    around.add_neighbors(mesh);
    around.count_before(mesh);
  }
  Rewrite done = step.by_rules(mesh, choice, false);
  static_cast<ColoringChange&>(done) = choice.change();
  if (!step.is_fan) {
    step.find_new(mesh, done.halfedge, start);
    std::erase_if(start, [&](Triangle t) { return !mesh.alive(t); });
    around.add(start);
    static_cast<ColoringChange&>(done) = around.change(mesh);
  }
  if (plan_.limits.looks == 0) return done;
  add_rings(mesh, start, step.rings + (plan_.from == IndexPlan::From::ring ? 1U : 0U));
  const ColoringChange found = chains_.run(mesh, start, plan_.limits);
  choice.count_improved(found.price(choice.cost()) < 0);
  done += found;
  return done;
}

ColoringChange LowestCost::improve(StripMesh& mesh, std::size_t budget) {
  constexpr ChainLimits limits{.looks = 70, .length = 16, .worse = 2};
  constexpr std::uint64_t moves_a_look = 4;  // an end has two dashed edges, and each of them at most two moves
  const std::size_t bound = mesh.triangle_bound();
  const std::uint64_t before = chains_.counts().looked;
  ColoringChange sum;
  unsettled_ = (std::min)(unsettled_, bound);
  for (; unsettled_ > 0 && moves_a_look * (chains_.counts().looked - before) < budget; --unsettled_, ++next_) {
    if (next_ >= bound) next_ = 0;
    if (!mesh.alive(next_) || !ChainSearch::may_begin(mesh, next_, limits)) continue;
    const ColoringChange change = chains_.run(mesh, {&next_, 1}, limits);
    if (change.price(chains_.cost()) < 0) unsettled_ = bound;
    sum += change;
  }
  return sum;
}

}  // namespace restrip::detail
