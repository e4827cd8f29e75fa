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

#include "restrip/mesh/history.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strip_buffer.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

class BufferHistory {
 public:
  /// Begins with the buffer as it is. Linear time.
  RESTRIP_COLD explicit BufferHistory(StripBuffer& buffer)
      : last_{(read_places(buffer), buffer.cells_), buffer.run_of_, buffer.places_.places_, buffer.places_.totals_} {
    places_.clear();
  }

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
  /// Call it before the update of a frame: what was noted since the last frame then does not
  /// belong to it. Its undo leaves that as it is.
  void before_update(StripBuffer& buffer) {
    const bool same = cells_.empty() && triangles_.empty() && buffer.places_.changed_.empty() &&
                      buffer.places_.cursor() == last_.totals.cursor;
    if (same || buffer.stale_) return;  // after an exception the update writes everything
    between_.push_back(take(buffer));
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
  // What is kept of a buffer.
  struct Contents {
    detail::Cells cells;
    std::vector<std::uint32_t> run_of;
    std::vector<detail::RunPlaces::Place> places;
    detail::RunPlaces::Totals totals;
  };
  struct Change {
    detail::ArrayChange narrow_cells;
    detail::ArrayChange wide_cells;
    detail::ArrayChange run_of;
    detail::ArrayChange places;
    detail::RunPlaces::Totals totals;
    bool narrow = false;
  };

  void note_all(const StripBuffer& buffer) {
    cells_.resize(buffer.cells_.size());
    triangles_.resize(buffer.run_of_.size());
    places_.resize(buffer.places_.places_.size());
    for (auto* const list : {&cells_, &triangles_, &places_}) std::iota(list->begin(), list->end(), 0U);
  }
  // The places that have changed since they were read last.
  void read_places(StripBuffer& buffer) {
    detail::RunPlaces& places = buffer.places_;
    places_.insert(places_.end(), places.changed_.begin(), places.changed_.end());
    for (const std::uint32_t p : places.changed_) places.places_[p].named = false;
    places.changed_.clear();
  }
  // The difference to the last contents, which are brought in step.
  Change take(StripBuffer& buffer) {
    const detail::Cells& cells = buffer.cells_;
    const detail::RunPlaces& places = buffer.places_;
    read_places(buffer);
    Change change;
    change.narrow = std::exchange(last_.cells.narrow_, cells.narrow_);
    if (change.narrow != cells.narrow_) cells_.clear();  // all of the one width, then all of the other
    if (change.narrow || cells.narrow_)
      change.narrow_cells.take(cells_, last_.cells.cells16_, cells.cells16_, filling<std::uint16_t>(buffer));
    if (!change.narrow || !cells.narrow_)
      change.wide_cells.take(cells_, last_.cells.cells32_, cells.cells32_, filling<std::uint32_t>(buffer));
    change.run_of.take(triangles_, last_.run_of, buffer.run_of_, StripBuffer::nothing);
    change.places.take(places_, last_.places, places.places_, {});
    change.totals = std::exchange(last_.totals, places.totals_);
    return change;
  }
  // For either width: that of a buffer may be the other one.
  template <class Index>
  static Index filling(const StripBuffer& buffer) noexcept {
    return static_cast<Index>(buffer.stitched_ ? 0 : 0xFFFFFFFFU);
  }
  // Exchanges a change with the buffer, and writes it to the copy; the next update returns its ranges.
  void put(Change& change, StripBuffer& buffer) {
    const detail::ArrayChange& cells = change.narrow ? change.narrow_cells : change.wide_cells;
    detail::make_room(buffer.written_, cells.places().size() + 1);
    buffer.mark((std::min)(cells.size(), buffer.cells_.size()), (std::max)(cells.size(), buffer.cells_.size()));
    for (const std::uint32_t i : cells.places()) buffer.mark(i, i + std::size_t{1});
    buffer.keep_ranges();
    const bool stale = std::exchange(buffer.stale_, true);  // in case memory runs out
    change.narrow_cells.exchange(buffer.cells_.cells16_, last_.cells.cells16_, filling<std::uint16_t>(buffer));
    change.wide_cells.exchange(buffer.cells_.cells32_, last_.cells.cells32_, filling<std::uint32_t>(buffer));
    change.run_of.exchange(buffer.run_of_, last_.run_of, StripBuffer::nothing);
    change.places.exchange(buffer.places_.places_, last_.places, {});
    std::swap(change.totals, buffer.places_.totals_);
    std::swap(change.narrow, buffer.cells_.narrow_);
    last_.totals = buffer.places_.totals_;
    last_.cells.narrow_ = buffer.cells_.narrow_;
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
  Contents last_;  // as it was at the end of the last frame
};

/// The history of a LiveBuffer of strips, of any width. Lists need no history: an update draws them, though in another
/// order.
class LiveHistory {
 public:
  /// Begins with the buffer as it is. Linear time. Exceptions: as for BufferHistory.
  RESTRIP_COLD explicit LiveHistory(LiveBuffer& buffer) {
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
