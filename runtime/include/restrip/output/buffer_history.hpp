// BufferHistory: undo and redo of whole frames of a StripBuffer, index by index.
//
// After History (mesh/history.hpp) has restored a mesh, an update would draw it correctly, but with indices elsewhere
// in the buffer. BufferHistory restores the indices in their places and all bookkeeping, so later operations write the
// same bytes as without the undone frames. LiveMesh keeps both histories in step.
//
//   BufferHistory buffers(buffer);
//   ... operations of a frame ...
//   buffer.update(mesh, changed);
//   buffers.note(buffer, changed);
//   if (history.frame(mesh, changed)) buffers.frame(buffer, history.undoable());
//   changed.clear();
//   if (history.undo(mesh)) buffers.undo(buffer);      // and changed.clear(): the buffer is in step
//   for (const auto& range : buffer.update(mesh, changed)) upload(range);
//
// A frame takes memory linear in what its update read and wrote, and time linear up to a logarithm. Each change is
// stored once, with the value before or after it. The history also holds one copy of the buffer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "restrip/output/strip_buffer.hpp"

namespace restrip {

template <class Index>
class BasicBufferHistory {
 public:
  using Buffer = BasicStripBuffer<Index>;

  /// Begins with the buffer as it is. Linear time.
  explicit BasicBufferHistory(Buffer& buffer) : last_(buffer) {
    note_all(buffer);
    take(buffer);
  }

  /// Call it after each update, with the same list of changes, and after each rebuild(). After an exception the history
  /// must not be used any more; the same holds for frame(), undo() and redo().
  void note(const Buffer& buffer, std::span<const std::uint32_t> changed) {
    if (buffer.rebuilt_) return note_all(buffer);
    for (const auto& [first, count] : buffer.written_)
      for (std::size_t i = first; i < first + count; ++i) cells_.push_back(static_cast<std::uint32_t>(i));
    triangles_.insert(triangles_.end(), changed.begin(), changed.end());
    for (std::uint32_t i = 0; i < buffer.links_; ++i) triangles_.push_back(buffer.strip_[i].triangle);
  }
  /// Ends a frame, which contains all updates since the previous frame. Frames that were undone and not redone are
  /// dropped, and so are the oldest beyond `most`.
  void frame(Buffer& buffer, std::size_t most) {
    frames_.resize(done_);
    frames_.push_back(take(buffer));
    while (frames_.size() > most) frames_.pop_front();
    done_ = frames_.size();
  }

  /// undo() restores the buffer as it was before the last frame that is not undone, redo() as it was after the frame
  /// undone last. Both first undo changes noted since the last frame, and return false when no such frame exists. The
  /// next update() returns the ranges that were written.
  bool undo(Buffer& buffer) {
    forget_unframed(buffer);
    if (done_ == 0) return false;
    put(frames_[--done_], buffer);
    return true;
  }
  bool redo(Buffer& buffer) {
    forget_unframed(buffer);
    if (done_ == frames_.size()) return false;
    put(frames_[done_++], buffer);
    return true;
  }

 private:
  /// Values of an array, to be exchanged with the present ones.
  template <class Value>
  struct Values {
    std::vector<std::uint32_t> at;  // ascending
    std::vector<Value> value;
    std::size_t size = 0;  // of the array

    // From `last`, which is brought in step, the values before. `named` is cleared.
    void take(std::vector<std::uint32_t>& named, std::vector<Value>& last, const std::vector<Value>& now,
              Value beyond) {
      for (std::size_t i = std::min(last.size(), now.size()); i < std::max(last.size(), now.size()); ++i)
        named.push_back(static_cast<std::uint32_t>(i));
      std::sort(named.begin(), named.end());
      named.erase(std::unique(named.begin(), named.end()), named.end());
      size = last.size();
      last.resize(std::max(last.size(), now.size()), beyond);
      for (const std::uint32_t i : named) {
        if (i >= last.size()) break;
        const Value after = i < now.size() ? now[i] : beyond;
        if (last[i] == after) continue;
        at.push_back(i);
        value.push_back(std::exchange(last[i], after));
      }
      last.resize(now.size(), beyond);
      named.clear();
    }
    void exchange_with(std::vector<Value>& array, Value beyond) {
      const std::size_t now = array.size();
      array.resize(std::max(now, size), beyond);
      for (std::size_t i = 0; i < at.size(); ++i) std::swap(array[at[i]], value[i]);
      array.resize(std::exchange(size, now), beyond);
    }
  };
  struct Frame {
    Values<Index> cells;
    Values<std::uint32_t> run_of;
    Values<detail::RunPlaces::Place> places;
    detail::RunPlaces::Totals totals;
  };

  void note_all(const Buffer& buffer) {
    cells_.resize(std::max(buffer.cells_.size(), last_.cells_.size()));
    triangles_.resize(std::max(buffer.run_of_.size(), last_.run_of_.size()));
    places_.resize(std::max(buffer.places_.places_.size(), last_.places_.places_.size()));
    for (auto* const list : {&cells_, &triangles_, &places_}) std::iota(list->begin(), list->end(), 0U);
  }
  Frame take(Buffer& buffer) {
    detail::RunPlaces& places = buffer.places_;
    for (const std::uint32_t p : places.changed_) places.places_[p].named = false;
    places_.insert(places_.end(), places.changed_.begin(), places.changed_.end());
    places.changed_.clear();
    Frame frame;
    frame.cells.take(cells_, last_.cells_, buffer.cells_, buffer.filling());
    frame.run_of.take(triangles_, last_.run_of_, buffer.run_of_, Buffer::nothing);
    frame.places.take(places_, last_.places_.places_, places.places_, {});
    frame.totals = std::exchange(last_.places_.totals_, places.totals_);
    return frame;
  }
  static void exchange(Frame& frame, Buffer& buffer) {
    frame.cells.exchange_with(buffer.cells_, buffer.filling());
    frame.run_of.exchange_with(buffer.run_of_, Buffer::nothing);
    frame.places.exchange_with(buffer.places_.places_, {});
    std::swap(frame.totals, buffer.places_.totals_);
  }
  // Writes a frame to the buffer and the copy; the next update returns its ranges.
  void put(Frame& frame, Buffer& buffer) {
    detail::make_room(buffer.written_, frame.cells.at.size() + 1);
    buffer.mark(std::min(frame.cells.size, buffer.cells_.size()), std::max(frame.cells.size, buffer.cells_.size()));
    for (const std::uint32_t i : frame.cells.at) buffer.mark(i, i + std::size_t{1});
    buffer.keep_ranges();
    Frame copy = frame;
    exchange(copy, last_);
    const bool stale = std::exchange(buffer.stale_, true);  // in case memory runs out
    exchange(frame, buffer);
    buffer.stale_ = stale;
  }
  void forget_unframed(Buffer& buffer) {
    Frame unframed = take(buffer);
    put(unframed, buffer);
  }

  Buffer last_;  // as it was at the end of the last frame
  std::deque<Frame> frames_;
  std::size_t done_ = 0;              // frames that are not undone
  std::vector<std::uint32_t> cells_;  // that updates since may have changed
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> places_;
};

using BufferHistory = BasicBufferHistory<std::uint32_t>;
using BufferHistory16 = BasicBufferHistory<std::uint16_t>;

}  // namespace restrip
