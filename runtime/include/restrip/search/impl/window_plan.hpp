// The plan of a window for its search: triangles in an order, and where each of their sides leads. Included by
// window.hpp.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/search/sided_mesh.hpp"

namespace restrip::detail {

/// The search (window_search.hpp) keeps a slot, one byte of a frontier, for each edge between coloured and other
/// triangles, and for each port whose strip returns into the window.
inline constexpr unsigned frontier_slots = 24;

/// In place of a slot, the other end of a strand that has ended: a strip written from there begins with a turn to the
/// left or does not turn; it begins with a turn to the right; or the end is the triangle right across the edge, and the
/// triangle before the edge decides.
inline constexpr std::uint8_t ends_well = 61;
inline constexpr std::uint8_t ends_wrong = 62;
inline constexpr std::uint8_t ends_there = 63;

struct WindowSide {
  enum class Kind : std::uint8_t {
    dashed,     ///< frozen, or on the boundary
    leaving,    ///< a dual edge to a later triangle of the window, in a new slot from here on
    arriving,   ///< one from an earlier triangle; its slot is free again
    port,       ///< a solid edge out of the window to a strand that ends outside, as `far_end` says
    port_out,   ///< a solid edge out of the window to a strand that comes back at a later triangle, by `slot`
    port_back,  ///< the other end of such a strand
  };
  Kind kind = Kind::dashed;
  std::uint8_t slot = 0;
  std::uint8_t turn = 0;     ///< of ports: how the strip turns beyond it, seen from the edge (other_solid_sides)
  std::uint8_t far_end = 0;  ///< of Kind::port: a StrandEnd
};

struct WindowTriangle {
  Triangle triangle = none;
  std::array<WindowSide, 3> sides{};
  std::uint8_t present = 0;  ///< solid sides
  std::uint8_t ports = 0;    ///< solid sides that stay solid
  std::uint8_t leaving = 0;  ///< sides that are chosen at this triangle
};

/// Numbers for a few triangles, found by hashing, without memory for the others.
class LocalNumbers {
 public:
  static constexpr std::uint32_t absent = 255;

  void clear() noexcept { numbers_.fill({}); }
  [[nodiscard]] std::uint32_t operator[](Triangle t) const noexcept { return numbers_[place(t)].number; }
  void add(Triangle t, std::uint32_t number) noexcept { numbers_[place(t)] = {t, static_cast<std::uint8_t>(number)}; }

 private:
  struct Entry {
    Triangle triangle = none;
    std::uint8_t number = absent;
  };
  [[nodiscard]] std::size_t place(Triangle t) const noexcept {
    std::size_t at = t * 0x9E3779B1U >> 24;
    while (numbers_[at].number != absent && numbers_[at].triangle != t) at = (at + 1) % numbers_.size();
    return at;
  }
  std::array<Entry, 256> numbers_{};
};

class WindowPlan {
 public:
  /// The number of triangles that a walk along a strip outside passes before the window is refused.
  static constexpr std::uint32_t max_walk = 10'000;

