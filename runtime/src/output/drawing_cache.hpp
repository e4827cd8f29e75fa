// DrawingCache: a first-in-first-out cache of vertices, what is still to be drawn at each of them, and trials of what
// drawing something next would miss. Both orders for a vertex cache are greedy with its help: strip_order.hpp draws
// triangles, strip_buffer.cpp whole runs.
//
// A vertex is cached until as many others have entered as the cache holds, so all that is stored of it is the number of
// its last miss. A trial has such numbers of its own, which the next trial ignores.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "restrip/precondition.hpp"

namespace restrip::detail {

class DrawingCache {
 public:
  enum class Lookup : std::uint8_t { hit, first_miss, later_miss };

  /// `uses`: the vertices of all items, one item after the other; item i ends before ends[i].
  RESTRIP_COLD DrawingCache(std::uint32_t size, const std::vector<std::uint32_t>& uses,
                            const std::vector<std::uint32_t>& ends)
      : size_(size), misses_(size), items_(uses.size()), drawn_(ends.size(), false), tried_(ends.size(), 0) {
    const std::size_t vertices = uses.empty() ? 0 : *std::max_element(uses.begin(), uses.end()) + std::size_t{1};
    // An empty cache: what was missed is a vertex without uses. A vertex that was never missed is not cached.
    missed_.assign(size + std::size_t{1}, static_cast<std::uint32_t>(vertices));
    vertices_.resize(vertices + 1);
    for (const std::uint32_t v : uses) ++vertices_[v].left_to_draw;
    first_.resize(vertices + 1);
    for (std::size_t v = 0; v < vertices; ++v) first_[v + 1] = first_[v] + vertices_[v].left_to_draw;
    end_ = first_;
    for (std::uint32_t item = 0, i = 0; item < ends.size(); ++item)
      for (; i < ends[item]; ++i) items_[end_[uses[i]]++] = item;
  }

  // ---- drawing
  [[nodiscard]] bool is_drawn(std::uint32_t item) const noexcept { return drawn_[item]; }
  [[nodiscard]] bool is_cached(std::uint32_t v) const noexcept { return misses_ - vertices_[v].came_in < size_; }
  /// Each of its uses is to be looked up, too.
  void draw(std::uint32_t item) { drawn_[item] = true; }
  void look_up(std::uint32_t number) {
    Vertex& v = vertices_[number];
    --v.left_to_draw;
    if (misses_ - v.came_in < size_) return;
    v.came_in = ++misses_;
    missed_.push_back(number);
    recent_.push_back(number);
  }

  // ---- candidates
  /// Calls `visit` with items that use cached vertices and are not drawn, each once, those at the vertices missed last
  /// first. Ends when `visit`, which returns the number of its trials, has made `most_tried`, or after `most_met` uses.
  template <class Visit>
  void for_each_near(unsigned most_tried, unsigned most_met, Visit&& visit) {
    ++round_;
    unsigned tried = 0;
    unsigned met = 0;
    const auto goes_on = [&] { return tried < most_tried && met < most_met; };
    for (std::uint32_t miss = misses_; miss > misses_ - size_ && goes_on(); --miss) {
      const std::uint32_t v = missed_[miss];
      if (v + std::size_t{1} == vertices_.size()) return;
      if (vertices_[v].came_in != miss) continue;
      for_each_at(v, [&](std::uint32_t item) {
        ++met;
        if (std::exchange(tried_[item], round_) != round_) tried += visit(item);
        return goes_on();
      });
    }
  }
  /// Calls `visit` with items that are not drawn, until it returns false, at the vertex missed last that has some.
  template <class Visit>
  void for_each_left_behind(Visit&& visit) {
    while (!recent_.empty() && vertices_[recent_.back()].left_to_draw == 0) recent_.pop_back();
    if (!recent_.empty()) for_each_at(recent_.back(), visit);
  }

  // ---- trials
  /// Begins a trial. Returns the number of misses so far, which look-ups continue.
  std::uint32_t try_from_here() noexcept {
    ++trial_;
    return misses_;
  }
  Lookup try_look_up(std::uint32_t number, std::uint32_t& misses) noexcept {
    Vertex& v = vertices_[number];
    const std::uint32_t came_in = v.trial == trial_ ? v.came_in_by_trial : v.came_in;
    v.trial = trial_;
    v.came_in_by_trial = came_in;
    if (misses - came_in < size_) return Lookup::hit;
    v.came_in_by_trial = ++misses;
    return came_in == 0 ? Lookup::first_miss : Lookup::later_miss;
  }
  /// Whether the last miss of the trial removes a vertex at which something else is still to be drawn.
  [[nodiscard]] bool harms(std::uint32_t misses) const noexcept {
    const std::uint32_t leaves = misses - size_;
    if (leaves > misses_) return false;
    const Vertex& lost = vertices_[missed_[leaves]];
    return lost.left_to_draw != 0 && lost.came_in == leaves && lost.trial != trial_;
  }

 private:
  struct Vertex {
    std::uint32_t came_in = 0;  // number of its last miss; 0: never
    std::uint32_t trial = 0;    // that met it last
    std::uint32_t came_in_by_trial = 0;
    std::uint32_t left_to_draw = 0;  // uses
  };

  // Removes items that have been drawn from the list. Ends if `visit` returns false.
  template <class Visit>
  void for_each_at(std::uint32_t v, Visit&& visit) {
    for (std::uint32_t i = first_[v]; i < end_[v];) {
      if (drawn_[items_[i]])
        items_[i] = items_[--end_[v]];
      else if (!visit(items_[i++]))
        return;
    }
  }

  std::uint32_t size_;
  std::uint32_t misses_;               // and `size_`
  std::vector<std::uint32_t> missed_;  // by the number of the miss
  std::vector<std::uint32_t> recent_;  // the same, without vertices that have nothing left
  std::vector<Vertex> vertices_;       // and one without uses
  // By vertex, the items that use it.
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> end_;
  std::vector<std::uint32_t> items_;
  std::vector<bool> drawn_;
  std::vector<std::uint32_t> tried_;  // by item: in which round
  std::uint32_t round_ = 0;
  std::uint32_t trial_ = 0;
};

}  // namespace restrip::detail
