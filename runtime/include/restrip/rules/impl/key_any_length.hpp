// The functions of key.hpp for bit strings of any length: a walk, one step an element. Included by key.hpp.
#pragma once

#include <cstddef>
#include <initializer_list>

#include "restrip/rules/bits.hpp"
#include "restrip/rules/key.hpp"

namespace restrip::detail {

struct Walker {
  Patch patch;
  BitSpan inner;
  BitSpan ports;

  bool port(std::size_t element) const noexcept { return patch.is_fan(element) && ports[patch.port(element)]; }
  bool above(std::size_t element) const noexcept { return element < patch.edges() && inner[element]; }
  bool below(std::size_t element) const noexcept {
    return element != 0 ? inner[element - 1] : patch.ring && inner[patch.edges() - 1];
  }
  bool chord() const noexcept { return patch.has_chord() && inner[patch.chord()]; }

  // The far end of the strand at an element with exactly one solid edge in the row. In a ring the other one ends it.
  std::size_t strand_end(std::size_t at) const noexcept {
    const std::size_t n = patch.size();
    const bool up = above(at);
    while (up ? above(at) : below(at)) at = up ? (at + 1) % n : (at + n - 1) % n;
    return at;
  }

  bool any_port(std::size_t from, std::size_t to) const noexcept {
    for (std::size_t e = from; e < to; ++e) {
      if (port(e)) return true;
    }
    return false;
  }

  bool all_solid(std::size_t from, std::size_t to) const noexcept {
    for (std::size_t e = from; e < to; ++e) {
      if (!inner[e]) return false;
    }
    return true;
  }

  void joined(MutableBitSpan result) const noexcept {
    result.clear(patch.k);
    const std::size_t n = patch.size();
    bool live = false;  // a strand from a solid port comes in from below
    // The first round only determines whether a strip enters at the start of a ring.
    for (const bool known : {false, true}) {
      for (std::size_t e = 0; e < n; ++e) {
        const bool solid_port = port(e);
        if (known && live && solid_port) result.set(patch.port(e));
        live = above(e) && (live || solid_port);
      }
    }
    if (!chord()) return;
    const std::size_t a = patch.inserted;
    const std::size_t d = patch.opposite;
    if (below(a) == above(a) || below(d) == above(d)) return;
    const std::size_t one = strand_end(a);
    const std::size_t two = strand_end(d);
    const std::size_t low = one < two ? one : two;
    const std::size_t high = one < two ? two : one;
    if (low == high || !port(low) || !port(high)) return;
    if (!any_port(low + 1, high)) {
      result.set(patch.port(high));
    } else if (patch.ring && !any_port(0, low) && !any_port(high + 1, n)) {
      result.set(patch.port(low));
    }
  }

  bool valid() const noexcept {
    const std::size_t n = patch.size();
    for (std::size_t e = 0; e < n; ++e) {
      const bool third = patch.is_fan(e) ? port(e) : chord();
      if (third && above(e) && below(e)) return false;
    }
    if (patch.ring && all_solid(0, patch.edges())) return false;
    if (!chord()) return true;
    if (all_solid(patch.inserted, patch.opposite)) return false;
    return !patch.ring || !all_solid(patch.opposite, patch.edges());  // A is the first element of a ring
  }
};

}  // namespace restrip::detail

namespace restrip {

inline bool Patch::valid(BitSpan inner, BitSpan ports) const noexcept {
  return detail::Walker{*this, inner, ports}.valid();
}
inline void Patch::joined(BitSpan inner, BitSpan ports, MutableBitSpan result) const noexcept {
  detail::Walker{*this, inner, ports}.joined(result);
}

}  // namespace restrip
