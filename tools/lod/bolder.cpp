#include "lod/bolder.hpp"

#include <limits>

#include "restrip/operations/linked.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Fan = detail::InteriorFan<Halfedge>;
static_assert(detail::max_interior_valence == max_compared_valence, "larger fans are not asked for by split() below");

/// Answers with the local rule, and asks the linked one beside it for closed fans of ordinary valence. With every strip
/// followed to its end the linked rule is the best in this mesh (docs/trust.md).
class Comparison : public detail::LocalRules {
 public:
  Comparison(Boldness& splits, Boldness& collapses) : splits_(&splits), collapses_(&collapses) {}

  Rule split(const StripMesh& mesh, Halfedge left, const Fan& fan) const {
    const Rule local = detail::LocalRules{}.split(mesh, left, fan);
    note(*splits_, local, linked.split(mesh, left, fan), best.split(mesh, left, fan));
    return local;
  }
  Rule collapse(const StripMesh& mesh, Halfedge chord, const Fan& fan, Word ring) const {
    const Rule local = detail::LocalRules{}.collapse(mesh, chord, fan, ring);
    note(*collapses_, local, linked.collapse(mesh, chord, fan, ring), best.collapse(mesh, chord, fan, ring));
    return local;
  }

 private:
  static constexpr detail::LinkedRules linked{default_reach};
  static constexpr detail::LinkedRules best{std::numeric_limits<std::size_t>::max()};  // to the ends of the strips

  static void note(Boldness& counts, const Rule& local, const Rule& linked_rule, const Rule& best_rule) {
    ++counts.operations;
    counts.costing += local.strips > 0 ? 1 : 0;
    counts.costing_at_best += best_rule.strips > 0 ? 1 : 0;
    counts.bolder += best_rule.strips < local.strips ? 1 : 0;
    counts.missed_by_linked += best_rule.strips < linked_rule.strips ? 1 : 0;
  }

  Boldness* splits_;
  Boldness* collapses_;
};

}  // namespace

BoldnessReport count_bolder(const ProgressiveMesh& source, const StripMesh& base) {
  BoldnessReport report;
  const Comparison rules(report.splits, report.collapses);
  StripMesh mesh = base;
  for (const Record& record : source.splits) detail::split_with(rules, mesh, spokes_of(mesh, record), record.v_t);
  for (auto record = source.splits.rbegin(); record != source.splits.rend(); ++record)
    detail::collapse_with(rules, mesh, mesh.spoke(record->v_s, record->v_t));
  return report;
}

}  // namespace restrip::tools
