// Annealing: a colouring of low cost by random changes of a few dual edges. annealing.cpp tells the method.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "restrip/fwd.hpp"
#include "restrip/mesh/cost.hpp"
#include "search/coloring_copy.hpp"
#include "search/poll.hpp"

namespace restrip::detail {

/// Pseudo-random bits, the same everywhere: xorshift64* (Vigna, "An experimental exploration of Marsaglia's xorshift
/// generators, scrambled", 2016).
class PseudoRandom {
 public:
  explicit constexpr PseudoRandom(std::uint64_t seed) noexcept : state_(seed ^ 0x9E3779B97F4A7C15U) {
    if (state_ == 0) state_ = 1;
  }
  constexpr std::uint32_t bits() noexcept {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return static_cast<std::uint32_t>(state_ * 0x2545F4914F6CDD1DU >> 32);
  }

 private:
  std::uint64_t state_;
};

/// A copy of the colours of a mesh, changed move by move and written back. The cost is the one of stripify(): wrong
/// windings count.
class Annealing : private ColoringCopy {
 public:
  Annealing(ColoringCopy colors, Cost cost, std::uint64_t seed)
      : ColoringCopy(std::move(colors)), cost_(cost), random_(seed) {}

  using ColoringCopy::give;
  using ColoringCopy::strips;
  using ColoringCopy::triangle_count;
  /// The colours, to be changed by another search.
  [[nodiscard]] ColoringCopy& colors() noexcept { return *this; }

  /// Colours it from scratch: strips of few indices in one pass (growing.cpp).
  void grow();
  /// Keeps the present colours if they cost less than the colours kept before. Linear time.
  void keep();
  /// The cost of the colours kept.
  [[nodiscard]] std::uint64_t least() const noexcept { return least_; }
  /// Goes back to the colours kept.
  void go_back() { solid_ = kept_; }

  /// Tries about N moves while the temperature falls from `heat` hundredths to a half and a quarter of that, in
  /// 45 % of the moves each, and then to 0. A heat of about 100 forgets the first colours, 20 improves them. At a
  /// temperature of 1 a change that costs a third of a strip (or a swap, if that weighs more) is accepted with
  /// probability 1 / e. `poll` may end it.
  void cool(std::uint64_t moves, std::uint32_t heat, Poll* poll = nullptr);

  /// The change of the cost if the dashed h is set and, in the triangle across, which has two solid edges, the one
  /// before it (`before` 1) or after it (0) is cleared; the least number if triangles at these edges coincide. The
  /// triangle of h must have room. Most moves that are tried gain nothing, and this finds out without changing colours.
  [[nodiscard]] std::int64_t least_change(std::uint32_t h, unsigned before) const noexcept;

 private:
  [[nodiscard]] bool flawed(Triangle t) const noexcept;
  [[nodiscard]] std::int64_t price(std::uint32_t h) const noexcept;
  [[nodiscard]] bool may_be_ends_of_one(Triangle t, Triangle u) const noexcept;
  void note(Triangle t) noexcept;
  void note_around(Triangle t) noexcept;
  void try_move(std::uint32_t h);

  Cost cost_;
  PseudoRandom random_;
  std::vector<std::uint8_t> kept_;
  std::uint64_t least_ = 0;
  std::vector<std::uint64_t> flaws_;  // a bit for each triangle: the flawed ones, and some that were
  std::uint64_t temperature_ = 0;     // of the cost, in units of 2^-16 / ln 2
  std::uint64_t tried_ = 0;
};

/// The searches of stripify(): from scratch, or from the present colours if swaps have no weight.
void color_from_scratch(Annealing& annealing, Effort effort, Cost cost, std::uint64_t limit, Poll& poll);

}  // namespace restrip::detail
