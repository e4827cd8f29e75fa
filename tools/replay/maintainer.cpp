#include "replay/maintainer.hpp"

#include <algorithm>

namespace restrip::tools {

void Maintainer::play_up(std::span<const Record> records, std::size_t first) {
  for (const Record& record : records) {
    split_silently(spokes_of(mesh_, record), record.v_t, first++);
    between();
  }
}

void Maintainer::play_down(std::span<const Record> records, std::size_t first) {
  for (std::size_t i = records.size(); i-- > 0;) {
    collapse_silently(mesh_.spoke(records[i].v_s, records[i].v_t), first + i);
    between();
  }
}

Witness::Count Witness::count(const StripMesh& mesh, Edges elsewhere) {
  const auto once = [](std::vector<Triangle>& triangles) {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  };
  for (const Halfedge h : elsewhere) {
    if (!mesh.alive(StripMesh::triangle(h))) continue;
    patch_.push_back(StripMesh::triangle(h));
    if (const Halfedge across = mesh.opposite(h); !StripMesh::on_boundary(across))
      patch_.push_back(StripMesh::triangle(across));
  }
  once(patch_);
  // Each triangle of the patch and next to it once, each solid edge of the patch once.
  std::vector<Triangle> around = patch_;
  Count count{static_cast<int>(patch_.size()), 0};
  for (const Triangle t : patch_)
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      const Halfedge across = mesh.opposite(h);
      if (StripMesh::on_boundary(across)) continue;
      const bool inside = std::binary_search(patch_.begin(), patch_.end(), StripMesh::triangle(across));
      if (!inside) around.push_back(StripMesh::triangle(across));
      if (mesh.solid(h) && (!inside || h.id < across.id)) --count.strips;
    }
  once(around);
  for (const Triangle t : around) count.isolated += mesh.solid_degree(t) == 0 ? 1 : 0;
  return count;
}

}  // namespace restrip::tools
