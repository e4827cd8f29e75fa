#pragma once
// What a certificate answers to a key of a fan: forwards over the letters of its arcs, back over the cases.

#include <array>
#include <cstddef>
#include <string>

#include "automaton_certificate.hpp"
#include "operation.hpp"

namespace restrip::verify {

/// The largest fan that can be asked about: its recolouring, two triangles and the chord more, is one mask.
inline constexpr unsigned largest_asked = 16;

/// A fan operation's place. `family` is "split", "collapse", "open-split", "boundary-split" or "fan-collapse"; `a` is
/// the arc of a split or the first gap, `b` the second gap.
struct FanPlace {
  std::string family;
  unsigned k = 0;
  unsigned a = 0;
  unsigned b = 0;
  std::string text() const;
  bool closed() const { return family == "split" || family == "collapse"; }
};

/// The patch after the operation.
Patch patch_after(const FanPlace& place);

/// All places of valence k, those that notation.md leaves to symmetry included.
std::vector<FanPlace> all_places(unsigned k);

/// A recolouring, and what the certificate says it is worth.
struct AutomatonAnswer {
  Mask inner = 0;
  Worth worth;
};
AutomatonAnswer answer_of(const AutomatonCertificate& certificate, const FanPlace& place, Mask ports, Mask joined);

}  // namespace restrip::verify
