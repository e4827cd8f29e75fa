// Where the indices of a strip go, as near as possible to where they were. Included by strip_buffer.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "restrip/output/strip_buffer.hpp"

namespace restrip {

// Room for all that is to come.
template <class Index>
void BasicStripBuffer<Index>::prepare() {
  std::size_t cells = 0;
  for (const Fresh& fresh : fresh_) cells += fresh.length;
  most_steps_ = detail::compaction_steps + cells / 4;
  const std::size_t ranges = cells / 4 + 4 * (fresh_.size() + touched_.size() + most_steps_);
  detail::make_buffer_room(cells_, cells);
  detail::make_buffer_room(whose_, cells);
  detail::make_buffer_room(written_, ranges);
  detail::make_buffer_room(text_, 256);
  detail::make_buffer_room(names_, 256);
  detail::make_buffer_room(homeless_, fresh_.size());
  detail::make_buffer_room(fresh_, 1);
  places_.make_room(fresh_.size() + most_steps_);
}

template <class Index>
void BasicStripBuffer<Index>::mark(std::size_t first, std::size_t end) noexcept {
  marked_ += end - first;
  if (!written_.empty()) {
    Range& last = written_.back();
    if (first >= last.first && first <= last.first + last.count + 2) {
      last.count = std::max(last.count, end - last.first);
      return;
    }
  }
  if (written_.size() == written_.capacity() && !written_.empty()) {
    // No room to tell it exactly.
    Range& last = written_.back();
    const std::size_t begin = std::min(last.first, first);
    last = {begin, std::max(last.first + last.count, end) - begin};
    return;
  }
  written_.push_back({first, end - first});
}

template <class Index>
void BasicStripBuffer<Index>::blank(std::uint32_t first, std::uint32_t end) noexcept {
  for (std::uint32_t i = first; i < end; ++i) {
    const std::uint32_t begin = i;
    for (; i < end && cells_[i] != restart; ++i) {
      whose_[i] = nothing;
      cells_[i] = restart;
    }
    if (i != begin) mark(begin, i);
    if (i < end) whose_[i] = nothing;
  }
}

template <class Index>
void BasicStripBuffer<Index>::remove(std::uint32_t p) noexcept {
  if (cursor_ == p) cursor_ = places_.previous(p);
  blank(places_.first(p), places_.end(p));
  places_.set_touched(p, false);
  places_.set_claimed(p, false);
  places_.remove(p);
}

template <class Index>
void BasicStripBuffer<Index>::write(std::uint32_t p, std::uint32_t first, const Fresh& fresh, bool all) noexcept {
  Index* cell = cells_.data() + first;
  std::uint32_t* whose = whose_.data() + first;
  const Index* text = text_.data() + fresh.begin;
  const std::uint32_t* names = names_.data() + fresh.begin;
  for (std::uint32_t i = 0; i < fresh.length; ++i) {
    const std::uint32_t begin = i;
    for (; i < fresh.length && cell[i] != text[i]; ++i) cell[i] = text[i];
    if (i != begin) mark(first + begin, first + i);
  }
  for (std::uint32_t i = 0; i < fresh.length; ++i) {
    if (all || whose[i] != names[i]) {
      whose[i] = names[i];
      if (names[i] < gone) at_[names[i]] = {p, i};
    }
  }
}

// The texts fresh_[begin] … fresh_[end - 1], in order, into the place that all of them name, as near as possible to
// where they wish to be. What finds no room is homeless.
template <class Index>
void BasicStripBuffer<Index>::store_in_place(std::size_t begin, std::size_t end) noexcept {
  const std::uint32_t p = fresh_[begin].target;
  const std::uint32_t old_first = places_.first(p);
  const std::uint32_t old_end = places_.end(p);
  const std::uint32_t low = places_.end(places_.previous(p));
  std::size_t total = 0;
  std::size_t keeper = begin;
  for (std::size_t i = begin; i < end; ++i) {
    total += fresh_[i].length;
    if (fresh_[i].length > fresh_[keeper].length) keeper = i;
  }
  while (total > places_.limit(p) - low) {
    if (end - begin == 1 && make_room(p, static_cast<std::uint32_t>(total))) break;
    std::size_t least = begin;
    for (std::size_t i = begin; i < end; ++i)
      if (fresh_[i].length < fresh_[least].length) least = i;
    total -= fresh_[least].length;
    homeless_.push_back(fresh_[least]);
    std::move(fresh_.begin() + static_cast<std::ptrdiff_t>(least) + 1,
              fresh_.begin() + static_cast<std::ptrdiff_t>(end), fresh_.begin() + static_cast<std::ptrdiff_t>(least));
    --end;
    if (begin == end) return remove(p);
    keeper = begin;
    for (std::size_t i = begin; i < end; ++i)
      if (fresh_[i].length > fresh_[keeper].length) keeper = i;
  }
  const std::uint32_t bottom = places_.end(places_.previous(p));
  if (end - begin == 1 && fresh_[begin].shift != 0) {
    Fresh& only = fresh_[begin];
    const bool fits_right =
        static_cast<std::int32_t>(only.wish - bottom) >= 0 && only.wish + only.length <= places_.limit(p);
    const bool fits_left = static_cast<std::int32_t>(only.wish - only.shift - bottom) >= 0;
    if (fits_left && (only.tail > only.head || !fits_right)) only.wish -= only.shift;
  }
  std::uint32_t at = bottom;
  for (std::size_t i = begin; i < end; ++i) {
    std::uint32_t& wish = fresh_[i].wish;
    if (static_cast<std::int32_t>(wish - at) < 0) wish = at;
    at = wish + fresh_[i].length;
  }
  at = places_.limit(p);
  for (std::size_t i = end; i-- > begin;) {
    std::uint32_t& wish = fresh_[i].wish;
    wish = std::min(wish, at - fresh_[i].length);
    at = wish;
  }
  // The largest keeps the number.
  places_.set(p, fresh_[keeper].wish, fresh_[keeper].length, fresh_[keeper].pads);
  places_.set_cuts(p, fresh_[keeper].cuts);
  at = old_first;
  std::uint32_t before = places_.previous(p);
  for (std::size_t i = begin; i < end; ++i) {
    const Fresh& fresh = fresh_[i];
    if (i == keeper) {
      before = p;
      write(p, fresh.wish, fresh, fresh.wish != old_first);
    } else {
      before = places_.insert(before, fresh.wish, fresh.length, fresh.pads);
      places_.set_cuts(before, fresh.cuts);
      write(before, fresh.wish, fresh, true);
    }
    blank(at, std::min(fresh.wish, old_end));
    at = std::max(at, fresh.wish + fresh.length);
  }
  blank(at, old_end);
  places_.set_touched(p, false);
  places_.set_claimed(p, false);
}

// Slides neighbours of p until there is room for so many cells between them, if that is cheaper than another place.
template <class Index>
bool BasicStripBuffer<Index>::make_room(std::uint32_t p, std::uint32_t cells) noexcept {
  using detail::RunPlaces;
  const std::uint32_t missing = cells - (places_.limit(p) - places_.end(places_.previous(p)));
  const std::uint32_t most = 2 * cells;
  for (const std::uint32_t q : {places_.next(p), places_.previous(p)}) {
    if (q == RunPlaces::head || places_.touched(q)) continue;
    const std::uint32_t size = places_.used(q);
    if (size < missing || size > detail::easily_moved || 3 * size > cells) continue;
    const std::uint32_t before = places_.find_gap(size);
    if (before == RunPlaces::no_place || before == q || before == places_.previous(q) || before == p ||
        before == places_.previous(p))
      continue;
    move(q, before);
    return true;
  }
  std::uint32_t cost = 0;
  std::uint32_t found = 0;
  std::uint32_t q = p;
  while (found < missing) {
    q = places_.next(q);
    if (q == RunPlaces::head || places_.touched(q)) break;
    cost += places_.used(q);
    if (cost > most) break;
    found += places_.gap(q);
  }
  if (found >= missing) {
    std::uint32_t end = places_.limit(q) - (found - missing);
    for (; q != p; q = places_.previous(q)) {
      end -= places_.used(q);
      const std::uint32_t now = places_.first(q);
      if (now < end) slide(q, end);
      end = places_.first(q);
    }
    return true;
  }
  cost = found = 0;
  q = p;
  while (found < missing) {
    q = places_.previous(q);
    if (q == RunPlaces::head || places_.touched(q)) return false;
    cost += places_.used(q);
    if (cost > most) return false;
    found += places_.gap(places_.previous(q));
  }
  std::uint32_t first = places_.end(places_.previous(q)) + (found - missing);
  for (; q != p; q = places_.next(q)) {
    if (places_.first(q) > first) slide(q, first);
    first = places_.end(q);
  }
  return true;
}

template <class Index>
void BasicStripBuffer<Index>::place_anew(const Fresh& fresh) noexcept {
  std::uint32_t before = places_.find_gap(fresh.length);
  std::uint32_t first = 0;
  if (before == detail::RunPlaces::no_place) {
    before = places_.last();
    first = places_.length();
    cells_.resize(first + fresh.length, restart);
    whose_.resize(first + fresh.length, nothing);
    places_.set_length(first + fresh.length);
    mark(first + fresh.length - 1, first + fresh.length);  // set by resize(), so write() does not mark it
  } else {
    first = places_.end(before) + std::min((places_.gap(before) - fresh.length) / 2, 4U);
  }
  const std::uint32_t p = places_.insert(before, first, fresh.length, fresh.pads);
  places_.set_cuts(p, fresh.cuts);
  write(p, first, fresh, true);
}

template <class Index>
void BasicStripBuffer<Index>::store() noexcept {
  for (const std::uint32_t p : touched_)
    if (!places_.claimed(p)) remove(p);
  std::sort(fresh_.begin(), fresh_.end(), [](const Fresh& a, const Fresh& b) {
    if (a.target != b.target) return a.target < b.target;
    if (a.wish != b.wish) return static_cast<std::int32_t>(a.wish - b.wish) < 0;
    return a.begin < b.begin;  // otherwise the buffer would depend on how a library sorts
  });
  homeless_.clear();
  for (std::size_t i = 0; i < fresh_.size();) {
    std::size_t end = i + 1;
    while (end < fresh_.size() && fresh_[end].target == fresh_[i].target) ++end;
    if (fresh_[i].target == nothing)
      homeless_.insert(homeless_.end(), fresh_.begin() + static_cast<std::ptrdiff_t>(i), fresh_.end());
    else
      store_in_place(i, end);
    i = end;
  }
  for (const Fresh& fresh : homeless_) place_anew(fresh);
}

}  // namespace restrip
