// BufferHistory: undo and redo of whole frames of a StripBuffer, index by index. LiveHistory: of a LiveBuffer.
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
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strip_buffer.hpp"

namespace restrip {

namespace detail {

inline std::uint32_t exchange(Cells& cells, std::uint32_t i, std::uint32_t index) noexcept {
  const std::uint32_t before = cells[i];
  cells.set(i, index);
  return before;
}
template <class Value>
Value exchange(std::vector<Value>& array, std::uint32_t i, Value value) noexcept {
  return std::exchange(array[i], value);
}

/// Values of an array, to be exchanged with the present ones.
template <class Value>
struct Values {
  std::vector<std::uint32_t> at;  // ascending
  std::vector<Value> value;
  std::size_t size = 0;  // of the array

  // From `last`, which is brought in step, the values before. `named` is cleared.
  template <class Array>
  void take(std::vector<std::uint32_t>& named, Array& last, const Array& now, Value beyond) {
    for (std::size_t i = (std::min)(last.size(), now.size()); i < (std::max)(last.size(), now.size()); ++i)
      named.push_back(static_cast<std::uint32_t>(i));
    sort_unique(named);
    size = last.size();
    last.resize((std::max)(last.size(), now.size()), beyond);
    for (const std::uint32_t i : named) {
      if (i >= last.size()) break;
      const Value after = i < now.size() ? now[i] : beyond;
      if (last[i] == after) continue;
      at.push_back(i);
      value.push_back(exchange(last, i, after));
    }
    last.resize(now.size(), beyond);
    named.clear();
  }
  template <class Array>
  void exchange_with(Array& array, Value beyond) {
    const std::size_t now = array.size();
    array.resize((std::max)(now, size), beyond);
    for (std::size_t i = 0; i < at.size(); ++i) value[i] = exchange(array, at[i], value[i]);
    array.resize(std::exchange(size, now), beyond);
  }
};

}  // namespace detail

class BufferHistory {
 public:
  /// Begins with the buffer as it is. Linear time.
  explicit BufferHistory(StripBuffer& buffer) : last_((read_places(buffer), buffer)) { places_.clear(); }

  /// Call it after each update, with the same list of changes, and after each rebuild(). After an exception the history
  /// must not be used any more; the same holds for frame(), undo() and redo().
  void note(const StripBuffer& buffer, std::span<const std::uint32_t> changed) {
    if (buffer.rebuilt_) return note_all(buffer);
    for (const auto& [first, count] : buffer.written_)
      for (std::size_t i = first; i < first + count; ++i) cells_.push_back(static_cast<std::uint32_t>(i));
    if (cells_.size() > 2 * buffer.cells_.size()) detail::sort_unique(cells_);  // however long no frame ends
    triangles_.insert(triangles_.end(), changed.begin(), changed.end());
    for (std::uint32_t i = 0; i < buffer.links_; ++i) triangles_.push_back(buffer.strip_[i].triangle);
  }
  /// Call it before the update of a frame: what was noted since the last frame, by compact() for example, then does not
  /// belong to it. Its undo leaves that as it is.
  void before_update(StripBuffer& buffer) {
    const bool same = cells_.empty() && triangles_.empty() && buffer.places_.changed_.empty() &&
                      buffer.places_.cursor() == last_.places_.cursor();
    if (same || buffer.stale_) return;  // after an exception the update writes everything
    Change change = take(buffer);
    if (!change.empty()) between_.push_back(std::move(change));
  }
  /// Ends a frame, which contains all updates since the previous frame. Frames that were undone and not redone are
  /// dropped, and so are the oldest beyond `most`.
  void frame(StripBuffer& buffer, std::size_t most) {
    drop_undone();
    frames_.emplace_back();
    frames_.back().push_back(take(buffer));
    done_ = frames_.size();
    limit(most);
  }
  /// Drops the frames that can be redone.
  void drop_undone() {
    while (frames_.size() > done_) frames_.pop_back();
    if (done_ != 0) std::move(between_.begin(), between_.end(), std::back_inserter(frames_.back()));
    between_.clear();
  }
  /// Drops the oldest frames that can be undone, beyond `most`.
  void limit(std::size_t most) noexcept {
    for (; done_ > most; --done_) frames_.pop_front();
  }

  /// undo() restores the buffer as it was before the last frame that is not undone, redo() as it was after the frame
  /// undone last. Both first undo changes noted since the last frame, and return false when no such frame exists. The
  /// next update() returns the ranges that were written.
  bool undo(StripBuffer& buffer) {
    forget_unframed(buffer);
    if (done_ == 0) return false;
    --done_;
    std::for_each(frames_[done_].rbegin(), frames_[done_].rend(), [&](Change& change) { put(change, buffer); });
    return true;
  }
  bool redo(StripBuffer& buffer) {
    forget_unframed(buffer);
    if (done_ == frames_.size()) return false;
    for (Change& change : frames_[done_]) put(change, buffer);
    ++done_;
    return true;
  }
  [[nodiscard]] std::size_t undoable() const noexcept { return done_; }
  [[nodiscard]] std::size_t redoable() const noexcept { return frames_.size() - done_; }

