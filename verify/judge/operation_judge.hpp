#pragma once
// Judges the rules of one operation at one position: by the definition or, beyond the searched number of ports, by the
// theorem about keys. In the latter case reasons must show that nothing is better.

#include <string>

#include "definition/definition.hpp"
#include "judge/keys.hpp"

namespace restrip::verify {

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
