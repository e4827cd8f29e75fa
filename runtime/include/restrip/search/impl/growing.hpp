// Strips of few indices in one pass. Included by annealing.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip::detail {

/// Strips grow one after the other, first from one end, then from the other, until no neighbour is left. A strip goes
/// on to the neighbour with the fewest neighbours left, and between equals to the one that needs no swap. The next
/// strip begins at a triangle with the fewest neighbours left, the one that came to be so last: strips grow beside each
/// other, and few triangles are left behind between them (Akeley, Haeberli, Burns, "tomesh.c", 1990; swaps as Evans,
/// Skiena, Varshney, "Optimizing triangle strips for fast rendering", 1996).
///
/// Linear time; memory: a byte a triangle and 4 for each whose neighbours are taken, at most 13.
class Growing {
 public:
  /// `across`: for each triangle the opposite halfedges, 4 * triangle + side, or none; three times none where there is
  /// no triangle. `solid` receives the solid sides.
  Growing(std::span<const std::array<std::uint32_t, 3>> across, std::span<std::uint8_t> solid)
      : across_(across), solid_(solid), left_(across.size(), 0) {}

  void run() {
    std::fill(solid_.begin(), solid_.end(), std::uint8_t{0});
    for (auto t = static_cast<Triangle>(across_.size()); t-- > 0;) {
      unsigned neighbors = 0;
      for (const std::uint32_t there : across_[t]) neighbors += there != none ? 1U : 0U;
      left_[t] = neighbors == 0 ? taken : static_cast<std::uint8_t>(neighbors);
      if (neighbors == 1 || neighbors == 2) waiting_[neighbors].push_back(t);
    }
    for (Triangle t = first(); t != none; t = first()) {
      take(t);
      const Turn turn = grow(t << 2 | 3U, Turn::none);
      if (solid_[t] == 0) continue;
      // The other way round the first turn is the one before, and has changed sides.
      const Turn before = turn == Turn::right ? Turn::left : turn == Turn::left ? Turn::right : Turn::none;
      grow(t << 2 | static_cast<std::uint32_t>(std::countr_zero(solid_[t])), before);
    }
  }

 private:
  enum class Turn : std::uint8_t { none, right, left };
  static constexpr std::uint8_t taken = 255;

  // A triangle that is not taken, with the fewest neighbours left; none when there is no more.
  Triangle first() {
    for (unsigned count = 0; count < waiting_.size(); ++count)
      while (!waiting_[count].empty()) {
        const Triangle t = waiting_[count].back();
        waiting_[count].pop_back();
        if (left_[t] == count) return t;
      }
    while (next_ < left_.size() && left_[next_] == taken) ++next_;
    return next_ < left_.size() ? next_ : none;
  }

  void take(Triangle t) {
    left_[t] = taken;
    for (const std::uint32_t there : across_[t])
      if (there != none && left_[there >> 2] != taken) waiting_[--left_[there >> 2]].push_back(there >> 2);
  }

  // Goes on from the triangle of `in`, entered over that side or from nowhere (side 3), as far as it gets. Returns the
  // first turn.
  Turn grow(std::uint32_t in, Turn last) {
    Turn first_turn = Turn::none;
    for (;;) {
      const Triangle t = in >> 2;
      const unsigned entered = in & 3U;
      unsigned out = 3;
      unsigned least = 8;
      Turn turn = Turn::none;
      for (unsigned s = 0; s < 3; ++s) {
        const std::uint32_t there = across_[t][s];
        if (s == entered || there == none || left_[there >> 2] == taken) continue;
        const Turn this_turn = entered == 3 ? Turn::none : s == (entered + 1) % 3 ? Turn::right : Turn::left;
        const unsigned score = 2U * left_[there >> 2] + (this_turn != Turn::none && this_turn == last ? 1U : 0U);
        if (score >= least) continue;
        least = score;
        out = s;
        turn = this_turn;
      }
      if (out == 3) return first_turn;
      in = across_[t][out];
      solid_[t] = static_cast<std::uint8_t>(solid_[t] | 1U << out);
      solid_[in >> 2] = static_cast<std::uint8_t>(1U << (in & 3U));
      take(in >> 2);
      if (turn == Turn::none) continue;
      if (first_turn == Turn::none) first_turn = turn;
      last = turn;
    }
  }

  std::span<const std::array<std::uint32_t, 3>> across_;
  std::span<std::uint8_t> solid_;
  std::vector<std::uint8_t> left_;                // neighbours that are not taken, of those that are not
  std::array<std::vector<Triangle>, 3> waiting_;  // by that number; some have another one by now
  Triangle next_ = 0;
};

}  // namespace restrip::detail
