// Lists of linked rules: the checker finds the same faults, claim by claim, as the naive method; and every alteration
// of a shipped alternative by one edge is noticed.

#include <fmt/format.h>
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

// Rows left out, exchanged, repeated, replaced; wrong claims.
TEST(Lists, EveryCrimeIsCounted) {
  const std::vector<NaiveFamily> families = naive_families(corpus_max_k);
  Crimes seen;
  int innocent = 0;
  for (const NaiveLinked& linked : naive_linked(families)) {
    const NaiveLists good = linked.good();
    const auto compare = [&](const std::string& damage, const NaiveLists& lists) {
      if (testing::Test::HasFailure()) return;  // the first one is enough
      const Crimes crimes = linked.crimes(lists);
      const Verdict verdict = verdict_of(lists);
      EXPECT_EQ(verdict.crimes, crimes) << damage << ", " << good.family << ' ' << good.position << '\n'
                                        << verdict.text;
      for (const auto& crime : crimes) ++seen[crime.first];
      innocent += crimes.empty() ? 1 : 0;
    };
    for (const auto& entry : good.lists) {
      const auto ports = entry.first;
      const std::vector<int>& list = entry.second;
      const auto with_list = [&](const char* damage, const std::vector<int>& other) {
        NaiveLists bad = good;
        bad.lists[ports] = other;
        bad.count();
        compare(fmt::format("{}, ports {:x}", damage, ports), bad);
      };
      NaiveLists missing = good;
      missing.lists.erase(ports);
      missing.count();
      compare(fmt::format("list left out, ports {:x}", ports), missing);
      for (std::size_t i = 0; i < list.size(); ++i) {
        const auto place = static_cast<std::ptrdiff_t>(i);
        std::vector<int> other = list;
        other.erase(other.begin() + place);
        if (!other.empty()) with_list("row left out", other);
        other = list;
        other.insert(other.begin() + place, list[i]);
        with_list("row twice", other);
        other = list;
        if (i + 1 < list.size()) {
          std::swap(other[i], other[i + 1]);
          with_list("rows exchanged", other);
        }
        other = list;
        for (int inner = 0; inner < linked.recolorings(); ++inner) {
          // All recolourings of the smallest patch; for others, recolourings that differ in at most two edges.
          const int differing = __builtin_popcount(static_cast<unsigned>(inner ^ list[i]));
          if (differing == 0 || (differing > 2 && linked.recolorings() > 64)) continue;
          other[i] = inner;
          with_list("row replaced", other);
        }
      }
    }
    for (std::size_t i = 0; i < good.claims.size(); ++i)
      for (const int difference : {-1, 1}) {
        NaiveLists bad = good;
        bad.claims[i].second += difference;
        compare("claim " + bad.claims[i].first, bad);
      }
  }
  for (const auto& [claim, count] : seen) std::cout << count << " x not: " << claim << '\n';
  std::cout << innocent << " as good as before\n";
  EXPECT_EQ(seen.size(), 7U);
}

TEST(Lists, EveryFlippedEdgeOfTheShippedOnesIsNoticed) {
  std::uint64_t flips = 0;
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
            // An alternative with one edge more or less is never as good, so no alteration may pass.
            EXPECT_GT(failures.present.count + failures.legal.count + failures.ordered.count +
                          failures.uncovered.count + failures.complete.count,
                      0U)
                << file << ", ports " << ports << ", row " << row << ", edge " << bit;
          }
      }
    }
  }
  std::cout << flips << " flips\n";
  EXPECT_GT(flips, 0U);
}

}  // namespace
}  // namespace restrip::verify::test
