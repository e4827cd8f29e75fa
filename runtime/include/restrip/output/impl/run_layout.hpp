// Where the runs of a strip buffer lie: their order from scratch, places for new runs near their neighbours in the
// mesh, and better places for old ones. Included by strip_buffer.hpp.
//
// Runs decay slowly if each new run is put next to runs that share its edges. A place is a gap before or after such a
// run, widened by sliding some of the runs around it; its price is the indices that slide, and `miss_price` for each
// miss that the run adds there (run_order.hpp). Without a place the run goes into any gap.
//
// compact() looks at one run after the other. A run whose misses elsewhere, near its neighbours, are fewer by at least
// `least_gain` moves there, or changes places with a run that is there; the best move is the one that saves most misses
// for each index written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "restrip/output/impl/run_order.hpp"
#include "restrip/output/impl/strip_buffer.hpp"
#include "restrip/output/strip_buffer.hpp"

namespace restrip {

namespace detail {
// Chosen by measurement.
inline constexpr std::uint32_t neighbors_tried = 4;          // those with the most common edges
inline constexpr std::int64_t miss_price = 24;               // indices moved
inline constexpr std::uint32_t indices_after = 36;           // whose misses count
inline constexpr int least_gain = 3;                         // misses
inline constexpr std::int64_t least_gain_per_mille = 40;     // of the indices written
inline constexpr std::uint32_t moved_for_a_better = 100;     // indices that slide, at most
inline constexpr std::uint32_t looked_at_for_an_index = 30;  // by compact(), in indices
}  // namespace detail

// ---- from scratch

RESTRIP_COLD inline void StripBuffer::order_runs() {
  std::vector<detail::Run> runs;
  std::vector<std::uint32_t> place;
  for (std::uint32_t p = places_.next(detail::RunPlaces::head); p != detail::RunPlaces::head; p = places_.next(p)) {
    runs.push_back(places_.run(p));
    place.push_back(p);
  }
  detail::Cells cells(cells_.width());
  cells.resize(cells_.size(), filling());
  std::vector<std::uint32_t> new_place(runs.size() + 1);  // by old place: without gaps they are 1 … runs
  detail::RunPlaces places;
  places.make_room(runs.size());
  places.set_length(places_.length());
  std::uint32_t end = 0;
  for (const std::uint32_t r : detail::order_of_runs(cells_, runs, layout_.cache)) {
    detail::Run run = runs[r];
    cells.copy(cells_, run.first, run.length, end);
    run.first = std::exchange(end, end + run.length);
    new_place[place[r]] = places.insert(places.last(), run);
  }
  for (std::uint32_t& p : run_of_)
    if (p != nothing) p = new_place[p];
  cells_ = std::move(cells);
  places_ = std::move(places);
}

// ---- neighbours

template <class Mesh>
void StripBuffer::note_across(const Mesh& mesh, std::uint32_t t) {
  auto h = mesh.halfedge(t);
  for (int side = 0; side < 3; ++side, h = mesh.next(h))
    if (!mesh.solid(h))
      if (const auto back = mesh.opposite(h); !mesh.on_boundary(back))
        across_.push_back(detail::triangle_of(mesh, back));
}

// The runs of some of across_, those with the most common edges first.
inline std::span<const StripBuffer::Neighbor> StripBuffer::neighbors(std::uint32_t begin, std::uint32_t end) noexcept {
  std::size_t count = 0;
  for (std::uint32_t i = begin; i < end; ++i) {
    const std::uint32_t place = run_of_[across_[i]];
    if (place >= reading) continue;
    const auto same = [place](const Neighbor& n) { return n.place == place; };
    auto* const neighbor = std::find_if(neighbors_.data(), neighbors_.data() + count, same);
    if (neighbor != neighbors_.data() + count)
      ++neighbor->edges;
    else if (count < neighbors_.size())
      neighbors_[count++] = {place, 1};
  }
  const auto before = [](const Neighbor& a, const Neighbor& b) {
    return a.edges != b.edges ? a.edges > b.edges : a.place < b.place;
  };
  const std::size_t tried = (std::min<std::size_t>)(count, detail::neighbors_tried);
  for (std::size_t i = 0; i < tried; ++i)
    std::swap(neighbors_[i], *std::min_element(neighbors_.data() + i, neighbors_.data() + count, before));
  return {neighbors_.data(), tried};
}

// ---- places

// Misses that a run adds in the gap after `before`, as if the run of `without` were not in the buffer.
inline int StripBuffer::added_misses(std::span<const std::uint32_t> run, std::uint32_t before,
                                     std::uint32_t without) const noexcept {
  std::array<std::uint32_t, std::size_t{2} * detail::AddedMisses::largest_cache> last;
  const std::uint32_t most = 2 * layout_.cache;
  std::uint32_t count = 0;
  for (std::uint32_t p = before; p != detail::RunPlaces::head && count < most; p = places_.previous(p)) {
    if (p == without) continue;
    for (std::uint32_t i = places_.run(p).end() - 1; i-- > places_.run(p).first && count < most;)
      last[count++] = cells_[i];
  }
  detail::AddedMisses misses(layout_.cache);
  while (count > 0) misses.before(last[--count]);
  for (const std::uint32_t v : run.first(run.size() - 1)) misses.run(v);
  count = 0;
  for (std::uint32_t p = places_.next(before); p != detail::RunPlaces::head && count < detail::indices_after;
       p = places_.next(p)) {
    if (p == without) continue;
    for (std::uint32_t i = places_.run(p).first; i + 1 < places_.run(p).end() && count < detail::indices_after;
         ++i, ++count)
      misses.after(cells_[i]);
  }
  return misses.added();
}

// What widen() would move so that a run of `length` fits into the gap after `before`; more than `most` if it cannot.
inline std::uint32_t StripBuffer::price_of_room(std::uint32_t before, std::uint32_t length,
                                                std::uint32_t most) const noexcept {
  if (places_.next(before) == detail::RunPlaces::head) return most + 1;
  if (places_.gap(before) >= length) return 0;
  const std::uint32_t missing = length - places_.gap(before);
  const Slide right = slide(places_.next(before), missing, most, true);
  const Slide left = slide(before, missing, most, false);
  if (right.cost == 0) return left.cost == 0 ? most + 1 : left.cost;
  return left.cost == 0 ? right.cost : (std::min)(left.cost, right.cost);
}

// Stores the run in the cheapest gap next to one of its neighbours. False if no such gap is cheap enough.
inline bool StripBuffer::store_near(const Text& text) noexcept {
  const std::span<const std::uint32_t> run = indices_of(text);
  const std::uint32_t share = (layout_.work + 1) / 2 * text.length;
  const std::uint32_t most = share + slack_;
  std::uint32_t best = nothing;
  std::int64_t lowest = 0;
  const auto look_at = [&](std::uint32_t before) {
    const std::uint32_t moved = price_of_room(before, text.length, most);
    if (moved > most) return;
    const std::int64_t price = moved + detail::miss_price * added_misses(run, before, nothing);
    if (best == nothing || price < lowest) {
      best = before;
      lowest = price;
    }
  };
  for (const Neighbor& neighbor : neighbors(text.across, text.across_end)) {
    look_at(neighbor.place);
    look_at(places_.previous(neighbor.place));
  }
  if (best == nothing) return false;
  if (const std::uint32_t gap = places_.gap(best); gap < text.length) {
    const std::uint32_t moved = widen(best, places_.next(best), text.length - gap, most);
    slack_ -= moved - (std::min)(moved, share);
  }
  insert(text, best);
  return true;
}

// ---- better places

template <NumberedMesh Mesh>
std::size_t StripBuffer::compact(const Mesh& mesh, std::size_t budget) {
  if (stale_ || layout_.cache == 0 || places_.runs() == 0) return 0;
  if (std::exchange(returned_, false)) written_.clear();
  const std::size_t most = budget < cells_.size() ? budget : cells_.size();
  std::size_t looked = 0;
  std::size_t written = 0;
  std::size_t seen = 0;  // triangles
  while (written < most && looked < detail::looked_at_for_an_index * most && seen < run_of_.size()) {
    const std::uint32_t t = places_.cursor() < run_of_.size() ? places_.cursor() : 0;
    places_.set_cursor(t + 1);
    ++looked;
    ++seen;
    const std::uint32_t place = run_of_[t];
    if (place >= reading || places_.run(place).triangle != t) continue;  // each run is met once
    looked += places_.run(place).length;
    written += improve(mesh, place);
  }
  return written;
}

// Moves a run to a better place, if one is found. Returns the number of indices written.
template <class Mesh>
std::size_t StripBuffer::improve(const Mesh& mesh, std::uint32_t place) {
  const detail::Run run = places_.run(place);
  const std::uint32_t previous = places_.previous(place);
  across_.clear();
  note_across(mesh, run.triangle);
  auto h = mesh.halfedge(run.triangle);
  for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
    if (!mesh.solid(h)) continue;
    auto in = mesh.opposite(h);
    for (std::uint32_t n = 1; n < run.triangles && run_of_[detail::triangle_of(mesh, in)] == place; ++n) {
      note_across(mesh, detail::triangle_of(mesh, in));
      const auto step = strip_step(mesh, in);
      if (!step.continues) break;
      in = step.in;
    }
  }
  detail::make_room(written_, std::size_t{3} * (detail::moved_for_a_better / detail::shortest_run + 4));
  constexpr std::size_t longest_text = 2 * detail::longest_run + 5;
  if (text_.size() < 2 * longest_text) text_.resize(2 * longest_text);

