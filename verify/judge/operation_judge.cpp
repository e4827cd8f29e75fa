#include "judge/operation_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "common/progress.hpp"
#include "common/share.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

Keys::Keys(const Operation& operation) : operation_(operation), joinable_(mask_count(operation.ports())) {
  std::vector<PortPairs> joined(joinable_.size());  // by kept ports
  const unsigned most = most_solid(operation.constraint);
  for (Mask inner = 0; inner < mask_count(operation.after.inner_edges()); ++inner)
    if (const auto graph = valid_graph(operation.after, {inner, 0}, most))
      for (Mask kept = 0; kept < joined.size(); ++kept)
        if (valid_graph(operation.after, {inner, kept}, most))
          joined[kept].add(joined_ports(operation.after, *graph, kept));
  for (Mask ports = 0; ports < joinable_.size(); ++ports)
    for (Mask kept = 0; kept <= ports; ++kept)
      if (admissible(operation, ports, kept)) joinable_[ports].add(joined[kept]);
}

std::optional<Key> Keys::key_of(Colors configuration) const {
  const std::optional<SolidGraph> inner =
      valid_graph(operation_.before, configuration, most_solid(operation_.constraint));
  if (!inner) return {};
  const PortPairs joined = joined_ports(operation_.before, *inner, configuration.ports);
  return Key{configuration.ports, joined.both(joinable_[configuration.ports])};
}

bool Keys::sound(const Key& key, Colors recoloring) const {
  const std::optional<SolidGraph> inner = valid_graph(operation_.after, recoloring, most_solid(operation_.constraint));
  return inner && joined_ports(operation_.after, *inner, recoloring.ports).within(key.joined);
}

OperationJudge::OperationJudge(const Operation& operation) : operation_(operation), keys_(operation) {
  if (searched(operation)) definition_.emplace(operation);
}

std::optional<Key> OperationJudge::key_of(Colors configuration) const {
  if (definition_ && !definition_->valid(configuration)) return {};
  return keys_.key_of(configuration);
}

bool OperationJudge::is_sound(Colors configuration, Colors recoloring) const {
  if (!admissible(operation_, configuration.ports, recoloring.ports)) return false;
  if (definition_) return !definition_->refuting_world(configuration, recoloring);
  return keys_.sound(keys_.key_of(configuration).value(), recoloring);
}

Judged OperationJudge::judged(Colors configuration, Colors recoloring) const {
  if (definition_) return definition_->judged(configuration, recoloring);
  if (!admissible(operation_, configuration.ports, recoloring.ports)) return {Verdict::wrong_ports};
  return {is_sound(configuration, recoloring) ? Verdict::right : Verdict::unsound};
}

std::string OperationJudge::explained(Colors configuration, Colors recoloring, const Judged& judged) const {
  std::string text = fmt::format("    before  {}\n    after   {}\n", drawn(operation_.before, configuration),
                                 drawn(operation_.after, recoloring));
  const Mask taken = recoloring.ports & ~configuration.ports;
  const Mask refused = configuration.ports & ~recoloring.ports & ~operation_.may_give_up;
  switch (judged.verdict) {
    case Verdict::right:
      break;
    case Verdict::wrong_ports:
      for (unsigned port = 0; port < operation_.ports(); ++port) {
        if (is_solid(taken, port)) return text + fmt::format("  port {} was dashed and becomes solid\n", port);
        if (is_solid(refused, port)) return text + fmt::format("  port {} must stay but is given up\n", port);
      }
      break;
    case Verdict::unsound: {
      const std::string invalid = invalid_because(operation_.after, recoloring, most_solid(operation_.constraint));
      if (!invalid.empty())
        text += fmt::format("  unsound: {} after\n", invalid);
      else if (definition_)
        text +=
            fmt::format("  unsound: with {}, the solid edges have no cycle before, but one after\n",
                        text_of(definition_->world(definition_->refuting_world(configuration, recoloring).value())));
      else
        text += "  unsound: it joins ports that were not joined before\n";
      if (definition_ && !definition_->best(configuration))
        text += "  no recolouring is sound here; the operation must be allowed to give up more ports\n";
      break;
    }
    case Verdict::not_best: {
      const Candidate better = definition_->best(configuration).value();
      const Criterion& criterion = operation_.cost[judged.criterion];
      text +=
          fmt::format("    better  {}\n  not best: {} is {}, and may be {}\n", drawn(operation_.after, better.colors),
                      text_of(criterion), definition_->cost(configuration, recoloring)[judged.criterion],
                      better.cost[judged.criterion]);
      break;
    }
  }
  return text;
}

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

