// Strips of few indices in one pass.
//
// Outline. Strips grow one after the other, first from one end, then from the other, until no neighbour is left. A
// strip continues to the neighbour with the fewest neighbours left, and between equals to the one that needs no swap.
// The next strip begins at a triangle with the fewest neighbours left, the most recent one of these: strips grow next
// to each other, and few triangles are left between them.
//
// Cost. Linear time; memory: 13 bytes a triangle. Properties of neighbours are effectively random, so branches on them
// would mispredict: a step is free of branches.
//
// Source. Akeley, Haeberli, Burns, "tomesh.c", 1990; swaps as Evans, Skiena, Varshney, "Optimizing triangle strips for
// fast rendering", 1996.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/annealing.hpp"

namespace restrip::detail {

namespace {

class Growing {
 public:
  /// `across`: for each triangle the opposite halfedges, 4 * triangle + side, or none; three times none for a missing
  /// triangle. `solid` receives the solid sides.
  Growing(std::span<const std::array<std::uint32_t, 3>> across, std::span<std::uint8_t> solid)
      : across_(across), solid_(solid), left_(across.size()), waiting_(3 * across.size() + 1) {}

  void run() {
    std::fill(solid_.begin(), solid_.end(), std::uint8_t{0});
    for (auto t = static_cast<Triangle>(across_.size()); t-- > 0;) {
      unsigned neighbors = 0;
      for (const std::uint32_t there : across_[t]) neighbors += there != none ? 1U : 0U;
      left_[t] = neighbors == 0 ? taken : static_cast<std::uint8_t>(neighbors);
      if (neighbors == 1 || neighbors == 2) waiting_[neighbors * across_.size() + count_[neighbors]++] = t;
    }
    for (Triangle t = first(); t != none; t = first()) {
      left_[t] = taken;
      unsigned best = 0;
      for (unsigned s = 1; s < 3; ++s)
        if (left_over(t, s) < left_over(t, best)) best = s;
      if (left_over(t, best) > 3) continue;
      for (unsigned s = 0; s < 3; ++s)
        if (s != best) update_neighbor(t, s);
      const std::uint32_t out = t << 2 | best;
      const Turn turn = grow(out, Turn::none);
      // In reverse the first turn is the previous one, with sides exchanged.
      const Turn before = turn == Turn::right ? Turn::left : turn == Turn::left ? Turn::right : Turn::none;
      const Way way = way_on(out, before);
      if (way.out != none) grow(way.out, way.turn);
    }
  }

 private:
  enum class Turn : std::uint8_t { none, right, left };
  struct Way {
    std::uint32_t out = none;  // halfedge
    Turn turn = Turn::none;
  };
  static constexpr unsigned taken = 16;  // stays above 3 while three neighbours are taken

  // A triangle that is not taken, with the fewest neighbours left; none when all are taken.
  Triangle first() noexcept {
    for (unsigned neighbors = 0; neighbors < 3; ++neighbors)
      while (count_[neighbors] != 0) {
        const Triangle t = waiting_[neighbors * across_.size() + --count_[neighbors]];
        if (left_[t] == neighbors) return t;
      }
    while (next_ < across_.size() && left_[next_] > 3) ++next_;
    return next_ < across_.size() ? next_ : none;
  }

  // Updates a neighbour of t, which is taken. A taken neighbour goes onto a fourth list, which has one place.
  void update_neighbor(Triangle t, unsigned side) noexcept {
    const std::uint32_t there = across_[t][side];
    const Triangle u = there == none ? t : there >> 2;
    const unsigned neighbors = --left_[u];
    const unsigned list = (std::min)(neighbors, 3U);
    waiting_[list * across_.size() + count_[list]] = u;
    count_[list] += static_cast<Triangle>(neighbors < 3);
  }

  // The neighbours left of the triangle over a side of t, which is taken.
  [[nodiscard]] unsigned left_over(Triangle t, unsigned side) const noexcept {
    const std::uint32_t there = across_[t][side];
    return left_[there == none ? t : there >> 2];
  }
  // From the triangle of `in`, entered over that side.
  [[nodiscard]] Way way_on(std::uint32_t in, Turn last) const noexcept {
    const Triangle t = in >> 2;
    const unsigned entered = in & 3U;
    const unsigned right = entered == 2 ? 0 : entered + 1;
    const unsigned left = entered == 0 ? 2 : entered - 1;
    // If neither turn is a swap, the lower side is preferred.
    const Turn avoided = last != Turn::none ? last : entered == 1 ? Turn::right : Turn::left;
    const unsigned score_right = 2 * left_over(t, right) + static_cast<unsigned>(avoided == Turn::right);
    const unsigned score_left = 2 * left_over(t, left) + static_cast<unsigned>(avoided == Turn::left);
    if ((std::min)(score_right, score_left) > 2 * 3 + 1) return {};
    const bool turns_left = score_left < score_right;
    return {t << 2 | (turns_left ? left : right), turns_left ? Turn::left : Turn::right};
  }

  // Continues over the halfedge, as far as possible. Returns the first turn. Of the neighbours of a triangle the
  // previous one is taken and the next one will be, so only the third has to be updated.
  Turn grow(std::uint32_t out, Turn last) noexcept {
    Turn first_turn = Turn::none;
    solid_[out >> 2] = static_cast<std::uint8_t>(solid_[out >> 2] | 1U << (out & 3U));
    for (;;) {
      const std::uint32_t in = across_[out >> 2][out & 3U];
      const Triangle t = in >> 2;
      left_[t] = taken;
      const Way way = way_on(in, last);
      solid_[t] = static_cast<std::uint8_t>(1U << (in & 3U));
      if (way.out == none) return first_turn;
      solid_[t] = static_cast<std::uint8_t>(1U << (in & 3U) | 1U << (way.out & 3U));
      update_neighbor(t, 3 - (in & 3U) - (way.out & 3U));
      out = way.out;
      last = way.turn;
      if (first_turn == Turn::none) first_turn = last;
    }
  }

  std::span<const std::array<std::uint32_t, 3>> across_;
  std::span<std::uint8_t> solid_;
  std::vector<std::uint8_t> left_;  // neighbours that are not taken, of those that are not
  // By that number, 0 to 2, each list with room for all triangles; the number of some entries has changed.
  std::vector<Triangle> waiting_;
  std::array<Triangle, 4> count_{};
  Triangle next_ = 0;
};

}  // namespace

void Annealing::grow() { Growing(across_, solid_).run(); }

}  // namespace restrip::detail
