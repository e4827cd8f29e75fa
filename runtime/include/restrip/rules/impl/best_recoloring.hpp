// The engine of restrip/rules/exact.hpp: sweeps arcs, tries every way in which the few special edges can tie them
// together.
#pragma once

#include <cassert>
#include <cstddef>

#include "restrip/rules/bits.hpp"
#include "restrip/rules/impl/layout.hpp"
#include "restrip/rules/impl/strand_sweep.hpp"

namespace restrip::detail {

// (ports, joined) with the question "may these two ports be joined?".
class Key {
 public:
  constexpr Key(std::size_t k, bool cyclic, BitSpan ports, BitSpan joined) noexcept
      : k_(k), cyclic_(cyclic), ports_(ports), joined_(joined) {
    if (!cyclic) return;
    const std::size_t one = ports.first_set(0, k);
    const std::size_t two = one == nowhere ? nowhere : ports.first_set(one + 1, k);
    if (two == nowhere || ports.first_set(two + 1, k) != nowhere) return;
    two_joined_ = joined[one] || joined[two];
  }

  constexpr bool port(std::size_t i) const noexcept { return ports_[i]; }

  constexpr bool joined_to_previous(std::size_t i) const noexcept { return joined_[i] || two_joined_; }

  // Whether the solid ports x and y are a pair of the key.
  constexpr bool allows(std::size_t x, std::size_t y) const noexcept {
    return x != y && ((previous(x) == y && joined_to_previous(x)) || (previous(y) == x && joined_to_previous(y)));
  }

  constexpr std::size_t first_port(std::size_t from, std::size_t to) const noexcept {
    return ports_.first_set(from, to);
  }
  constexpr std::size_t last_port(std::size_t from, std::size_t to) const noexcept { return ports_.last_set(from, to); }

 private:
  constexpr std::size_t previous(std::size_t x) const noexcept {
    const std::size_t below = ports_.last_set(0, x);
    return below == nowhere && cyclic_ ? ports_.last_set(x + 1, k_) : below;
  }

  std::size_t k_;
  bool cyclic_;
  bool two_joined_ = false;  // exactly two solid ports in a ring: either bit stands for the pair
  BitSpan ports_;
  BitSpan joined_;
};

// A sweep over the elements from ... to-1, its steps stored at steps[from ...].
template <unsigned lanes>
constexpr StrandSweep<lanes> sweep(const Layout& patch, const Key& key, std::size_t from, std::size_t to,
                                   Step* steps) noexcept {
  StrandSweep<lanes> result(steps + from);
  for (std::size_t e = from; e < to; ++e) {
    if (patch.is_fan(e) && key.port(patch.port(e))) {
      result.push_port(key.joined_to_previous(patch.port(e)));
    } else {
      result.push_portless();
    }
  }
  return result;
}

// The best recolouring without the chord: A and D are elements like the others, without a port. A ring takes three
// lanes, a path one: its first element has no link to the left.
template <unsigned lanes>
class Chordless {
 public:
  constexpr Chordless(const Layout& patch, const Key& key, Step* steps) noexcept
      : sweep_(sweep<lanes>(patch, key, 0, patch.size(), steps)), best_(sweep_.score(dashed, dashed)) {
    if constexpr (lanes == 1) return;
    // The ring's last edge is the left link and the right link of the sweep, and counts once. `through` is a solid
    // cycle.
    for (const Reach left : {loose, ported}) {
      for (const Reach right : {loose, ported}) {
        const Score score = sweep_.score(left, right) - solid_edge;
        if (score <= best_) continue;
        if (left == ported && right == ported && !key.allows(key.first_port(0, patch.k), key.last_port(0, patch.k))) {
          continue;
        }
        best_ = score;
        left_ = left;
        right_ = right;
      }
    }
  }

  constexpr Score score() const noexcept { return best_; }
  constexpr void write(MutableBitSpan colors) const noexcept { sweep_.write(left_, right_, 0, colors); }

