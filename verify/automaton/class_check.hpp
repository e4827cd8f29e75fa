// Checks the classes of a certificate against arcs by their definition, for arcs of any length
// (docs/explanation/automaton.md, "What is verified").
#pragma once

#include <cstdint>
#include <vector>

#include "automaton/automaton_certificate.hpp"
#include "judge/report.hpp"

namespace restrip::verify {

/// A claim of the certificate, with the number of tests and of failures.
struct AutomatonClaim {
  const char* claim = "";
  const char* method = "";
  std::uint64_t cases = 0;
  Failures failures;
};

struct ClassCheck {
  std::vector<AutomatonClaim> claims;
  std::size_t kinds = 0;  ///< of arcs, distinguished by the least cost of each case, by end ports and by class
};
ClassCheck check_classes(const AutomatonCertificate& certificate);

}  // namespace restrip::verify
