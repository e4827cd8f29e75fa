// The engine of a Keeper under the cost of strips.
//
// Invariant. Between operations `locator_`, if the policy tunnels, knows every strip of the mesh.
//
// Outline of an operation. The rule recolours the patch. Then either ends of strips that meet are joined (join.cpp),
// or, if the policy tunnels, (1) the locator learns what became of the strips through the patch, (2) a search
// (tunnel.cpp) tries to join each strip that ends in the patch, or next to it, with another one, and (3) isolated
// triangles are absorbed (absorb.hpp). When a strip breaks, its ends are known, and ends of other strips are near.
//
// Cost. The rule; linear in the patch for the locator; for each strip end a search of at most Search::states states.
// Source. Porcu and Scateni, "An iterative stripification algorithm based on dual graph operations", 2003, tunnel when
// isolated triangles exceed a threshold. Immediate local searches keep the strips of every level of detail as long as
// strips made from scratch.
#include "search/fewest_strips.hpp"

#include "operations/absorb.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::detail {

std::size_t FewestStrips::rebuild(const StripMesh& mesh) {
  rounds_.restart();
  if (!tunnels()) return count_strips(mesh);
  locator_.rebuild(mesh);
  triangles_ = mesh.triangle_count();
  return locator_.strips();
}

Rewrite FewestStrips::perform(StripMesh& mesh, RuleChoice& choice, const Step& step) {
  choice.begin(false, false);
  if (tunnels()) return tunnel_from_patch(mesh, choice, step);
  const Rewrite done = step.by_rules(mesh, choice, joins_);
  if (!joins_) return done;
  const ColoringChange& by_rule = choice.change();
  choice.count_improved(done.strips < by_rule.strips || done.isolated < by_rule.isolated);
  return done;
}

Rewrite FewestStrips::tunnel_from_patch(StripMesh& mesh, RuleChoice& choice, const Step& step) {
  step.find_patch(mesh, patch_);
  triangles_ -= patch_.size();
  locator_.before_patch(mesh, patch_);
  const Rewrite by_rule = step.by_rules(mesh, choice, false);
  step.find_new(mesh, by_rule.halfedge, patch_);
  const ColoringChange change = tunnelled(mesh, by_rule.isolated, step.may_isolate);
  choice.count_improved(change.strips < 0 || change.isolated < 0);
  return with(by_rule, change);
}

// The steps after the rule; `isolated`: what the rule reported.
ColoringChange FewestStrips::tunnelled(StripMesh& mesh, int isolated, MayIsolate may_isolate) {
  std::erase_if(patch_, [&](Triangle t) { return !mesh.alive(t); });
  triangles_ += patch_.size();
  locator_.after_patch(mesh, patch_);
  const std::uint32_t states = states_now();
  const TunnelCounts before = counts();
  for (const Triangle t : patch_)
    if (mesh.solid_degree(t) < 2) tunnel_.join(mesh, locator_, t, states);
  // Cleared ports end strips next to the patch.
  if (may_isolate != MayIsolate::as_reported)
    for (const Triangle t : patch_)
      for_each_neighbor(mesh, t, [&](Triangle neighbor) {
        if (mesh.solid_degree(neighbor) < 2) tunnel_.join(mesh, locator_, neighbor, states);
      });
  ColoringChange change{-static_cast<int>(counts().joined - before.joined), 0,
                        static_cast<int>(counts().isolated - before.isolated)};
  const auto paint = [&](StripMesh::Halfedge g, bool solid) { solid ? locator_.link(mesh, g) : locator_.cut(mesh, g); };
  const auto absorb_at = [&](StripMesh::Halfedge h) {
    const ColoringChange absorbed = absorb_with(mesh, h, default_absorptions, paint, [](StripMesh::Halfedge) {});
    change += absorbed;
  };
  if (isolated + change.isolated > 0 || may_isolate == MayIsolate::everywhere)
    for (const Triangle t : patch_) absorb_at(StripMesh::halfedge(t, 0));
  // An operation that clears ports may isolate a triangle next to the patch.
  if (may_isolate != MayIsolate::as_reported)
    for (const Triangle t : patch_)
      for (unsigned side = 0; side < 3; ++side) absorb_at(mesh.opposite(StripMesh::halfedge(t, side)));
  return change;
}

// The longer the strips, the more states it takes to find an end; a high power of the length keeps all levels of
// detail close to `enough`.
std::uint32_t FewestStrips::states_now() const noexcept {
  const double short_of =
      static_cast<double>(search_.enough) * static_cast<double>(locator_.strips()) / static_cast<double>(triangles_);
  if (search_.enough == 0 || short_of >= 1) return search_.states;
  const double square = short_of * short_of;
  return static_cast<std::uint32_t>(square * square * search_.states);
}

ColoringChange FewestStrips::improve(StripMesh& mesh, std::size_t budget) {
  if (!tunnels()) locator_.rebuild(mesh);
  const std::size_t strips = locator_.strips();
  const auto isolated = counts().isolated;
  rounds_.run(mesh, locator_, tunnel_, budget);
  return {static_cast<int>(locator_.strips()) - static_cast<int>(strips), 0,
          static_cast<int>(counts().isolated - isolated)};
}

}  // namespace restrip::detail
