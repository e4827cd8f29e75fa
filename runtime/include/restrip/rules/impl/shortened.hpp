// Fans somewhat larger than the tables, answered by the tables where that is provably exact.
//
// Take a triangle without a solid port out of an arc. A sound recolouring of the fan becomes a sound one of the shorter
// fan with at most one solid edge less: where the triangle had two solid edges its neighbours are joined directly,
// where it had one or none that edge is dropped. So the best of the fan has at most one solid edge more than the best
// of the shorter one. Put the triangle back into a solid edge of its stretch (between two solid ports, A or D nothing
// tells the triangles apart) and exactly one is gained. If that works each time, and nobody is isolated at the end, the
// answer is best in both criteria; if not, the exact solver is asked.
#pragma once

#include <bit>
#include <cstddef>

#include "restrip/rules/bits.hpp"
#include "restrip/rules/key.hpp"

namespace restrip::detail {

/// A fan and its key while triangles are taken out and put back. `arc` is a split's a; 0 for a collapse, whose fan has
/// no places to keep apart.
class Shortened {
 public:
  constexpr Shortened(std::size_t k, std::size_t arc, Word ports, Word joined) noexcept
      : now_{k, arc, ports}, joined_(joined) {}

  /// Takes triangles out until `target` are left. False when too many have a solid port.
  constexpr bool shorten(std::size_t target) noexcept {
    if (now_.k > target + most) return false;
    while (now_.k > target) {
      Word loose = ~now_.ports & low_bits(now_.k);
      if (now_.arc == 1) loose &= ~Word{1};
      if (now_.arc != 0 && now_.k - now_.arc == 1) loose &= ~bit(now_.k - 1);
      if (loose == 0) return false;
      const auto i = static_cast<std::size_t>(std::countr_zero(loose));
      const std::size_t inserted_before = now_.arc == 0 ? 0 : i < now_.arc ? 1 : 2;  // A, then D
      taken_[count_++] = {now_, i + inserted_before};
      now_ = {now_.k - 1, i < now_.arc ? now_.arc - 1 : now_.arc, remove_bit(now_.ports, i)};
      joined_ = remove_bit(joined_, i);
    }
    return true;
  }

  [[nodiscard]] constexpr std::size_t k() const noexcept { return now_.k; }
  [[nodiscard]] constexpr std::size_t arc() const noexcept { return now_.arc; }
  [[nodiscard]] constexpr Word ports() const noexcept { return now_.ports; }
  [[nodiscard]] constexpr Word joined() const noexcept { return joined_; }

  /// Puts all back into a recolouring of the shorter patch. False when a stretch has no solid edge.
  constexpr bool put_back(Word& colors) noexcept {
    while (count_ > 0) {
      const auto& [before, element] = taken_[--count_];
      const Word stops = now_.arc == 0 ? now_.ports : ring_ports(now_.arc, now_.ports) | Word{1} | bit(now_.arc + 1);
      const std::size_t edges = now_.arc == 0 ? now_.k : now_.k + 2;
      const Word below = stops & low_bits(element);
      const Word above = stops & ~low_bits(element);
      const std::size_t first = below == 0 ? 0 : word_bits - 1 - static_cast<std::size_t>(std::countl_zero(below));
      const std::size_t last = above == 0 ? edges : static_cast<std::size_t>(std::countr_zero(above));
      const Word solid = colors & low_bits(last) & ~low_bits(first);
      if (solid == 0) return false;
      const auto m = static_cast<std::size_t>(std::countr_zero(solid));
      colors = (colors & low_bits(m + 1)) | (colors >> m) << (m + 1);
      now_ = before;
    }
    return true;
  }

 private:
  static constexpr std::size_t most = 24;
  struct State {
    std::size_t k;
    std::size_t arc;
    Word ports;
  };
  struct Taken {
    State before;
    std::size_t element;  // its place in the patch after the operation
  };
  State now_;
  Word joined_;
  std::size_t count_ = 0;
  Taken taken_[most] = {};
};

}  // namespace restrip::detail
