// The cheapest colouring of a window, by a search along a frontier. Included by window.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/search/impl/pseudo_random.hpp"
#include "restrip/search/impl/window_plan.hpp"

namespace restrip::detail {

/// Everything about the coloured triangles that the others depend on, a byte for each slot of the plan. Bits 0 and 1,
/// of an edge: 0 dashed, or else 1 + how the strip turns in the coloured triangle, seen from the edge. Bits 2 to 7: the
/// slot that the strand over this edge comes from, or how it ended. Unused slots are 0.
class Frontier {
 public:
  [[nodiscard]] std::uint8_t& operator[](std::size_t slot) noexcept { return bytes_[slot]; }
  [[nodiscard]] std::uint8_t operator[](std::size_t slot) const noexcept { return bytes_[slot]; }
  void set_far(std::uint8_t slot, std::uint8_t far_end) noexcept {
    bytes_[slot] = static_cast<std::uint8_t>((bytes_[slot] & 3U) | unsigned{far_end} << 2);
  }
  [[nodiscard]] std::uint64_t hash() const noexcept {
    const Words words = std::bit_cast<Words>(bytes_);
    std::uint64_t sum = words[0] * 0x9E3779B97F4A7C15U ^ (words[1] + 0x7F4A7C15U) * 0xC2B2AE3D27D4EB4FU ^
                        words[2] * 0x165667B19E3779F9U;
    sum = (sum ^ sum >> 29) * 0xBF58476D1CE4E5B9U;
    return sum ^ sum >> 32;
  }
  friend bool operator==(const Frontier& a, const Frontier& b) noexcept {
    return std::bit_cast<Words>(a.bytes_) == std::bit_cast<Words>(b.bytes_);
  }

