// Where the runs of a strip buffer lie: their order from scratch, and places for new runs next to their neighbours in
// the mesh. Included by strip_buffer.hpp.
//
// Runs decay slowly if each new run is put next to a run that shares its edges. A place is a gap before or after such a
// run, widened by sliding some of the runs around it; the one taken slides the fewest indices. Without a place the run
// goes into any gap.
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
inline constexpr std::uint32_t neighbors_tried = 4;  // those with the most common edges
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
  const std::uint32_t share = (layout_.work + 1) / 2 * text.length;
  const std::uint32_t most = share + slack_;
  std::uint32_t best = nothing;
  std::uint32_t lowest = most + 1;
  const auto look_at = [&](std::uint32_t before) {
    const std::uint32_t moved = price_of_room(before, text.length, most);
    if (moved >= lowest) return;
    best = before;
    lowest = moved;
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

}  // namespace restrip
