// Every operation in two halves, with the change of the mesh between them. The first reads the patch, looks the rule up
// and clears edges; the second sets edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "operations/patch_walk.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/rules/exact.hpp"
#include "restrip/rules/rules.hpp"

namespace restrip::detail {

/// The colours of a rule and the changes that it makes.
struct Answer {
  FanBits colors;
  ColoringChange change;
};

/// For colours that no valid stripification has, all edges are dashed, as in Rule.
[[nodiscard]] Answer answer_by_rule(SeenPatch& patch);

/// The source of rules for the operations: the tables, unless a choice compares them with other colours. split() and
/// collapse() are for interior fans of ordinary valence, answer_split() and answer_collapse() for others.
class RuleSource {
 public:
  virtual ~RuleSource() = default;
  virtual Rule split(const StripMesh& /*mesh*/, Halfedge /*left*/, const InteriorFan& fan) {
    return split_rule({fan.k, fan.a}, fan.loop, fan.ports);
  }
  virtual Rule collapse(const StripMesh& /*mesh*/, Halfedge /*chord*/, const InteriorFan& fan, Word ring) {
    return collapse_rule({fan.k, fan.a}, ring, fan.ports);
  }
  virtual Answer answer_split(const StripMesh& /*mesh*/, const VertexSplit& /*where*/, SeenPatch& patch) {
    return answer_by_rule(patch);
  }
  virtual Answer answer_collapse(const StripMesh& /*mesh*/, Halfedge /*chord*/, SeenPatch& patch) {
    return answer_by_rule(patch);
  }
};

// ---- what is known between the halves

/// A split or a collapse that has begun.
struct FanChange {
  /// At an interior vertex of ordinary valence. Elsewhere only k of `fan` is known.
  bool interior = false;
  InteriorFan fan;
  Word before = 0;      ///< interior: colours of the loop before a split, of the inner edges before a collapse
  FanBits colors;       ///< of the inner edges after a split, of the loop after a collapse
  Patch layout;         ///< elsewhere: of the fan
  std::size_t gap = 0;  ///< elsewhere: see SeenPatch
  ColoringChange counts;

  /// Takes the rule of an interior fan. The masks are of isolated triangles.
  void take(const Rule& rule, Word colors_before, Word isolated_after, Word isolated_before) {
    before = colors_before;
    colors = FanBits(rule.colors);
    counts = {rule.strips, 0, count_difference(isolated_after, isolated_before)};
  }
  /// Takes the rule of another patch, whose layout without the inserted triangles is `at`.
  void take(Answer&& rule, const Patch& at, std::size_t gap_of_spoke) {
    fan.k = at.k;
    colors = std::move(rule.colors);
    layout = at;
    gap = gap_of_spoke;
    counts = rule.change;
  }
  /// The spokes that go from one vertex to the other, if they are known.
  [[nodiscard]] std::span<const Halfedge> moved() const {
    return {fan.spokes + (interior ? fan.a - 1 : 0), interior ? fan.k - fan.a : 0};
  }
  [[nodiscard]] Rewrite done(Halfedge at) const { return {counts, at, static_cast<std::uint32_t>(fan.k)}; }
};

// ---- the halves, for fans of any size and kind

FanChange begin_split(RuleSource& rules, StripMesh& mesh, const VertexSplit& where);
/// The change of the mesh between them, which uses the walk already done. Returns the chord.
Halfedge change_by_split(StripMesh& mesh, const VertexSplit& where, const FanChange& change, Vertex new_vertex);
Rewrite finish_split(StripMesh& mesh, const FanChange& change, Halfedge chord);

FanChange begin_collapse(RuleSource& rules, StripMesh& mesh, Halfedge chord);
/// Returns a spoke of v_s.
Halfedge change_by_collapse(StripMesh& mesh, Halfedge chord, const FanChange& change);
Rewrite finish_collapse(StripMesh& mesh, const FanChange& change, Halfedge left);

/// Flips by the rule, without checks of preconditions.
Rewrite flip_by_rule(StripMesh& mesh, Halfedge h);

/// Isolated triangles outside the ports that an operation clears: the triangles left without a solid edge when the dual
/// edges of `given_up` (halfedges of triangles outside the patch) are cleared.
[[nodiscard]] int isolated_outside(const StripMesh& mesh, std::span<const Halfedge> given_up);

}  // namespace restrip::detail
