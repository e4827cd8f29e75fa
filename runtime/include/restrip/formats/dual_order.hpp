// Names for dual edges near a place: their numbers in a breadth-first walk. Nearby numbers are small, so files can
// store them in few bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// The walk starts with the triangles given, takes each triangle's sides 0, 1, 2, numbers a dual edge when it first
/// meets it, and continues with the triangles beyond in the order in which it met them.
class DualOrder {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Starts a walk from the triangles at the chord, left first.
  void start(const StripMesh& mesh, Halfedge chord) {
    mesh_ = &mesh;
    if (met_.size() < mesh.triangle_bound()) met_.resize(mesh.triangle_bound() + mesh.triangle_bound() / 2, 0);
    ++walk_;
    queue_.clear();
    edges_.clear();
    done_ = 0;
    for (const Halfedge h : {chord, mesh.opposite(chord)})
      if (!StripMesh::on_boundary(h)) meet(StripMesh::triangle(h));
  }

  /// Dual edge number n, by the halfedge it was met from; {none} if the walk ends earlier.
  [[nodiscard]] Halfedge edge(std::size_t n) {
    while (edges_.size() <= n && done_ < queue_.size()) expand();
    return n < edges_.size() ? edges_[n] : Halfedge{none};
  }

 private:
  // met_: 2 walk_ when met, and 2 walk_ + 1 when its sides have been numbered.
  void meet(Triangle t) {
    if (met_[t] >= 2 * walk_) return;
    met_[t] = 2 * walk_;
    queue_.push_back(t);
  }
  void expand() {
    const Triangle t = queue_[done_++];
    met_[t] = 2 * walk_ + 1;
    for (unsigned side = 0; side < 3; ++side) {
      const Halfedge h = StripMesh::halfedge(t, side);
      const Halfedge there = mesh_->opposite(h);
      if (StripMesh::on_boundary(there)) continue;
      const Triangle u = StripMesh::triangle(there);
      if (met_[u] != 2 * walk_ + 1) edges_.push_back(h);  // else it was met from the other side
      meet(u);
    }
  }

  const StripMesh* mesh_ = nullptr;
  std::vector<std::uint64_t> met_;
  std::uint64_t walk_ = 0;
  std::vector<Triangle> queue_;
  std::vector<Halfedge> edges_;
  std::size_t done_ = 0;
};

}  // namespace restrip
