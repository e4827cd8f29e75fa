// Compares the answers of a certificate in whole fans with an independent search, and with the rules of the tables.
#pragma once

#include <cstdint>

#include "automaton/answers.hpp"
#include "certificate/certificate.hpp"
#include "judge/report.hpp"
#include "model/operation.hpp"

namespace restrip::verify {

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
