// Compares the answers of a certificate in whole fans with an independent search, and with the rules of the tables.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "automaton/arc.hpp"
#include "automaton/automaton_certificate.hpp"
#include "certificate/certificate.hpp"
#include "judge/report.hpp"
#include "model/description.hpp"
#include "model/masks.hpp"
#include "model/operation.hpp"

namespace restrip::verify {

// The answer of a certificate to a key of a fan: forwards over the letters of its arcs, back over the cases.

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

/// Numbers of compared and of wrong answers.
struct FanCheck {
  std::uint64_t places = 0;
  std::uint64_t keys = 0;
  std::uint64_t same = 0;  ///< with rules: answers with exactly the recolouring of the rule
  Failures failures;
};

/// For every key of every place of valence k, of all families: the answer must be sound, have the stated cost, and no
/// sound recolouring may cost less. Keys are all pairs of masks in which `joined` has only solid ports with a
/// predecessor; with exactly two solid ports in a closed fan it has both bits or none. `every` = n checks the first
/// place and every n-th after it.
FanCheck check_against_search(const AutomatonCertificate& certificate, unsigned k, unsigned every = 1);

/// Compares with the rows of a family's certificate: the answer must have the same numbers of solid edges and isolated
/// triangles.
FanCheck check_against_rows(const AutomatonCertificate& certificate, const Family& family, const Certificate& rows);

}  // namespace restrip::verify
