#pragma once
// The key of a configuration (docs/notation.md): what a rule needs to know.

#include "operation.hpp"
#include "survey.hpp"

namespace restrip::verify {

struct Key {
  Mask ports = 0;
  Mask second = 0;  ///< `joined`; for a flip the inner edge
  friend constexpr bool operator==(Key, Key) = default;
  friend constexpr auto operator<=>(Key, Key) = default;
};

/// Bit i: solid port i is joined to the solid port that precedes it.
Mask joined_to_predecessor(PortPairs joined, Mask ports, unsigned port_count, bool closed);

/// The pairs that a `joined` mask stands for; nullopt when it names a port that is dashed or has no predecessor.
std::optional<PortPairs> pairs_of(Mask joined, Mask ports, unsigned port_count, bool closed);

/// The key of a valid configuration.
Key key_of(const Operation& operation, Coloring before, const Survey& survey);

}  // namespace restrip::verify
