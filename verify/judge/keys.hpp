#pragma once
// The keys of configurations (docs/reference/operation-file.md), by which certificates list rules. It is a theorem
// about the definition that a key contains all that a rule must know; verdicts on searched rows do not depend on it.

#include <vector>

#include "model/coloring.hpp"
#include "model/key.hpp"

namespace restrip::verify {

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

}  // namespace restrip::verify
