// The order of runs for a cache of transformed vertices. Knows neither places nor meshes.
//
// From scratch, greedy: the next run is the one with the fewest misses for each triangle, counted by simulating the
// cache over the whole run, among the runs that have a cached vertex. If no run has one, it is a run at the vertex
// that was missed last among the vertices with runs. Linear time: for each run drawn, at most 64 runs of bounded length
// are tried.
//
// Later, one run at a time: AddedMisses prices a place for a run by the misses that it adds there, in the run itself
// and in the runs after it. The simulation begins some indices before the place.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/output/impl/run_places.hpp"
#include "restrip/output/impl/undrawn.hpp"

namespace restrip::detail {

/// Orders runs for a cache of `cache` vertices, first in, first out. `cells` has their indices, each run a separator at
/// its end.
template <class Index>
class RunOrder {
 public:
  std::vector<std::uint32_t> order;  // numbers of runs

  RunOrder(const std::vector<Index>& cells, const std::vector<Run>& runs, std::uint32_t cache)
      : cells_(cells), runs_(runs), cache_(cache), misses_(cache), drawn_(runs.size(), false), tried_(runs.size(), 0) {
    // An empty cache, and numbers of misses that are never 0.
    missed_.assign(misses_ + std::size_t{1}, none);
    list_runs();
  }

  void run() {
    order.reserve(runs_.size());
    std::uint32_t first = 0;
    while (order.size() < runs_.size()) {
      best_ = {};
      try_cached();
      if (best_.run == none) try_left_behind();
      if (best_.run == none) {
        while (drawn_[first]) ++first;
        best_.run = first;
      }
      draw(best_.run);
    }
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  static constexpr unsigned most_tried = 64;            // runs
  static constexpr unsigned most_met = 8 * most_tried;  // for vertices of many runs

  struct Vertex {
    std::uint32_t came_in = 0;  // number of its last miss; 0: never
    std::uint32_t trial = 0;    // that met it last
    std::uint32_t came_in_by_trial = 0;
  };
  struct Trial {
    std::uint32_t run = none;
    std::uint64_t misses = 0;
    std::uint64_t triangles = 1;
  };

  template <class Visit>
  void for_each_vertex(std::uint32_t run, Visit&& visit) const {
    for (std::uint32_t i = runs_[run].first; i + 1 < runs_[run].end(); ++i) visit(cells_[i]);
  }
  void list_runs() {
    std::size_t bound = 0;
    const auto count = static_cast<std::uint32_t>(runs_.size());
    for (std::uint32_t r = 0; r < count; ++r)
      for_each_vertex(r, [&](Index v) { bound = (std::max)(bound, v + std::size_t{1}); });
    vertices_.resize(bound);
    runs_at_.list(bound, [&](auto&& use) {
      for (std::uint32_t r = 0; r < count; ++r) for_each_vertex(r, [&](Index v) { use(v, r); });
    });
  }
  void try_cached() {
    ++round_;
    unsigned tried = 0;
    unsigned met = 0;
    for (std::uint32_t miss = misses_; miss > misses_ - cache_ && tried < most_tried && met < most_met; --miss) {
      const std::uint32_t v = missed_[miss];
      if (v == none) return;
      if (vertices_[v].came_in != miss) continue;
      runs_at_.for_each(v, drawn_, [&](std::uint32_t run) {
        ++met;
        if (tried_[run] != round_) {
          tried_[run] = round_;
          ++tried;
          try_run(run);
        }
        return tried < most_tried && met < most_met;
      });
    }
  }
  void try_left_behind() {
    for (; best_.run == none && !recent_.empty(); recent_.pop_back()) {
      runs_at_.for_each(recent_.back(), drawn_, [&](std::uint32_t run) {
        best_.run = run;
        return false;
      });
      if (best_.run != none) return;
    }
  }
  void try_run(std::uint32_t run) {
    ++trial_;
    std::uint32_t misses = misses_;
    for_each_vertex(run, [&](Index number) {
      Vertex& v = vertices_[number];
      const std::uint32_t came_in = v.trial == trial_ ? v.came_in_by_trial : v.came_in;
      v.trial = trial_;
      v.came_in_by_trial = came_in != 0 && misses - came_in < cache_ ? came_in : ++misses;
    });
    const Trial here{run, misses - misses_, runs_[run].triangles};
    if (best_.run == none || here.misses * best_.triangles < best_.misses * here.triangles) best_ = here;
  }
  void draw(std::uint32_t run) {
    drawn_[run] = true;
    order.push_back(run);
    for_each_vertex(run, [&](Index number) {
      Vertex& v = vertices_[number];
      if (v.came_in != 0 && misses_ - v.came_in < cache_) return;
      v.came_in = ++misses_;
      missed_.push_back(number);
      recent_.push_back(number);
    });
  }

  const std::vector<Index>& cells_;
  const std::vector<Run>& runs_;
  std::uint32_t cache_;
  std::uint32_t misses_;
  std::vector<bool> drawn_;
  std::vector<std::uint32_t> tried_;  // by run: in which round
  std::vector<Vertex> vertices_;
  UndrawnAt runs_at_;
  std::vector<std::uint32_t> missed_;  // by the number of the miss
  std::vector<std::uint32_t> recent_;  // the same, without vertices that have no run left
  std::uint32_t round_ = 0;
  std::uint32_t trial_ = 0;
  Trial best_;
};

/// The misses of two sequences of vertices in caches of their own: with a run in the middle, and without it.
class AddedMisses {
 public:
  static constexpr std::uint32_t largest_cache = 64;

  explicit AddedMisses(std::uint32_t cache) noexcept : cache_(cache) { slots_.fill({empty, 0, 0}); }
  /// The next vertex of both, of the sequence with the run, or of both again. At most 300 different vertices in all.
  void before(std::uint32_t v) noexcept {
    Slot& slot = at(v);
    look_up(slot.with, with_);
    look_up(slot.without, without_);
  }
  void run(std::uint32_t v) noexcept { added_ += look_up(at(v).with, with_) ? 1 : 0; }
  void after(std::uint32_t v) noexcept {
    Slot& slot = at(v);
    added_ += (look_up(slot.with, with_) ? 1 : 0) - (look_up(slot.without, without_) ? 1 : 0);
  }
  [[nodiscard]] int added() const noexcept { return added_; }

 private:
  static constexpr std::uint32_t empty = 0xFFFFFFFFU;
  struct Slot {
    std::uint32_t vertex;
    std::uint32_t with;  // number of its last miss; 0: never
    std::uint32_t without;
  };
  Slot& at(std::uint32_t v) noexcept {
    std::size_t i = (v * 0x9E3779B1U) >> 23U;
    while (slots_[i].vertex != v && slots_[i].vertex != empty) i = (i + 1) % slots_.size();
    if (slots_[i].vertex == empty) slots_[i] = {v, 0, 0};
    return slots_[i];
  }
  bool look_up(std::uint32_t& came_in, std::uint32_t& misses) const noexcept {
    if (came_in != 0 && misses - came_in < cache_) return false;
    came_in = ++misses;
    return true;
  }

  std::uint32_t cache_;
  std::uint32_t with_ = 0;
  std::uint32_t without_ = 0;
  int added_ = 0;
  std::array<Slot, 512> slots_;
};

}  // namespace restrip::detail
