// All checks of one operation at one position, and the threads that run them.
#pragma once

#include <functional>
#include <set>

#include "certificate/certificate.hpp"
#include "judge/operation_judge.hpp"
#include "judge/orbits.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

struct PositionCheck {
  const Operation* operation = nullptr;
  std::uint64_t configurations = 0;
  std::uint64_t valid = 0;
  std::uint64_t with_row = 0;        ///< valid ones that have a row
  std::uint64_t with_sound_row = 0;  ///< valid ones whose row is sound
  std::uint64_t graphs = 0;          ///< colourings of a patch in a world that were judged
  std::uint64_t costing = 0;
  std::optional<int> worst_strips;
  std::optional<int> worst_isolated;
  std::set<Key> keys;  ///< of valid configurations
  Failures missing;
  Failures wrong_ports;
  Failures unsound;
  std::array<Failures, most_criteria> not_best;
  std::vector<bool> row_used;
  std::vector<std::string> reason_faults;  ///< by row; for rules that serve a configuration here
  OrbitCounts orbits;

  /// Processor time.
  struct Seconds {
    double judging = 0;
    double reasons = 0;
    double orbits = 0;
  } seconds;
};

/// One task: an operation and the rows that serve it. Without rows, its configurations are only counted.
struct PositionTask {
  const Operation* operation = nullptr;
  const SectionRows* rows = nullptr;
  std::string file;
};

/// Runs all tasks on this number of threads; results are in the order of the tasks. `on_done` is called with the number
/// of finished tasks, from one thread at a time.
std::vector<PositionCheck> check_positions(const std::vector<PositionTask>& tasks, unsigned threads,
                                           const std::function<void(std::size_t)>& on_done);

}  // namespace restrip::verify
