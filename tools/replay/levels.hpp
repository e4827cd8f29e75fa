// The levels of detail in a report: from the base to the finest mesh in geometric steps.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// The mesh at one level of detail.
struct Level {
  std::size_t triangles = 0;
  std::size_t strips = 0;    ///< including isolated triangles
  std::size_t isolated = 0;  ///< strips of one triangle
  std::size_t swaps = 0;     ///< including a first turn that needs one more index
  std::size_t indices = 0;   ///< of an index buffer of strips with primitive restart
  /// The live buffer after all operations so far, including its gaps. 0: no live buffer.
  std::size_t buffer_indices = 0;
  double acmr = 0;  ///< of the live buffer, in a FIFO cache of 16 vertices
};

/// Counts the strips of a mesh. Adds a sentence to `faults` if a triangle is in no strip. Linear time.
[[nodiscard]] Level level_of(const StripMesh& mesh, std::vector<std::string>& faults);

/// Decides where to stop on the way up.
class LevelStops {
 public:
  /// `count` levels, including base and finest level; at least 2.
  LevelStops(std::size_t base_triangles, std::size_t fine_triangles, std::size_t count);

  /// Call it before each split: whether the current mesh is the next level. The finest level follows the last split
  /// without a call.
  [[nodiscard]] bool reached(std::size_t triangles) noexcept {
    if (next_ == sizes_.size() || triangles < sizes_[next_]) return false;
    ++next_;
    return true;
  }

 private:
  std::vector<std::size_t> sizes_;
  std::size_t next_ = 0;
};

}  // namespace restrip::tools
