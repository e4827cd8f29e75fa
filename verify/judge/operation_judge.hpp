// Judges the rules of one operation at one position: by the definition or, beyond the searched number of ports, by the
// theorem about keys. In the latter case reasons must show that nothing is better.
#pragma once

#include <string>
#include <vector>

#include "definition/definition.hpp"
#include "model/coloring.hpp"
#include "model/key.hpp"

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

}  // namespace restrip::verify
