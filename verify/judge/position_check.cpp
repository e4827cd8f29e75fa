#include "judge/position_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <mutex>
#include <numeric>

#include "judge/reason_check.hpp"
#include "model/on_threads.hpp"

namespace restrip::verify {
namespace {

class RowChecker {
 public:
  RowChecker(const PositionTask& task, RuleJudge& judge, PositionCheck& check)
      : task_(task), operation_(*task.operation), judge_(judge), check_(check) {
    check.row_used.resize(task.rows->rows.size());
    check.reason_faults.resize(task.rows->rows.size());
  }

  void run() {
    for (std::uint32_t number = 0; number < judge_.before().classes().size(); ++number) {
      const ColoringClass& configurations = judge_.before().classes()[number];
      const Key key = judge_.key_of_class(number);
      if (const Row* const row = task_.rows->row_of(key)) {
        judge_row(*row, configurations);
      } else {
        check_.missing.add(
            fmt::format("{}: {}: no row for the key {:x} {:x} of\n    {}\n", task_.file, operation_.name(), key.ports,
                        key.joined.bits, drawn(operation_.before, configurations.first)),
            configurations.colorings);
      }
    }
  }
  void check_reasons() {
    if (!may_have_reasons(operation_)) return;
    for (std::uint32_t number = 0; number < judge_.before().classes().size(); ++number) {
      const Row* const row = task_.rows->row_of(judge_.key_of_class(number));
      if (row == nullptr || row->copy) continue;
      std::string& fault = check_.reason_faults[index_of(*row)];
      const Colors configuration = judge_.before().classes()[number].first;
      if (row->reason && fault.empty()) fault = fault_of_reason(judge_, configuration, row->after, *row->reason);
      if (!row->reason && !searched(operation_)) fault = "there is none, and more ports than are searched";
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

  void judge_row(const Row& row, const ColoringClass& configurations) {
    check_.row_used[index_of(row)] = true;
    check_.with_row += configurations.colorings;
    const Judged judged = judge_.judged(configurations.first, row.after);
    if (judged.verdict == Verdict::right || judged.verdict == Verdict::not_best)
      check_.with_sound_row += configurations.colorings;
    if (Failures* const failures = failures_of(judged)) {
      // Explaining takes longer than judging: only the first is shown.
      failures->add(failures->count != 0 ? std::string()
                                         : fmt::format("{}:{}: \"{}\"\n    {}, inner {:x}, ports {:x}\n{}", task_.file,
                                                       row.line, row.text(), operation_.name(),
                                                       configurations.first.inner, configurations.first.ports,
                                                       judge_.explained(configurations.first, row.after, judged)),
                    configurations.colorings);
    }
    count_cost(row, configurations);
  }

  /// What the rule does to the numbers of strips and of isolated triangles.
  void count_cost(const Row& row, const ColoringClass& configurations) {
    const Side& before = operation_.before;
    const auto given_up = static_cast<int>(solid_count(configurations.first.ports & ~row.after.ports));
    const int strips_after = strips_of(operation_.after, row.after);
    const int isolated_after = static_cast<int>(isolated_of(operation_.after, row.after)) + given_up;
    const bool matching = operation_.constraint == Constraint::matching;
    for (unsigned solid = 0; solid < configurations.with_solid.size(); ++solid) {
      const int strips = strips_after - (static_cast<int>(before.triangles) - static_cast<int>(solid));
      count(configurations.with_solid[solid], strips, !matching, check_.worst_strips);
    }
    for (unsigned isolated = 0; isolated < configurations.with_isolated.size(); ++isolated)
      count(configurations.with_isolated[isolated], isolated_after - static_cast<int>(isolated), matching,
            check_.worst_isolated);
  }
  void count(std::uint64_t configurations, int change, bool costs, std::optional<int>& worst) {
    if (configurations == 0) return;
    worst = std::max(worst.value_or(change), change);
    if (costs && change > 0) check_.costing += configurations;
  }

  const PositionTask& task_;
  const Operation& operation_;
  RuleJudge& judge_;
  PositionCheck& check_;
};

/// The first configuration whose class does not tell its joined ports, or whose joined ports do not tell its class.
void check_keys(const RuleJudge& judge, const FitTable& table, PositionCheck& check) {
  const Colorings& before = judge.before();
  const auto fail = [&](Colors configuration) {
    check.odd_keys.add(fmt::format("    {}\n  its joined ports do not tell which worlds it fits\n",
                                   drawn(judge.operation().before, configuration)));
  };
  if (before.odd_one() != Colorings::not_valid) fail(before.coloring(before.odd_one()));
  std::map<Key, std::uint32_t> class_of_joined;
  for (std::uint32_t number = 0; number < before.classes().size(); ++number) {
    const ColoringClass& own = before.classes()[number];
    const FitClass& fit = table.classes()[own.fit_class];
    if (!class_of_joined.try_emplace({fit.ports, fit.joined}, number).second) fail(own.first);
    check.keys.insert(judge.key_of_class(number));
    check.valid += own.colorings;
  }
  check.configurations = before.size();
  check.tested = before.tested() + judge.after().tested();
  check.pairs = judge.pairs();
  check.shortcuts = judge.shortcuts();
  check.wrong_shortcuts = judge.wrong_shortcuts();
}

std::vector<bool> valid_configurations(const Colorings& before) {
  std::vector<bool> valid;
  valid.reserve(before.size());
  for (Mask both = 0; both < before.size(); ++both) valid.push_back(before.valid(before.coloring(both)));
  return valid;
}

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

FitTable& FitTables::of(const Operation& operation) {
  std::unique_ptr<FitTable>& table = tables_[{operation.constraint, operation.ports()}];
  if (!table) table = std::make_unique<FitTable>(operation.constraint, operation.ports());
  return *table;
}

PositionCheck check_position(const PositionTask& task, bool second_formulation, FitTables& tables) {
  PositionCheck check;
  double last = thread_seconds();
  const auto lap = [&](double& stage) {
    const double now = thread_seconds();
    stage += now - last;
    last = now;
  };
  const Operation& operation = *task.operation;
  FitTable& table = tables.of(operation);
  RuleJudge judge(operation, table);
  check_keys(judge, table, check);
  if (task.rows == nullptr) return check;
  RowChecker rows(task, judge, check);
  rows.run();
  lap(check.seconds.judging);
  rows.check_reasons();
  lap(check.seconds.reasons);
  if (second_formulation && searched(operation) && has_second_formulation(operation)) {
    check.agreement = second_opinion_on(judge);
    lap(check.seconds.agreement);
  }
  const std::vector<bool> valid = valid_configurations(judge.before());
  check.merged = merged_orbits(operation, Symmetries(operation, Symmetries::Keep::both_sides), valid);
  lap(check.seconds.merged);
  if (searched(operation)) check.nauty = nauty_orbits(operation, valid);
  lap(check.seconds.nauty);
  return check;
}

std::vector<PositionCheck> check_positions(const std::vector<PositionTask>& tasks, bool second_formulation,
                                           unsigned threads, const std::function<void(std::size_t)>& on_done) {
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
  on_threads(threads, order.size(), [&] {
    return [&, tables = FitTables()](std::size_t i) mutable {
      checks[order[i]] = check_position(tasks[order[i]], second_formulation, tables);
      const std::lock_guard lock(mutex);
      on_done(++done);
    };
  });
  return checks;
}

}  // namespace restrip::verify
