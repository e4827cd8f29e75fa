// LowestCost: the engine of a Keeper under a cost that weighs swaps or isolated triangles, such as Cost::indices().
// lowest_cost.cpp tells the method.
#pragma once

#include <cstddef>
#include <cstdint>
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
  [[nodiscard]] const IndexPlan& plan() const noexcept { return plan_; }
  Rewrite perform(StripMesh& mesh, RuleChoice& choice, Surroundings& around, const Step& step);
  /// Chains from every strip end, of about `budget` moves.
  ColoringChange improve(StripMesh& mesh, std::size_t budget);
  /// The mesh has changed: chains from every end may gain again.
  void unsettle() noexcept { unsettled_ = (std::numeric_limits<std::size_t>::max)(); }
  [[nodiscard]] SearchNumbers numbers() const noexcept { return {next_, unsettled_}; }
  void set_numbers(const SearchNumbers& numbers) noexcept {
    next_ = static_cast<Triangle>(numbers[0]);
    unsettled_ = static_cast<std::size_t>(numbers[1]);
  }

 private:
  IndexPlan plan_;
  ChainSearch chains_;
  Triangle next_ = 0;                                                  // of the background work
  std::size_t unsettled_ = (std::numeric_limits<std::size_t>::max)();  // triangles that it still has to pass
};

}  // namespace restrip::detail
