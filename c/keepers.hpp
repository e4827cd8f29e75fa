// Two ways of keeping the strips of a mesh that the library has no keeper for: not at all, and by baked levels. They
// have the members of StripKeeper that the interface calls, and its promises after an exception. And all operations of
// the interface by any keeper.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "restrip/restrip.hpp"

namespace restrip::c {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;
using Change = Rewrite<Halfedge>;

/// What both have: a mesh, and the number of its strips, which an operation that ends by an exception leaves unknown.
class CountingKeeper {
 public:
  void rebuild() {
    up_to_date_ = false;
    strips_ = count_strips(*mesh_);
    up_to_date_ = true;
  }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }
  [[nodiscard]] bool up_to_date() const noexcept { return up_to_date_; }

 protected:
  explicit CountingKeeper(StripMesh& mesh) : mesh_(&mesh) { rebuild(); }

  [[nodiscard]] StripMesh& changing() const noexcept { return *mesh_; }
  void begin() {
    if (!up_to_date_) rebuild();
    up_to_date_ = false;
  }
  Change finish(const Change& done) noexcept {
    strips_ = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(strips_) + done.strips);
    up_to_date_ = true;
    return done;
  }

 private:
  StripMesh* mesh_;
  std::size_t strips_ = 0;
  bool up_to_date_ = false;
};

/// The mesh update alone. New dual edges are dashed; a flip also dashes all those of its two triangles, because the
/// colouring would not stay valid otherwise.
class BareKeeper : public CountingKeeper {
 public:
  explicit BareKeeper(StripMesh& mesh) : CountingKeeper(mesh) {}

  Change split(const Where& where, Vertex v_t) {
    begin_patch();
    if (where.spokes != Where::Spokes::right_only) add_beside(where.left);
    if (where.spokes != Where::Spokes::left_only) add_beside(where.right);
    const Count before = count();
    const Halfedge chord = changing().insert_vertex(where, v_t);
    const std::size_t old = patch_.size();
    add_beside(chord);
    return counted(chord, before, static_cast<int>(patch_.size() - old));
  }
  Change collapse(Halfedge chord) {
    begin_patch();
    add_beside(chord);
    const auto removed = static_cast<int>(patch_.size());
    add_neighbors();
    const Count before = count();
    return counted(changing().remove_vertex(chord), before, -removed);
  }
  Change flip(Halfedge h) {
    begin_patch();
    add_beside(h);
    add_neighbors();
    const Count before = count();
    for (const Triangle t : {StripMesh::triangle(h), StripMesh::triangle(mesh().opposite(h))})
      for (unsigned side = 0; side < 3; ++side)
        if (const Halfedge g = StripMesh::halfedge(t, side); mesh().solid(g)) changing().set_solid(g, false);
    return counted(changing().turn_edge(h), before, 0);
  }

 private:
  struct Count {
    int solid_sides = 0;
    int isolated = 0;
  };

  void begin_patch() {
    begin();
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
    add(mesh().opposite(h));
  }
  void add_neighbors() {
    const std::size_t inner = patch_.size();
    for (std::size_t i = 0; i < inner; ++i)
      for (unsigned side = 0; side < 3; ++side) add(mesh().opposite(StripMesh::halfedge(patch_[i], side)));
  }
  /// Counts the triangles of the patch that there are now. Both triangles of every dual edge whose colour changes are
  /// among them, before and after.
  [[nodiscard]] Count count() const {
    Count sum;
    for (const Triangle t : patch_) {
      if (!mesh().alive(t)) continue;
      sum.solid_sides += static_cast<int>(mesh().solid_degree(t));
      sum.isolated += static_cast<int>(mesh().solid_degree(t) == 0);
    }
    return sum;
  }
  Change counted(Halfedge h, const Count& before, int more_triangles) {
    const Count after = count();
    return CountingKeeper::finish(
        {h, 0, more_triangles - (after.solid_sides - before.solid_sides) / 2, after.isolated - before.isolated});
  }

  std::vector<Triangle> patch_;
};

/// Plays the records of a baked mesh. Any other operation leaves its levels and is done by the rules.
class LevelKeeper : public CountingKeeper {
 public:
  /// The mesh is the base of the file, in its colours.
  LevelKeeper(StripMesh& mesh, const BakedFile& file)
      : CountingKeeper(mesh), file_(&file), player_(mesh, file.records) {}

  [[nodiscard]] bool in_step() const noexcept { return player_.in_step(); }
  [[nodiscard]] std::size_t level() const noexcept { return player_.level(); }
  void leave_step() noexcept { player_.leave_step(); }

