// History: undo and redo of whole frames of a StripMesh, colours included.
//
// Inverse operations restore a mesh, but not its strips: rules and searches choose new colours on the way back. A
// history keeps the changed triangles of each frame as they were before and after it. So undo restores triangles,
// handles and colours bit for bit.
//
//   std::vector<Triangle> changed;
//   mesh.watch(&changed);
//   History history(mesh);
//   ... operations of a frame, under a keeper or not ...
//   history.frame(mesh, changed);                      // the frame ends here
//   history.undo(mesh);  keeper.rebuild();             // changed names what undo changed
//
// A frame takes time and memory linear in the triangles that changed in it, some 100 bytes each. The history also holds
// one copy of the mesh.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

class History {
 public:
  /// Begins with the mesh as it is. Linear time. `most_triangles` limits the changed triangles of all frames together:
  /// beyond it the oldest frames are dropped, but never the last one.
  explicit History(const StripMesh& mesh, std::size_t most_triangles = (std::numeric_limits<std::size_t>::max)())
      : last_(mesh), most_(most_triangles) {}

  /// Ends a frame. `changed`: the list made by the watch of the mesh since the previous frame; not cleared. Frames that
  /// were undone and not redone are dropped. Returns false and adds no frame when the mesh has not changed; free
  /// handles in another order are a change. After std::bad_alloc the history must not be used any more.
  bool frame(const StripMesh& mesh, std::span<const Triangle> changed);

  /// undo() restores the mesh as it was before the last frame, redo() as it was after the frame undone last. Both
  /// return false when no such frame exists. Call them right after frame(): later changes are lost. The watch of the
  /// mesh is notified. Keepers of the mesh must be rebuilt, buffers updated. After std::bad_alloc nothing has changed.
  bool undo(StripMesh& mesh) {
    if (undoable() == 0) return false;
    step(mesh, frames_[done_ - 1], false);
    --done_;
    return true;
  }
  bool redo(StripMesh& mesh) {
    if (redoable() == 0) return false;
    step(mesh, frames_[done_], true);
    ++done_;
    return true;
  }

  [[nodiscard]] std::size_t undoable() const noexcept { return done_; }
  [[nodiscard]] std::size_t redoable() const noexcept { return frames_.size() - done_; }

 private:
  template <class Value>
  struct Change {
    std::uint32_t at;
    Value before;
    Value after;
  };
  /// The end of a list, from the first change on.
  template <class Value>
  struct Tail {
    std::size_t kept = 0;  // of the beginning
    std::vector<Value> before;
    std::vector<Value> after;
    [[nodiscard]] std::size_t size() const noexcept { return (std::max)(before.size(), after.size()); }
  };
  struct Frame {
    std::vector<Change<StripMesh::Record>> triangles;
    std::vector<Change<std::uint32_t>> spokes;
    Tail<Triangle> free;
    Tail<Vertex> free_vertices;
    std::size_t triangles_before = 0;
    std::size_t triangles_after = 0;
    std::size_t vertices_before = 0;
    std::size_t vertices_after = 0;

    /// Its memory, in triangles; 0: neither the mesh nor its free handles have changed.
    [[nodiscard]] std::size_t size() const noexcept {
      const bool grown = triangles_before != triangles_after || vertices_before != vertices_after;
      return (std::max)({triangles.size(), spokes.size(), free.size(), free_vertices.size(), std::size_t{grown}});
    }
  };

  /// Also used for a handle that a frame took and gave back.
  static constexpr StripMesh::Record removed{
      {none, none, none}, {StripMesh::edge_of_mesh, StripMesh::edge_of_mesh, StripMesh::edge_of_mesh}};

  template <class Value>
  static Tail<Value> tail_of(const std::vector<Value>& before, const std::vector<Value>& after, std::size_t changes) {
    // Each change removes an element from the end or appends one.
    Tail<Value> tail;
    tail.kept = (std::min)(before.size(), after.size());
    tail.kept -= (std::min)(tail.kept, changes);
    while (tail.kept < before.size() && tail.kept < after.size() && before[tail.kept] == after[tail.kept]) ++tail.kept;
    tail.before.assign(before.begin() + static_cast<std::ptrdiff_t>(tail.kept), before.end());
    tail.after.assign(after.begin() + static_cast<std::ptrdiff_t>(tail.kept), after.end());
    return tail;
  }

