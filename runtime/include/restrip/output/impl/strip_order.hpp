// The order of strips for a vertex cache. Included by strip_order.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/output/strip_order.hpp"

namespace restrip::detail {

// The strips of an index buffer.
inline std::vector<std::span<const std::uint32_t>> strips_in(std::span<const std::uint32_t> indices) {
  std::vector<std::span<const std::uint32_t>> strips;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= indices.size(); ++i) {
    if (i < indices.size() && indices[i] != restart_index) continue;
    strips.push_back(indices.subspan(begin, i - begin));
    begin = i + 1;
  }
  return strips;
}

class StripOrder {
 public:
  // A strip and the direction in which it is written.
  struct Choice {
    std::uint32_t strip;
    bool turned;
  };

  /// The indices of all strips, written in one direction and in the other.
  StripOrder(std::span<const std::uint32_t> one_way, std::span<const std::uint32_t> other_way, std::size_t cache_size)
      : written_{strips_in(one_way), strips_in(other_way)}, cache_size_(cache_size), done_(written_[0].size(), false) {
    std::size_t vertices = 0;
    for (const std::uint32_t v : one_way)
      if (v != restart_index) vertices = (std::max)(vertices, v + std::size_t{1});
    came_in_.assign(vertices, 0);
    trial_of_.assign(vertices, 0);
    trial_came_in_.assign(vertices, {});
    // For each vertex the strips that have it among their first indices in one direction or the other.
    first_of_.assign(vertices + 1, 0);
    const auto each = [this](auto&& visit) {
      for (std::uint32_t s = 0; s < done_.size(); ++s)
        for (const bool turned : {false, true})
          for (const std::uint32_t v : beginning({s, turned})) visit(v, Choice{s, turned});
    };
    each([this](std::uint32_t v, Choice) { ++first_of_[v + 1]; });
    for (std::size_t v = 0; v < vertices; ++v) first_of_[v + 1] += first_of_[v];
    choices_.resize(first_of_[vertices]);
    std::vector<std::size_t> filled(first_of_.begin(), first_of_.end() - 1);
    each([&](std::uint32_t v, Choice c) { choices_[filled[v]++] = c; });
    end_of_ = std::move(filled);
  }

  std::vector<Choice> run() {
    std::vector<Choice> order;
    order.reserve(done_.size());
    std::size_t first = 0;
    while (order.size() < done_.size()) {
      Choice next{};
      if (!best_beside_cache(next) && !beside_left_behind(next)) {
        while (done_[first]) ++first;
        next = {static_cast<std::uint32_t>(first), false};
      }
      order.push_back(next);
      write(next);
    }
    return order;
  }

 private:
  static constexpr std::size_t most_tried = 64;

  [[nodiscard]] std::span<const std::uint32_t> beginning(Choice of) const noexcept {
    const std::span<const std::uint32_t> all = written_[of.turned ? 1 : 0][of.strip];
    return all.first((std::min)(all.size(), 2 * cache_size_));
  }

  // Strips that have been written are taken out of the list of v while it is read.
  template <class Visit>
  void for_each_choice_at(std::uint32_t v, Visit&& visit) {
    for (std::size_t i = first_of_[v]; i < end_of_[v];) {
      if (done_[choices_[i].strip])
        choices_[i] = choices_[--end_of_[v]];
      else if (!visit(choices_[i++]))
        return;
    }
  }

  // Misses of a beginning with an empty cache, and the number of these saved by the present cache.
  struct Gain {
    std::size_t spared = 0;
    std::size_t of = 1;
  };

