// The answer of a certificate to a key of a fan: forwards over the letters of its arcs, back over the cases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "automaton/arcs_around.hpp"
#include "automaton/automaton_certificate.hpp"
#include "model/family.hpp"
#include "model/key.hpp"

namespace restrip::verify {

/// The place of a fan operation. `family` is "split", "collapse", "open-split", "boundary-split" or "fan-collapse"; `a`
/// is the arc of a split or the first gap, `b` the second gap.
struct FanPlace {
  std::string family;
  unsigned k = 0;
  unsigned a = 0;
  unsigned b = 0;
  std::string text() const;
  bool closed() const { return family == "split" || family == "collapse"; }
};

/// All places of valence k, including the places that notation.md leaves to symmetry.
std::vector<FanPlace> all_places(unsigned k);

/// What a rule knows of a fan's ports, bit i for port i.
struct FanKey {
  Mask ports = 0;
  Mask joined = 0;  ///< to the solid port before it; with two in a closed fan both bits or none
  std::string text() const;
};

/// The number n in base 3, a digit for each port, the last one the lowest: 1 solid, 2 also joined.
FanKey written_key(unsigned k, std::uint64_t n);
/// The key as the look-up sees it, without unused bits. `joined` counts at solid ports, in an open fan not at the
/// first, and with exactly two in a closed fan either bit stands for both.
FanKey seen_key(FanKey key, const FanPlace& place);

/// A recolouring, and its cost according to the certificate, minus the restarts of all triangles of the patch.
struct AutomatonAnswer {
  Mask inner = 0;
  int cost = 0;
};

/// Answers from one certificate.
class AutomatonReader {
 public:
  explicit AutomatonReader(const AutomatonCertificate& certificate) : certificate_(certificate) {}
  AutomatonAnswer answer(const FanPlace& place, const FanKey& key) const;

 private:
  const AutomatonCertificate& certificate_;
  ArcWays ways_;
};

}  // namespace restrip::verify
