#pragma once
// What the index automaton's certificate answers to a key of a fan: forwards over the letters of its arcs, the best way
// to put their cases together, back over the cases.

#include <string>

#include "answers.hpp"
#include "turn_certificate.hpp"
#include "turn_parts.hpp"

namespace restrip::verify {

/// What a rule is told of a fan's ports, bit i for port i.
struct TurnKey {
  Mask ports = 0;
  Mask joined = 0;  ///< to the solid port before it; with two in a closed fan both bits or none
  Mask left = 0;    ///< solid, and behind it the strip goes on about the corner of the port at the left link
  Mask right = 0;   ///< the same at the right link
  std::string text() const;
};

struct TurnAnswer {
  Mask inner = 0;
  int cost = 0;  ///< less the restarts of all triangles of the patch
};

/// Asks one certificate.
class TurnReader {
 public:
  explicit TurnReader(const TurnCertificate& certificate) : certificate_(certificate), ways_(certificate.weights) {}
  TurnAnswer answer(const FanPlace& place, const TurnKey& key) const;

 private:
  class Walk;
  struct Part;

  TurnAnswer split(const FanPlace& place, const TurnKey& key) const;
  TurnAnswer open_split(const FanPlace& place, const TurnKey& key) const;
  TurnAnswer boundary_split(const FanPlace& place, const TurnKey& key) const;
  TurnAnswer collapse(const FanPlace& place, const TurnKey& key) const;
  TurnAnswer fan_collapse(const FanPlace& place, const TurnKey& key) const;

  const TurnCertificate& certificate_;
  TurnWays ways_;
};

}  // namespace restrip::verify
