// Chooses the colours that a split or a collapse of a Keeper writes: the rule's, or, if the policy searches and they
// cost no more, the previous colours, passed on. rule_choice.cpp tells how they are priced.
#pragma once

#include <vector>

#include "operations/halves.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip::detail {

/// The source of rules for begin_split() and begin_collapse().
class RuleChoice final : public RuleSource {
 public:
  using Halfedge = StripMesh::Halfedge;

  explicit RuleChoice(const Cost& cost) noexcept : cost_(cost), weighs_(cost.swap != 0 || cost.isolated != 0) {}
  [[nodiscard]] const Cost& cost() const noexcept { return cost_; }
  /// Whether the cost weighs swaps or isolated triangles. Swaps are then counted.
  [[nodiscard]] bool weighs() const noexcept { return weighs_; }
  /// `searches`: a search follows; then colours that cost no more than the rule's are passed on, and start() names the
  /// triangles of the patch after the operation, or the strip ends among them.
  void begin(bool searches, bool from_ends) noexcept {
    searches_ = searches;
    from_ends_ = from_ends;
    start_.clear();
  }

  Rule split(const StripMesh& mesh, Halfedge left, const InteriorFan& fan) override;
  Rule collapse(const StripMesh& mesh, Halfedge chord, const InteriorFan& fan, Word ring) override;
  Answer answer_split(const StripMesh& mesh, const VertexSplit& where, SeenPatch& patch) override;
  Answer answer_collapse(const StripMesh& mesh, Halfedge chord, SeenPatch& patch) override;
  /// Notes an operation without a rule, which has been done.
  void did(const ColoringChange& change) noexcept { change_ = change; }
  /// Counts another operation, which always takes its rule and has been done.
  Rewrite taken(const Rewrite& done) noexcept {
    ++counts_.asked;
    took(done);
    return done;
  }

  /// After a split or a collapse: notes where a search begins. New triangles come first.
  void begin_after_split(const StripMesh& mesh, const FanChange& change, Halfedge chord);
  void begin_after_collapse(const StripMesh& mesh, const FanChange& change, Halfedge spoke);
  [[nodiscard]] std::vector<Triangle>& start() noexcept { return start_; }

  /// Takes the counts of begin_split() and begin_collapse(), if swaps are not weighed.
  void note(const FanChange& change) noexcept { change_.isolated = change.counts.isolated; }

  /// The change by the colours chosen last. Swaps are right if they are weighed and the operation is a split or a
  /// collapse.
  [[nodiscard]] const ColoringChange& change() const noexcept { return change_; }
  void count_improved(bool improved) noexcept { counts_.improved += improved ? 1U : 0U; }
  [[nodiscard]] RuleCounts& counts() noexcept { return counts_; }
  [[nodiscard]] const RuleCounts& counts() const noexcept { return counts_; }

 private:
  void keep_ends(const StripMesh& mesh);
  void took(const ColoringChange& change) noexcept {
    change_ = change;
    ++counts_.taken;
  }
  [[nodiscard]] bool keeps(const ColoringChange& kept, const ColoringChange& by_rule) noexcept;
  template <class Change>
  Rule chosen(const Rule& rule, Word passed, Change&& change);
  template <class WalkPorts>
  Answer chosen(const StripMesh& mesh, SeenPatch& patch, WalkPorts&& walk_ports);

  Cost cost_;
  bool weighs_;
  bool searches_ = false;
  bool from_ends_ = false;
  std::vector<Triangle> start_;
  ColoringChange change_;
  RuleCounts counts_;
};

}  // namespace restrip::detail
