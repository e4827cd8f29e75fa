#include "operation_check.hpp"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

namespace restrip::verify {
namespace {

std::vector<bool> valid_configurations(const std::vector<Answer>& answers) {
  std::vector<bool> valid;
  valid.reserve(answers.size());
  for (const Answer answer : answers) valid.push_back(answer != not_valid);
  return valid;
}

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

OperationCheck check_operation(const OperationTask& task, bool second_formulation) {
  OperationCheck check;
  double last = thread_seconds();
  const auto lap = [&](double& stage) {
    const double now = thread_seconds();
    stage += now - last;
    last = now;
  };
  const Operation& operation = *task.operation;
  Judge judge(*task.section, *task.rows, operation, task.file);
  SecondOpinion second(operation);
  for (Mask ports = 0; ports < mask_count(operation.before.ports()); ++ports) {
    const PortSlice slice = slice_of(operation, ports);
    judge.judge(slice);
    lap(check.judging_seconds);
    if (!second_formulation || !searched(operation)) continue;
    second.compare(slice);
    lap(check.agreement_seconds);
  }
  check.judgment = judge.judgment();
  check.agreement = second.agreement();
  const std::vector<bool> valid = valid_configurations(check.judgment.answers);
  check.burnside = burnside_orbits(operation, valid);
  lap(check.burnside_seconds);
  check.nauty = searched(operation) ? nauty_orbits(operation, valid) : check.burnside;
  lap(check.nauty_seconds);
  return check;
}

std::vector<OperationCheck> check_operations(const std::vector<OperationTask>& tasks, bool second_formulation,
                                             unsigned threads, const std::function<void(std::size_t)>& on_done) {
  // Large patches first, so that no thread is left with a long task at the end.
  std::vector<std::size_t> order(tasks.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto size = [&](std::size_t i) {
    return tasks[i].operation->before.inner_edges() + tasks[i].operation->after.inner_edges() +
           tasks[i].operation->before.ports();
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });

  std::vector<OperationCheck> checks(tasks.size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t done = 0;
  std::exception_ptr error;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < order.size(); i = next++) {
        checks[order[i]] = check_operation(tasks[order[i]], second_formulation);
        const std::lock_guard lock(mutex);
        on_done(++done);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      error = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(work);
    work();
  }
  if (error) std::rethrow_exception(error);
  return checks;
}

}  // namespace restrip::verify
