// Claim: in the automaton of fewest strips, fewer strips come first in fans of any valence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "automaton/automaton_certificate.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

// A cost is strips and isolated triangles in one number. They can be separated, in the certificate and in sums of a few
// of its numbers: every cost differs from whole strips by a few isolated triangles only.
TEST(AutomatonCosts, IsolatedTrianglesNeverOutweighAStrip) {
  const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/automaton.cert";
  const AutomatonCertificate certificate = parse_automaton(file, read_file(file));
  std::size_t compared = 0;
  const auto expect_few = [&](int cost) {
    ++compared;
    const int rest = std::abs(cost) % strip_cost;
    EXPECT_LE(std::min(rest, strip_cost - rest), 3) << cost;
  };
  for (const AutomatonClass& c : certificate.classes) {
    for (const auto& cost : c.costs)
      if (cost) expect_few(*cost);
    for (const auto& step : c.steps)
      if (step) expect_few(step->cost);
  }
  EXPECT_GT(compared, 1000U);
}

}  // namespace
}  // namespace restrip::verify
