// Keeper: the rule of an operation, or colours that are as good; then the steps of the policy, which only lower the
// cost.
//
// Outline of an operation. begin() makes sure that the counts are right, and marks the keeper as out of date, which it
// stays if the operation ends by an exception. The engine does the operation, as a Step (steps.hpp), and what its
// policy adds. counted() takes the change of the counts.
//
// Invariant. If up_to_date(), the counts are those of the mesh and, under a policy that tunnels, the locator knows
// every strip.
#include "restrip/search/keeper.hpp"

#include <utility>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/output/strips.hpp"
#include "search/fewest_strips.hpp"
#include "search/lowest_cost.hpp"
#include "search/rule_choice.hpp"
#include "search/steps.hpp"

namespace restrip {

/// One of the two engines, and what both use.
struct Keeper::Engine {
  detail::RuleChoice choice;
  std::optional<detail::FewestStrips> fewest;
  std::optional<detail::LowestCost> lowest;
  detail::Surroundings around;  // for operations that do not count

  Engine(const PolicyRow& row, const Cost& cost) : choice(cost) {
    if (choice.weighs())
      lowest.emplace(row.plan, cost);
    else
      fewest.emplace(row);
  }
  Rewrite perform(StripMesh& mesh, const detail::Step& step) {
    return fewest ? fewest->perform(mesh, choice, step) : lowest->perform(mesh, choice, around, step);
  }
};

Keeper::Keeper(StripMesh& mesh, Policy policy, Cost cost)
    : mesh_(&mesh), policy_(policy), cost_(cost), engine_(std::make_unique<Engine>(row_of(policy), cost)) {
  rebuild();
}
Keeper::Keeper(Keeper&&) noexcept = default;
Keeper& Keeper::operator=(Keeper&&) noexcept = default;
Keeper::~Keeper() = default;

void Keeper::set_search(Search search) {
  if (policy_ == Policy::bare) return;  // its operations do not update a locator
  if (engine_->fewest && engine_->fewest->set_search(search)) rebuild();
}
void Keeper::set_plan(const IndexPlan& plan) noexcept {
  if (engine_->lowest) engine_->lowest->set_plan(plan);
}
void Keeper::reserve(std::size_t triangles) {
  if (engine_->fewest) engine_->fewest->reserve(triangles);
}

// ---- operations

Rewrite Keeper::split(const VertexSplit& where, Vertex new_vertex) {
  RESTRIP_ASSERT_GRANTED(check_split(*mesh_, where, new_vertex), "Keeper::split");
  return perform(detail::SplitStep(where, new_vertex));
}
Rewrite Keeper::collapse(Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(check_collapse(*mesh_, chord), "Keeper::collapse");
  return perform(detail::CollapseStep(chord));
}
Rewrite Keeper::flip(Halfedge h) {
  RESTRIP_ASSERT_GRANTED(check_flip(*mesh_, h), "Keeper::flip");
  return perform(detail::FlipStep(h));
}
Rewrite Keeper::apply(const OperationView& table, Halfedge where, NewVertices* added) {
  RESTRIP_ASSERT_GRANTED(check_apply(*mesh_, table, where), "Keeper::apply");
  NewVertices unused;
  return perform(detail::ApplyStep(table, where, added != nullptr ? *added : unused));
}

Rewrite Keeper::replace(std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in) {
  RESTRIP_ASSERT_GRANTED(check_replace(*mesh_, out, in), "Keeper::replace");
  std::vector<Triangle> made;
  return perform(detail::ReplaceStep(*mesh_, out, in, made));
}

void Keeper::begin() {
  if (!up_to_date_) rebuild();
  up_to_date_ = false;
}

Rewrite Keeper::perform(const detail::Step& step) {
  begin();
  return policy_ == Policy::bare ? bare(step) : counted(engine_->perform(*mesh_, step));
}

Rewrite Keeper::bare(const detail::Step& step) {
  if (engine_->lowest) engine_->lowest->unsettle();
  std::vector<Triangle>& patch = engine_->choice.start();
  detail::Surroundings& around = engine_->around;
  around.clear();
  step.surround(*mesh_, around);
  around.count_before(*mesh_);
  const Halfedge h = step.bare(*mesh_);
  patch.clear();
  step.find_new(*mesh_, h, patch);
  around.add(patch);
  return counted({around.change(*mesh_), h, 0});
}

Rewrite Keeper::counted(const Rewrite& done) {
  counts_.strips += static_cast<std::size_t>(done.strips);
  counts_.swaps += static_cast<std::size_t>(done.swaps);
  counts_.isolated += static_cast<std::size_t>(done.isolated);
  up_to_date_ = true;
  return done;
}

// ---- background work

std::size_t Keeper::improve(std::size_t budget) {
  begin();
  const std::size_t before = cost();
  counted({engine_->fewest ? engine_->fewest->improve(*mesh_, budget) : engine_->lowest->improve(*mesh_, budget),
           Halfedge{}, 0});
  return before - cost();
}

// ---- the whole mesh

void Keeper::rebuild() {
  up_to_date_ = false;
  if (engine_->lowest) {
    engine_->lowest->unsettle();
    counts_.strips = count_strips(*mesh_);
    counts_.swaps = count_swaps(*mesh_);
  } else {
    counts_.strips = engine_->fewest->rebuild(*mesh_);
    counts_.swaps = 0;
  }
  counts_.isolated = 0;
  for (Triangle t = 0; t < mesh_->triangle_bound(); ++t)
    counts_.isolated += mesh_->alive(t) && mesh_->solid_sides(t) == 0 ? 1U : 0U;
  up_to_date_ = true;
}

void Keeper::return_to(const std::optional<Counts>& counts) {
  if (!counts || (engine_->fewest && engine_->fewest->tunnels())) return rebuild();
  if (engine_->lowest) engine_->lowest->unsettle();
  counts_ = *counts;
  up_to_date_ = true;
}
void Keeper::keep(Policy policy, const Cost& cost) {
  Keeper other(*mesh_, policy, cost);
  other.engine_->choice.counts() = engine_->choice.counts();
  *this = std::move(other);
}

// ---- counts

std::size_t Keeper::swaps() const { return engine_->choice.weighs() ? counts_.swaps : count_swaps(*mesh_); }
const RuleCounts& Keeper::rule_counts() const noexcept { return engine_->choice.counts(); }
const StripLocator* detail::locator_of(const Keeper& keeper) noexcept {
  const auto& fewest = keeper.engine_->fewest;
  return fewest && fewest->tunnels() && keeper.up_to_date_ ? &fewest->locator() : nullptr;
}

// ---- operations that are checked first

Checked checked_split(Keeper& keeper, const VertexSplit& where, Vertex new_vertex) {
  Checked done;
  done.refusal = check_split(keeper.mesh(), where, new_vertex);
  if (!done) return done;
  done.rewrite = keeper.split(where, new_vertex);
  done.new_vertices.push_back(keeper.mesh().to(done.rewrite.halfedge));
  return done;
}
Checked checked_collapse(Keeper& keeper, Halfedge chord) {
  Checked done;
  done.refusal = check_collapse(keeper.mesh(), chord);
  if (done) done.rewrite = keeper.collapse(chord);
  return done;
}
Checked checked_flip(Keeper& keeper, Halfedge h) {
  Checked done;
  done.refusal = check_flip(keeper.mesh(), h);
  if (done) done.rewrite = keeper.flip(h);
  return done;
}
Checked checked_apply(Keeper& keeper, const OperationView& table, Halfedge where) {
  Checked done;
  done.refusal = check_apply(keeper.mesh(), table, where);
  if (done) done.rewrite = keeper.apply(table, where, &done.new_vertices);
  return done;
}

Checked checked_replace(Keeper& keeper, std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in) {
  Checked done;
  done.refusal = check_replace(keeper.mesh(), out, in);
  if (done) done.rewrite = keeper.replace(out, in);
  return done;
}

}  // namespace restrip
