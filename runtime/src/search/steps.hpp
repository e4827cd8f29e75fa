// The operations of a Keeper, in steps, and counts around an operation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/search/keeper.hpp"
#include "search/rule_choice.hpp"

namespace restrip::detail {

/// The change by an operation that does not report it: strips, swaps and isolated triangles are counted before and
/// after it. Both triangles of each dual edge whose colour changes must be among those added. Time quadratic in the
/// triangles, about a dozen.
class Surroundings {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Makes room for one operation, so that nothing is allocated between the two counts.
  void clear() {
    triangles_.clear();
    triangles_.reserve(48);
  }
  void add(Triangle t);
  void add(const std::vector<Triangle>& triangles) {
    for (const Triangle t : triangles) add(t);
  }
  void add_next_to(const StripMesh& mesh, Halfedge h);
  void add_neighbors(const StripMesh& mesh);
  void count_before(const StripMesh& mesh) { before_ = counted(mesh); }
  /// Removed triangles are skipped; new ones must have been added.
  [[nodiscard]] ColoringChange change(const StripMesh& mesh);

 private:
  [[nodiscard]] ColoringChange counted(const StripMesh& mesh) const;

  std::vector<Triangle> triangles_;
  ColoringChange before_;
};

/// Where an operation may leave isolated triangles, which can then be absorbed.
enum class MayIsolate : std::uint8_t { as_reported, next_to_patch, everywhere };

class Step {
 public:
  using Halfedge = StripMesh::Halfedge;

  bool is_fan = false;  ///< a split or a collapse: the choice counts swaps and names the triangles where searches begin
  unsigned rings = 0;   ///< of triangles around the patch where searches begin as well
  MayIsolate may_isolate = MayIsolate::as_reported;

  /// Sets `patch` to the triangles about to be rewritten.
  virtual void find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const = 0;
  /// The operation with its rule, or what the choice takes instead; then, if `joins`, ends that meet are joined.
  virtual Rewrite by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const = 0;
  /// The mesh update alone; returns Rewrite::halfedge.
  virtual Halfedge bare(StripMesh& mesh) const = 0;
  /// Adds the triangles that bare() changes.
  virtual void surround(const StripMesh& mesh, Surroundings& around) const = 0;
  /// Adds the triangles that are new.
  virtual void find_new(const StripMesh& mesh, Halfedge done, std::vector<Triangle>& patch) const = 0;

 protected:
  ~Step() = default;
};

struct SplitStep : Step {
  VertexSplit where;
  Vertex new_vertex;

  explicit SplitStep(const VertexSplit& at, Vertex name = none) : where(at), new_vertex(name) { is_fan = true; }
  void find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const override;
  Rewrite by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const override;
  Halfedge bare(StripMesh& mesh) const override { return mesh.insert_vertex(where, new_vertex); }
  void surround(const StripMesh& mesh, Surroundings& around) const override;
  void find_new(const StripMesh& mesh, Halfedge chord, std::vector<Triangle>& patch) const override;
};

struct CollapseStep : Step {
  Halfedge chord;

  explicit CollapseStep(Halfedge h) : chord(h) { is_fan = true; }
  void find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const override;
  Rewrite by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const override;
  Halfedge bare(StripMesh& mesh) const override { return mesh.remove_vertex(chord); }
  void surround(const StripMesh& mesh, Surroundings& around) const override;
  void find_new(const StripMesh& mesh, Halfedge spoke, std::vector<Triangle>& patch) const override;
};

/// The chord is turned.
struct FlipStep final : CollapseStep {
  explicit FlipStep(Halfedge h);
  void find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const override;
  Rewrite by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const override;
  Halfedge bare(StripMesh& mesh) const override;
};

/// An operation with a table.
struct ApplyStep final : Step {
  const OperationView& table;
  Halfedge where;
  NewVertices& added;

  ApplyStep(const OperationView& of, Halfedge at, NewVertices& vertices);
  void find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const override;
  Rewrite by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const override;
  Halfedge bare(StripMesh& mesh) const override;
  void surround(const StripMesh& mesh, Surroundings& around) const override;
  void find_new(const StripMesh& mesh, Halfedge first, std::vector<Triangle>& patch) const override;
};

/// Triangles replaced by others, which begin isolated. The patch includes the triangles next to `out`, which lose
/// edges.
struct ReplaceStep final : Step {
  std::span<const Triangle> out;
  std::span<const std::array<Vertex, 3>> in;
  std::vector<Triangle> beyond;  ///< the triangles next to `out`
  std::vector<Triangle>& made;

  ReplaceStep(const StripMesh& mesh, std::span<const Triangle> removed, std::span<const std::array<Vertex, 3>> added,
              std::vector<Triangle>& list);
  void find_patch(const StripMesh& mesh, std::vector<Triangle>& patch) const override;
  Rewrite by_rules(StripMesh& mesh, RuleChoice& choice, bool joins) const override;
  Halfedge bare(StripMesh& mesh) const override;
  void surround(const StripMesh& mesh, Surroundings& around) const override;
  void find_new(const StripMesh& mesh, Halfedge first, std::vector<Triangle>& patch) const override;
};

}  // namespace restrip::detail
