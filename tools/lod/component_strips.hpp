// How many strips each connected component of a mesh has, and a lower bound for each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::tools {

/// Each connected component of the dual graph takes at least one strip, and a triangle with at most one neighbour is
/// the end of a strip. A vertex split neither joins nor divides components, so updating the counts takes time linear in
/// its patch.
class ComponentStrips {
 public:
  /// Linear time.
  explicit ComponentStrips(const StripMesh& mesh);

  /// Call them with the triangles around the vertex before a split, and around both vertices after it.
  void before_split(const StripMesh& mesh, const std::vector<Triangle>& patch);
  void after_split(const StripMesh& mesh, const std::vector<Triangle>& patch);
  /// The component of a triangle now has `strips` more strips than before.
  void add(Triangle t, std::ptrdiff_t strips) { components_[component_[t]].strips += strips; }
  /// Counts the strips again, after any change of colours. Linear time.
  void recount(const StripMesh& mesh);

  [[nodiscard]] std::size_t components() const noexcept { return components_.size(); }
  /// For the whole mesh, whatever its colours.
  [[nodiscard]] std::size_t needed() const noexcept { return static_cast<std::size_t>(needed_); }
  /// Whether the component of a triangle has more strips than its lower bound.
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
  std::uint32_t split_ = 0;  // the component of the current split
};

/// A lower bound for any colouring. Linear time.
[[nodiscard]] inline std::size_t strips_at_least(const StripMesh& mesh) { return ComponentStrips(mesh).needed(); }

}  // namespace restrip::tools
