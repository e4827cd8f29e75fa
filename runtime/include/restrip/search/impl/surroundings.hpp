// Counts around an operation, before and after it. Included by keeper.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/search/descent.hpp"

namespace restrip::detail {

/// The change by an operation that does not report it: strips, swaps and isolated triangles are counted before and
/// after it. Both triangles of each dual edge whose colour changes must be among those added. Time quadratic in the
/// triangles, about a dozen.
template <NumberedMesh Mesh>
class Surroundings {
 public:
  using Halfedge = typename Mesh::Halfedge;

  /// Makes room for one operation, so that nothing is allocated between the two counts.
  void clear() {
    triangles_.clear();
    triangles_.reserve(48);
  }
  void add(const std::vector<Triangle>& triangles) {
    for (const Triangle t : triangles) add(t);
  }
  void add(const Mesh& mesh, Halfedge h) {
    if (!mesh.on_boundary(h)) add(static_cast<Triangle>(mesh.triangle(h)));
  }
  void add_next_to(const Mesh& mesh, Halfedge h) {
    add(mesh, h);
    add(mesh, mesh.opposite(h));
  }
  void add_neighbors(const Mesh& mesh) {
    for (std::size_t i = 0, n = triangles_.size(); i < n; ++i)
      for_each_neighbor(mesh, triangles_[i], [this](Triangle t) { add(t); });
  }
  void count_before(const Mesh& mesh) { before_ = counted(mesh); }
  /// Removed triangles are skipped; new ones must have been added.
  [[nodiscard]] ColoringChange change(const Mesh& mesh) {
    std::erase_if(triangles_, [&](Triangle t) { return !mesh.has_triangle(t); });
    ColoringChange change = counted(mesh);
    change += {-before_.strips, -before_.swaps, -before_.isolated};
    return change;
  }

 private:
  void add(Triangle t) {
    if (std::find(triangles_.begin(), triangles_.end(), t) == triangles_.end()) triangles_.push_back(t);
  }
  // `strips` is the number of triangles minus the number of solid edges.
  [[nodiscard]] ColoringChange counted(const Mesh& mesh) const {
    ColoringChange count;
    count.strips = static_cast<int>(triangles_.size());
    for (auto t = triangles_.begin(); t != triangles_.end(); ++t) {
      bool isolated = true;
      auto h = mesh.halfedge(*t);
      for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
        if (!mesh.solid(h)) continue;
        isolated = false;
        if (std::find(triangles_.begin(), t, static_cast<Triangle>(mesh.triangle(mesh.opposite(h)))) != t) continue;
        --count.strips;
        count.swaps += int{restrip::is_swap(mesh, h)};
      }
      count.isolated += int{isolated};
    }
    return count;
  }

  std::vector<Triangle> triangles_;
  ColoringChange before_;
};

}  // namespace restrip::detail
