#pragma once
// Counterexamples as text.

#include <string>

#include "survey.hpp"

namespace restrip::verify {

/// The ring or path with solid `=` and dashed `-`, the chord, and the port of each triangle below it; in brackets the
/// neighbour around the ring. For instance
///     (t2 -) A - t0 = D - t1 = t2 (- A)     chord A = D
///                "        "    :                            ports: " solid, : dashed
///     ports joined inside: none
std::string drawn(const Patch& patch, Coloring colors, const std::string& indent);

/// The pairs as "0-3 1-2", or "none".
std::string listed(PortPairs pairs, unsigned ports);

}  // namespace restrip::verify
