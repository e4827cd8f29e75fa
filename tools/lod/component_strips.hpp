// How many strips each connected component of a mesh has, and how many it cannot do without.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// Each connected component of the dual graph takes at least one strip, and a triangle with at most one neighbour is
/// the end of a strip. A vertex split neither joins components nor divides them, so the counts are kept in linear time
/// in its patch.
class ComponentStrips {
 public:
  /// Linear time.
  explicit ComponentStrips(const StripMesh& mesh);

  /// Before a split, the triangles around its vertex; after it, those around both its vertices.
  void before_split(const StripMesh& mesh, const std::vector<Triangle>& patch);
  void after_split(const StripMesh& mesh, const std::vector<Triangle>& patch);
  /// The component of a triangle has so many strips more than before.
  void add(Triangle t, std::ptrdiff_t strips) { components_[component_[t]].strips += strips; }
  /// Reads the strips again, after any change of colours. Linear time.
  void recount(const StripMesh& mesh);

  [[nodiscard]] std::size_t components() const noexcept { return components_.size(); }
  /// Of the whole mesh, whatever its colours.
  [[nodiscard]] std::size_t needed() const noexcept { return static_cast<std::size_t>(needed_); }
  /// The component of a triangle has more strips than it is known to need.
  [[nodiscard]] bool can_spare(Triangle t) const {
    const Component& component = components_[component_[t]];
    return component.strips > component.needed();
  }

 private:
  struct Component {
    std::ptrdiff_t strips = 0;
    std::ptrdiff_t tips = 0;  // triangles with at most one neighbour
    [[nodiscard]] std::ptrdiff_t needed() const noexcept { return tips > 2 ? (tips + 1) / 2 : 1; }
  };
  [[nodiscard]] static std::ptrdiff_t tips(const StripMesh& mesh, const std::vector<Triangle>& patch);

  std::vector<std::uint32_t> component_;  // of each triangle
  std::vector<Component> components_;
  std::ptrdiff_t needed_ = 0;
  std::uint32_t split_ = 0;  // the component of the split that is continuing
};

/// No colouring has fewer strips. Linear time.
[[nodiscard]] inline std::size_t strips_at_least(const StripMesh& mesh) { return ComponentStrips(mesh).needed(); }

}  // namespace restrip::tools
