// How gaps are closed, a few indices at a time. Included by strip_buffer.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "restrip/output/strip_buffer.hpp"

namespace restrip {

template <class Index>
void BasicStripBuffer<Index>::slide(std::uint32_t p, std::uint32_t first) noexcept {
  const std::uint32_t old = places_.first(p);
  const std::uint32_t used = places_.used(p);
  if (first == old) return;
  if (first < old) {
    std::copy(cells_.data() + old, cells_.data() + old + used, cells_.data() + first);
    std::copy(whose_.data() + old, whose_.data() + old + used, whose_.data() + first);
    mark(first, first + used);
    blank(std::max(old, first + used), old + used);
  } else {
    std::copy_backward(cells_.data() + old, cells_.data() + old + used, cells_.data() + first + used);
    std::copy_backward(whose_.data() + old, whose_.data() + old + used, whose_.data() + first + used);
    blank(old, std::min(first, old + used));
    mark(first, first + used);
  }
  places_.set(p, first, used, places_.pads(p));
}

// The run goes into the gap behind another one.
template <class Index>
void BasicStripBuffer<Index>::move(std::uint32_t p, std::uint32_t before) noexcept {
  const std::uint32_t from = places_.first(p);
  const std::uint32_t to = places_.end(before);
  const std::uint32_t size = places_.used(p);
  const std::uint32_t pads = places_.pads(p);
  const std::uint32_t cuts = places_.cuts(p);
  if (cursor_ == p) cursor_ = places_.previous(p);
  std::copy_n(cells_.data() + from, size, cells_.data() + to);
  std::copy_n(whose_.data() + from, size, whose_.data() + to);
  mark(to, to + size);
  blank(from, from + size);
  places_.remove(p);
  places_.insert(before, to, size, pads);  // has the number that was given back last: the same
  places_.set_cuts(p, cuts);
}

template <class Index>
void BasicStripBuffer<Index>::trim() noexcept {
  const std::uint32_t end = places_.end(places_.last());
  if (end == places_.length()) return;
  places_.set_length(end);
  cells_.resize(end);
  whose_.resize(end);
}

template <class Index>
void BasicStripBuffer<Index>::compact() noexcept {
  using detail::RunPlaces;
  trim();
  std::size_t budget = detail::compaction_base + detail::compaction_times * marked_;
  std::size_t steps = 0;
  for (;;) {
    // Indices are needed for what is drawn in the fewest runs; restarts and beginnings of other runs are wasted.
    const std::uint64_t needed = places_.used() - places_.pads() - 3 * places_.cuts() / 2;
    const std::uint64_t wasted = std::uint64_t{1000} * (places_.length() - needed);
    const std::uint64_t soft = needed * detail::wasted_soft;
    const std::uint64_t hard = needed * detail::wasted_hard;
    if (wasted <= soft || ++steps > most_steps_) return;
    const std::size_t done = move_from_the_end(budget);
    if (done > budget) return;
    budget -= done;
    if (done != 0) continue;
    // The run at the cursor slides to the left, so that two gaps become one, where that is cheap enough.
    const std::size_t ratio =
        wasted > hard ? 1000 : 4 + static_cast<std::size_t>(16 * (wasted - soft) / (hard - soft + 1));
    for (;;) {
      if (++steps > most_steps_) return;
      const std::uint32_t p = places_.next(cursor_);
      const std::uint32_t before = cursor_;
      cursor_ = p;
      if (p == RunPlaces::head) continue;
      const std::uint32_t used = places_.used(p);
      const std::uint32_t pads = places_.pads(p);
      const std::uint32_t gap = places_.gap(before);
      if (gap + pads == 0 || (gap + pads + places_.gap(p)) * ratio < used) continue;
      if (used > budget) {
        cursor_ = before;
        return;
      }
      budget -= used;
      slide_together(p);
      trim();
      if (places_.gap(p) >= detail::worth_filling) break;
    }
  }
}

// The last run goes into a gap, or where none is large enough its end goes into the largest. Returns how many cells
// that were, 0 when all gaps are small.
template <class Index>
std::size_t BasicStripBuffer<Index>::move_from_the_end(std::size_t budget) noexcept {
  using detail::RunPlaces;
  const std::uint32_t last = places_.last();
  const std::uint32_t size = places_.used(last);
  std::uint32_t before = places_.find_gap(size);
  if (before == RunPlaces::no_place) {
    before = places_.find_largest_gap();
    if (before == RunPlaces::no_place || places_.gap(before) < detail::worth_filling) return 0;
  }
  if (before == places_.previous(last) || places_.gap(before) >= size) {
    if (size > budget) return size;
    if (before == places_.previous(last))
      slide(last, places_.end(before));
    else
      move(last, before);
    trim();
    return size;
  }
  const std::uint32_t gap = places_.gap(before);
  if (gap > budget) return gap;
  // Not when many strips are divided already: one of a hundred indices would be wasted so.
  if (size < detail::worth_filling + 8 || places_.cuts() * std::size_t{100} > places_.used()) return 0;
  // The end of it: from the triangle at `cut` on.
  const std::uint32_t first = places_.first(last);
  const std::uint32_t* whose = whose_.data() + first;
  std::uint32_t cut = std::max(size + 4 - gap, detail::worth_filling / 2);
  while (cut < size && whose[cut] == nothing) ++cut;
  if (cut + 4 >= size) return 0;
  std::uint32_t kept = cut - 1;
  while (whose[kept] == nothing) --kept;
  Piece end;
  end.place = last;
  end.from = cut;
  end.to = size - 2;
  text_.clear();
  names_.clear();
  begin_ = 0;
  fresh_.assign(1, Fresh{});
  std::uint32_t may_pad = 0;
  append_stretch(end, nothing, true, may_pad);
  put(restart, nothing);
  fresh_[0].length = static_cast<std::uint32_t>(text_.size());
  if (fresh_[0].length > gap) return 0;
  cells_[first + kept + 1] = restart;
  mark(first + kept + 1, first + kept + 2);
  whose_[first + kept + 1] = nothing;
  const std::uint32_t to = places_.end(before);
  places_.set(last, first, kept + 2, std::min(places_.pads(last), (kept - 2) & ~1U));
  trim();
  const std::uint32_t p = places_.insert(before, to, fresh_[0].length, fresh_[0].pads);
  places_.set_cuts(p, 1);
  places_.set_cuts(last, std::min(places_.cuts(last) + 1, 2U));
  write(p, to, fresh_[0], true);
  return gap;
}

// The run slides to the one before it.
template <class Index>
void BasicStripBuffer<Index>::slide_together(std::uint32_t p) noexcept {
  const std::uint32_t gap = places_.gap(places_.previous(p));
  const std::uint32_t used = places_.used(p);
  const std::uint32_t first = places_.first(p);
  if (places_.pads(p) == 0) return slide(p, first - gap);
  // Without its pads.
  text_.clear();
  names_.clear();
  std::uint32_t k = 0;
  while (k + 1 < used) {
    put(cells_[first + k], whose_[first + k]);
    if (k++ < 2) continue;
    std::uint32_t between = 0;
    while (k + between + 1 < used && whose_[first + k + between] == nothing) ++between;
    if (between % 2 != 0) put(cells_[first + k], nothing);
    k += between;
  }
  put(restart, nothing);
  const Fresh fresh{0, static_cast<std::uint32_t>(text_.size()), 0, p};
  write(p, first - gap, fresh, true);
  blank(std::max(first, first - gap + fresh.length), first + used);
  places_.set(p, first - gap, fresh.length, 0);
}

}  // namespace restrip