 private:
  using Words = std::array<std::uint64_t, 3>;
  alignas(std::uint64_t) std::array<std::uint8_t, frontier_slots> bytes_{};
};

/// The number of set bits of three; std::popcount is a call on many machines.
constexpr int sides_in(unsigned sides) noexcept {
  return static_cast<int>(0b11'10'10'01'10'01'01'00U >> 2 * sides & 3U);
}

/// The counts of a colouring of a few triangles.
struct WindowTally {
  int ends = 0;  ///< of strips; an isolated triangle has two
  int isolated = 0;
  int swaps = 0;
  int windings = 0;  ///< strips that begin with the wrong turn from both ends
};

class WindowSearch {
 public:
  WindowSearch(Cost cost, bool windings, bool stays) noexcept
      : cost_(cost), priced_{cost.swap != 0, cost.swap != 0 && windings}, stays_(stays) {}

  /// Twice the cost, so that an end is half a strip.
  [[nodiscard]] std::int64_t price(const WindowTally& tally) const noexcept {
    return std::int64_t{cost_.restart} * tally.ends + std::int64_t{2} * cost_.isolated * tally.isolated +
           std::int64_t{2} * cost_.swap * (tally.swaps + (priced_.windings ? tally.windings : 0));
  }

  /// Searches. The present colours are never dropped, so that the best costs no more than they do. `slack`: the most
  /// that a state may cost above the least of its layer, in units of price(); `states`: the most states of a layer; the
  /// most expensive are dropped.
  void run(std::span<const WindowTriangle> triangles, std::span<const WindowPlan::Step> steps, std::int64_t slack,
           std::size_t states, PseudoRandom& random) {
    // All counts, priced or not.
    const auto tally_of = [&](auto&& choice) {
      WindowTally tally;
      Frontier frontier;
      for (std::size_t i = 0; i < steps.size(); ++i)
        if (!take(triangles.subspan(steps[i].first, steps[i].count), choice(i), Marks{}, frontier, tally)) break;
      return tally;
    };
    tally_of_present_ = tally_of(
        [&](std::size_t i) { return unsigned{triangles[steps[i].first].present} & triangles[steps[i].first].leaving; });
    price_of_present_ = price(tally_of_present_) * unit;
    constexpr std::int64_t no_limit = (std::numeric_limits<std::int64_t>::max)();
    least_dropped_ = no_limit;
    slack_ = slack < no_limit / unit ? slack * unit + unit - 1 : no_limit;
    nodes_.clear();
    layer_.assign(1, State{});
    layer_.front().present = true;
    for (const WindowPlan::Step& step : steps) {
      expand(triangles.subspan(step.first, step.count), random);
      const auto drop_above = [&](std::int64_t highest) {
        std::erase_if(next_, [&](const State& state) {
          const bool drop = state.price > highest && !state.present;
          if (drop) least_dropped_ = (std::min)(least_dropped_, state.price);
          return drop;
        });
      };
      if (slack_ < no_limit - least_) drop_above(least_ + slack_);
      if (next_.size() > states) {
        prices_.clear();
        for (const State& state : next_) prices_.push_back(state.price);
        const auto limit = prices_.begin() + static_cast<std::ptrdiff_t>(states);
        std::nth_element(prices_.begin(), limit, prices_.end());
        drop_above(*limit - 1);
      }
      layer_.swap(next_);
    }
    best_.assign(steps.size(), 0);
    std::uint32_t node = layer_.front().node;
    for (std::size_t i = steps.size(); i-- > 0; node = nodes_[node].before) best_[i] = nodes_[node].opened;
    tally_of_best_ = tally_of([&](std::size_t i) { return unsigned{best_[i]}; });
  }

  /// For each step the leaving sides of its first triangle that are solid in the best colouring, one of the best at
  /// random.
  [[nodiscard]] std::span<const std::uint8_t> best() const noexcept { return best_; }
  [[nodiscard]] const WindowTally& tally_of_best() const noexcept { return tally_of_best_; }
  [[nodiscard]] const WindowTally& tally_of_present() const noexcept { return tally_of_present_; }
  /// Whether nothing that was dropped could have been cheaper.
  [[nodiscard]] bool proven() const noexcept { return price(tally_of_best_) * unit <= least_dropped_; }
  /// Colourings of a step tried in all searches.
  [[nodiscard]] std::uint64_t tried() const noexcept { return tried_; }

 private:
  // Of price(), in the price of a state; with `stays_` a changed edge counts 1, and no window has that many edges.
  static constexpr std::int64_t unit = 1024;

  struct State {
    Frontier frontier;
    std::int64_t price = 0;
    std::uint32_t node = 0;
    std::uint16_t ties = 1;  // colourings of this price with this frontier
    bool present = false;    // the present colours reach this frontier, at this price or a higher one
  };
  struct Node {
    std::uint32_t before;
    std::uint8_t opened;
  };
  // The properties that frontiers distinguish. Properties without a price are left out, for fewer frontiers.
  struct Marks {
    bool turns = true;
    bool windings = true;
    [[nodiscard]] unsigned turn(unsigned turn) const noexcept { return turns ? turn : 0; }
    [[nodiscard]] std::uint8_t end(std::uint8_t end) const noexcept { return windings ? end : ends_well; }
  };

  // Colours the triangles of a step: `opened` are the leaving sides of the first one that are solid. False if that is
  // not valid.
  [[nodiscard]] static bool take(std::span<const WindowTriangle> step, unsigned opened, const Marks& marks,
                                 Frontier& frontier, WindowTally& tally) noexcept {
    using Kind = WindowSide::Kind;
    for (const WindowTriangle& here : step) {
      unsigned solid = here.ports | std::exchange(opened, 0U);
      for (unsigned s = 0; s < 3; ++s)
        if (here.sides[s].kind == Kind::arriving && frontier[here.sides[s].slot] != 0) solid |= 1U << s;
      const int degree = sides_in(solid);
      if (degree > 2) return false;
      tally.ends += 2 - degree;
      if (degree == 0) {
        ++tally.isolated;
        continue;
      }
      std::array<std::uint8_t, 2> far_end{};
      std::array<std::uint8_t, 2> own{};
      std::uint8_t end_here = marks.end(ends_there);  // what the strand of a triangle of degree one ends with
      std::size_t n = 0;
      for (unsigned s = 0; s < 3; ++s) {
        if ((solid >> s & 1U) == 0) continue;
        const WindowSide& side = here.sides[s];
        const unsigned turn = marks.turn(solid * 0b1001U >> (s + 1) & 3U);
        const auto meets = [&](unsigned turn_beyond) {
          tally.swaps += int{(turn_beyond ^ turn) == 3};
          end_here = turn_beyond == 1 ? marks.end(ends_wrong) : ends_well;
          if (far_end[n] == ends_there) far_end[n] = turn == 1 ? marks.end(ends_wrong) : ends_well;
        };
        own[n] = side.slot;
        switch (side.kind) {
          case Kind::leaving:
            frontier[side.slot] = static_cast<std::uint8_t>(1 + turn);
            far_end[n] = side.slot;
            break;
          case Kind::arriving:
            far_end[n] = frontier[side.slot] >> 2;
            meets((frontier[side.slot] & 3U) - 1);
            frontier[side.slot] = 0;
            break;
          case Kind::port:
            far_end[n] = marks.end(side.far_end);
            own[n] = ends_well;
            meets(marks.turn(side.turn));
            break;
          case Kind::port_out:
            far_end[n] = side.slot;
            meets(marks.turn(side.turn));
            break;
          case Kind::port_back:
            far_end[n] = frontier[side.slot] >> 2;
            meets(marks.turn(side.turn));
            frontier[side.slot] = 0;
            break;
          case Kind::dashed:
            break;
        }
        ++n;
      }
      if (degree == 1)
        far_end[1] = end_here;
      else if (far_end[0] == own[1] && far_end[0] < frontier_slots)
        return false;  // a cycle
      const bool ends0 = far_end[0] >= frontier_slots;
      const bool ends1 = far_end[1] >= frontier_slots;
      if (ends0 && ends1) tally.windings += int{far_end[0] == ends_wrong && far_end[1] == ends_wrong};
      if (!ends0) frontier.set_far(far_end[0], far_end[1]);
      if (!ends1) frontier.set_far(far_end[1], far_end[0]);
    }
    return true;
  }

  void expand(std::span<const WindowTriangle> step, PseudoRandom& random) {
    const WindowTriangle& first = step.front();
    const unsigned present = first.present & first.leaving;
    next_.clear();
    std::size_t places = 256;
    while (places < layer_.size() * 4) places *= 2;
    table_.assign(places, 0);
    least_ = (std::numeric_limits<std::int64_t>::max)();
    for (const State& from : layer_) {
      int degree = sides_in(first.ports);
      for (const WindowSide& side : first.sides)
        if (side.kind == WindowSide::Kind::arriving && from.frontier[side.slot] != 0) ++degree;
      for (unsigned opened = first.leaving;; opened = (opened - 1) & first.leaving) {
        if (degree + sides_in(opened) <= 2) {
          State state = from;
          WindowTally tally;
          ++tried_;
          if (take(step, opened, priced_, state.frontier, tally)) {
            state.price += price(tally) * unit;
            if (stays_) state.price += sides_in(opened ^ present);
            state.present = from.present && opened == present;
            const bool dear = least_ < state.price - slack_;
            if (state.price <= price_of_present_ && (!dear || state.present))
              offer(state, opened, random);
            else if (dear)
              least_dropped_ = (std::min)(least_dropped_, state.price);
          }
        }
        if (opened == 0) break;
      }
    }
  }

  void offer(const State& state, unsigned opened, PseudoRandom& random) {
    least_ = (std::min)(least_, state.price);
    if (next_.size() * 2 >= table_.size()) rehash();
    std::size_t at = static_cast<std::size_t>(state.frontier.hash()) & (table_.size() - 1);
    while (table_[at] != 0 && !(next_[table_[at] - 1].frontier == state.frontier)) at = (at + 1) & (table_.size() - 1);
    const Node node{state.node, static_cast<std::uint8_t>(opened)};
    if (table_[at] == 0) {
      next_.push_back(state);
      next_.back().ties = 1;
      next_.back().node = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(node);
      table_[at] = static_cast<std::uint32_t>(next_.size());
      return;
    }
    State& there = next_[table_[at] - 1];
    there.present |= state.present;
    if (there.price < state.price) return;
    if (there.price > state.price) {
      there.price = state.price;
      there.ties = 1;
    } else if (there.ties == (std::numeric_limits<std::uint16_t>::max)() || random.below(++there.ties) != 0) {
      return;
    }
    nodes_[there.node] = node;
  }

  void rehash() {
    table_.assign(table_.size() * 2, 0);
    for (std::uint32_t i = 0; i < next_.size(); ++i) {
      std::size_t at = static_cast<std::size_t>(next_[i].frontier.hash()) & (table_.size() - 1);
      while (table_[at] != 0) at = (at + 1) & (table_.size() - 1);
      table_[at] = i + 1;
    }
  }

  Cost cost_;
  Marks priced_;
  bool stays_;
  std::vector<State> layer_;
  std::vector<State> next_;
  std::vector<std::uint32_t> table_;  // 1 + place in next_, or 0
  std::vector<Node> nodes_;
  std::vector<std::int64_t> prices_;
  std::int64_t slack_ = 0;
  std::int64_t least_ = 0;
  std::int64_t price_of_present_ = 0;
  std::int64_t least_dropped_ = 0;
  std::vector<std::uint8_t> best_;
  WindowTally tally_of_best_;
  WindowTally tally_of_present_;
  std::uint64_t tried_ = 0;
};

}  // namespace restrip::detail