namespace {

PositionCheck check_position(const PositionTask& task) {
  PositionCheck check;
  double last = thread_seconds();
  const auto lap = [&](double& stage) {
    const double now = thread_seconds();
    stage += now - last;
    last = now;
  };
  check.operation = task.operation;
  const Operation& operation = *task.operation;
  const OperationJudge judge(operation);
  if (task.rows != nullptr) {
    check.row_used.resize(task.rows->rows.size());
    check.reason_faults.resize(task.rows->rows.size());
  }
  std::vector<std::pair<const Row*, Colors>> first;  // the first configuration that each row serves
  const auto index_of = [&](const Row& row) { return static_cast<std::size_t>(&row - task.rows->rows.data()); };
  const auto judge_row = [&](const Row& row, Colors configuration) {
    if (!check.row_used[index_of(row)]) first.emplace_back(&row, configuration);
    check.row_used[index_of(row)] = true;
    ++check.with_row;
    const Judged judged = judge.judged(configuration, row.after);
    if (judged.verdict == Verdict::right || judged.verdict == Verdict::not_best) ++check.with_sound_row;
    if (judged.verdict != Verdict::right) {
      Failures& failures = judged.verdict == Verdict::wrong_ports ? check.wrong_ports
                           : judged.verdict == Verdict::unsound   ? check.unsound
                                                                  : check.not_best[judged.criterion];
      failures.add(failures.count != 0
                       ? std::string()
                       : fmt::format("{}:{}: \"{}\"\n    {}, inner {}, ports {}\n{}", task.file, row.line, row.text(),
                                     operation.name(), configuration.inner, configuration.ports,
                                     judge.explained(configuration, row.after, judged)));
    }
    const Change change = change_of(operation, configuration, row.after);
    check.worst_strips = std::max(check.worst_strips.value_or(change.strips), change.strips);
    check.worst_isolated = std::max(check.worst_isolated.value_or(change.isolated), change.isolated);
    const bool matching = operation.constraint == Constraint::matching;
    if ((matching ? change.isolated : change.strips) > 0) ++check.costing;
  };

  std::vector<bool> valid(mask_count(operation.before.colors()));
  check.configurations = valid.size();
  for (Mask both = 0; both < valid.size(); ++both) {
    const Colors configuration{high_part(both, operation.ports()), low_part(both, operation.ports())};
    const std::optional<Key> key = judge.key_of(configuration);
    if (!key) continue;
    valid[both] = true;
    ++check.valid;
    check.keys.insert(*key);
    if (task.rows == nullptr) continue;
    if (const Row* const row = task.rows->row_of(*key))
      judge_row(*row, configuration);
    else
      check.missing.add(check.missing.count != 0
                            ? std::string()
                            : fmt::format("{}: {}: no row for the key {:x} {:x} of\n    {}\n", task.file,
                                          operation.name(), key->ports, key->joined.bits,
                                          drawn(operation.before, configuration)));
  }
  if (judge.definition()) check.graphs = judge.definition()->graphs();
  lap(check.seconds.judging);
  if (task.rows == nullptr) return check;

  if (may_have_reasons(operation))
    for (const auto& [row, configuration] : first) {
      if (row->copy) continue;
      std::string& fault = check.reason_faults[index_of(*row)];
      if (row->reason) fault = fault_of_reason(judge, configuration, row->after, *row->reason);
      if (!row->reason && !searched(operation))
        fault = fmt::format("missing, and {} has {} ports: without reasons at most {} are searched", operation.name(),
                            operation.ports(), most_searched_ports);
    }
  lap(check.seconds.reasons);
  check.orbits = merged_orbits(operation, Symmetries(operation, Symmetries::Keep::both_sides), valid);
  lap(check.seconds.orbits);
  return check;
}

}  // namespace

std::vector<PositionCheck> check_positions(const std::vector<PositionTask>& tasks, unsigned threads) {
  // Large patches first, so that no thread is left with a long task at the end.
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto size = [&](std::size_t i) {
    return tasks[i].operation->before.colors() + tasks[i].operation->after.inner_edges();
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });

  std::vector<PositionCheck> checks(tasks.size());
  Progress progress("checking positions", order.size());
  share(order.size(), threads, [&](std::size_t i) {
    checks[order[i]] = check_position(tasks[order[i]]);
    progress.step();
  });
  return checks;
}

}  // namespace restrip::verify