  struct Move {
    std::int64_t rate = detail::least_gain_per_mille - 1;  // misses saved, per mille of the indices written
    std::uint32_t place = nothing;
    bool swaps = false;
    std::uint32_t written = 0;
  };
  Move best;
  const auto consider = [&](int gain, std::uint32_t where, bool swaps, std::uint32_t indices) {
    const std::int64_t rate = std::int64_t{1000} * gain / indices;
    if (gain >= detail::least_gain && rate > best.rate) best = {rate, where, swaps, indices};
  };
  const auto text_of = [&](const detail::Run& r, std::size_t at) {
    for (std::uint32_t i = 0; i < r.length; ++i) text_[at + i] = cells_[r.first + i];
    return std::span<const std::uint32_t>(text_).subspan(at, r.length);
  };
  const auto text = text_of(run, 0);
  const int here = added_misses(text, previous, place);
  const auto look_at = [&](std::uint32_t other) {
    if (other == detail::RunPlaces::head || other == previous || other == places_.next(place)) return;
    const detail::Run there = places_.run(other);
    // Closer than this, what moves would change the misses of both places.
    constexpr std::uint32_t apart = 200;
    if (there.first < run.first + apart && run.first < there.first + apart) return;
    if (const std::uint32_t slides = price_of_room(other, run.length, detail::moved_for_a_better);
        slides <= detail::moved_for_a_better)
      consider(here - added_misses(text, other, place), other, false, run.length + slides);
    const std::uint32_t before = places_.previous(other);
    if (run.length > places_.limit(other) - places_.run(before).end() ||
        there.length > places_.limit(place) - places_.run(previous).end())
      return;
    const int gain = here - added_misses(text, before, other);
    if (gain < detail::least_gain) return;
    const auto text_there = text_of(there, longest_text);
    consider(gain + added_misses(text_there, before, other) - added_misses(text_there, previous, place), other, true,
             run.length + there.length);
  };
  for (const Neighbor& neighbor : neighbors(0, static_cast<std::uint32_t>(across_.size()))) {
    std::uint32_t p = places_.previous(places_.previous(neighbor.place));
    for (int i = 0; i < 5; ++i, p = places_.next(p)) look_at(p);
  }
  if (best.place == nothing) return 0;
  if (best.swaps) {
    swap(place, best.place, text);
  } else {
    if (places_.gap(best.place) < run.length)
      widen(best.place, places_.next(best.place), run.length - places_.gap(best.place), detail::moved_for_a_better);
    move(place, best.place, places_.run(best.place).end());
  }
  return best.written;
}

