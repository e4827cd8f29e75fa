// Keeper, member by member. Included by keeper.hpp.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "restrip/search/keeper.hpp"

namespace restrip {

// ---- operations

template <class Mesh>
template <class... Name>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::split(const VertexSplit<Halfedge>& where, Name... name) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_split(*mesh_, where, name...), "Keeper::split");
  return perform(detail::SplitStep<Mesh, Name...>{where, {name...}});
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::collapse(Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_collapse(*mesh_, chord), "Keeper::collapse");
  return perform(detail::CollapseStep<Mesh>{chord});
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::flip(Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_flip(*mesh_, h), "Keeper::flip");
  return perform(detail::FlipStep<Mesh>{{h}});
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::split_face(Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_face_split(*mesh_, h), "Keeper::split_face");
  return perform(detail::InsertStep<Mesh, false>(*mesh_, h));
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::bisect(Halfedge h) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_bisection(*mesh_, h), "Keeper::bisect");
  return perform(detail::InsertStep<Mesh, true>(*mesh_, h));
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::join_faces(Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_removal(*mesh_, chord, 3, 0), "Keeper::join_faces");
  return perform(detail::RemoveStep<Mesh, false>{{chord}});
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::merge(Halfedge chord) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_removal(*mesh_, chord, 4, 2), "Keeper::merge");
  return perform(detail::RemoveStep<Mesh, true>{{chord}});
}

template <class Mesh>
template <SurfaceTable Table, class Change>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::apply(const Table& table, Halfedge where, Change&& change) {
  RESTRIP_ASSERT_GRANTED(detail::refusal_of_apply(*mesh_, table, where), "Keeper::apply");
  return perform(detail::ApplyStep<Mesh, Table, std::remove_reference_t<Change>>{table, where, change});
}
template <class Mesh>
template <SurfaceTable Table>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::apply(const Table& table,
                                                     Halfedge where) requires std::same_as<Mesh, StripMesh> {
  RESTRIP_ASSERT_GRANTED(check_apply(*mesh_, table, where), "Keeper::apply");
  return apply(table, where, detail::replacing(*mesh_, table));
}