  Gain gain_of(Choice choice) {
    ++trial_;
    std::size_t misses = misses_;
    std::size_t misses_alone = 0;
    for (const std::uint32_t v : beginning(choice)) {
      const bool met = trial_of_[v] == trial_;
      const std::size_t last = met ? trial_came_in_[v].shared : came_in_[v];
      if (!met) trial_came_in_[v] = {last, 0};
      trial_of_[v] = trial_;
      if (last == 0 || misses - last >= cache_size_) trial_came_in_[v].shared = ++misses;
      std::size_t& alone = trial_came_in_[v].alone;
      if (alone == 0 || misses_alone - alone >= cache_size_) alone = ++misses_alone;
    }
    const std::size_t now = misses - misses_;
    return {misses_alone - (std::min)(misses_alone, now), misses_alone};
  }

  bool best_beside_cache(Choice& best) {
    Gain best_gain;
    std::size_t tried = 0;
    // The vertices that entered last come first: they stay longest.
    for (std::size_t i = recent_.size(); i-- > recent_.size() - (std::min)(recent_.size(), cache_size_);)
      for_each_choice_at(recent_[i], [&](Choice choice) {
        if (tried == most_tried) return false;
        ++tried;
        const Gain gain = gain_of(choice);
        if (gain.spared * best_gain.of > best_gain.spared * gain.of) {
          best_gain = gain;
          best = choice;
        }
        return true;
      });
    return best_gain.spared != 0;
  }

  // A strip at the most recent vertex that still has one.
  bool beside_left_behind(Choice& next) {
    while (!recent_.empty()) {
      bool found = false;
      for_each_choice_at(recent_.back(), [&](Choice choice) {
        next = choice;
        found = true;
        return false;
      });
      if (found) return true;
      recent_.pop_back();
    }
    return false;
  }

  void write(Choice choice) {
    done_[choice.strip] = true;
    for (const std::uint32_t v : written_[choice.turned ? 1 : 0][choice.strip])
      if (came_in_[v] == 0 || misses_ - came_in_[v] >= cache_size_) {
        came_in_[v] = ++misses_;
        recent_.push_back(v);
      }
  }

  struct Times {
    std::size_t shared;
    std::size_t alone;
  };

  std::vector<std::span<const std::uint32_t>> written_[2];
  std::size_t cache_size_;
  std::vector<bool> done_;            // by strip
  std::vector<std::size_t> came_in_;  // of a vertex, the number of the miss; 0: never
  std::size_t misses_ = 0;
  std::vector<std::size_t> trial_of_;  // in which a vertex was met last
  std::vector<Times> trial_came_in_;
  std::size_t trial_ = 0;
  std::vector<std::uint32_t> recent_;  // misses, without vertices that have no strip left
  std::vector<std::size_t> first_of_;
  std::vector<std::size_t> end_of_;
  std::vector<Choice> choices_;
};

}  // namespace restrip::detail

namespace restrip {

template <NumberedMesh Mesh>
Strips order_for_vertex_cache(const Mesh& mesh, const Strips& strips, std::size_t cache_size) {
  RESTRIP_ASSERT(detail::are_strips_of(mesh, strips), "order_for_vertex_cache", detail::not_strips);
  if (cache_size == 0 || strips.size() < 2) return strips;
  // strip_indices() writes a strip as listed if the other end would not take fewer indices.
  Strips turned = strips;
  for (std::size_t s = 0; s < strips.size(); ++s)
    std::reverse(turned.order.begin() + static_cast<std::ptrdiff_t>(strips.start[s]),
                 turned.order.begin() + static_cast<std::ptrdiff_t>(strips.start[s + 1]));
  const std::vector<std::uint32_t> plain_written = strip_indices(mesh, strips);
  const std::vector<std::uint32_t> turned_written = strip_indices(mesh, turned);
  detail::StripOrder order(plain_written, turned_written, cache_size);
  Strips ordered;
  ordered.order.reserve(strips.order.size());
  ordered.start.reserve(strips.start.size());
  for (const auto& [strip, is_turned] : order.run()) {
    const std::span<const Triangle> triangles = (is_turned ? turned : strips)[strip];
    ordered.order.insert(ordered.order.end(), triangles.begin(), triangles.end());
    ordered.start.push_back(ordered.order.size());
  }
  return ordered;
}

}  // namespace restrip
