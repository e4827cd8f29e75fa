// The operations of a Keeper, in steps, and counts around an operation. Included by keeper.hpp.
//
// Each step has
//   find_patch(mesh, patch)          the triangles about to be rewritten
//   by_rules(mesh, choice)           the operation with its rule, or what the choice takes instead
//   joined(mesh, choice)             the same, then ends that meet are joined
//   bare(mesh)                       the mesh update alone, what it returns as Rewrite::halfedge
//   surround(mesh, around)           the triangles that bare() changes
//   find_new(mesh, done, patch)      adds the triangles that are new
// and constants: whether the choice counts swaps and names the triangles where searches begin, the number of rings of
// triangles around the patch that these include, and where a triangle may be left isolated.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/impl/absorb.hpp"
#include "restrip/operations/impl/join.hpp"
#include "restrip/operations/impl/patch_sides.hpp"
#include "restrip/search/impl/descent.hpp"
#include "restrip/search/impl/rule_choice.hpp"

namespace restrip::detail {

/// The change by an operation that does not report it: strips, swaps and isolated triangles are counted before and
/// after it. Both triangles of each dual edge whose colour changes must be among those added. Time quadratic in the
/// triangles, about a dozen.
template <NumberedMesh Mesh>
class Surroundings {
 public:
  using Halfedge = typename Mesh::Halfedge;

  /// Makes room for one operation, so that nothing is allocated between the two counts.
  void clear() {
    triangles_.clear();
    triangles_.reserve(48);
  }
  void add(const std::vector<Triangle>& triangles) {
    for (const Triangle t : triangles) add(t);
  }
  void add_next_to(const Mesh& mesh, Halfedge h) {
    for (const Halfedge side : {h, mesh.opposite(h)})
      if (!mesh.on_boundary(side)) add(static_cast<Triangle>(mesh.triangle(side)));
  }
  void add_neighbors(const Mesh& mesh) {
    for (std::size_t i = 0, n = triangles_.size(); i < n; ++i)
      for_each_neighbor(mesh, triangles_[i], [this](Triangle t) { add(t); });
  }
  void count_before(const Mesh& mesh) { before_ = counted(mesh); }
  /// Removed triangles are skipped; new ones must have been added.
  [[nodiscard]] ColoringChange change(const Mesh& mesh) {
    std::erase_if(triangles_, [&](Triangle t) { return !mesh.has_triangle(t); });
    ColoringChange change = counted(mesh);
    change += -before_;
    return change;
  }

 private:
  void add(Triangle t) {
    if (std::find(triangles_.begin(), triangles_.end(), t) == triangles_.end()) triangles_.push_back(t);
  }
  // `strips` is the number of triangles minus the number of solid edges.
  [[nodiscard]] ColoringChange counted(const Mesh& mesh) const {
    ColoringChange count;
    count.strips = static_cast<int>(triangles_.size());
    for (auto t = triangles_.begin(); t != triangles_.end(); ++t) {
      bool isolated = true;
      auto h = mesh.halfedge(*t);
      for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
        if (!mesh.solid(h)) continue;
        isolated = false;
        if (std::find(triangles_.begin(), t, static_cast<Triangle>(mesh.triangle(mesh.opposite(h)))) != t) continue;
        --count.strips;
        count.swaps += int{restrip::is_swap(mesh, h)};
      }
      count.isolated += int{isolated};
    }
    return count;
  }

  std::vector<Triangle> triangles_;
  ColoringChange before_;
};

template <class Mesh>
void add_next_to(const Mesh& mesh, typename Mesh::Halfedge h, std::vector<Triangle>& patch) {
  for (const auto side : {h, mesh.opposite(h)})
    if (!mesh.on_boundary(side)) patch.push_back(static_cast<Triangle>(mesh.triangle(side)));
}

/// Where an operation may leave isolated triangles, which can then be absorbed.
enum class MayIsolate { as_reported, next_to_patch, everywhere };

template <class Mesh>
struct SplitStep {
  using Halfedge = typename Mesh::Halfedge;
  using Spokes = VertexSplit::Spokes;
  static constexpr bool counts_swaps = true;
  static constexpr unsigned rings = 0;
  static constexpr MayIsolate may_isolate = MayIsolate::as_reported;
  VertexSplit where;
  Vertex new_vertex;

  void find_patch(const Mesh& mesh, std::vector<Triangle>& patch) const { fan_triangles(mesh, where.spoke(), patch); }
  Rewrite by_rules(Mesh& mesh, RuleChoice<Mesh>& choice) const {
    const auto change = begin_split(choice, mesh, where);
    const auto done = finish_split(mesh, change, changed(mesh, change));
    choice.begin_after_split(mesh, change, done.halfedge);
    return done;
  }
  Rewrite joined(Mesh& mesh, RuleChoice<Mesh>& choice) const {
    const auto change = begin_split(choice, mesh, where);
    choice.note(change);
    return finish_split_and_join(mesh, change, changed(mesh, change));
  }
  Halfedge bare(Mesh& mesh) const { return mesh.insert_vertex(where, new_vertex); }
  void surround(const Mesh& mesh, Surroundings<Mesh>& around) const {
    if (where.spokes != Spokes::right_only) around.add_next_to(mesh, where.left);
    if (where.spokes != Spokes::left_only) around.add_next_to(mesh, where.right);
  }
  void find_new(const Mesh& mesh, Halfedge chord, std::vector<Triangle>& patch) const {
    add_next_to(mesh, chord, patch);
  }

