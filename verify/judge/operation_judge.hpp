#pragma once
// Judges the rules of one operation at one position: by the definition, or, of more ports than are searched, what keys
// say of soundness; what nothing is better than is then for reasons to show.

#include <string>

#include "definition/definition.hpp"
#include "judge/keys.hpp"

namespace restrip::verify {

class OperationJudge {
 public:
  explicit OperationJudge(const Operation& operation);

  const Operation& operation() const { return operation_; }
  const std::optional<Definition>& definition() const { return definition_; }

  /// Nothing for a configuration that is not valid.
  std::optional<Key> key_of(Colors configuration) const;
  /// Judges a recolouring of a valid configuration; never `not_best` when the operation is not searched.
  Judged judged(Colors configuration, Colors recoloring) const;
  /// Of a valid configuration.
  bool is_sound(Colors configuration, Colors recoloring) const;
  /// What is wrong, in full: colours drawn, the world in which they are not valid, the recolouring that is better.
  std::string explained(Colors configuration, Colors recoloring, const Judged& judged) const;

 private:
  const Operation& operation_;
  Keys keys_;
  std::optional<Definition> definition_;
};

}  // namespace restrip::verify
