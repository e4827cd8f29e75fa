// Claim: the compiled automaton is the certificate. Every number of the header that a look-up can come to is compared
// with the row that states it, read by the verifier's parser. Compiled with the shipped header, and with that of a cost
// in which swaps have a price.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "automaton/automaton_certificate.hpp"
#include "model/input.hpp"
#include "restrip/tables/automaton.hpp"

namespace restrip::verify {
namespace {

AutomatonCertificate certificate_of_header() {
  const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/automaton.cert";
  return parse_automaton(file, read_file(file));
}

/// A case of a class in the header's four bits, as automaton_format.hpp says.
unsigned coded(const AutomatonClass& c, std::size_t number) {
  const Case wanted = case_at(number);
  if (!tables::automaton.tells_turns) {
    const auto reach = [](char r) { return static_cast<unsigned>(std::string("-ept").find(r)); };
    return 4 * reach(wanted.left) + reach(wanted.right);
  }
  unsigned place = wanted.right == '-' ? 0 : 8;
  for (std::size_t k = 0; k < number; ++k)
    if (c.costs[k] && (case_at(k).right == '-') == (wanted.right == '-')) ++place;
  return place;
}

TEST(AutomatonHeader, IsTheCertificate) {
  const AutomatonCertificate certificate = certificate_of_header();
  const auto& header = tables::automaton;
  const std::size_t n = certificate.classes.size();
  ASSERT_EQ(header.classes, n);
  ASSERT_EQ(header.letters, letters_of(certificate.weights).size());
  std::size_t meetings = 0;
  for (std::size_t c = 0; c < n; ++c) {
    const AutomatonClass& stated = certificate.classes[c];
    for (std::size_t letter = 0; letter < header.letters; ++letter) {
      const auto& step = stated.steps[letter];
      ASSERT_EQ(header.next[header.letters * c + letter], step ? step->to : header.no_class);
      for (std::size_t k = 0; step && k < case_count; ++k)
        if (const AutomatonClass& to = certificate.classes[step->to]; to.costs[k]) {
          ASSERT_EQ(header.before[header.letters * c + letter] >> 4 * coded(to, k) & 15U, coded(stated, step->from[k]))
              << c << ' ' << letter;
        }
    }
    if (const auto& closing = certificate.closings[c]) {
      ASSERT_EQ(header.closed[c], coded(stated, closing->arc));
    }
    if (!stated.as_first) continue;
    for (std::size_t y = 1; y < n; ++y, ++meetings) {
      const AutomatonMeeting& met = certificate.meeting(c, y);
      ASSERT_EQ(header.meetings[header.meet[header.seconds * header.first[c] + header.second[y]]],
                coded(stated, met.first) | coded(certificate.classes[y], met.second) << 4U | (met.chord ? 256U : 0U));
    }
  }
  EXPECT_GT(meetings, n);
}

// Costs of fewest strips are strips and isolated triangles in one number. They can be told apart, in the certificate
// and in sums of a few of its numbers: no cost is further from whole strips than a few isolated triangles. So fewer
// strips come first, in fans of any valence.
TEST(AutomatonHeader, IsolatedTrianglesNeverOutweighAStrip) {
  const AutomatonCertificate certificate = certificate_of_header();
  if (certificate.weights.tells_turns()) GTEST_SKIP() << "another cost";
  ASSERT_EQ(certificate.weights, strips_weights);
  std::size_t compared = 0;
  const auto expect_few = [&](int cost) {
    ++compared;
    const int rest = std::abs(cost) % strips_weights.restart;
    EXPECT_LE(std::min(rest, strips_weights.restart - rest), 3) << cost;
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
