// FewestStrips: the engine of a Keeper under the cost of strips. Included by keeper.hpp.
//
// Invariant. Between operations `locator_`, if the policy tunnels, knows every strip of the mesh.
//
// Outline of an operation. The rule recolours the patch. Then either ends of strips that meet are joined (join.hpp),
// or, if the policy tunnels, (1) the locator learns what became of the strips through the patch, (2) a search
// (tunnel.hpp) tries to join each strip that ends in the patch, or next to it, with another one, and (3) isolated
// triangles are absorbed (absorb.hpp). When a strip breaks, its ends are known, and ends of other strips are near.
//
// Cost. The rule; linear in the patch for the locator; for each strip end a search of at most Search::states states.
// Source. Porcu and Scateni, "An iterative stripification algorithm based on dual graph operations", 2003, tunnel when
// isolated triangles exceed a threshold. Immediate local searches keep the strips of every level of detail as long as
// strips made from scratch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/impl/absorb.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/impl/keeper_steps.hpp"
#include "restrip/search/impl/rounds.hpp"
#include "restrip/search/impl/rule_choice.hpp"
#include "restrip/search/impl/strip_locator.hpp"
#include "restrip/search/impl/tunnel.hpp"
#include "restrip/search/policy.hpp"
#include "restrip/search/sided_mesh.hpp"

namespace restrip::detail {

template <class Mesh>
class FewestStrips {
 public:
  using Halfedge = typename Mesh::Halfedge;

  explicit FewestStrips(const PolicyRow& row) : search_(row.search), joins_(row.policy != Policy::rules) {}

  /// True if the mesh must be read before the next operation.
  bool set_search(Search search) noexcept {
    const bool had_locator = tunnels();
    search_ = search;
    return !had_locator && tunnels();
  }
  [[nodiscard]] bool tunnels() const noexcept { return search_.states != 0; }
  [[nodiscard]] const StripLocator& locator() const noexcept { return locator_; }
  [[nodiscard]] const TunnelCounts& counts() const noexcept { return tunnel_.counts(); }
  void reserve(std::size_t triangles) { locator_.reserve(triangles); }

  /// Reads the mesh and returns the number of its strips.
  std::size_t rebuild(Mesh& mesh) {
    rounds_.restart();
    if (!tunnels()) return count_strips(mesh);
    auto&& sides = by_sides(mesh);
    locator_.rebuild(sides);
    triangles_ = sides.triangle_count();
    return locator_.strips();
  }

  template <class Step>
  Rewrite perform(Mesh& mesh, RuleChoice<Mesh>& choice, Surroundings<Mesh>& /*around*/, const Step& step) {
    choice.begin(false, false);
    if (tunnels()) return tunnel_from_patch(mesh, choice, step);
    if (!joins_) return step.by_rules(mesh, choice);
    const auto done = step.joined(mesh, choice);
    const ColoringChange& by_rule = choice.change();
    choice.count_improved(done.strips < by_rule.strips || done.isolated < by_rule.isolated);
    return done;
  }

  /// Rounds over all strip ends, of about `budget` states.
  ColoringChange improve(Mesh& mesh, std::size_t budget) {
    auto&& sides = by_sides(mesh);
    if (!tunnels()) locator_.rebuild(sides);
    const std::size_t strips = locator_.strips();
    const auto isolated = counts().isolated;
    rounds_.run(sides, locator_, tunnel_, budget);
    return {static_cast<int>(locator_.strips()) - static_cast<int>(strips), 0,
            static_cast<int>(counts().isolated - isolated)};
  }

  template <class Visit>
  void visit_state(const Mesh& /*mesh*/, Visit&& visit) {
    rounds_.visit_state(visit);
  }

 private:
  template <class Step>
  Rewrite tunnel_from_patch(Mesh& mesh, RuleChoice<Mesh>& choice, const Step& step) {
    step.find_patch(mesh, patch_);
    triangles_ -= patch_.size();
    locator_.before_patch(by_sides(mesh), patch_);
    const auto by_rule = step.by_rules(mesh, choice);
    step.find_new(mesh, by_rule.halfedge, patch_);
    const ColoringChange change = tunnelled(mesh, by_rule.isolated, Step::may_isolate);
    choice.count_improved(change.strips < 0 || change.isolated < 0);
    return with(by_rule, change);
  }

  /// The steps after the rule; `isolated`: what the rule reported.
  ColoringChange tunnelled(Mesh& mesh, int isolated, MayIsolate may_isolate) {
    auto&& sides = by_sides(mesh);
    std::erase_if(patch_, [&](Triangle t) { return !mesh.has_triangle(t); });
    triangles_ += patch_.size();
    locator_.after_patch(sides, patch_);
    const std::uint32_t states = states_now();
    const TunnelCounts before = counts();
    for (const Triangle t : patch_)
      if (sides.solid_degree(t) < 2) tunnel_.join(sides, locator_, t, states);
    // Cleared ports end strips next to the patch.
    if (may_isolate != MayIsolate::as_reported)
      for (const Triangle t : patch_)
        for_each_neighbor(sides, t, [&](Triangle neighbor) {
          if (sides.solid_degree(neighbor) < 2) tunnel_.join(sides, locator_, neighbor, states);
        });
    ColoringChange change{-static_cast<int>(counts().joined - before.joined), 0,
                          static_cast<int>(counts().isolated - before.isolated)};
    const auto paint = [&](StripMesh::Halfedge g, bool solid) {
      solid ? locator_.link(sides, g) : locator_.cut(sides, g);
    };
    const auto absorb_at = [&](StripMesh::Halfedge h) {
      const ColoringChange absorbed = absorb_with(sides, h, default_absorptions, paint, [](StripMesh::Halfedge) {});
      change += absorbed;
    };
    if (isolated + change.isolated > 0 || may_isolate == MayIsolate::everywhere)
      for (const Triangle t : patch_) absorb_at(StripMesh::halfedge(t, 0));
    // An operation that clears ports may isolate a triangle next to the patch.
    if (may_isolate != MayIsolate::as_reported)
      for (const Triangle t : patch_)
        for (unsigned side = 0; side < 3; ++side) absorb_at(sides.opposite(StripMesh::halfedge(t, side)));
    return change;
  }

  /// The longer the strips, the more states it takes to find an end; a high power of the length keeps all levels of
  /// detail close to `enough`.
  [[nodiscard]] std::uint32_t states_now() const noexcept {
    const double short_of =
        static_cast<double>(search_.enough) * static_cast<double>(locator_.strips()) / static_cast<double>(triangles_);
    if (search_.enough == 0 || short_of >= 1) return search_.states;
    const double square = short_of * short_of;
    return static_cast<std::uint32_t>(square * square * search_.states);
  }

  Search search_;
  bool joins_;  // ends that meet, if the policy does not tunnel
  StripLocator locator_;
  Tunnel tunnel_;
  TunnelRounds rounds_{256, 4096};  // background work
  std::size_t triangles_ = 0;       // while a locator exists
  std::vector<Triangle> patch_;
};

}  // namespace restrip::detail
