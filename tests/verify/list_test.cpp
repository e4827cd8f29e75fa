// Lists of linked rules: the checker finds the same faults, claim by claim, as the naive method; and every alteration
// of a shipped alternative by one edge is noticed.

#include <gtest/gtest.h>

#include <iostream>

#include "linked/linked_check.hpp"
#include "model/input.hpp"
#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

TEST(Lists, GoodOnesHold) {
  const std::vector<NaiveFamily> families = naive_families(corpus_max_k);
  for (const NaiveLinked& linked : naive_linked(families)) {
    EXPECT_EQ(linked.crimes(linked.good()), Crimes{});
    const Verdict verdict = verdict_of(linked.good());
    EXPECT_EQ(verdict.exit_code, 0) << verdict.text;
  }
}

TEST(Lists, EveryCrimeIsCounted) {
  const std::vector<NaiveFamily> families = naive_families(corpus_max_k);
  Crimes seen;
  int innocent = 0;
  for (const NaiveLinked& linked : naive_linked(families))
    for_each_doubtful(linked, [&](const DoubtfulLists& doubtful) {
      const Crimes crimes = linked.crimes(doubtful.lists);
      const Verdict verdict = verdict_of(doubtful.lists);
      EXPECT_EQ(verdict.crimes, crimes) << doubtful.damage << "\n" << verdict.text;
      for (const auto& crime : crimes) ++seen[crime.first];
      innocent += crimes.empty() ? 1 : 0;
      return !testing::Test::HasFailure();
    });
  for (const auto& [claim, count] : seen) std::cout << count << " x not: " << claim << '\n';
  std::cout << innocent << " as good as before\n";
  EXPECT_EQ(seen.size(), 7U);
}

TEST(Lists, EveryFlippedEdgeOfTheShippedOnesIsNoticed) {
  std::uint64_t flips = 0;
  std::uint64_t survivors = 0;
  for (const LinkedFamily& family : linked_families()) {
    const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/" + family.name + ".cert";
    const LinkedCertificate certificate = parse_linked_certificate(file, read_file(file), family);
    for (std::size_t i = 0; i < certificate.sections.size(); ++i) {
      const Section& section = family.local.sections[i];
      const Side& after = section.operations.front().after;
      for (Mask ports = 0; ports < mask_count(section.ports); ++ports) {
        const List good = certificate.sections[i].list(ports);
        const std::vector<Recoloring> recolorings = recolorings_of(after, ports);
        for (std::size_t row = 0; row < good.size(); ++row)
          for (unsigned bit = 0; bit < after.inner_edges(); ++bit) {
            std::vector<Alternative> bad(good.begin(), good.end());
            bad[row].inner ^= single(bit);
            ListFailures failures;
            check_list(after, recolorings, ports, bad, file, failures);
            ++flips;
            if (failures.present.count + failures.legal.count + failures.ordered.count + failures.uncovered.count +
                    failures.complete.count ==
                0)
              ++survivors;
          }
      }
    }
  }
  std::cout << flips << " flips\n";
  EXPECT_GT(flips, 0U);
  // An alternative with one edge more or less is never as good, so no alteration may pass.
  EXPECT_EQ(survivors, 0U);
}

}  // namespace
}  // namespace restrip::verify::test
