// The operations of a Keeper, in steps: what a policy needs to know about each, and how it is done.
#include "search/steps.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "operations/absorb.hpp"
#include "operations/join.hpp"
#include "operations/patch_sides.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/apply.hpp"

namespace restrip::detail {

namespace {

void add_next_to(const StripMesh& mesh, StripMesh::Halfedge h, std::vector<Triangle>& patch) {
  for (const auto side : {h, mesh.opposite(h)})
    if (!StripMesh::on_boundary(side)) patch.push_back(StripMesh::triangle(side));
}

void add_triangles(const StripMesh& mesh, std::span<const tables::PatchTriangle> triangles, StripMesh::Halfedge first,
                   std::vector<Triangle>& patch) {
  patch.clear();
  const PatchSides all = read_sides(mesh, triangles, first);
  for (const auto& sides : all.sides()) patch.push_back(StripMesh::triangle(sides[0]));
}

}  // namespace

// ---- counts

void Surroundings::add(Triangle t) {
  if (std::find(triangles_.begin(), triangles_.end(), t) == triangles_.end()) triangles_.push_back(t);
}
void Surroundings::add_next_to(const StripMesh& mesh, Halfedge h) {
  for (const Halfedge side : {h, mesh.opposite(h)})
    if (!StripMesh::on_boundary(side)) add(StripMesh::triangle(side));
}
void Surroundings::add_neighbors(const StripMesh& mesh) {
  for (std::size_t i = 0, n = triangles_.size(); i < n; ++i)
    for_each_neighbor(mesh, triangles_[i], [this](Triangle t) { add(t); });
}

ColoringChange Surroundings::change(const StripMesh& mesh) {
  std::erase_if(triangles_, [&](Triangle t) { return !mesh.alive(t); });
  ColoringChange change = counted(mesh);
  change += -before_;
  return change;
}

// `strips` is the number of triangles minus the number of solid edges.
ColoringChange Surroundings::counted(const StripMesh& mesh) const {
  ColoringChange count;
  count.strips = static_cast<int>(triangles_.size());
  for (auto t = triangles_.begin(); t != triangles_.end(); ++t) {
    count.isolated += mesh.solid_sides(*t) == 0 ? 1 : 0;
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(*t, side);
      if (!mesh.solid(h)) continue;
      if (std::find(triangles_.begin(), t, StripMesh::triangle(mesh.opposite(h))) != t) continue;  // counted there
      --count.strips;
      count.swaps += int{restrip::is_swap(mesh, h)};
    }
  }
  return count;
}

// ---- split

void SplitStep::find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const {
  fan_triangles(mesh, where.spoke(), patch);
}
Rewrite SplitStep::by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const {
  const auto change = begin_split(choice, mesh, where);
  if (joins) choice.note(change);
  const Halfedge chord = change_by_split(mesh, where, change, new_vertex);
  if (joins) return finish_split_and_join(mesh, change, chord);
  const Rewrite done = finish_split(mesh, change, chord);
  choice.begin_after_split(mesh, change, done.halfedge);
  return done;
}
void SplitStep::surround(const StripMesh& mesh, Surroundings& around) const {
  using Spokes = VertexSplit::Spokes;
  if (where.spokes != Spokes::right_only) around.add_next_to(mesh, where.left);
  if (where.spokes != Spokes::left_only) around.add_next_to(mesh, where.right);
}
void SplitStep::find_new(const StripMesh& mesh, Halfedge chord, std::vector<Triangle>& patch) const {
  add_next_to(mesh, chord, patch);
}

// ---- collapse

void CollapseStep::find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const {
  edge_triangles(mesh, chord, patch);
}
Rewrite CollapseStep::by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const {
  const auto change = begin_collapse(choice, mesh, chord);
  if (joins) choice.note(change);
  const Halfedge spoke = change_by_collapse(mesh, chord, change);
  if (joins) return finish_collapse_and_join(mesh, change, spoke);
  const Rewrite done = finish_collapse(mesh, change, spoke);
  choice.begin_after_collapse(mesh, change, done.halfedge);
  return done;
}
void CollapseStep::surround(const StripMesh& mesh, Surroundings& around) const {
  around.add_next_to(mesh, chord);
  around.add_neighbors(mesh);
}
void CollapseStep::find_new(const StripMesh& /*mesh*/, Halfedge /*spoke*/, std::vector<Triangle>& /*patch*/) const {}

// ---- flip

FlipStep::FlipStep(Halfedge h) : CollapseStep(h) {
  is_fan = false;
  may_isolate = MayIsolate::next_to_patch;
}
void FlipStep::find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const {
  patch.clear();
  add_next_to(mesh, chord, patch);
}
Rewrite FlipStep::by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const {
  const Rewrite done = choice.taken(flip_by_rule(mesh, chord));
  return joins ? with(done, join_at_edge(mesh, done.halfedge)) : done;
}
// The colouring would not stay valid with the colours of the two triangles' sides, so all of them are cleared.
StripMesh::Halfedge FlipStep::bare(StripMesh& mesh) const {
  for (auto h : {chord, mesh.opposite(chord)})
    for (int side = 0; side < 3; ++side, h = StripMesh::next(h))
      if (mesh.solid(h)) mesh.set_solid(h, false);
  return mesh.turn_edge(chord);
}

