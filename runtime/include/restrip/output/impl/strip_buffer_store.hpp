// Stores the indices of a run, as close as possible to their old place. Included by strip_buffer.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "restrip/output/strip_buffer.hpp"

namespace restrip {

namespace detail {
// Chosen by measurement under all policies; in indices unless stated otherwise.
inline constexpr std::uint32_t moved_for_a_run = 60;      // at most, so that a run that grew stays where it is
inline constexpr std::uint32_t moved_for_a_gap = 400;     // at most, so that the last run fits into it
inline constexpr std::uint32_t moved_by_an_update = 200;  // into gaps: none is closed beyond this
inline constexpr std::uint64_t tolerated_waste = 90;      // per mille of what is needed
inline constexpr std::uint32_t shortest_run = 4;
}  // namespace detail

template <class Index>
void BasicStripBuffer<Index>::store() {
  // Room for everything that follows, so that nothing throws after this.
  constexpr std::size_t slides_for_a_run = detail::moved_for_a_run / detail::shortest_run;
  constexpr std::size_t slides = (detail::moved_for_a_gap + detail::moved_by_an_update) / detail::shortest_run;
  detail::make_room(cells_, letters_ + 1);
  detail::make_room(written_, dirty_.size() + 3 * (slides_for_a_run + 1) * texts_.size() + 3 * slides);
  places_.make_room(texts_.size());
  for (const std::uint32_t place : dirty_)
    if (places_.state(place) == State::dirty) remove(place);
  for (Text& text : texts_)
    if (text.place != nothing && !store_in_place(text)) {
      remove(text.place);
      text.place = nothing;
    }
  for (const Text& text : texts_)
    if (text.place == nothing) store_anew(text);
}

// False if the room is too small.
template <class Index>
bool BasicStripBuffer<Index>::store_in_place(const Text& text) noexcept {
  const std::uint32_t before = places_.previous(text.place);
  const std::uint32_t room = places_.limit(text.place) - places_.run(before).end();
  if (text.length > room) {
    const std::uint32_t missing = text.length - room;
    if (widen(before, places_.next(text.place), missing, detail::moved_for_a_run) == 0) return false;
  }
  const detail::Run old = places_.run(text.place);
  std::uint32_t first = old.first;
  if (text.length != old.length) {
    // Keeps its beginning or its end, whichever is unchanged for longer.
    const Index* now = cells_.data() + old.first;
    const Index* then = text_.data() + text.first;
    const std::uint32_t both = std::min(text.length, old.length);
    std::uint32_t head = 0;
    while (head < both && now[head] == then[head]) ++head;
    std::uint32_t tail = 0;
    while (tail < both && now[old.length - 1 - tail] == then[text.length - 1 - tail]) ++tail;
    const std::uint32_t high = places_.limit(text.place) - text.length;
    const bool fits_at_end = old.end() >= places_.run(before).end() + text.length;
    if (fits_at_end && (tail > head || first > high)) first = old.end() - text.length;
    first = std::min(first, high);
  }
  write(text, first);
  blank(old.first, std::min(first, old.end()));
  blank(std::max(first + text.length, old.first), old.end());
  places_.set(text.place, {first, text.length, text.end - text.begin, text.cuts});
  own(text, text.place);
  return true;
}

// In the smallest gap that is large enough, or at the end.
template <class Index>
void BasicStripBuffer<Index>::store_anew(const Text& text) noexcept {
  std::uint32_t before = places_.find_gap(text.length);
  if (before == nothing || places_.gap(before) < text.length) before = places_.last();
  const std::uint32_t first = places_.run(before).end();
  if (first + text.length > places_.limit(before)) {
    const std::uint32_t length = even(first + text.length);
    mark(cells_.size(), length);
    cells_.resize(length, filling());
    places_.set_length(length);
  }
  write(text, first);
  own(text, places_.insert(before, {first, text.length, text.end - text.begin, text.cuts}));
}

template <class Index>
void BasicStripBuffer<Index>::own(const Text& text, std::uint32_t place) noexcept {
  for (std::uint32_t i = text.begin; i < text.end; ++i) run_of_[strip_[i].triangle] = place;
  places_.set_state(place, State::settled);
}

template <class Index>
void BasicStripBuffer<Index>::remove(std::uint32_t place) noexcept {
  blank(places_.run(place).first, places_.run(place).end());
  places_.remove(place);
}

// ---- cells

// From the first index that differs to the last.
template <class Index>
void BasicStripBuffer<Index>::write(const Text& text, std::uint32_t first) noexcept {
  const Index* then = text_.data() + text.first;
  Index* now = cells_.data() + first;
  std::uint32_t begin = 0;
  std::uint32_t end = text.length;
  while (begin < end && now[begin] == then[begin]) ++begin;
  while (begin < end && now[end - 1] == then[end - 1]) --end;
  std::copy(then + begin, then + end, now + begin);
  mark(first + begin, first + end);
}

template <class Index>
void BasicStripBuffer<Index>::blank(std::uint32_t first, std::uint32_t end) noexcept {
  if (first >= end) return;
  std::fill(cells_.data() + first, cells_.data() + end, filling());
  mark(first, end);
}

// Moves the run of a place to `first`, in the gap after `before` or within the gaps on both sides of it.
template <class Index>
void BasicStripBuffer<Index>::move(std::uint32_t place, std::uint32_t before, std::uint32_t first) noexcept {
  detail::Run run = places_.run(place);
  const std::uint32_t old = std::exchange(run.first, first);
  if (old == first) return;
  const Index* from = cells_.data() + old;
  if (first < old)
    std::copy(from, from + run.length, cells_.data() + first);
  else
    std::copy_backward(from, from + run.length, cells_.data() + run.end());
  mark(first, run.end());
  blank(old, std::min(first, old + run.length));
  blank(std::max(run.end(), old), old + run.length);
  if (before == places_.previous(place)) return places_.set(place, run);
  places_.remove(place);
  places_.insert(before, run);  // into the same place: it was freed last
}

// Slides runs from `right` on to the right, or runs up to `left` to the left, until `missing` more cells lie between
// the two. Returns the number of indices moved; 0 if it would exceed `most`. Runs that are to be written stay.
template <class Index>
std::uint32_t BasicStripBuffer<Index>::widen(std::uint32_t left, std::uint32_t right, std::uint32_t missing,
                                             std::uint32_t most) noexcept {
  struct Side {
    std::uint32_t cost = 0;
    std::uint32_t last = 0;
    std::uint32_t found = 0;
  };
  const auto look = [&](std::uint32_t place, bool rightwards) {
    for (Side side; place != detail::RunPlaces::head && places_.state(place) == State::settled;) {
      const std::uint32_t before = places_.previous(place);
      side.cost += places_.run(place).length;
      if (side.cost > most) break;
      side.last = place;
      side.found += places_.gap(rightwards ? place : before);
      if (side.found >= missing) return side;
      place = rightwards ? places_.next(place) : before;
    }
    return Side{};
  };
  Side side = look(right, true);
  const bool rightwards = side.cost != 0;
  if (rightwards) most = side.cost - 1;
  if (const Side other = look(left, false); other.cost != 0) {
    std::uint32_t first = places_.run(places_.previous(other.last)).end() + other.found - missing;
    for (std::uint32_t place = other.last;; place = places_.next(place)) {
      move(place, places_.previous(place), first);
      if (place == left) return other.cost;
      first = places_.run(place).end();
    }
  }
  if (!rightwards) return 0;
  std::uint32_t end = places_.limit(side.last) - (side.found - missing);
  for (std::uint32_t place = side.last;; place = places_.previous(place)) {
    end -= places_.run(place).length;
    move(place, places_.previous(place), end);
    if (place == right) return side.cost;
  }
}

// ---- gaps

// Moves the last run into a gap, repeatedly. A cut wastes some two and a half indices, four in stitched runs, half of
// them at each end.
template <class Index>
void BasicStripBuffer<Index>::close_gaps() noexcept {
  for (std::uint32_t moved = 0;;) {
    const std::uint32_t last = places_.last();
    const detail::Run run = places_.run(last);
    // A gap at the end is not a part of the buffer.
    if (const std::uint32_t length = even(run.end()); length < cells_.size()) {
      cells_.resize(length);
      places_.set_length(length);
    }
    const std::uint64_t needed = places_.used() - std::uint64_t{places_.cuts()} * (stitched_ ? 8 : 5) / 4;
    const bool wasteful = 1000 * (places_.length() - needed) > detail::tolerated_waste * needed;
    const std::uint32_t before = places_.find_gap(run.length);
    if (!wasteful || moved >= detail::moved_by_an_update || before == nothing) return;
    if (places_.gap(before) < run.length && places_.next(before) != last) {
      const std::uint32_t missing = run.length - places_.gap(before);
      const std::uint32_t cost = widen(before, places_.next(before), missing, detail::moved_for_a_gap);
      if (cost == 0) return;
      moved += cost;
    }
    move(last, before, places_.run(before).end());
    moved += run.length;
  }
}

// ---- ranges written

template <class Index>
void BasicStripBuffer<Index>::mark(std::size_t first, std::size_t end) noexcept {
  if (first == end) return;
  // A write is mostly adjacent to the previous one.
  if (!written_.empty()) {
    Range& last = written_.back();
    const std::size_t last_end = last.first + last.count;
    if (first <= last_end && last.first <= end) {
      last.first = std::min(last.first, first);
      last.count = std::max(last_end, end) - last.first;
      return;
    }
  }
  written_.push_back({first, end - first});
}

template <class Index>
void BasicStripBuffer<Index>::draws(std::vector<Range>& draws) const {
  draws.clear();
  for (std::uint32_t p = places_.next(detail::RunPlaces::head); p != detail::RunPlaces::head; p = places_.next(p))
    draws.push_back({places_.run(p).first, places_.run(p).length - std::size_t{1}});
}

inline void detail::join_ranges(std::vector<IndexRange>& ranges, std::size_t end, std::size_t gap,
                                std::size_t unit) noexcept {
  unit = std::max(unit, std::size_t{1});
  for (IndexRange& range : ranges) {
    const std::size_t stop = (range.first + range.count + unit - 1) / unit * unit;
    range.first = range.first / unit * unit;
    range.count = stop - range.first;
  }
  std::sort(ranges.begin(), ranges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (const auto& [first, count] : ranges) {
    const std::size_t stop = std::min(first + count, end);
    if (first >= stop) break;
    if (kept == 0 || first > ranges[kept - 1].first + ranges[kept - 1].count + gap) ranges[kept++] = {first, 0};
    IndexRange& last = ranges[kept - 1];
    last.count = std::max(last.count, stop - last.first);
  }
  ranges.resize(kept);
}

}  // namespace restrip
