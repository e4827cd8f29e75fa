// The dynamic program under restrip/rules/exact.hpp: one sweep along an arc, a row of elements between two links.
//
// Solid edges inside an arc form strands. What the world beyond the arc's two ends must know of them is little, because
// a strand that enters over a link passes only elements without a solid port, so it can reach no port but the first one
// it meets. Per link there are three cases, its `Reach`; and one more for both, when the strand runs through the arc.
//
// The sweep goes from left to right and keeps, for each reach of the left link and each reach of the edge just passed,
// as seen from the right, the best score so far. At the end of the arc the edge just passed is the right link.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "restrip/rules/bits.hpp"

namespace restrip::detail {

// Solid edges first, isolated triangles second, in one number: every solid edge counts 2^32, every isolated triangle
// -1.
using Score = std::int64_t;
inline constexpr Score solid_edge = Score{1} << 32;
inline constexpr Score isolated_triangle = -1;

// Far below every score of a patch of fewer than 2^26 triangles, and stays there when scores are added to it.
inline constexpr Score impossible = -(Score{1} << 60);

// Where the strand of a link goes, on the side of the arc.
enum Reach : unsigned {
  dashed = 0,   // the link is dashed
  loose = 1,    // it ends in the arc without a solid port
  ported = 2,   // it ends at the first solid port of the arc, as seen from the link
  through = 3,  // it leaves the arc over the other link
};

// How each score of an element came about: for each lane the reach from which `dashed` came (2 bits) and the one from
// which `loose` came (1 bit); then one bit for a solid port.
using Step = std::uint16_t;
inline constexpr unsigned lane_bits = 3;
inline constexpr unsigned loose_shift = 2;
inline constexpr unsigned port_shift = 3 * lane_bits;

// lanes = 3: the left link may have any colour; lane r holds the scores for left reach r. lanes = 1: it is dashed, or
// there is none, and lane 0 is all. Solid links count as edges of the arc. An arc of no elements has no links, and
// score(dashed, dashed) is all that may be asked of it.
template <unsigned lanes>
class StrandSweep {
 public:
  // `steps` gets one entry for each element and must outlive the sweep.
  constexpr explicit StrandSweep(Step* steps) noexcept : steps_(steps) {}

  // Appends an element without a solid port.
  constexpr void push_portless() noexcept {
    unsigned step = 0;
    for (unsigned r = 0; r < lanes; ++r) {
      Lane& lane = lanes_[r];
      Best end{lane.dashed + isolated_triangle, dashed};
      end.offer(lane.loose, loose);
      end.offer(lane.ported, ported);
      if (r == loose) end.offer(through_, through);
      Best start{lane.dashed, dashed};
      start.offer(lane.loose, loose);
      lane = {end.score, start.score + solid_edge, lane.ported + solid_edge};
      step |= (end.from | start.from << loose_shift) << (lane_bits * r);
    }
    through_ += solid_edge;
    steps_[size_++] = static_cast<Step>(step);
  }

  // Appends an element with a solid port; `joined`: may it be joined to the solid port before it in this arc?
  constexpr void push_port(bool joined) noexcept {
    unsigned step = 1U << port_shift;
    for (unsigned r = 0; r < lanes; ++r) {
      Lane& lane = lanes_[r];
      Best end{lane.dashed, dashed};
      end.offer(lane.loose, loose);
      if (joined) end.offer(lane.ported, ported);
      if (r == ported) end.offer(through_, through);
      lane = {end.score, impossible, lane.dashed + solid_edge};
      step |= end.from << (lane_bits * r);
    }
    through_ = impossible;
    steps_[size_++] = static_cast<Step>(step);
  }

  // The best score for a pair of reaches, neither of them `through`; `impossible` or a little more when there is none.
  constexpr Score score(Reach left, Reach right) const noexcept {
    if (left >= lanes) return impossible;
    const Lane& lane = lanes_[left];
    return right == dashed ? lane.dashed : right == loose ? lane.loose : lane.ported;
  }

  // Writes the solid edges behind score(left, right), except the left link: edge `first_edge` + m follows element m.
  constexpr void write(Reach left, Reach right, std::size_t first_edge, MutableBitSpan colors) const noexcept {
    unsigned reach = right;
    for (std::size_t m = size_; m-- > 0;) {
      if (reach != dashed) colors.set(first_edge + m);
      const unsigned all = steps_[m];
      const unsigned step = all >> (lane_bits * left);
      const bool port = (all >> port_shift) != 0;
      if (reach == dashed) {
        reach = step & 3U;
      } else if (reach == loose) {
        reach = (step >> loose_shift) & 1U;
      } else if (reach == ported && port) {
        reach = dashed;
      }
    }
  }

 private:
  struct Lane {
    Score dashed;
    Score loose;
    Score ported;
  };

  // The first of several equal offers wins: the result is the same on every machine.
  struct Best {
    Score score;
    unsigned from;
    constexpr void offer(Score other, unsigned reach) noexcept {
      from = other > score ? reach : from;
      score = other > score ? other : score;
    }
  };

  Lane lanes_[3] = {
      {0, impossible, impossible}, {impossible, impossible, impossible}, {impossible, impossible, impossible}};
  Score through_ = lanes == 3 ? solid_edge : impossible;
  Step* steps_;
  std::size_t size_ = 0;
};

}  // namespace restrip::detail