template <class Mesh>
template <class... Name>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::split_record(std::size_t record, const VertexSplit<Halfedge>& where,
                                                            Name... name) {
  RESTRIP_ASSERT(baked_.has_value(), "Keeper::split_record", "the keeper does not play baked strips");
  if (!baked_->can_split(record)) return split(where, name...);
  begin();
  return counted(baked_->split(record, where, name...), false);
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::collapse_record(std::size_t record, Halfedge chord) {
  RESTRIP_ASSERT(baked_.has_value(), "Keeper::collapse_record", "the keeper does not play baked strips");
  if (!baked_->can_collapse(record)) return collapse(chord);
  begin();
  return counted(baked_->collapse(record, chord), false);
}

// One that ends by an exception leaves up_to_date_ false.
template <class Mesh>
void Keeper<Mesh>::begin() {
  if (!up_to_date_) rebuild();
  up_to_date_ = false;
}

// The rule, or colours that are as good; then the steps of the policy, which only lower the cost.
template <class Mesh>
template <class Step>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::perform(const Step& step) {
  begin();
  unsettled_ = (std::numeric_limits<std::size_t>::max)();
  if (baked_) baked_->leave_step();
  if (policy_ == Policy::bare) {
    around_.clear();
    step.surround(*mesh_, around_);
    around_.count_before(*mesh_);
    const auto h = step.bare(*mesh_);
    patch_.clear();
    step.find_new(*mesh_, h, patch_);
    around_.add(patch_);
    return counted({{}, h, 0}, around_.change(*mesh_), false);
  }
  choice_.begin(weighs() && plan_.limits.looks != 0, plan_.from == IndexPlan::From::ends);
  if (weighs()) return search_from_ends(step);
  if (tunnels()) return tunnel_from_patch(step);
  if (policy_ == Policy::rules) return counted(step.by_rules(*mesh_, choice_), false);
  const auto done = step.joined(*mesh_, choice_);
  const ColoringChange& by_rule = choice_.change();
  return counted(done, done.strips < by_rule.strips || done.isolated < by_rule.isolated);
}

/// `improved`: the cost is lower than after the rule.
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::counted(const Rewrite<Halfedge>& done, bool improved) {
  strips_ += static_cast<std::size_t>(done.strips);
  isolated_ += static_cast<std::size_t>(done.isolated);
  choice_.counts().improved += improved ? 1U : 0U;
  up_to_date_ = true;
  return done;
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::counted(Rewrite<Halfedge> done, const ColoringChange& change,
                                                       bool improved) {
  swaps_ += static_cast<std::size_t>(change.swaps);
  static_cast<ColoringChange&>(done) = change;
  return counted(done, improved);
}

template <class Mesh>
template <class Step>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::search_from_ends(const Step& step) {
  std::vector<Triangle>& start = choice_.start();
  if (!Step::counts_swaps) {
    step.find_patch(*mesh_, start);
    around_.clear();
    around_.add(start);
    around_.add_neighbors(*mesh_);
    around_.count_before(*mesh_);
  }
  const auto by_rule = step.by_rules(*mesh_, choice_);
  if (!Step::counts_swaps) step.find_new(*mesh_, by_rule.halfedge, start);
  return searched(by_rule, Step::counts_swaps, Step::rings);
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::searched(const Rewrite<Halfedge>& by_rule, bool counts_swaps,
                                                        unsigned rings) {
  auto&& sides = by_sides(*mesh_);
  std::vector<Triangle>& start = choice_.start();
  ColoringChange change = choice_.change();
  if (!counts_swaps) {
    std::erase_if(start, [this](Triangle t) { return !mesh_->has_triangle(t); });
    around_.add(start);
    change = around_.change(*mesh_);
  }
  if (plan_.limits.looks == 0) return counted(by_rule, change, false);
  add_rings(*mesh_, start, rings + (plan_.from == IndexPlan::From::ring ? 1U : 0U));
  const Triangle middle = start.empty() ? none : start.front();
  ColoringChange found = ends_.run(sides, start, plan_.limits);
  if (plan_.window != 0 && middle != none) found += window_.around(sides, middle, {.triangles = plan_.window}).change;
  change += found;
  return counted(by_rule, change, found.price(weights()) < 0);
}

template <class Mesh>
template <class Step>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::tunnel_from_patch(const Step& step) {
  step.find_patch(*mesh_, patch_);
  triangles_ -= patch_.size();
  locator_.before_patch(by_sides(*mesh_), patch_);
  const Rewrite<Halfedge> by_rule = step.by_rules(*mesh_, choice_);
  step.find_new(*mesh_, by_rule.halfedge, patch_);
  return tunnelled(by_rule, Step::may_isolate);
}
template <class Mesh>
Rewrite<typename Mesh::Halfedge> Keeper<Mesh>::tunnelled(const Rewrite<Halfedge>& by_rule,
                                                         detail::MayIsolate may_isolate) {
  auto&& sides = by_sides(*mesh_);
  Rewrite<Halfedge> done = by_rule;
  std::erase_if(patch_, [this](Triangle t) { return !mesh_->has_triangle(t); });
  triangles_ += patch_.size();
  locator_.after_patch(sides, patch_);
  // The longer the strips, the more states it takes to find an end; a high power of the length keeps all levels of
  // detail close to `enough`.
  const double short_of =
      static_cast<double>(search_.enough) * static_cast<double>(locator_.strips()) / static_cast<double>(triangles_);
  const double square = short_of * short_of;
  const std::uint32_t states = search_.enough == 0 || short_of >= 1
                                   ? search_.states
                                   : static_cast<std::uint32_t>(square * square * search_.states);
  const TunnelCounts before = tunnel_.counts();
  for (const Triangle t : patch_)
    if (sides.solid_degree(t) < 2) tunnel_.join(sides, locator_, t, states);
  // Cleared ports end strips next to the patch.
  if (may_isolate != detail::MayIsolate::as_reported)
    for (const Triangle t : patch_)
      for_each_neighbor(sides, t, [&](Triangle neighbor) {
        if (sides.solid_degree(neighbor) < 2) tunnel_.join(sides, locator_, neighbor, states);
      });
  done.strips -= static_cast<int>(tunnel_.counts().joined - before.joined);
  done.isolated += static_cast<int>(tunnel_.counts().isolated - before.isolated);
  const auto paint = [&](StripMesh::Halfedge g, bool solid) {
    solid ? locator_.link(sides, g) : locator_.cut(sides, g);
  };
  const auto absorb_at = [&](StripMesh::Halfedge h) {
    return detail::absorb_with<std::remove_cvref_t<decltype(sides)>>(sides, h, detail::default_absorptions, paint,
                                                                     [](StripMesh::Halfedge) {});
  };
  ColoringChange repair;
  if (done.isolated > 0 || may_isolate == detail::MayIsolate::everywhere)
    for (const Triangle t : patch_) repair += absorb_at(StripMesh::halfedge(t, 0));
  // An operation that clears ports may isolate a triangle next to the patch.
  if (may_isolate != detail::MayIsolate::as_reported)
    for (const Triangle t : patch_)
      for (unsigned side = 0; side < 3; ++side) repair += absorb_at(sides.opposite(StripMesh::halfedge(t, side)));
  done = detail::with(done, repair);
  return counted(done, done.strips < by_rule.strips || done.isolated < by_rule.isolated);
}

// ---- background work

template <class Mesh>
std::size_t Keeper<Mesh>::improve(std::size_t budget) {
  begin();
  if (baked_) baked_->leave_step();
  auto&& sides = by_sides(*mesh_);
  const std::size_t before = cost();
  if (!weighs()) {
    if (!tunnels()) locator_.rebuild(sides);
    const auto isolated = tunnel_.counts().isolated;
    rounds_.run(sides, locator_, tunnel_, budget);
    strips_ = locator_.strips();
    isolated_ += static_cast<std::size_t>(tunnel_.counts().isolated - isolated);
    up_to_date_ = true;
    return before - cost();
  }
  const std::uint64_t spent = spent_by_improve();
  const std::uint64_t stop =
      spent + std::min<std::uint64_t>(budget, (std::numeric_limits<std::uint64_t>::max)() - spent);
  ColoringChange sum;
  constexpr std::size_t at_once = 256;
  unsettled_ = (std::min)(unsettled_, sides.triangle_bound());
  while (unsettled_ > 0 && spent_by_improve() < stop) {
    patch_.clear();
    for (; unsettled_ > 0 && patch_.size() < at_once; --unsettled_) {
      if (next_ >= sides.triangle_bound()) next_ = 0;
      if (sides.alive(next_)) patch_.push_back(next_);
      ++next_;
    }
    const auto moves = static_cast<std::uint32_t>(std::min<std::uint64_t>(stop - spent_by_improve(), 1U << 20));
    sum += descent_.run(sides, patch_, {.moves = moves, .tries = 4, .worse = 1});
  }
  // Windows gain more and take longer, so they come when the descent has nothing left to do.
  if (spent_by_improve() < stop) sum += windows_.run(sides, stop - spent_by_improve(), {.triangles = 30}).change;
  counted(Rewrite<Halfedge>{}, sum, false);
  return before - cost();
}

template <class Mesh>
void Keeper<Mesh>::rebuild() {
  up_to_date_ = false;
  rounds_.restart();
  unsettled_ = (std::numeric_limits<std::size_t>::max)();
  if (tunnels()) {
    auto&& sides = by_sides(*mesh_);
    locator_.rebuild(sides);
    triangles_ = sides.triangle_count();
    strips_ = locator_.strips();
  } else {
    strips_ = count_strips(*mesh_);
  }
  isolated_ = swaps_ = 0;
  for (Triangle t = 0; t < mesh_->triangle_bound(); ++t)
    if (mesh_->has_triangle(t)) isolated_ += detail::solid_degree(*mesh_, mesh_->halfedge(t)) == 0 ? 1U : 0U;
  if (weighs()) swaps_ = count_swaps(*mesh_);
  up_to_date_ = true;
}

template <class Mesh>
typename Keeper<Mesh>::State Keeper<Mesh>::state() noexcept {
  State state{up_to_date_, strips_, swaps_, isolated_, weights(), {}, {}};
  auto next = state.searches.begin();
  visit_searches([&](std::uint64_t& number) { *next++ = number; });
  if (baked_ && baked_->in_step()) state.level = baked_->level();
  return state;
}
template <class Mesh>
void Keeper<Mesh>::return_to(const State& state) {
  const bool same_cost = state.cost == weights();
  if (tunnels() || !state.known || !same_cost) {
    rebuild();
  } else {
    strips_ = state.strips;
    swaps_ = state.swaps;
    isolated_ = state.isolated;
    up_to_date_ = true;
  }
  auto next = state.searches.begin();
  visit_searches([&](std::uint64_t& number) { number = *next++; });
  if (!same_cost) {
    rounds_.restart();
    unsettled_ = (std::numeric_limits<std::size_t>::max)();
  }
  if (baked_) state.level ? baked_->restart(*state.level) : baked_->leave_step();
}
template <class Mesh>
void Keeper<Mesh>::keep(Policy policy, const Cost& cost) {
  Keeper other(*mesh_, policy, cost);
  other.return_to(state());
  other.choice_.counts() = choice_.counts();
  *this = std::move(other);
}

template <class Mesh>
template <class Visit>
void Keeper<Mesh>::visit_searches(Visit&& visit) {
  std::uint64_t next = next_;
  std::uint64_t unsettled = (std::min)(unsettled_, mesh_->triangle_bound());
  visit(next);
  visit(unsettled);
  next_ = static_cast<Triangle>(next);
  unsettled_ = static_cast<std::size_t>((std::min)(unsettled, std::uint64_t{mesh_->triangle_bound()}));
  rounds_.visit_state(visit);
  windows_.visit_state(visit);
  window_.visit_state(visit);
}
template <class Mesh>
template <class Visit>
void Keeper<Mesh>::visit_state(Visit&& visit) {
  if (!up_to_date_) rebuild();
  visit_searches(visit);
  RuleCounts& counts = choice_.counts();
  for (std::uint64_t* const count : {&counts.asked, &counts.taken, &counts.kept, &counts.improved}) visit(*count);
}

}  // namespace restrip
