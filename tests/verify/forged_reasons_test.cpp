// Reasons of an operation's certificate that are none are refused, each for its own crime. The good ones are those of
// the shipped certificate of `merge`, where ports may be given up and reasons have up to four cases.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

std::string shipped(const std::string& path) {
  std::ifstream file(RESTRIP_TABLES_DIR "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class ForgedReason : public ::testing::Test {
 protected:
  /// Of the certificate with one row written otherwise, and right sums.
  static Verdict verdict(const std::string& row, const std::string& forged) {
    std::istringstream lines(shipped("certificates/operations/merge.cert"));
    std::string above;
    std::size_t rows = 0;
    bool found = row.empty();
    for (std::string line; std::getline(lines, line) && !line.starts_with("end ");) {
      rows += line.starts_with("rule ") || line.starts_with("copy ") ? 1U : 0U;
      found = found || line == row;
      above += (line == row ? forged : line) + '\n';
    }
    EXPECT_TRUE(found) << row;
    return verdict_on(RESTRIP_TABLES_DIR "/operations/merge.json", with_end(above, rows), {});
  }
  static void expect_refused(const std::string& row, const std::string& forged, int exit_code,
                             const std::string& sentence) {
    const Verdict found = verdict(row, forged);
    EXPECT_EQ(found.exit_code, exit_code) << found.text;
    EXPECT_TRUE(found.says(sentence)) << "expected: " << sentence << "\nfound: " << found.text;
  }
};

TEST_F(ForgedReason, TheGoodOnesHold) { EXPECT_EQ(verdict("", "").exit_code, 0) << verdict("", "").text; }

TEST_F(ForgedReason, ThatShowTooLittle) {
  // Giving a port up would do without a set: the case must show that something is dashed.
  expect_refused("rule 5 0 0 5 because b", "rule 5 0 0 5 because -", 1,
                 "wrong reason: a case shows 0 dashed, 0 isolated, 0 ports given up; the row has 1, 0, 0");
  expect_refused("rule 3 0 1 1 because if 1 then 4 else -", "rule 3 0 1 1 because 6", 1,
                 "wrong reason: a case shows 1 dashed, 0 isolated, 0 ports given up; the row has 1,");
  expect_refused("rule 7 0 0 5 because if 1 then 4 9 else d", "rule 7 0 0 5 because if 1 then 4 else d", 1,
                 "wrong reason: a case shows");
  // The case in which the edge is dashed, the other one being shown.
  expect_refused("rule 7 0 0 5 because if 1 then 4 9 else d", "rule 7 0 0 5 because if 1 then 4 9 else -", 1,
                 "wrong reason: a case shows 1 dashed");
}

TEST_F(ForgedReason, WhoseSetsAreNone) {
  // The inner edge with port 0 alone may be solid together.
  expect_refused("rule 5 0 0 5 because b", "rule 5 0 0 5 because 3", 1, "wrong reason: the set 3 may be all solid");
  expect_refused("rule 7 1 0 7 because 7", "rule 7 1 0 7 because 6", 1, "wrong reason: the set 6 may be all solid");
  expect_refused("rule 7 0 0 5 because if 1 then 4 9 else d", "rule 7 0 0 5 because if 1 then 4 d else d", 1,
                 "wrong reason: the set d has an edge that another set has or a case settles");
  expect_refused("rule 7 0 0 5 because if 1 then 4 9 else d", "rule 7 0 0 5 because if 1 then 6 9 else d", 1,
                 "wrong reason: the set 6 has an edge that another set has or a case settles");
  // Port 3 is dashed before.
  expect_refused("rule 7 1 0 7 because 7", "rule 7 1 0 7 because 17", 1,
                 "wrong reason: the set 17 has an edge that is no matter of choice");
  expect_refused("rule 7 1 0 7 because 7", "rule 7 1 0 7 because if 4 then 7 else 7", 1,
                 "wrong reason: edge 4 is no matter of choice");
}

TEST_F(ForgedReason, Form) {
  const std::string row = "rule 7 0 0 5 because if 1 then 4 9 else d";
  expect_refused(row, "rule 7 0 0 5", 2, "has a reason: expected the same of all");
  expect_refused(row, "rule 7 0 0 5 because", 2, "or behind them \"because\" and a reason");
  expect_refused(row, "rule 7 0 0 5 since 7", 2, "or behind them \"because\" and a reason");
  expect_refused(row, "rule 7 0 0 5 because if 1 then 4 9", 2, "expected \"else\", found \"the end of the line\"");
  expect_refused(row, "rule 7 0 0 5 because if 5 then 4 9 else d", 2, "expected an edge from 0 to 4, found 5");
  expect_refused(row, "rule 7 0 0 5 because if 1 then if 1 then 4 else 4 else d", 2,
                 "edge 1 makes cases of a case of its own");
  expect_refused(row, "rule 7 0 0 5 because - -", 2, "expected the end of the reason, found \"-\"");
  expect_refused(row, "rule 7 0 0 5 because 27", 2, "27");
}

// Reasons are of no use where something else than strips counts first.
TEST_F(ForgedReason, WhereThereCanBeNone) {
  const std::string name = "merge-face-matching";
  NaiveTable table = naive_table(name, naive_section(corpus_operation(name)), false).value();
  for (auto& [key, row] : table.rows)
    if (row.by.empty()) row.because = "-";
  const Verdict found = verdict_on(corpus_path(name), certificate_text(name, {table}), {});
  EXPECT_EQ(found.exit_code, 2);
  EXPECT_TRUE(found.says("reasons are for strips and forests")) << found.text;
}

}  // namespace
}  // namespace restrip::verify::test
