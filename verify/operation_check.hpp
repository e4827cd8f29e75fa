#pragma once
// Everything that is checked of one operation at one position, and the threads that do it.

#include <functional>

#include "orbits.hpp"
#include "second_opinion.hpp"

namespace restrip::verify {

struct OperationCheck {
  Judgment judgment;
  Agreement agreement;  ///< of the second formulation, when asked for
  OrbitCounts burnside;
  OrbitCounts nauty;
  double judging_seconds = 0;  ///< processor time
  double agreement_seconds = 0;
  double burnside_seconds = 0;
  double nauty_seconds = 0;
};

/// One piece of work: an operation and the rows that serve it.
struct OperationTask {
  const Section* section = nullptr;
  const SectionRows* rows = nullptr;
  const Operation* operation = nullptr;
  std::string file;
};

OperationCheck check_operation(const OperationTask& task, bool second_formulation);

/// All tasks on so many threads; the result has the order of the tasks, whatever the threads do. `on_done` is called
/// with the number of finished tasks, from one thread at a time.
std::vector<OperationCheck> check_operations(const std::vector<OperationTask>& tasks, bool second_formulation,
                                             unsigned threads, const std::function<void(std::size_t)>& on_done);

/// Processor seconds of the calling thread.
double thread_seconds();

}  // namespace restrip::verify
