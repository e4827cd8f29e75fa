// The levels of detail that a report is about: from the base to the finest mesh in geometric steps.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// The mesh at one level of detail.
struct Level {
  std::size_t triangles = 0;
  std::size_t strips = 0;    ///< isolated triangles included
  std::size_t isolated = 0;  ///< strips of one triangle
  std::size_t swaps = 0;     ///< a first turn that needs one more index included
  std::size_t indices = 0;   ///< of the index buffer: strips with primitive restart
  /// The live buffer, as it is there after all operations that led here: its gaps are counted. 0: there was none.
  std::size_t buffer_indices = 0;
  double acmr = 0;  ///< of the live buffer, in a cache of 16 vertices, first in, first out
};

/// Counts the strips of a mesh. `faults` receives a sentence when some triangle is in no strip. Linear time.
[[nodiscard]] Level level_of(const StripMesh& mesh, std::vector<std::string>& faults);

/// Where to stop on the way up.
class LevelStops {
 public:
  /// `count` levels, base and finest level among them, at least 2.
  LevelStops(std::size_t base_triangles, std::size_t fine_triangles, std::size_t count);

  /// To be asked before each split: is this mesh, of that many triangles, the next level? The finest level is not asked
  /// for; it comes after the last split.
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