 private:
  struct Change {
    detail::Values<std::uint32_t> cells;
    detail::Values<std::uint32_t> run_of;
    detail::Values<detail::RunPlaces::Place> places;
    detail::RunPlaces::Totals totals;
    std::vector<StripBuffer> whole;  // instead of all that, if the width of the indices changed
    [[nodiscard]] bool empty() const noexcept {
      return cells.at.empty() && run_of.at.empty() && places.at.empty() && whole.empty();
    }
  };

  void note_all(const StripBuffer& buffer) {
    cells_.resize((std::max)(buffer.cells_.size(), last_.cells_.size()));
    triangles_.resize((std::max)(buffer.run_of_.size(), last_.run_of_.size()));
    places_.resize((std::max)(buffer.places_.places_.size(), last_.places_.places_.size()));
    for (auto* const list : {&cells_, &triangles_, &places_}) std::iota(list->begin(), list->end(), 0U);
  }
  // The places that have changed since they were read last.
  void read_places(StripBuffer& buffer) {
    detail::RunPlaces& places = buffer.places_;
    places_.insert(places_.end(), places.changed_.begin(), places.changed_.end());
    for (const std::uint32_t p : places.changed_) places.places_[p].named = false;
    places.changed_.clear();
  }
  Change take(StripBuffer& buffer) {
    const detail::RunPlaces& places = buffer.places_;
    read_places(buffer);
    Change change;
    if (buffer.width() != last_.width()) {
      change.whole.push_back(buffer);
      std::swap(change.whole.front(), last_);
      for (auto* const list : {&cells_, &triangles_, &places_}) list->clear();
      return change;
    }
    change.cells.take(cells_, last_.cells_, buffer.cells_, buffer.filling());
    change.run_of.take(triangles_, last_.run_of_, buffer.run_of_, StripBuffer::nothing);
    change.places.take(places_, last_.places_.places_, places.places_, {});
    change.totals = std::exchange(last_.places_.totals_, places.totals_);
    return change;
  }
  static void exchange(Change& change, StripBuffer& buffer) {
    change.cells.exchange_with(buffer.cells_, buffer.filling());
    change.run_of.exchange_with(buffer.run_of_, StripBuffer::nothing);
    change.places.exchange_with(buffer.places_.places_, {});
    std::swap(change.totals, buffer.places_.totals_);
  }
  // Writes a change to the buffer and the copy; the next update returns its ranges.
  void put(Change& change, StripBuffer& buffer) {
    if (!change.whole.empty()) {
      StripBuffer whole = change.whole.front();
      std::swap(change.whole.front(), last_);
      buffer = std::move(whole);
      return;
    }
    detail::make_room(buffer.written_, change.cells.at.size() + 1);
    buffer.mark((std::min)(change.cells.size, buffer.cells_.size()),
                (std::max)(change.cells.size, buffer.cells_.size()));
    for (const std::uint32_t i : change.cells.at) buffer.mark(i, i + std::size_t{1});
    buffer.keep_ranges();
    Change copy = change;
    exchange(copy, last_);
    const bool stale = std::exchange(buffer.stale_, true);  // in case memory runs out
    exchange(change, buffer);
    buffer.stale_ = stale;
  }
  void forget_unframed(StripBuffer& buffer) {
    before_update(buffer);
    for (; !between_.empty(); between_.pop_back()) put(between_.back(), buffer);
  }

  std::deque<std::vector<Change>> frames_;
  std::vector<Change> between_;       // since the last frame that is not undone
  std::size_t done_ = 0;              // frames that are not undone
  std::vector<std::uint32_t> cells_;  // that updates since may have changed
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> places_;
  StripBuffer last_;  // as it was at the end of the last frame
};

/// The history of a LiveBuffer of strips, of any width. Lists need no history: an update draws them, though in another
/// order.
class LiveHistory {
 public:
  /// Begins with the buffer as it is. Linear time. Exceptions: as for BufferHistory.
  explicit LiveHistory(LiveBuffer& buffer) {
    if (auto* strips = std::get_if<StripBuffer>(&buffer.buffer())) history_.emplace(*strips);
  }

  /// As BufferHistory::before_update.
  void before_update(LiveBuffer& buffer) {
    if (history_) history_->before_update(std::get<StripBuffer>(buffer.buffer()));
  }
  /// Ends a frame, after one update with `changed`. `is_frame`: whether the mesh has changed; `most`: frames that the
  /// history of the mesh can undo.
  void frame(LiveBuffer& buffer, std::span<const std::uint32_t> changed, bool is_frame, std::size_t most) {
    if (!history_) return;
    auto& strips = std::get<StripBuffer>(buffer.buffer());
    history_->note(strips, changed);
    if (is_frame) history_->frame(strips, most);
  }
  /// Restore the buffer exactly, whatever its width was. The next update() returns what was written. Call them if the
  /// history of the mesh has such a frame. They return false for a list.
  bool undo(LiveBuffer& buffer) { return step(buffer, false); }
  bool redo(LiveBuffer& buffer) { return step(buffer, true); }

 private:
  bool step(LiveBuffer& buffer, bool forward) {
    if (!history_) return false;
    auto& strips = std::get<StripBuffer>(buffer.buffer());
    const IndexWidth width = strips.width();
    if (!(forward ? history_->redo(strips) : history_->undo(strips))) return false;
    if (strips.width() != width) buffer.keep_all();
    return true;
  }

  std::optional<BufferHistory> history_;
};

}  // namespace restrip
