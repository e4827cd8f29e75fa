#pragma once
// The key of a configuration (docs/operation-file.md, "What a rule must be"): what a rule needs to know.

#include "model/masks.hpp"

namespace restrip::verify {

struct Key {
  Mask ports = 0;    ///< the solid ones
  PortPairs joined;  ///< those pairs of them that are joined, and that some recolouring joins
  friend constexpr bool operator==(Key, Key) = default;
  friend constexpr auto operator<=>(Key, Key) = default;
};

}  // namespace restrip::verify
