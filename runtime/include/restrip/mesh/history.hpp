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
// A frame takes time and memory linear in the triangles that changed in it, some 50 bytes each. The history also holds
// one copy of the mesh, with which it finds the changes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace detail {

/// The elements of an array that a frame has changed, with the values that they do not have now: the values before the
/// frame while it is done, after it while it is undone. Elements are compared and exchanged as bytes, so arrays of
/// all types share this code.
class ArrayChange {
 public:
  /// Elements: those in the array now, or those in it after exchange(), whichever are more.
  [[nodiscard]] std::span<const std::uint32_t> places() const noexcept { return {data_.data(), count_}; }
  /// The size of the array after exchange().
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return count_ == 0 && !resized_; }

  /// Brings `last` in step with `now` and stores the values that it had. `named`, which is cleared, has the elements
  /// that may differ, in any order, except those that only one of the arrays has. New elements that are not named
  /// have the value `beyond`.
  template <class Value>
  void take(std::vector<std::uint32_t>& named, std::vector<Value>& last, const std::vector<Value>& now, Value beyond) {
    static_assert(std::has_unique_object_representations_v<Value>);
    size_ = last.size();
    resized_ = size_ != now.size();
    last.resize((std::max)(size_, now.size()), beyond);
    take_bytes(named, last.size(), now.size(), last.data(), now.data(), sizeof(Value));
    last.resize(now.size(), beyond);
  }
  /// Exchanges the values with those of the array, and writes them into the copy, too. Throws nothing if both have
  /// room for the larger size.
  template <class Value>
  void exchange(std::vector<Value>& array, std::vector<Value>& copy, Value beyond) {
    const std::size_t now = array.size();
    for (auto* const list : {&array, &copy}) list->resize((std::max)(now, size_), beyond);
    exchange_bytes(array.data(), copy.data(), sizeof(Value));
    for (auto* const list : {&array, &copy}) list->resize(size_, beyond);
    size_ = now;
  }

 private:
  void take_bytes(std::vector<std::uint32_t>& named, std::size_t size, std::size_t size_now, void* last,
                  const void* now, std::size_t bytes);
  void exchange_bytes(void* array, void* copy, std::size_t bytes) noexcept;
  [[nodiscard]] std::byte* values() noexcept { return reinterpret_cast<std::byte*>(data_.data() + count_); }

  std::vector<std::uint32_t> data_;  // the places, ascending, then the values
  std::size_t count_ = 0;
  std::size_t size_ = 0;
  bool resized_ = false;
};

inline void ArrayChange::take_bytes(std::vector<std::uint32_t>& named, std::size_t size, std::size_t size_now,
                                    void* last, const void* now, std::size_t bytes) {
  const std::size_t first = (std::min)(size_, size_now);
  const std::size_t known = named.size();
  named.resize(known + size - first);
  std::iota(named.begin() + static_cast<std::ptrdiff_t>(known), named.end(), static_cast<std::uint32_t>(first));
  sort_unique(named);
  auto* const before = static_cast<std::byte*>(last);
  const auto* const after = static_cast<const std::byte*>(now);
  count_ = 0;
  for (const std::uint32_t i : named)
    if (i < size && (i >= size_now || std::memcmp(before + i * bytes, after + i * bytes, bytes) != 0))
      named[count_++] = i;
  data_.resize(count_ + (count_ * bytes + sizeof(std::uint32_t) - 1) / sizeof(std::uint32_t));
  std::copy_n(named.begin(), count_, data_.begin());
  for (std::size_t k = 0; k < count_; ++k) {
    const std::size_t at = data_[k] * bytes;
    std::memcpy(values() + k * bytes, before + at, bytes);
    if (data_[k] < size_now) std::memcpy(before + at, after + at, bytes);
  }
  named.clear();
}

inline void ArrayChange::exchange_bytes(void* array, void* copy, std::size_t bytes) noexcept {
  for (std::size_t k = 0; k < count_; ++k) {
    std::byte* const value = values() + k * bytes;
    std::byte* const element = static_cast<std::byte*>(array) + data_[k] * bytes;
    std::swap_ranges(value, value + bytes, element);
    std::memcpy(static_cast<std::byte*>(copy) + data_[k] * bytes, element, bytes);
  }
}

}  // namespace detail