// ---- apply

ApplyStep::ApplyStep(const OperationView& of, Halfedge at, NewVertices& vertices)
    : table(of), where(at), added(vertices) {
  rings = 1;
  may_isolate = MayIsolate::everywhere;
}
void ApplyStep::find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const {
  add_triangles(mesh, table.triangles_before, where, patch);
}
Rewrite ApplyStep::by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const {
  const Rewrite done = choice.taken(apply_unchecked(mesh, table, where, &added));
  return joins ? with(done, join_patch(mesh, table, done.halfedge)) : done;
}
// Without a rule no side of the patch can stay solid.
StripMesh::Halfedge ApplyStep::bare(StripMesh& mesh) const {
  const PatchSides patch = read_sides(mesh, table.triangles_before, where);
  for (const auto& triangle : patch.sides())
    for (const Halfedge h : triangle)
      if (mesh.solid(h)) mesh.set_solid(h, false);
  return replace_patch(mesh, table, patch, &added);
}
void ApplyStep::surround(const StripMesh& mesh, Surroundings& around) const {
  const PatchSides patch = read_sides(mesh, table.triangles_before, where);
  for (const auto& triangle : patch.sides())
    for (const Halfedge h : triangle) around.add_next_to(mesh, h);
}
void ApplyStep::find_new(const StripMesh& mesh, Halfedge first, std::vector<Triangle>& patch) const {
  add_triangles(mesh, table.triangles_after, first, patch);
}

// ---- any triangles replaced by any others

ReplaceStep::ReplaceStep(const StripMesh& mesh, std::span<const Triangle> removed,
                         std::span<const std::array<Vertex, 3>> added, std::vector<Triangle>& list)
    : out(removed), in(added), made(list) {
  rings = 1;
  may_isolate = MayIsolate::everywhere;
  std::vector<Triangle> gone(out.begin(), out.end());
  std::sort(gone.begin(), gone.end());
  for (const Triangle t : out)
    for_each_neighbor(mesh, t, [&](Triangle u) {
      if (!std::binary_search(gone.begin(), gone.end(), u)) beyond.push_back(u);
    });
  sort_unique(beyond);
}
void ReplaceStep::find_patch(const StripMesh& /*mesh*/, std::vector<Triangle>& patch) const {
  patch.assign(out.begin(), out.end());
  patch.insert(patch.end(), beyond.begin(), beyond.end());
}
Rewrite ReplaceStep::by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const {
  Rewrite done{{static_cast<int>(in.size()) - static_cast<int>(out.size()), 0, static_cast<int>(in.size())}, {}, 0};
  const auto isolated = [&](const auto& triangles) {
    return static_cast<int>(
        std::count_if(triangles.begin(), triangles.end(), [&](Triangle t) { return mesh.solid_degree(t) == 0; }));
  };
  done.isolated -= isolated(out) + isolated(beyond);
  for (const Triangle t : out)
    for (unsigned s = 0; s < 3; ++s)
      if (const Halfedge h = StripMesh::halfedge(t, s); mesh.solid(h)) {
        mesh.set_solid(h, false);
        ++done.strips;
      }
  made.resize(in.size());
  mesh.replace(out, in, made);
  done.isolated += isolated(beyond);
  if (!made.empty()) done.halfedge = StripMesh::halfedge(made[0]);
  choice.did(done);
  if (!joins) return done;
  std::vector<Halfedge> nearby;
  for (const Triangle t : made) nearby.push_back(StripMesh::halfedge(t));
  for (const Triangle t : beyond) nearby.push_back(StripMesh::halfedge(t));
  const std::size_t count = nearby.size();
  for (std::size_t i = 0; i < count; ++i)
    for_each_neighbor(mesh, StripMesh::triangle(nearby[i]),
                      [&](Triangle u) { nearby.push_back(StripMesh::halfedge(u)); });
  return with(done, join_in(mesh, nearby));
}
StripMesh::Halfedge ReplaceStep::bare(StripMesh& mesh) const {
  made.resize(in.size());
  mesh.replace(out, in, made);
  return made.empty() ? Halfedge{} : StripMesh::halfedge(made[0]);
}
void ReplaceStep::surround(const StripMesh& mesh, Surroundings& around) const {
  for (const std::span<const Triangle> triangles : {out, std::span<const Triangle>(beyond)})
    for (const Triangle t : triangles) around.add(t);
  around.add_neighbors(mesh);
}
void ReplaceStep::find_new(const StripMesh& /*mesh*/, Halfedge /*first*/, std::vector<Triangle>& patch) const {
  patch = made;
  patch.insert(patch.end(), beyond.begin(), beyond.end());
}

}  // namespace restrip::detail
