// Keeper, member by member. Included by keeper.hpp.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "restrip/search/keeper.hpp"

namespace restrip {

// ---- operations

template <class Mesh>
Rewrite Keeper<Mesh>::split(const VertexSplit& where, Vertex new_vertex) {
  RESTRIP_ASSERT_GRANTED(check_split(*mesh_, where, new_vertex), "Keeper::split");
  return perform(detail::SplitStep<Mesh>{where, new_vertex});
}
template <class Mesh>
Rewrite Keeper<Mesh>::collapse(Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(check_collapse(*mesh_, chord), "Keeper::collapse");
  return perform(detail::CollapseStep<Mesh>{chord});
}
template <class Mesh>
Rewrite Keeper<Mesh>::flip(Halfedge h) {
  RESTRIP_ASSERT_GRANTED(check_flip(*mesh_, h), "Keeper::flip");
  return perform(detail::FlipStep<Mesh>{{h}});
}
template <class Mesh>
Rewrite Keeper<Mesh>::apply(const OperationView& table, Halfedge where, NewVertices* added) {
  RESTRIP_ASSERT_GRANTED(check_apply(*mesh_, table, where), "Keeper::apply");
  NewVertices unused;
  return perform(detail::ApplyStep<Mesh>{table, where, added != nullptr ? *added : unused});
}

template <class Mesh>
Rewrite Keeper<Mesh>::split_record(std::size_t record, const VertexSplit& where, Vertex new_vertex) {
  RESTRIP_ASSERT(baked_.has_value(), "Keeper::split_record", "the keeper does not play baked strips");
  if (!baked_->can_split(record)) return split(where, new_vertex);
  begin();
  return counted(baked_->split(record, where, new_vertex));
}
template <class Mesh>
Rewrite Keeper<Mesh>::collapse_record(std::size_t record, Halfedge chord) {
  RESTRIP_ASSERT(baked_.has_value(), "Keeper::collapse_record", "the keeper does not play baked strips");
  if (!baked_->can_collapse(record)) return collapse(chord);
  begin();
  return counted(baked_->collapse(record, chord));
}

// One that ends by an exception leaves up_to_date_ false.
template <class Mesh>
void Keeper<Mesh>::begin() {
  if (!up_to_date_) rebuild();
  up_to_date_ = false;
}

// Isolated triangles are not counted while baked strips are played: begin() counts them.
template <class Mesh>
void Keeper<Mesh>::leave_levels() noexcept {
  if (!baked_ || !baked_->in_step()) return;
  baked_->leave_step();
  up_to_date_ = false;
}

// The rule, or colours that are as good; then the steps of the policy, which only lower the cost.
template <class Mesh>
template <class Step>
Rewrite Keeper<Mesh>::perform(const Step& step) {
  leave_levels();
  begin();
  if (policy_ == Policy::bare) return bare(step);
  return by_engine([&](auto& engine) { return counted(engine.perform(*mesh_, choice_, around_, step)); });
}
template <class Mesh>
template <class Step>
Rewrite Keeper<Mesh>::bare(const Step& step) {
  if (lowest_) lowest_->unsettle();
  std::vector<Triangle>& patch = choice_.start();
  around_.clear();
  step.surround(*mesh_, around_);
  around_.count_before(*mesh_);
  const auto h = step.bare(*mesh_);
  patch.clear();
  step.find_new(*mesh_, h, patch);
  around_.add(patch);
  return counted({around_.change(*mesh_), h, 0});
}

template <class Mesh>
Rewrite Keeper<Mesh>::counted(const Rewrite& done) {
  strips_ += static_cast<std::size_t>(done.strips);
  swaps_ += static_cast<std::size_t>(done.swaps);
  isolated_ += static_cast<std::size_t>(done.isolated);
  up_to_date_ = true;
  return done;
}

// ---- background work

template <class Mesh>
std::size_t Keeper<Mesh>::improve(std::size_t budget) {
  leave_levels();
  begin();
  const std::size_t before = cost();
  counted({by_engine([&](auto& engine) { return engine.improve(*mesh_, budget); }), Halfedge{}, 0});
  return before - cost();
}

template <class Mesh>
void Keeper<Mesh>::rebuild() {
  up_to_date_ = false;
  if (lowest_) {
    lowest_->unsettle();
    strips_ = count_strips(*mesh_);
    swaps_ = count_swaps(*mesh_);
  } else {
    strips_ = fewest_->rebuild(*mesh_);
    swaps_ = 0;
  }
  isolated_ = 0;
  for (Triangle t = 0; t < mesh_->triangle_bound(); ++t)
    if (mesh_->has_triangle(t)) isolated_ += detail::solid_degree(*mesh_, mesh_->halfedge(t)) == 0 ? 1U : 0U;
  up_to_date_ = true;
}

template <class Mesh>
typename Keeper<Mesh>::State Keeper<Mesh>::state() noexcept {
  State state{up_to_date_, strips_, swaps_, isolated_, weights(), {}, {}};
  auto next = state.searches.begin();
  by_engine([&](auto& engine) { engine.visit_state(*mesh_, [&](std::uint64_t& number) { *next++ = number; }); });
  if (baked_ && baked_->in_step()) state.level = baked_->level();
  return state;
}
template <class Mesh>
void Keeper<Mesh>::return_to(const State& state) {
  const bool same_cost = state.cost == weights();
  if ((fewest_ && fewest_->tunnels()) || !state.known || !same_cost) {
    rebuild();
  } else {
    strips_ = state.strips;
    swaps_ = state.swaps;
    isolated_ = state.isolated;
    up_to_date_ = true;
  }
  auto next = state.searches.begin();
  by_engine([&](auto& engine) {
    if (same_cost) engine.visit_state(*mesh_, [&](std::uint64_t& number) { number = *next++; });
  });
  if (!same_cost && lowest_)
    lowest_ = std::make_unique<LowestCost>(lowest_->plan(), weights());  // searches begin again
  if (baked_) state.level ? baked_->restart(*state.level) : baked_->leave_step();
}
template <class Mesh>
void Keeper<Mesh>::keep(Policy policy, const Cost& cost) {
  Keeper other(*mesh_, policy, cost);
  other.return_to(state());
  other.choice_.counts() = choice_.counts();
  *this = std::move(other);
}

}  // namespace restrip
