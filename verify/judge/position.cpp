#include "judge/position.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <numeric>

#include "common/share.hpp"
#include "judge/reason_check.hpp"
#include "judge/report.hpp"

namespace restrip::verify {
namespace {

class RowChecker {
 public:
  RowChecker(const PositionTask& task, const OperationJudge& judge, PositionCheck& check)
      : task_(task), operation_(*task.operation), judge_(judge), check_(check) {
    check.row_used.resize(task.rows->rows.size());
    check.reason_faults.resize(task.rows->rows.size());
  }

  void judge(Colors configuration, const Key& key) {
    if (const Row* const row = task_.rows->row_of(key)) {
      judge_row(*row, configuration);
      count_cost(*row, configuration);
    } else {
      check_.missing.add(check_.missing.count != 0
                             ? std::string()
                             : fmt::format("{}: {}: no row for the key {:x} {:x} of\n    {}\n", task_.file,
                                           operation_.name(), key.ports, key.joined.bits,
                                           drawn(operation_.before, configuration)));
    }
  }
  /// For the first configuration that each rule serves.
  void check_reasons() {
    if (!may_have_reasons(operation_)) return;
    for (const auto& [row, configuration] : first_) {
      if (row->copy) continue;
      std::string& fault = check_.reason_faults[index_of(*row)];
      if (row->reason) fault = fault_of_reason(judge_, configuration, row->after, *row->reason);
      if (!row->reason && !searched(operation_)) fault = "missing, and the operation has too many ports to be searched";
    }
  }

 private:
  std::size_t index_of(const Row& row) const { return static_cast<std::size_t>(&row - task_.rows->rows.data()); }

  Failures* failures_of(const Judged& judged) {
    switch (judged.verdict) {
      case Verdict::right:
        return nullptr;
      case Verdict::wrong_ports:
        return &check_.wrong_ports;
      case Verdict::unsound:
        return &check_.unsound;
      case Verdict::not_best:
        break;
    }
    return &check_.not_best[judged.criterion];
  }

  void judge_row(const Row& row, Colors configuration) {
    if (!check_.row_used[index_of(row)]) first_.emplace_back(&row, configuration);
    check_.row_used[index_of(row)] = true;
    ++check_.with_row;
    const Judged judged = judge_.judged(configuration, row.after);
    if (judged.verdict == Verdict::right || judged.verdict == Verdict::not_best) ++check_.with_sound_row;
    if (Failures* const failures = failures_of(judged))
      failures->add(failures->count != 0
                        ? std::string()
                        : fmt::format("{}:{}: \"{}\"\n    {}, inner {:x}, ports {:x}\n{}", task_.file, row.line,
                                      row.text(), operation_.name(), configuration.inner, configuration.ports,
                                      judge_.explained(configuration, row.after, judged)));
  }

  /// The rule's change of the numbers of strips and of isolated triangles.
  void count_cost(const Row& row, Colors configuration) {
    const auto given_up = static_cast<int>(solid_count(configuration.ports & ~row.after.ports));
    const int strips = strips_of(operation_.after, row.after) - strips_of(operation_.before, configuration);
    const int isolated = static_cast<int>(isolated_of(operation_.after, row.after)) + given_up -
                         static_cast<int>(isolated_of(operation_.before, configuration));
    check_.worst_strips = std::max(check_.worst_strips.value_or(strips), strips);
    check_.worst_isolated = std::max(check_.worst_isolated.value_or(isolated), isolated);
    const bool matching = operation_.constraint == Constraint::matching;
    if ((matching ? isolated : strips) > 0) ++check_.costing;
  }

  const PositionTask& task_;
  const Operation& operation_;
  const OperationJudge& judge_;
  PositionCheck& check_;
  std::vector<std::pair<const Row*, Colors>> first_;
};

}  // namespace

PositionCheck check_position(const PositionTask& task) {
  PositionCheck check;
  double last = thread_seconds();
  const auto lap = [&](double& stage) {
    const double now = thread_seconds();
    stage += now - last;
    last = now;
  };
  const Operation& operation = *task.operation;
  const OperationJudge judge(operation);
  std::optional<RowChecker> rows;
  if (task.rows != nullptr) rows.emplace(task, judge, check);
  std::vector<bool> valid(mask_count(operation.before.colors()));
  check.configurations = valid.size();
  for (Mask both = 0; both < valid.size(); ++both) {
    const Colors configuration{high_part(both, operation.ports()), low_part(both, operation.ports())};
    const std::optional<Key> key = judge.key_of(configuration);
    if (!key) continue;
    valid[both] = true;
    ++check.valid;
    check.keys.insert(*key);
    if (rows) rows->judge(configuration, *key);
  }
  if (judge.definition()) check.graphs = judge.definition()->graphs();
  lap(check.seconds.judging);
  if (!rows) return check;
  rows->check_reasons();
  lap(check.seconds.reasons);
  check.merged = merged_orbits(operation, Symmetries(operation, Symmetries::Keep::both_sides), valid);
  lap(check.seconds.merged);
  if (searched(operation)) check.nauty = nauty_orbits(operation, valid);
  lap(check.seconds.nauty);
  return check;
}

std::vector<PositionCheck> check_positions(const std::vector<PositionTask>& tasks, unsigned threads,
                                           const std::function<void(std::size_t)>& on_done) {
  // Large patches first, so that no thread is left with a long task at the end.
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto size = [&](std::size_t i) {
    return tasks[i].operation->before.colors() + tasks[i].operation->after.inner_edges();
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });

  std::vector<PositionCheck> checks(tasks.size());
  std::mutex mutex;
  std::size_t done = 0;
  share(order.size(), threads, [&](std::size_t i) {
    checks[order[i]] = check_position(tasks[order[i]]);
    const std::lock_guard lock(mutex);
    on_done(++done);
  });
  return checks;
}

}  // namespace restrip::verify
