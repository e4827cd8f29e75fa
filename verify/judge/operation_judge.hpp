// Judges the rules of one operation at one position: by the definition or, beyond the searched number of ports, by the
// theorem about keys. In the latter case reasons must show that nothing is better.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "certificate/certificate.hpp"
#include "definition/definition.hpp"
#include "judge/report.hpp"
#include "judge/symmetry.hpp"
#include "model/coloring.hpp"
#include "model/masks.hpp"

namespace restrip::verify {

/// The keys of configurations (docs/reference/operation-file.md), by which certificates list rules. It is a theorem
/// about the definition that a key contains all that a rule must know; verdicts on searched rows do not depend on it.
class Keys {
 public:
  explicit Keys(const Operation& operation);

  /// Empty for a configuration that is not valid.
  std::optional<Key> key_of(Colors configuration) const;
  /// Whether a recolouring with admissible ports is sound for all configurations with this key: if it is valid and
  /// joins no other ports (the locality lemma).
  bool sound(const Key& key, Colors recoloring) const;

 private:
  const Operation& operation_;
  std::vector<PortPairs> joinable_;  ///< by ports: the pairs that some recolouring joins
};

class OperationJudge {
 public:
  explicit OperationJudge(const Operation& operation);

  const Operation& operation() const { return operation_; }
  const std::optional<Definition>& definition() const { return definition_; }

  /// Empty for a configuration that is not valid.
  std::optional<Key> key_of(Colors configuration) const;
  /// Judges a recolouring of a valid configuration; never `not_best` if the operation is not searched.
  Judged judged(Colors configuration, Colors recoloring) const;
  /// For a valid configuration.
  bool is_sound(Colors configuration, Colors recoloring) const;
  /// A full explanation: colours drawn, the world in which they are not valid, the better recolouring.
  std::string explained(Colors configuration, Colors recoloring, const Judged& judged) const;

 private:
  const Operation& operation_;
  Keys keys_;
  std::optional<Definition> definition_;
};

// Checks reasons: why nothing is better than a rule (docs/reference/certificate.md, "Reasons"). All sets and cases are
// in the file. A set "cannot be all solid" if the colouring in which exactly it is solid is not sound, by the worlds.
// docs/reference/verifiers.md proves that a reason that passes is valid.

/// The fault of a reason why nothing is better than this recolouring of a valid configuration; empty if the reason is
/// valid. Precondition: the operation may have reasons.
std::string fault_of_reason(const OperationJudge& judge, Colors configuration, Colors recoloring, const Reason& reason);

/// All checks of one operation at one position, and the threads that run them.
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

/// Runs all tasks on this number of threads; results are in the order of the tasks.
std::vector<PositionCheck> check_positions(const std::vector<PositionTask>& tasks, unsigned threads);

}  // namespace restrip::verify
