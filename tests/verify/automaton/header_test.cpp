// Claim: the compiled automaton is the certificate. Every number of the header that a look-up can come to is compared
// with the row that states it, read by the verifier's parser.
#include <gtest/gtest.h>

#include <string>

#include "automaton_certificate.hpp"
#include "input.hpp"
#include "restrip/tables/automaton.hpp"

namespace restrip::verify {
namespace {

/// A case of the certificate in the header's four bits.
unsigned coded(std::size_t number) {
  const auto reach = [](char c) { return static_cast<unsigned>(std::string("-ept").find(c)); };
  return 4 * reach(all_cases[number].left) + reach(all_cases[number].right);
}

TEST(AutomatonHeader, IsTheCertificate) {
  const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/automaton.cert";
  const AutomatonCertificate certificate = parse_automaton(file, read_file(file));
  const auto& header = tables::automaton;
  const std::size_t n = certificate.classes.size();
  ASSERT_EQ(header.classes, n);
  std::size_t meetings = 0;
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t letter = 0; letter < 4; ++letter) {
      const auto& step = certificate.classes[c].steps[letter];
      ASSERT_EQ(header.next[4 * c + letter], step ? step->to : no_arc_class);
      for (std::size_t k = 0; step && k < all_cases.size(); ++k)
        if (certificate.classes[step->to].values[k]) {
          ASSERT_EQ(header.before[4 * c + letter] >> 4 * coded(k) & 15U, coded(step->from[k])) << c << ' ' << letter;
        }
    }
    if (!certificate.can_be_first(c)) continue;
    ASSERT_EQ(header.closed[c], coded(certificate.closings[c]->arc));
    for (std::size_t y = 1; y < n; ++y, ++meetings) {
      const AutomatonMeeting& stated = certificate.meetings[c][y].value();
      ASSERT_EQ(header.meetings[header.meet[header.seconds * header.first[c] + header.second[y]]],
                coded(stated.first) | coded(stated.second) << 4U | (stated.chord ? 256U : 0U));
    }
  }
  EXPECT_GT(meetings, n);
}

}  // namespace
}  // namespace restrip::verify