// Two runs, not next to each other, that fit into each other's place.
inline void StripBuffer::swap(std::uint32_t one, std::uint32_t other,
                              std::span<const std::uint32_t> text_of_one) noexcept {
  detail::Run a = places_.run(one);
  detail::Run b = places_.run(other);
  const std::uint32_t before_one = places_.previous(one);
  const std::uint32_t before_other = places_.previous(other);
  const std::uint32_t a_first = (std::min)(b.first, places_.limit(other) - a.length);
  const std::uint32_t b_first = (std::min)(a.first, places_.limit(one) - b.length);
  cells_.fill(a.first, a.end(), filling());
  mark(a.first, a.end());
  mark(b.first, b.end());
  // To the left or to the right, and perhaps over itself: the run was elsewhere.
  cells_.copy(cells_, b.first, b.length, b_first);
  cells_.fill(b.first, b.end(), filling());
  cells_.write(a_first, text_of_one);
  a.first = a_first;
  b.first = b_first;
  mark(a.first, a.end());
  mark(b.first, b.end());
  places_.remove(one);
  places_.remove(other);
  places_.insert(before_one, b);  // into the places that were freed last
  places_.insert(before_other, a);
}

#ifdef RESTRIP_COMPILED
extern template std::size_t StripBuffer::compact(const StripMesh&, std::size_t);
#endif

}  // namespace restrip