  /// False if a frontier gets too wide or a strip outside too long; then no plan exists. `triangles` are all different,
  /// alive, at most 128.
  [[nodiscard]] bool make(const SidedMesh auto& mesh, std::span<const Triangle> triangles) {
    numbers_.clear();
    for (std::uint32_t i = 0; i < triangles.size(); ++i) numbers_.add(triangles[i], i);
    neighbors_.resize(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (unsigned s = 0; s < 3; ++s) {
        const Halfedge there = mesh.opposite(StripMesh::halfedge(triangles[i], s));
        const bool outside = StripMesh::on_boundary(there) || StripMesh::triangle(there) == triangles[i];
        neighbors_[i][s] =
            static_cast<std::uint8_t>(outside ? LocalNumbers::absent : numbers_[StripMesh::triangle(there)]);
      }
    find_order();
    free_slots_ = (1U << frontier_slots) - 1;
    slots_.assign(triangles.size(), {no_slot, no_slot, no_slot});
    order_.clear();
    steps_.clear();
    for (const std::uint8_t number : sequence_) {
      WindowTriangle& here = order_.emplace_back();
      here.triangle = triangles[number];
      here.present = static_cast<std::uint8_t>(mesh.solid_sides(here.triangle));
      std::uint32_t freed = 0;
      for (unsigned s = 0; s < 3; ++s) {
        WindowSide& side = here.sides[s];
        const auto bit = static_cast<std::uint8_t>(1U << s);
        const Halfedge h = StripMesh::halfedge(here.triangle, s);
        const std::uint8_t adjacent = neighbors_[number][s];
        std::uint8_t& slot = slots_[number][s];
        if (adjacent == LocalNumbers::absent) {
          if ((here.present & bit) == 0) continue;
          here.ports |= bit;
          if (!place_port(mesh, h, side, slot)) return false;
          if (side.kind == Kind::port_back) freed |= 1U << slot;
        } else if (place_in_sequence_[adjacent] > place_in_sequence_[number]) {
          here.leaving |= bit;
          side.kind = Kind::leaving;
          if (!take_slot(slot)) return false;
          slots_[adjacent][StripMesh::side(mesh.opposite(h))] = slot;
        } else {
          side.kind = Kind::arriving;
          freed |= 1U << slot;
        }
        side.slot = slot;
      }
      // Not earlier: within one triangle old and new slots must differ.
      free_slots_ |= freed;
      if (here.leaving != 0 || steps_.empty()) steps_.push_back({static_cast<std::uint32_t>(order_.size()) - 1, 0});
      ++steps_.back().count;
    }
    return true;
  }

  /// In the order in which the search colours them.
  [[nodiscard]] std::span<const WindowTriangle> triangles() const noexcept { return order_; }
  /// In steps of `count` triangles from `first` on: only the first one has leaving sides, so the others are determined.
  struct Step {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  [[nodiscard]] std::span<const Step> steps() const noexcept { return steps_; }
  /// Triangles walked past in all plans.
  [[nodiscard]] std::uint64_t walked() const noexcept { return walked_; }
  /// What matters later: WindowRounds counts every eighth.
  template <class Visit>
  void visit_state(Visit&& visit) {
    walked_ %= 8;
    visit(walked_);
    walked_ %= 8;
  }

 private:
  using Halfedge = StripMesh::Halfedge;
  using Kind = WindowSide::Kind;
  using Neighbors = std::array<std::uint8_t, 3>;  // local numbers, absent if none exists
  static constexpr std::uint8_t no_slot = 255;

  // Next comes the triangle that leaves the fewest edges between ordered triangles and others; between equals the one
  // that has waited longest. The last triangle, on the rim of a ball, comes first.
  void find_order() {
    const std::size_t count = neighbors_.size();
    place_in_sequence_.assign(count, LocalNumbers::absent);
    sequence_.clear();
    constexpr std::uint8_t waits = 254;
    std::array<std::uint8_t, 256> waiting{};
    std::size_t waiting_count = 0;
    std::array<std::int8_t, 256> widens{};  // the number of edges by which a waiting triangle widens the frontier
    const auto take = [&](std::uint8_t number) {
      place_in_sequence_[number] = static_cast<std::uint8_t>(sequence_.size());
      sequence_.push_back(number);
      for (const std::uint8_t adjacent : neighbors_[number]) {
        if (adjacent == LocalNumbers::absent || place_in_sequence_[adjacent] < waits) continue;
        if (place_in_sequence_[adjacent] == waits) {
          widens[adjacent] = static_cast<std::int8_t>(widens[adjacent] - 2);
          continue;
        }
        place_in_sequence_[adjacent] = waits;
        waiting[waiting_count++] = adjacent;
        int edges = 0;
        for (const std::uint8_t other : neighbors_[adjacent])
          if (other != LocalNumbers::absent) edges += place_in_sequence_[other] < waits ? -1 : 1;
        widens[adjacent] = static_cast<std::int8_t>(edges);
      }
    };
    for (std::size_t start = count; start-- > 0;) {
      if (place_in_sequence_[start] != LocalNumbers::absent) continue;
      take(static_cast<std::uint8_t>(start));
      while (waiting_count != 0) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < waiting_count; ++i)
          if (widens[waiting[i]] < widens[waiting[best]]) best = i;
        const std::uint8_t number = waiting[best];
        --waiting_count;
        for (std::size_t i = best; i < waiting_count; ++i) waiting[i] = waiting[i + 1];
        take(number);
      }
    }
  }

  [[nodiscard]] bool place_port(const SidedMesh auto& mesh, Halfedge h, WindowSide& side, std::uint8_t& slot) {
    Halfedge in = mesh.opposite(h);
    side.turn = static_cast<std::uint8_t>(mesh.other_solid_sides(in));
    if (slot != no_slot) {
      side.kind = Kind::port_back;
      return true;
    }
    for (std::uint32_t steps = 0; steps < max_walk; ++steps, ++walked_) {
      const auto step = mesh.strip_step(in);
      if (!step.continues) {
        side.kind = Kind::port;
        const unsigned last_turn = mesh.other_solid_sides(mesh.opposite(in));
        side.far_end = side.turn == 0 ? ends_there : last_turn == 1 ? ends_wrong : ends_well;
        return true;
      }
      in = step.in;
      const std::uint32_t back = numbers_[StripMesh::triangle(in)];
      if (back == LocalNumbers::absent) continue;
      side.kind = Kind::port_out;
      if (!take_slot(slot)) return false;
      slots_[back][StripMesh::side(in)] = slot;
      return true;
    }
    return false;
  }
  [[nodiscard]] bool take_slot(std::uint8_t& slot) noexcept {
    if (free_slots_ == 0) return false;
    slot = static_cast<std::uint8_t>(std::countr_zero(free_slots_));
    free_slots_ &= free_slots_ - 1;
    return true;
  }

  LocalNumbers numbers_;
  std::vector<Neighbors> neighbors_;
  std::vector<std::uint8_t> sequence_;              // local numbers in the order of the search
  std::vector<std::array<std::uint8_t, 3>> slots_;  // of each side, as soon as it has one
  std::vector<std::uint8_t> place_in_sequence_;
  std::uint32_t free_slots_ = 0;
  std::vector<WindowTriangle> order_;
  std::vector<Step> steps_;
  std::uint64_t walked_ = 0;
};

}  // namespace restrip::detail
