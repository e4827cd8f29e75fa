// StripBuffer, member by member. Included by strip_buffer.hpp.
#pragma once

#include <algorithm>

#include "restrip/output/strip_buffer.hpp"

namespace restrip {

inline void StripBuffer::rebuild(const StripMesh& mesh) {
  indices_.clear();
  runs_.clear();
  free_runs_.clear();
  released_.clear();
  empty_.clear();
  used_ = 0;
  run_of_.assign(mesh.triangle_bound(), none);
  const Strips strips = extract_strips(mesh);
  for (std::size_t s = 0; s < strips.size(); ++s) write(mesh, strips[s]);
  written_.assign(1, {0, indices_.size()});
}

inline std::span<const StripBuffer::Range> StripBuffer::update(const StripMesh& mesh,
                                                               std::span<const Triangle> changed) {
  written_.clear();
  if (run_of_.size() < mesh.triangle_bound()) run_of_.resize(mesh.triangle_bound(), none);
  // All runs with a changed triangle go. What is left of such a run hangs together with a changed triangle, since both
  // sides of an edge that changes are changed: so the triangles to write are found from these.
  for (const Triangle t : changed) {
    if (has_run(t)) release(run_of_[t]);
    if (!mesh.alive(t) && t < run_of_.size()) run_of_[t] = none;
  }
  for (const Triangle t : changed) {
    if (!mesh.alive(t) || has_run(t)) continue;
    collect(mesh, t);
    write(mesh, stretch_);
  }
  free_runs_.insert(free_runs_.end(), released_.begin(), released_.end());
  released_.clear();
  if (used_ * 2 + 1024 < indices_.size())
    rebuild(mesh);
  else
    merge_ranges();
  return written_;
}

// The run is no more, and its place is blank. Its number is not used again before the update is over, because its
// triangles still name it.
inline void StripBuffer::release(std::uint32_t run) {
  Run& gone = runs_[run];
  std::fill_n(indices_.begin() + static_cast<std::ptrdiff_t>(gone.first), gone.room, restart_index);
  written_.push_back({gone.first, gone.room});
  give_back(gone.first, gone.room);
  used_ -= gone.used;
  gone.triangles = 0;
  released_.push_back(run);
}

inline void StripBuffer::give_back(std::size_t first, std::uint32_t room) {
  const std::size_t size = room / room_step;
  if (size >= empty_.size()) empty_.resize(size + 1);
  empty_[size].push_back(first);
}

// The triangles without a run that lie next to each other around `start`, in strip order. Short runs at their ends are
// taken in, so that runs do not crumble.
inline void StripBuffer::collect(const StripMesh& mesh, Triangle start) {
  stretch_.assign(1, start);
  // First over the lowest solid side of the start, then over the other one.
  unsigned past = 3;
  for (int end = 0; end < 2; ++end) {
    std::reverse(stretch_.begin(), stretch_.end());
    bool may_take_in = true;
    StripStep<StripMesh::Halfedge> next = mesh.strip_step(StripMesh::halfedge(start, past));
    if (next.goes_on) past = StripMesh::side(mesh.opposite(next.in));
    // In a colouring that is not valid a strip may come back to itself; what is drawn then is wrong, but there is an
    // end.
    for (; next.goes_on && stretch_.size() < mesh.triangle_count(); next = mesh.strip_step(next.in)) {
      const Triangle following = StripMesh::triangle(next.in);
      if (has_run(following)) {
        const std::uint32_t triangles = runs_[run_of_[following]].triangles;
        const bool is_short = std::min<std::size_t>(triangles, stretch_.size()) < max_run_ / 4;
        if (!may_take_in || !is_short || triangles + stretch_.size() > max_run_) break;
        release(run_of_[following]);
        may_take_in = false;
      }
      stretch_.push_back(following);
    }
    if (past == 3) break;
  }
}

inline void StripBuffer::write(const StripMesh& mesh, std::span<const Triangle> triangles) {
  const std::size_t parts = (triangles.size() + max_run_ - 1) / max_run_;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t begin = triangles.size() * part / parts;
    const std::size_t end = triangles.size() * (part + 1) / parts;
    text_.clear();
    detail::append_indices(mesh, triangles.subspan(begin, end - begin), text_);
    text_.push_back(restart_index);
    Run run;
    run.used = static_cast<std::uint32_t>(text_.size());
    run.room = (run.used + room_step - 1) / room_step * room_step;
    run.first = place_for(run.room);
    run.triangles = static_cast<std::uint32_t>(end - begin);
    std::copy(text_.begin(), text_.end(), indices_.begin() + static_cast<std::ptrdiff_t>(run.first));
    written_.push_back({run.first, run.used});
    used_ += run.used;
    std::uint32_t name = static_cast<std::uint32_t>(runs_.size());
    if (free_runs_.empty()) {
      runs_.push_back(run);
    } else {
      name = free_runs_.back();
      free_runs_.pop_back();
      runs_[name] = run;
    }
    for (std::size_t i = begin; i < end; ++i) run_of_[triangles[i]] = name;
  }
}

// A blank place of at least this many indices: an unused one that is not much larger, or a new one.
inline std::size_t StripBuffer::place_for(std::uint32_t room) {
  const std::size_t wanted = room / room_step;
  for (std::size_t size = wanted; size < empty_.size() && size <= wanted * 2 + 2; ++size) {
    if (empty_[size].empty()) continue;
    const std::size_t first = empty_[size].back();
    empty_[size].pop_back();
    if (size > wanted) give_back(first + room, static_cast<std::uint32_t>(size - wanted) * room_step);
    return first;
  }
  const std::size_t first = indices_.size();
  indices_.resize(first + room, restart_index);
  written_.push_back({first, room});
  return first;
}

inline void StripBuffer::merge_ranges() {
  std::sort(written_.begin(), written_.end(), [](const Range& a, const Range& b) { return a.first < b.first; });
  std::size_t kept = 0;
  for (const Range& range : written_) {
    if (kept != 0 && range.first <= written_[kept - 1].first + written_[kept - 1].count) {
      Range& last = written_[kept - 1];
      last.count = std::max(last.count, range.first + range.count - last.first);
    } else {
      written_[kept++] = range;
    }
  }
  written_.resize(kept);
}

}  // namespace restrip
