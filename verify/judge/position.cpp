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
