#pragma once
// What a certificate answers to a key of a fan: forwards over the letters of its arcs, back over the cases.

#include <cstdint>
#include <string>
#include <vector>

#include "automaton/arcs_around.hpp"
#include "automaton/automaton_certificate.hpp"
#include "model/family.hpp"
#include "model/key.hpp"

namespace restrip::verify {

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
Side patch_after(const FanPlace& place);

/// All places of valence k, those that notation.md leaves to symmetry included.
std::vector<FanPlace> all_places(unsigned k);

/// What a rule is told of a fan's ports, bit i for port i.
struct FanKey {
  Mask ports = 0;
  Mask joined = 0;  ///< to the solid port before it; with two in a closed fan both bits or none
  std::string text() const;
};

/// What a row of a table of fans is told: bit i of `joined` where port i is joined to the solid port before it.
FanKey fan_key(const Key& key, const FanPlace& place);

/// The number n to the base 3, a digit for each port, the last one the lowest: 1 solid, 2 joined as well.
FanKey written_key(unsigned k, std::uint64_t n);
/// The key as the look-up takes it: what is not looked at is taken away. `joined` counts at solid ports, in an open fan
/// not at the first, and with exactly two in a closed fan either bit stands for both.
FanKey seen_key(FanKey key, const FanPlace& place);

/// A recolouring, and what the certificate says it costs, less the restarts of all triangles of the patch.
struct AutomatonAnswer {
  Mask inner = 0;
  int cost = 0;
};

/// Asks one certificate.
class AutomatonReader {
 public:
  explicit AutomatonReader(const AutomatonCertificate& certificate) : certificate_(certificate) {}
  AutomatonAnswer answer(const FanPlace& place, const FanKey& key) const;

 private:
  class Walk;
  AutomatonAnswer two_arcs(const FanPlace& place, const FanKey& key) const;

  const AutomatonCertificate& certificate_;
  ArcWays ways_;
};

}  // namespace restrip::verify