class History {
 public:
  /// Begins with the mesh as it is. Linear time. `most_triangles` limits the changed triangles of all frames together:
  /// beyond it the oldest frames are dropped, but never the last one.
  RESTRIP_COLD explicit History(const StripMesh& mesh,
                                std::size_t most_triangles = (std::numeric_limits<std::size_t>::max)())
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
    step(mesh, frames_[done_ - 1]);
    --done_;
    return true;
  }
  bool redo(StripMesh& mesh) {
    if (redoable() == 0) return false;
    step(mesh, frames_[done_]);
    ++done_;
    return true;
  }

  [[nodiscard]] std::size_t undoable() const noexcept { return done_; }
  [[nodiscard]] std::size_t redoable() const noexcept { return frames_.size() - done_; }

 private:
  struct Frame {
    detail::ArrayChange triangles;
    detail::ArrayChange spokes;
    detail::ArrayChange free;
    detail::ArrayChange free_vertices;

    /// Its memory, in triangles; 0: neither the mesh nor its free handles have changed.
    [[nodiscard]] std::size_t size() const noexcept {
      std::size_t most = 0;
      for (const auto* const change : {&triangles, &spokes, &free, &free_vertices})
        most = (std::max)({most, change->places().size(), std::size_t{!change->empty()}});
      return most;
    }
  };

  /// Also used for a handle that a frame took and gave back.
  static constexpr StripMesh::Record removed{
      {none, none, none}, {StripMesh::edge_of_mesh, StripMesh::edge_of_mesh, StripMesh::edge_of_mesh}};

  // Each change of a list of free handles removes an element from its end or appends one.
  void name_end(const std::vector<std::uint32_t>& before, const std::vector<std::uint32_t>& after,
                std::size_t changes) {
    const std::size_t both = (std::min)(before.size(), after.size());
    named_.resize((std::min)(both, changes));
    std::iota(named_.begin(), named_.end(), static_cast<std::uint32_t>(both - named_.size()));
  }
  void step(StripMesh& mesh, Frame& frame) {
    mesh.expect_touches(frame.triangles.places().size());
    const auto reach = [](auto& list, std::size_t size) {
      detail::make_room(list, (std::max)(size, list.size()) - list.size());
    };
    for (StripMesh* const one : {&mesh, &last_}) {  // after this nothing throws
      reach(one->triangles_, frame.triangles.size());
      reach(one->spoke_, frame.spokes.size());
      reach(one->non_manifold_, frame.spokes.size());
      reach(one->free_, frame.free.size());
      reach(one->free_vertices_, frame.free_vertices.size());
    }
    frame.triangles.exchange(mesh.triangles_, last_.triangles_, removed);
    frame.spokes.exchange(mesh.spoke_, last_.spoke_, none);
    frame.free.exchange(mesh.free_, last_.free_, none);
    frame.free_vertices.exchange(mesh.free_vertices_, last_.free_vertices_, none);
    for (StripMesh* const one : {&mesh, &last_}) one->non_manifold_.resize(one->spoke_.size(), 0);
    for (const Triangle t : frame.triangles.places()) mesh.touch(t);
  }

  StripMesh last_;  // as it was at the end of the last frame
  std::deque<Frame> frames_;
  std::size_t done_ = 0;  // frames that are not undone
  std::size_t kept_ = 0;  // triangles of all frames
  std::size_t most_;
  std::vector<std::uint32_t> named_;
  std::vector<Vertex> corners_;
};

inline bool History::frame(const StripMesh& mesh, std::span<const Triangle> changed) {
  named_.assign(changed.begin(), changed.end());
  detail::sort_unique(named_);
  corners_.clear();
  for (const Triangle t : named_)
    for (const StripMesh* const one : std::initializer_list<const StripMesh*>{&mesh, &last_})
      if (one->alive(t))
        for (const Vertex v : one->triangles_[t].corner) corners_.push_back(v);
  Frame frame;
  frame.triangles.take(named_, last_.triangles_, mesh.triangles_, removed);
  frame.spokes.take(corners_, last_.spoke_, mesh.spoke_, none);
  name_end(last_.free_, mesh.free_, changed.size());
  frame.free.take(named_, last_.free_, mesh.free_, none);
  name_end(last_.free_vertices_, mesh.free_vertices_, changed.size());
  frame.free_vertices.take(named_, last_.free_vertices_, mesh.free_vertices_, none);
  last_.non_manifold_.resize(last_.spoke_.size(), 0);
  if (frame.size() == 0) return false;
  for (; frames_.size() > done_; frames_.pop_back()) kept_ -= frames_.back().size();
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