 private:
  Halfedge changed(Mesh& mesh, const FanChange& change) const {
    return change_by_split(mesh, where, change, new_vertex);
  }
};

template <class Mesh>
struct CollapseStep {
  using Halfedge = typename Mesh::Halfedge;
  static constexpr bool counts_swaps = true;
  static constexpr unsigned rings = 0;
  static constexpr MayIsolate may_isolate = MayIsolate::as_reported;
  Halfedge chord;

  void find_patch(const Mesh& mesh, std::vector<Triangle>& patch) const { edge_triangles(mesh, chord, patch); }
  Rewrite by_rules(Mesh& mesh, RuleChoice<Mesh>& choice) const {
    const auto change = begin_collapse(choice, mesh, chord);
    const auto done = finish_collapse(mesh, change, change_by_collapse(mesh, chord, change));
    choice.begin_after_collapse(mesh, change, done.halfedge);
    return done;
  }
  Rewrite joined(Mesh& mesh, RuleChoice<Mesh>& choice) const {
    const auto change = begin_collapse(choice, mesh, chord);
    choice.note(change);
    return finish_collapse_and_join(mesh, change, change_by_collapse(mesh, chord, change));
  }
  Halfedge bare(Mesh& mesh) const { return mesh.remove_vertex(chord); }
  void surround(const Mesh& mesh, Surroundings<Mesh>& around) const {
    around.add_next_to(mesh, chord);
    around.add_neighbors(mesh);
  }
  void find_new(const Mesh& /*mesh*/, Halfedge /*spoke*/, std::vector<Triangle>& /*patch*/) const {}
};

/// The chord is turned.
template <class Mesh>
struct FlipStep : CollapseStep<Mesh> {
  using Halfedge = typename Mesh::Halfedge;
  using CollapseStep<Mesh>::chord;
  static constexpr bool counts_swaps = false;
  static constexpr MayIsolate may_isolate = MayIsolate::next_to_patch;

  void find_patch(const Mesh& mesh, std::vector<Triangle>& patch) const {
    patch.clear();
    add_next_to(mesh, chord, patch);
  }
  Rewrite by_rules(Mesh& mesh, RuleChoice<Mesh>& choice) const { return choice.taken(flip_by_rule(mesh, chord)); }
  Rewrite joined(Mesh& mesh, RuleChoice<Mesh>& choice) const {
    const auto done = by_rules(mesh, choice);
    return with(done, join_at_edge(mesh, done.halfedge));
  }
  /// The colouring would not stay valid with the colours of the two triangles' sides, so all of them are cleared.
  Halfedge bare(Mesh& mesh) const {
    for (auto h : {chord, mesh.opposite(chord)})
      for (int side = 0; side < 3; ++side, h = mesh.next(h))
        if (mesh.solid(h)) mesh.set_solid(h, false);
    return mesh.turn_edge(chord);
  }
};

/// An operation with a table.
template <class Mesh>
struct ApplyStep {
  using Halfedge = typename Mesh::Halfedge;
  static constexpr bool counts_swaps = false;
  static constexpr unsigned rings = 1;
  static constexpr MayIsolate may_isolate = MayIsolate::everywhere;
  const OperationView& table;
  Halfedge where;
  NewVertices& added;

  void find_patch(const Mesh& mesh, std::vector<Triangle>& patch) const {
    add_triangles(read_sides(mesh, table.triangles_before, where), patch);
  }
  Rewrite by_rules(Mesh& mesh, RuleChoice<Mesh>& choice) const {
    return choice.taken(apply_unchecked(mesh, table, where, &added));
  }
  Rewrite joined(Mesh& mesh, RuleChoice<Mesh>& choice) const {
    const Rewrite done = by_rules(mesh, choice);
    return with(done, join_patch(mesh, table, done.halfedge));
  }
  /// Without a rule no side of the patch can stay solid.
  Halfedge bare(Mesh& mesh) const {
    const PatchSides patch = read_sides(mesh, table.triangles_before, where);
    for (const auto& triangle : patch.sides())
      for (const Halfedge h : triangle)
        if (mesh.solid(h)) mesh.set_solid(h, false);
    return replace_patch(mesh, table, patch, &added);
  }
  void surround(const Mesh& mesh, Surroundings<Mesh>& around) const {
    const PatchSides patch = read_sides(mesh, table.triangles_before, where);
    for (const auto& triangle : patch.sides())
      for (const Halfedge h : triangle) around.add_next_to(mesh, h);
  }
  void find_new(const Mesh& mesh, Halfedge first, std::vector<Triangle>& patch) const {
    add_triangles(read_sides(mesh, table.triangles_after, first), patch);
  }

 private:
  static void add_triangles(const PatchSides& sides, std::vector<Triangle>& patch) {
    patch.clear();
    for (const auto& triangle : sides.sides()) patch.push_back(StripMesh::triangle(triangle[0]));
  }
};

}  // namespace restrip::detail
