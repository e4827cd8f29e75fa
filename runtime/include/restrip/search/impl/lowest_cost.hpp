// LowestCost: the engine of a Keeper under a cost that weighs swaps or isolated triangles, such as Cost::indices().
// Included by keeper.hpp.
//
// Invariant. No step raises the cost: each takes the present colours or cheaper ones.
//
// Outline of an operation. (1) A split or collapse takes the previous colours if they cost no more than the rule's; an
// operation with a table takes the cheapest of its rule and the colours that join two ports only if they were joined
// before (rule_choice.hpp). (2) A search at the strip ends of the patch (end_search.hpp) lowers the cost. (3) Under
// Policy::best an exact window (window.hpp) follows. Background work is a descent by chains over all triangles
// (descent.hpp) and, once that has nothing left to do, windows around all strip ends and swaps (window_rounds.hpp):
// they gain more and take longer.
//
// Cost. The rule; the looks of IndexPlan; the window. Nothing depends on the length of strips but walks that look for
// solid cycles. Fewest strips take 15 to 25 % more indices than fewest indices.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/search/impl/descent.hpp"
#include "restrip/search/impl/end_search.hpp"
#include "restrip/search/impl/keeper_steps.hpp"
#include "restrip/search/impl/rule_choice.hpp"
#include "restrip/search/impl/window.hpp"
#include "restrip/search/impl/window_rounds.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip::detail {

template <class Mesh>
class LowestCost {
 public:
  using Halfedge = typename Mesh::Halfedge;

  LowestCost(const IndexPlan& plan, const Cost& cost)
      : plan_(plan),
        ends_(cost),
        window_(cost, 1, Windings::ignored),
        descent_(cost),
        windows_(cost, 1, Windings::ignored) {}

  void set_plan(const IndexPlan& plan) noexcept { plan_ = plan; }
  [[nodiscard]] const IndexPlan& plan() const noexcept { return plan_; }

  template <class Step>
  Rewrite perform(Mesh& mesh, RuleChoice<Mesh>& choice, Surroundings<Mesh>& around, const Step& step) {
    unsettle();
    choice.begin(plan_.limits.looks != 0, plan_.from == IndexPlan::From::ends);
    std::vector<Triangle>& start = choice.start();
    if (!Step::counts_swaps) {
      step.find_patch(mesh, start);
      around.clear();
      around.add(start);
      around.add_neighbors(mesh);
      around.count_before(mesh);
    }
    Rewrite done = step.by_rules(mesh, choice);
    static_cast<ColoringChange&>(done) = choice.change();
    if (!Step::counts_swaps) {
      step.find_new(mesh, done.halfedge, start);
      std::erase_if(start, [&](Triangle t) { return !mesh.has_triangle(t); });
      around.add(start);
      static_cast<ColoringChange&>(done) = around.change(mesh);
    }
    if (plan_.limits.looks == 0) return done;
    const ColoringChange found = search(mesh, start, Step::rings);
    choice.count_improved(found.price(cost()) < 0);
    done += found;
    return done;
  }

  /// The descent, then windows, of about `budget` moves and colourings.
  ColoringChange improve(Mesh& mesh, std::size_t budget) {
    auto&& sides = by_sides(mesh);
    const std::uint64_t stop = spent() + std::min<std::uint64_t>(budget, WindowRounds::no_limit - spent());
    ColoringChange sum;
    constexpr std::size_t at_once = 256;
    unsettled_ = (std::min)(unsettled_, sides.triangle_bound());
    while (unsettled_ > 0 && spent() < stop) {
      some_.clear();
      for (; unsettled_ > 0 && some_.size() < at_once; --unsettled_) {
        if (next_ >= sides.triangle_bound()) next_ = 0;
        if (sides.alive(next_)) some_.push_back(next_);
        ++next_;
      }
      const auto moves = static_cast<std::uint32_t>(std::min<std::uint64_t>(stop - spent(), 1U << 20));
      sum += descent_.run(sides, some_, {.moves = moves, .tries = 4, .worse = 1});
    }
    if (spent() < stop) sum += windows_.run(sides, stop - spent(), {.triangles = 30}).change;
    return sum;
  }

  /// The mesh has changed: the descent has to pass all triangles.
  void unsettle() noexcept { unsettled_ = (std::numeric_limits<std::size_t>::max)(); }
  template <class Visit>
  void visit_state(const Mesh& mesh, Visit&& visit) {
    const std::uint64_t bound = mesh.triangle_bound();
    std::uint64_t next = next_;
    std::uint64_t unsettled = std::min<std::uint64_t>(unsettled_, bound);
    visit(next);
    visit(unsettled);
    next_ = static_cast<Triangle>(next);
    unsettled_ = static_cast<std::size_t>((std::min)(unsettled, bound));
    windows_.visit_state(visit);
    window_.visit_state(visit);
  }

 private:
  [[nodiscard]] const Cost& cost() const noexcept { return descent_.cost(); }
  /// The work of improve() so far.
  [[nodiscard]] std::uint64_t spent() const noexcept { return descent_.counts().priced + windows_.spent(); }

  /// The steps after the rule, from these triangles and `rings` around them.
  ColoringChange search(Mesh& mesh, std::vector<Triangle>& start, unsigned rings) {
    auto&& sides = by_sides(mesh);
    add_rings(mesh, start, rings + (plan_.from == IndexPlan::From::ring ? 1U : 0U));
    const Triangle middle = start.empty() ? none : start.front();
    ColoringChange change = ends_.run(sides, start, plan_.limits);
    if (plan_.window != 0 && middle != none)
      change += window_.around(sides, middle, {.triangles = plan_.window}).change;
    return change;
  }

  IndexPlan plan_;
  EndSearch ends_;  // after an operation
  Window window_;   // after that search
  Descent descent_;
  WindowRounds windows_;
  Triangle next_ = 0;                                                  // of the descent
  std::size_t unsettled_ = (std::numeric_limits<std::size_t>::max)();  // triangles that it still has to pass
  std::vector<Triangle> some_;                                         // of them
};

}  // namespace restrip::detail