  /// Needs in_step() and a level that there is. Returns how many records were played, at most `most`.
  std::size_t move(std::size_t level, std::size_t most) {
    std::size_t done = 0;
    for (; player_.level() != level && done < most; ++done) {
      begin();
      const bool up = player_.level() < level;
      const std::size_t i = up ? player_.level() : player_.level() - 1;
      const BakedSplit& split = file_->splits[i];
      finish(up ? player_.split(i, spokes_of(mesh(), split), split.v_t)
                : player_.collapse(i, mesh().spoke(split.v_s, split.v_t)));
    }
    return done;
  }

  Change split(const Where& where, Vertex v_t) {
    return by_rules([&](StripMesh& own) { return split_and_join(own, where, v_t); });
  }
  Change collapse(Halfedge chord) {
    return by_rules([&](StripMesh& own) { return collapse_and_join(own, chord); });
  }
  Change flip(Halfedge h) {
    return by_rules([&](StripMesh& own) { return flip_and_join(own, h); });
  }
  Change split_face(Halfedge h) {
    return by_rules([&](StripMesh& own) {
      const Change done = restrip::split_face(own, h);
      return with(done, join_around(own, own.opposite(done.halfedge)));
    });
  }
  Change bisect(Halfedge h) {
    return by_rules([&](StripMesh& own) {
      const Change done = restrip::bisect(own, h);
      return with(done, join_around(own, own.opposite(done.halfedge)));
    });
  }
  Change join_faces(Halfedge chord) {
    return by_rules([&](StripMesh& own) {
      const Change done = restrip::join_faces(own, chord);
      return with(done, join_beside(own, done.halfedge));
    });
  }
  Change merge(Halfedge chord) {
    return by_rules([&](StripMesh& own) {
      const Change done = restrip::merge(own, chord);
      return with(done, join_beside(own, done.halfedge));
    });
  }

 private:
  template <class Operation>
  Change by_rules(Operation&& operation) {
    begin();
    leave_step();
    return finish(operation(changing()));
  }
  static Change with(Change done, Mending mending) {
    done.strips += mending.strips;
    done.isolated += mending.isolated;
    return done;
  }

  const BakedFile* file_;
  BakedPlayer<StripMesh> player_;
};

// The operations of refine.hpp by a keeper that has none of its own: a split or a collapse changes the mesh in the same
// way. Rewrite::halfedge is as refine.hpp says; the valence is that of the split or the collapse.

template <class Keeper>
Change split_face(Keeper& keeper, Halfedge h) {
  if constexpr (requires { keeper.split_face(h); })
    return keeper.split_face(h);
  else
    return keeper.split(Where{keeper.mesh().opposite(StripMesh::next(StripMesh::next(h))), h}, none);
}
template <class Keeper>
Change join_faces(Keeper& keeper, Halfedge chord) {
  if constexpr (requires { keeper.join_faces(chord); })
    return keeper.join_faces(chord);
  else
    return keeper.collapse(chord);
}
template <class Keeper>
Change bisect(Keeper& keeper, Halfedge h) {
  if constexpr (requires { keeper.bisect(h); }) {
    return keeper.bisect(h);
  } else {
    const StripMesh& mesh = keeper.mesh();
    const Halfedge back = mesh.opposite(h);
    Where where;
    where.spokes = StripMesh::on_boundary(h)      ? Where::Spokes::right_only
                   : StripMesh::on_boundary(back) ? Where::Spokes::left_only
                                                  : Where::Spokes::both;
    if (where.spokes != Where::Spokes::right_only) where.left = mesh.opposite(StripMesh::next(StripMesh::next(h)));
    if (where.spokes != Where::Spokes::left_only) where.right = StripMesh::next(back);
    return keeper.split(where, none);
  }
}
template <class Keeper>
Change merge(Keeper& keeper, Halfedge chord) {
  if constexpr (requires { keeper.merge(chord); }) {
    return keeper.merge(chord);
  } else {
    const StripMesh& mesh = keeper.mesh();
    const bool no_left = StripMesh::on_boundary(chord);
    Change done = keeper.collapse(chord);
    // From the spoke to the mesh edge beside it that takes the place of two.
    done.halfedge = no_left ? mesh.opposite(StripMesh::next(StripMesh::next(done.halfedge)))
                            : StripMesh::next(mesh.opposite(done.halfedge));
    return done;
  }
}

}  // namespace restrip::c
