#pragma once
// The answers of a certificate in whole fans: against a search of their own, and against the rules of the tables.

#include <cstdint>

#include "automaton/answers.hpp"
#include "certificate/certificate.hpp"
#include "judge/report.hpp"
#include "model/operation.hpp"

namespace restrip::verify {

/// Answers compared, and those that were wrong.
struct FanCheck {
  std::uint64_t places = 0;
  std::uint64_t keys = 0;
  std::uint64_t same = 0;  ///< with rules: those that are the very recolouring of the rule
  Failures failures;
};

/// Every key of every place of valence k, of all families: the answer must be sound, cost what it says, and no sound
/// recolouring may cost less. Keys are all pairs of masks in which `joined` has only solid ports that have a
/// predecessor; with exactly two solid ports in a closed fan it has both bits or none. `every` = n looks at the first
/// place and every n-th after it.
FanCheck check_against_search(const AutomatonCertificate& certificate, unsigned k, unsigned every = 1);

/// The rows of a family's certificate: the answer must have as many solid edges and isolated triangles as the row has.
FanCheck check_against_rows(const AutomatonCertificate& certificate, const Family& family, const Certificate& rows);

}  // namespace restrip::verify
