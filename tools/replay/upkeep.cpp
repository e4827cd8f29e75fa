#include "replay/upkeep.hpp"

#include <algorithm>

#include "restrip/mesh/walks.hpp"

namespace restrip::tools {

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

Rewrite<StripMesh::Halfedge> Witness::reported(const StripMesh& mesh, Halfedge h, Edges elsewhere) {
  const Count after = count(mesh, elsewhere);
  return {h, static_cast<std::uint32_t>(valence_), after.strips - before_.strips, after.isolated - before_.isolated};
}

void Witness::before_split(const StripMesh& mesh, const VertexSplit<Halfedge>& where, Edges elsewhere) {
  fan_triangles(mesh, where.spokes == VertexSplit<Halfedge>::Spokes::right_only ? where.right : where.left, patch_);
  valence_ = patch_.size();
  before_ = count(mesh, elsewhere);
}
Rewrite<StripMesh::Halfedge> Witness::after_split(const StripMesh& mesh, Halfedge chord, Edges elsewhere) {
  edge_triangles(mesh, chord, patch_);
  return reported(mesh, chord, elsewhere);
}

void Witness::before_collapse(const StripMesh& mesh, Halfedge chord, Edges elsewhere) {
  edge_triangles(mesh, chord, patch_);
  before_ = count(mesh, elsewhere);
}
Rewrite<StripMesh::Halfedge> Witness::after_collapse(const StripMesh& mesh, Halfedge spoke, Edges elsewhere) {
  fan_triangles(mesh, spoke, patch_);
  valence_ = patch_.size();
  return reported(mesh, spoke, elsewhere);
}

void Witness::before_flip(const StripMesh& mesh, Halfedge h) {
  patch_.assign({StripMesh::triangle(h), StripMesh::triangle(mesh.opposite(h))});
  valence_ = 4;
  before_ = count(mesh, {});
}
Rewrite<StripMesh::Halfedge> Witness::after_flip(const StripMesh& mesh, Halfedge turned) {
  patch_.assign({StripMesh::triangle(turned), StripMesh::triangle(mesh.opposite(turned))});
  return reported(mesh, turned, {});
}

}  // namespace restrip::tools
