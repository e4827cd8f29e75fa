// BakedStrips: strips decided beforehand by `restrip bake` and played back. It has the functions of a keeper.
#pragma once

#include "progressive.hpp"

namespace restrip::web {

class BakedStrips {
 public:
  /// `mesh` is the base of the file in its colours. Both must outlive this.
  BakedStrips(StripMesh& mesh, const BakedFile& file)
      : mesh_(&mesh),
        player_(mesh, file.records),
        base_points_(file.points.size() - file.splits.size()),
        strips_(count_strips(mesh)) {}

  Rewrite<Halfedge> split(const Where& where, Vertex v_t) { return counted(player_.split(record(v_t), where, v_t)); }
  Rewrite<Halfedge> collapse(Halfedge chord) { return counted(player_.collapse(record(mesh_->to(chord)), chord)); }
  Rewrite<Halfedge> flip(Halfedge h) {
    leave_step();
    return counted(flip_and_join(*mesh_, h));
  }
  /// Call before an operation that is none of the file's records.
  void leave_step() noexcept { player_.leave_step(); }
  [[nodiscard]] bool in_step() const noexcept { return player_.in_step(); }
  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }

 private:
  /// The record that adds this vertex; no record for the vertices of the base.
  [[nodiscard]] std::size_t record(Vertex v_t) const noexcept { return std::size_t{v_t} - base_points_; }
  Rewrite<Halfedge> counted(const Rewrite<Halfedge>& done) noexcept {
    strips_ += static_cast<std::size_t>(done.strips);
    return done;
  }

  StripMesh* mesh_;
  BakedPlayer<StripMesh> player_;
  std::size_t base_points_;
  std::size_t strips_;
};

}  // namespace restrip::web
