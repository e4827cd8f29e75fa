#include "judge/reason_check.hpp"

#include <fmt/format.h>

namespace restrip::verify {
namespace {

/// The losses of a recolouring, most important first; less is better.
struct Loss {
  int dashed = 0;    ///< edges, including ports given up
  int isolated = 0;  ///< triangles; every port given up counts as one
  int given_up = 0;  ///< ports
  friend constexpr auto operator<=>(const Loss&, const Loss&) = default;
};

/// The reason of one rule. Sets of edges are masks: inner edges first, then ports; ports that may be given up are
/// edges.
class RuleReason {
 public:
  RuleReason(const OperationJudge& judge, Colors configuration, Colors recoloring)
      : judge_(judge), operation_(judge.operation()), configuration_(configuration) {
    const unsigned inner = operation_.after.inner_edges();
    const Mask open_ports = configuration.ports & operation_.may_give_up;
    staying_ports_ = configuration.ports & ~open_ports;
    edges_ = concatenated(open_ports, mask_count(inner) - 1, inner);
    row_loss_ = loss(edges_ & ~concatenated(recoloring.ports & open_ports, recoloring.inner, inner));
  }

  /// The fault of a reason, given that the edges `solid` are solid and the edges `dashed` are not; empty if it is
  /// correct.
  std::string fault(const Reason& reason, Mask solid, Mask dashed) const {
    if (reason.cases.empty()) return fault_of_leaf(reason.sets, solid, dashed);
    const Mask edge = single(reason.edge);
    if (!is_subset(edge, edges_)) return fmt::format("edge {} is fixed", reason.edge);
    const std::string first = fault(reason.cases[0], solid | edge, dashed);
    return first.empty() ? fault(reason.cases[1], solid, dashed | edge) : first;
  }

 private:
  Colors colors_of(Mask solid) const {
    const unsigned inner = operation_.after.inner_edges();
    return {low_part(solid, inner), staying_ports_ | high_part(solid, inner)};
  }

  std::string fault_of_leaf(const std::vector<Mask>& sets, Mask solid, Mask dashed) const {
    Mask taken = solid | dashed;
    Mask surely_dashed = dashed;
    for (const Mask set : sets) {
      if (!is_subset(set, edges_)) return fmt::format("the set {:x} has a fixed edge", set);
      if ((set & taken) != 0)
        return fmt::format("the set {:x} has an edge that is in another set or settled by a case", set);
      if (judge_.is_sound(configuration_, colors_of(set | solid)))
        return fmt::format("the set {:x} may be all solid", set);
      taken |= set;
      if (solid_count(set) == 1) surely_dashed |= set;
    }
    Loss least = loss(surely_dashed);
    least.dashed = static_cast<int>(solid_count(dashed) + sets.size());
    if (least >= row_loss_) return {};
    return fmt::format("a case shows {} dashed, {} isolated, {} ports given up; the row has {}, {}, {}", least.dashed,
                       least.isolated, least.given_up, row_loss_.dashed, row_loss_.isolated, row_loss_.given_up);
  }

  /// The loss of a recolouring in which exactly these edges are dashed.
  Loss loss(Mask dashed) const {
    const auto given_up = static_cast<int>(solid_count(high_part(dashed, operation_.after.inner_edges())));
    const auto isolated = static_cast<int>(isolated_of(operation_.after, colors_of(edges_ & ~dashed)));
    return {static_cast<int>(solid_count(dashed)), isolated + given_up, given_up};
  }

  const OperationJudge& judge_;
  const Operation& operation_;
  Colors configuration_;
  Mask edges_ = 0;
  Mask staying_ports_ = 0;
  Loss row_loss_;
};

}  // namespace

std::string fault_of_reason(const OperationJudge& judge, Colors configuration, Colors recoloring,
                            const Reason& reason) {
  return RuleReason(judge, configuration, recoloring).fault(reason, 0, 0);
}

}  // namespace restrip::verify