  template <class Value>
  static void put(std::vector<Value>& list, const Tail<Value>& tail, bool forward) {
    const std::vector<Value>& now = forward ? tail.after : tail.before;
    list.resize(tail.kept);
    list.insert(list.end(), now.begin(), now.end());
  }

  /// So that apply() does not throw.
  static void make_room(StripMesh& mesh, const Frame& frame) {
    const auto reach = [](auto& list, std::size_t size) {
      detail::make_room(list, (std::max)(size, list.size()) - list.size());
    };
    reach(mesh.triangles_, (std::max)(frame.triangles_before, frame.triangles_after));
    reach(mesh.spoke_, (std::max)(frame.vertices_before, frame.vertices_after));
    reach(mesh.non_manifold_, (std::max)(frame.vertices_before, frame.vertices_after));
    reach(mesh.free_, frame.free.kept + frame.free.size());
    reach(mesh.free_vertices_, frame.free_vertices.kept + frame.free_vertices.size());
  }
  static void apply(StripMesh& mesh, const Frame& frame, bool forward) noexcept {
    const auto size = forward ? frame.triangles_after : frame.triangles_before;
    if (mesh.triangles_.size() < size) mesh.triangles_.resize(size, removed);
    const auto vertices = forward ? frame.vertices_after : frame.vertices_before;
    mesh.spoke_.resize((std::max)(vertices, mesh.spoke_.size()), none);
    for (const auto& change : frame.triangles)
      if (change.at < size) mesh.triangles_[change.at] = forward ? change.after : change.before;
    mesh.triangles_.resize(size);
    for (const auto& change : frame.spokes) mesh.spoke_[change.at] = forward ? change.after : change.before;
    mesh.spoke_.resize(vertices, none);
    mesh.non_manifold_.resize(vertices, 0);
    put(mesh.free_, frame.free, forward);
    put(mesh.free_vertices_, frame.free_vertices, forward);
  }

  void step(StripMesh& mesh, const Frame& frame, bool forward) {
    mesh.expect_touches(frame.triangles.size());
    make_room(mesh, frame);
    make_room(last_, frame);
    apply(mesh, frame, forward);
    apply(last_, frame, forward);
    for (const auto& change : frame.triangles) mesh.touch(change.at);
  }

  StripMesh last_;  // as it was at the end of the last frame
  std::deque<Frame> frames_;
  std::size_t done_ = 0;  // frames that are not undone
  std::size_t kept_ = 0;  // triangles of all frames
  std::size_t most_;
  std::vector<Triangle> named_;
  std::vector<Vertex> corners_;
};

inline bool History::frame(const StripMesh& mesh, std::span<const Triangle> changed) {
  named_.assign(changed.begin(), changed.end());
  detail::sort_unique(named_);
  Frame frame;
  frame.triangles_before = last_.triangles_.size();
  frame.triangles_after = mesh.triangles_.size();
  frame.vertices_before = last_.spoke_.size();
  frame.vertices_after = mesh.spoke_.size();
  corners_.clear();
  for (const Triangle t : named_) {
    const auto& before = t < frame.triangles_before ? last_.triangles_[t] : removed;
    const auto& after = t < frame.triangles_after ? mesh.triangles_[t] : removed;
    for (const auto& record : {before, after})
      for (const Vertex v : record.corner)
        if (v != none) corners_.push_back(v);
    if (before.corner != after.corner || before.link != after.link) frame.triangles.push_back({t, before, after});
  }
  detail::sort_unique(corners_);
  for (const Vertex v : corners_) {
    const std::uint32_t before = v < frame.vertices_before ? last_.spoke_[v] : none;
    const std::uint32_t after = v < frame.vertices_after ? mesh.spoke_[v] : none;
    if (before != after) frame.spokes.push_back({v, before, after});
  }
  frame.free = tail_of(last_.free_, mesh.free_, changed.size());
  frame.free_vertices = tail_of(last_.free_vertices_, mesh.free_vertices_, changed.size());
  if (frame.size() == 0) return false;
  for (; frames_.size() > done_; frames_.pop_back()) kept_ -= frames_.back().size();
  make_room(last_, frame);
  apply(last_, frame, true);
  kept_ += frame.size();
  frames_.push_back(std::move(frame));
  ++done_;
  while (kept_ > most_ && frames_.size() > 1) {
    kept_ -= frames_.front().size();
    frames_.pop_front();
    --done_;
  }
  return true;
}

}  // namespace restrip
