// Strips from scratch.
#pragma once

#include <cstddef>

#include "restrip/greedy.hpp"
#include "restrip/strip_mesh.hpp"

namespace restrip {

enum class Effort {
  fast,  ///< one pass: stripify_fast (greedy.hpp)
};

/// Colours the whole mesh anew and returns the number of strips. Deterministic; all triangles are kept.
inline std::size_t stripify(StripMesh& mesh, [[maybe_unused]] Effort effort = Effort::fast) {
  return stripify_fast(mesh);
}

}  // namespace restrip
