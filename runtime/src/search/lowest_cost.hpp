// LowestCost: the engine of a Keeper under a cost that weighs swaps or isolated triangles, such as Cost::indices().
// lowest_cost.cpp tells the method.
#pragma once

#include <cstddef>
#include <limits>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/policy.hpp"
#include "search/chain_search.hpp"
#include "search/steps.hpp"

namespace restrip::detail {

class LowestCost {
 public:
  LowestCost(const IndexPlan& plan, const Cost& cost) : plan_(plan), chains_(cost) {}

  void set_plan(const IndexPlan& plan) noexcept { plan_ = plan; }
  Rewrite perform(StripMesh& mesh, RuleChoice& choice, Surroundings& around, const Step& step);
  /// Chains from every strip end, of about `budget` moves.
  ColoringChange improve(StripMesh& mesh, std::size_t budget);
  /// The mesh has changed: chains from every end may gain again.
  void unsettle() noexcept { unsettled_ = (std::numeric_limits<std::size_t>::max)(); }

 private:
  IndexPlan plan_;
  ChainSearch chains_;
  Triangle next_ = 0;                                                  // of the background work
  std::size_t unsettled_ = (std::numeric_limits<std::size_t>::max)();  // triangles that it still has to pass
};

}  // namespace restrip::detail
