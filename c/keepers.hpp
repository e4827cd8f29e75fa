// Two ways of keeping the strips of a mesh that the library has no keeper for: not at all, and by baked levels. They
// have the members of StripKeeper that the interface calls, and its promises after an exception.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "restrip/restrip.hpp"

namespace restrip::c {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;
using Change = Rewrite<Halfedge>;

/// The mesh update alone. New dual edges are dashed; a flip also dashes all those of its two triangles, because the
/// colouring would not stay valid otherwise.
class BareKeeper {
 public:
  explicit BareKeeper(StripMesh& mesh) : mesh_(&mesh) { rebuild(); }

  Change split(const Where& where, Vertex v_t) {
    begin();
    if (where.spokes != Where::Spokes::right_only) add_beside(where.left);
    if (where.spokes != Where::Spokes::left_only) add_beside(where.right);
    const Count before = count();
    const Halfedge chord = mesh_->insert_vertex(where, v_t);
    const std::size_t old = patch_.size();
    add_beside(chord);
    return finish(chord, before, static_cast<int>(patch_.size() - old));
  }
  Change collapse(Halfedge chord) {
    begin();
    add_beside(chord);
    const auto removed = static_cast<int>(patch_.size());
    add_neighbors();
    const Count before = count();
    return finish(mesh_->remove_vertex(chord), before, -removed);
  }
  Change flip(Halfedge h) {
    begin();
    add_beside(h);
    add_neighbors();
    const Count before = count();
    for (const Triangle t : {StripMesh::triangle(h), StripMesh::triangle(mesh_->opposite(h))})
      for (unsigned side = 0; side < 3; ++side)
        if (const Halfedge g = StripMesh::halfedge(t, side); mesh_->solid(g)) mesh_->set_solid(g, false);
    return finish(mesh_->turn_edge(h), before, 0);
  }
  void rebuild() {
    up_to_date_ = false;
    strips_ = count_strips(*mesh_);
    up_to_date_ = true;
  }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }

 private:
  struct Count {
    int solid_sides = 0;
    int isolated = 0;
  };

  void begin() {
    if (!up_to_date_) rebuild();
    up_to_date_ = false;
    patch_.clear();
    patch_.reserve(12);  // more than any operation has: nothing is allocated once the mesh has changed
  }
  void add(Halfedge h) {
    if (StripMesh::on_boundary(h)) return;
    const Triangle t = StripMesh::triangle(h);
    if (std::find(patch_.begin(), patch_.end(), t) == patch_.end()) patch_.push_back(t);
  }
  void add_beside(Halfedge h) {
    add(h);
    add(mesh_->opposite(h));
  }
  void add_neighbors() {
    const std::size_t inner = patch_.size();
    for (std::size_t i = 0; i < inner; ++i)
      for (unsigned side = 0; side < 3; ++side) add(mesh_->opposite(StripMesh::halfedge(patch_[i], side)));
  }
  /// Of the triangles of the patch that there are now. Both triangles of every dual edge whose colour changes are among
  /// them, before and after.
  [[nodiscard]] Count count() const {
    Count sum;
    for (const Triangle t : patch_) {
      if (!mesh_->alive(t)) continue;
      sum.solid_sides += static_cast<int>(mesh_->solid_degree(t));
      sum.isolated += static_cast<int>(mesh_->solid_degree(t) == 0);
    }
    return sum;
  }
  Change finish(Halfedge h, const Count& before, int more_triangles) {
    const Count after = count();
    const Change done{h, 0, more_triangles - (after.solid_sides - before.solid_sides) / 2,
                      after.isolated - before.isolated};
    strips_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(strips_) + done.strips);
    up_to_date_ = true;
    return done;
  }

  StripMesh* mesh_;
  std::size_t strips_ = 0;
  bool up_to_date_ = false;
  std::vector<Triangle> patch_;
};

/// Plays the records of a baked mesh. Any other operation leaves its levels and is done by the rules.
class LevelKeeper {
 public:
  /// The mesh is the base of the file, in its colours.
  LevelKeeper(StripMesh& mesh, const BakedFile& file) : mesh_(&mesh), file_(&file), player_(mesh, file.records) {
    rebuild();
  }

  [[nodiscard]] bool in_step() const noexcept { return player_.in_step(); }
  [[nodiscard]] std::size_t level() const noexcept { return player_.level(); }
  void leave_step() noexcept { player_.leave_step(); }

  /// Needs in_step() and a level that there is. Returns how many records were played, at most `most`.
  std::size_t move(std::size_t level, std::size_t most) {
    begin();
    std::size_t done = 0;
    for (; player_.level() != level && done < most; ++done) {
      const bool up = player_.level() < level;
      const std::size_t i = up ? player_.level() : player_.level() - 1;
      const BakedSplit& split = file_->splits[i];
      finish(up ? player_.split(i, spokes_of(*mesh_, split), split.v_t)
                : player_.collapse(i, mesh_->spoke(split.v_s, split.v_t)));
      up_to_date_ = false;
    }
    up_to_date_ = true;
    return done;
  }

  Change split(const Where& where, Vertex v_t) {
    begin();
    leave_step();
    return finish(split_and_adopt(*mesh_, where, v_t));
  }
  Change collapse(Halfedge chord) {
    begin();
    leave_step();
    return finish(collapse_and_adopt(*mesh_, chord));
  }
  Change flip(Halfedge h) {
    begin();
    leave_step();
    return finish(flip_and_adopt(*mesh_, h));
  }
  void rebuild() {
    up_to_date_ = false;
    strips_ = count_strips(*mesh_);
    up_to_date_ = true;
  }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }

 private:
  void begin() {
    if (!up_to_date_) rebuild();
    up_to_date_ = false;
  }
  Change finish(const Change& done) noexcept {
    strips_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(strips_) + done.strips);
    up_to_date_ = true;
    return done;
  }

  StripMesh* mesh_;
  const BakedFile* file_;
  BakedPlayer<StripMesh> player_;
  std::size_t strips_ = 0;
  bool up_to_date_ = false;
};

}  // namespace restrip::c