 private:
  StrandSweep<lanes> sweep_;
  Score best_;
  Reach left_ = dashed;
  Reach right_ = dashed;
};

// The best recolouring with the chord. A and D have room for one more solid edge each, into the arc between them or
// into what lies outside: in a ring one arc from D round to A, in a path one arc below A and one above D, either of
// them perhaps empty. A strand through an arc from A to D would close a cycle with the chord, so `through` never comes
// in.
class WithChord {
 public:
  constexpr WithChord(const Layout& patch, const Key& key, Step* steps) noexcept
      : patch_(patch),
        between_(sweep<3>(patch, key, patch.inserted + 1, patch.opposite, steps)),
        below_(sweep<1>(patch, key, 0, patch.inserted, steps)),
        above_(sweep<3>(patch, key, patch.opposite + 1, patch.size(), steps)) {
    const std::size_t cut_a = patch.inserted;      // fan triangles below A
    const std::size_t cut_d = patch.opposite - 1;  // fan triangles below D
    // The port that a strand from A or D reaches, inwards or outwards.
    const std::size_t a_in = key.first_port(cut_a, cut_d);
    const std::size_t d_in = key.last_port(cut_a, cut_d);
    const std::size_t a_out = patch.ring ? key.last_port(cut_d, patch.k) : key.last_port(0, cut_a);
    const std::size_t d_out = key.first_port(cut_d, patch.k);
    for (const Side& a : sides) {
      for (const Side& d : sides) {
        const Score score = between_.score(a.in, d.in) + outside(a.out, d.out) + solid_edge;
        if (score <= best_) continue;
        const bool joins = (a.in == ported || a.out == ported) && (d.in == ported || d.out == ported);
        if (joins && !key.allows(a.in == ported ? a_in : a_out, d.in == ported ? d_in : d_out)) continue;
        best_ = score;
        a_ = a;
        d_ = d;
      }
    }
  }

  constexpr Score score() const noexcept { return best_; }

  constexpr void write(MutableBitSpan colors) const noexcept {
    colors.set(patch_.chord());
    if (a_.in != dashed) colors.set(patch_.inserted);
    if (d_.out != dashed) colors.set(patch_.opposite);
    between_.write(a_.in, d_.in, patch_.inserted + 1, colors);
    above_.write(d_.out, patch_.ring ? a_.out : dashed, patch_.opposite + 1, colors);
    if (!patch_.ring) below_.write(dashed, a_.out, 0, colors);
  }

 private:
  // What A or D does with its one free place.
  struct Side {
    Reach in;
    Reach out;
  };
  static constexpr Side sides[] = {
      {dashed, dashed}, {loose, dashed}, {ported, dashed}, {dashed, loose}, {dashed, ported}};

  constexpr Score outside(Reach a, Reach d) const noexcept {
    return patch_.ring ? above_.score(d, a) : below_.score(dashed, a) + above_.score(d, dashed);
  }

  Layout patch_;
  StrandSweep<3> between_;
  StrandSweep<1> below_;
  StrandSweep<3> above_;
  Score best_ = impossible;
  Side a_ = sides[0];
  Side d_ = sides[0];
};

// How many steps best_recoloring needs room for.
constexpr std::size_t steps_for(const Layout& patch) noexcept { return 2 * patch.size(); }

template <unsigned lanes>
constexpr Score best_of_row(const Layout& patch, const Key& key, Step* steps, MutableBitSpan colors) noexcept {
  const Chordless<lanes> without(patch, key, steps);
  if (patch.has_chord()) {
    const WithChord with(patch, key, steps + patch.size());
    if (with.score() > without.score()) {
      with.write(colors);
      return with.score();
    }
  }
  without.write(colors);
  return without.score();
}

// The best sound recolouring of a patch with this key; `colors` gets patch.colors() bits.
constexpr Score best_recoloring(const Layout& patch, BitSpan ports, BitSpan joined, Step* steps,
                                MutableBitSpan colors) noexcept {
  const Key key(patch.k, patch.ring, ports, joined);
  colors.clear(patch.colors());
  return patch.ring ? best_of_row<3>(patch, key, steps, colors) : best_of_row<1>(patch, key, steps, colors);
}

}  // namespace restrip::detail
