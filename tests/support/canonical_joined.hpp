// Keys are compared in their canonical form (restrip/rules/key.hpp).
#pragma once

#include <bit>

#include "restrip/rules/key.hpp"

namespace restrip {

/// The canonical form of `joined`, for closed fans and rings: with exactly two solid ports either both bits are set or
/// none. Do not call this for open fans and paths, where every `joined` is canonical.
constexpr Word canonical_joined(Word ports, Word joined) noexcept {
  return joined != 0 && std::popcount(ports) == 2 ? ports : joined;
}

}  // namespace restrip
