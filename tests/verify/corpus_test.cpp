// The checker accepts good tables, and rejects every bad one for the right reason.

#include "corpus.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "bad_tables.hpp"
#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

TEST(Corpus, GoodTablesHold) {
  for (const NaiveFamily& family : naive_families(corpus_max_k))
    for (const NaiveSection& section : family.sections) {
      const Verdict verdict = verdict_of(naive_table(family.name, section, true).value());
      EXPECT_EQ(verdict.exit_code, 0) << verdict.text;
    }
}

TEST(Corpus, SmallTablesHold) {
  const Verdict verdict = verdict_of(small_tables());
  EXPECT_EQ(verdict.exit_code, 0) << verdict.text;
}

// One table for each constraint and case; each must be rejected for its own fault.
TEST(Corpus, TargetedBadTablesAreRejected) {
  std::map<std::string, int> kinds;
  int failures = 0;
  for_each_bad_table(corpus_max_k, [&](const BadTable& bad) {
    ++kinds[bad.kind];
    const Verdict verdict = verdict_of(bad.table);
    EXPECT_EQ(verdict.exit_code, 1) << bad.crime;
    EXPECT_TRUE(verdict.says(bad.expected)) << bad.crime << ": expected " << bad.expected << "\n" << verdict.text;
    failures += testing::Test::HasFailure() ? 1 : 0;
    return failures < 5;
  });
  for (const char* kind :
       {"all cycles dropped", "outer cycle dropped", "chord cycles dropped", "degrees dropped", "new degrees dropped",
        "pairing dropped", "one edge short", "chord avoided", "all solid avoided", "lonelier"})
    EXPECT_GT(kinds[kind], 0) << kind;
  for (const auto& [kind, count] : kinds) std::cout << count << " x " << kind << '\n';
}

TEST(Corpus, DamagedFilesAreRejected) {
  const std::vector<Damage> all = damages();
  EXPECT_GE(all.size(), 106U);
  for (const Damage& damage : all) {
    const Verdict verdict = verdict_of(DamagedTables(damage).path());
    EXPECT_EQ(verdict.exit_code, damage.exit_code) << damage.name << "\n" << verdict.text;
    EXPECT_TRUE(verdict.says(damage.message)) << damage.name << ": expected \"" << damage.message << "\"\n"
                                              << verdict.text;
  }
}

}  // namespace
}  // namespace restrip::verify::test
