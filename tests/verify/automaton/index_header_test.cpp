// Claim: the compiled index automaton is its certificate, number by number, read by the verifier's parser; and no
// automaton of the same cost has fewer classes: any two are told apart by what some other arc makes of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input.hpp"
#include "restrip/tables/index_automaton.hpp"
#include "turn_certificate.hpp"
#include "turn_parts.hpp"

namespace restrip::verify {
namespace {

TurnCertificate shipped_index_automaton() {
  const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/index-automaton.cert";
  return parse_turn_automaton(file, read_file(file));
}

/// The cases of a class, ascending.
std::vector<std::size_t> cases_of(const TurnClass& c) {
  std::vector<std::size_t> cases;
  for (std::size_t k = 0; k < turn_cases; ++k)
    if (c.costs[k]) cases.push_back(k);
  return cases;
}

TEST(IndexHeader, IsTheCertificate) {
  const TurnCertificate certificate = shipped_index_automaton();
  const auto& header = tables::index_automaton;
  ASSERT_EQ(header.classes, certificate.classes.size());
  EXPECT_EQ(header.restart, certificate.weights.restart);
  EXPECT_EQ(header.swap, certificate.weights.swap);
  EXPECT_EQ(header.isolated, certificate.weights.isolated);
  std::size_t compared = 0;
  for (std::size_t c = 0; c < header.classes; ++c) {
    const TurnClass& stated = certificate.classes[c];
    const std::vector<std::size_t> cases = cases_of(stated);
    ASSERT_EQ(header.first[c + 1] - header.first[c], static_cast<int>(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i, ++compared) {
      ASSERT_EQ(header.cases[header.first[c] + i], cases[i]);
      ASSERT_EQ(header.costs[header.first[c] + i], stated.costs[cases[i]].value());
    }
    for (std::size_t letter = 0; letter < turn_letters.size(); ++letter) {
      const TurnStep& step = stated.steps[letter];
      const std::size_t entry = turn_letters.size() * c + letter;
      ASSERT_EQ(header.next[entry], step.to);
      const std::size_t move = header.move[entry];
      ASSERT_EQ(header.move_costs[move], step.cost);
      const std::vector<std::size_t> after = cases_of(certificate.classes[step.to]);
      for (std::size_t i = 0; i < after.size(); ++i, ++compared) {
        const std::size_t place = header.origins[move] >> 4 * i & 15U;
        ASSERT_EQ(cases.at(place), step.from[after[i]]);
        ASSERT_EQ((header.links[move] >> i & 1U) != 0, turn_case(step.from[after[i]]).right != '-');
      }
    }
  }
  EXPECT_GT(compared, 15000U);
}

/// What an arc of one class costs beside an arc of another, for each set of pairs that may be joined.
std::vector<int> beside(const TurnWays& ways, const TurnClass& x, const TurnClass& y) {
  constexpr int none = 1000;
  std::vector<int> least(pair_sets, none);
  for (std::size_t one = 0; one < turn_cases; ++one)
    for (std::size_t other = 0; x.costs[one] && other < turn_cases; ++other)
      for (const bool chord : {false, true}) {
        const TurnWay& way = ways.around(one, other, chord);
        if (!y.costs[other] || !way.legal) continue;
        for (Mask allowed = 0; allowed < pair_sets; ++allowed)
          if (is_subset(way.joined, allowed))
            least[allowed] = std::min(least[allowed], *x.costs[one] + *y.costs[other] + way.cost);
      }
  return least;
}

TEST(IndexHeader, NoTwoClassesAreTheSameToAllOthers) {
  const TurnCertificate certificate = shipped_index_automaton();
  const TurnWays ways(certificate.weights);
  const std::size_t n = certificate.classes.size();
  // Moore's algorithm, from what a class costs beside each of some others, up to a constant.
  std::vector<std::size_t> block(n, 0);
  std::map<std::vector<int>, std::size_t> sights;
  for (std::size_t c = 1; c < n; ++c) {
    std::vector<int> sight;
    for (std::size_t other = 1; other < n; other += 3) {
      const std::vector<int> least = beside(ways, certificate.classes[c], certificate.classes[other]);
      sight.insert(sight.end(), least.begin(), least.end());
    }
    const int base = sight[0];
    for (int& cost : sight) cost -= base;
    block[c] = sights.emplace(sight, sights.size() + 1).first->second;
  }
  for (std::size_t blocks = sights.size() + 1;;) {
    std::map<std::vector<std::size_t>, std::size_t> numbers;
    std::vector<std::size_t> finer(n);
    for (std::size_t c = 0; c < n; ++c) {
      std::vector<std::size_t> sight{block[c]};
      for (const TurnStep& step : certificate.classes[c].steps) sight.push_back(block[step.to]);
      finer[c] = numbers.emplace(sight, numbers.size()).first->second;
    }
    block = finer;
    if (numbers.size() == blocks) break;
    blocks = numbers.size();
  }
  EXPECT_EQ(1 + *std::max_element(block.begin(), block.end()), n);
}

}  // namespace
}  // namespace restrip::verify
