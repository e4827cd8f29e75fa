// Every single-bit flip of every shipped recolouring is noticed, for every configuration that the row serves. (A flip
// in a row's key leaves its old key without a row, which is noticed for every row in the corpus tests.)

#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "certificate/certificate.hpp"
#include "judge/rule_judge.hpp"
#include "model/input.hpp"

namespace restrip::verify {
namespace {

TEST(BitFlips, AllAreNoticed) {
  std::uint64_t flips = 0;
  std::uint64_t survivors = 0;
  std::map<unsigned, FitTable> tables;
  for (const Family& family : all_families()) {
    const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/" + family.name + ".cert";
    const Certificate certificate = parse_certificate(file, read_file(file), family);
    for (std::size_t i = 0; i < family.sections.size(); ++i)
      for (const Operation& operation : family.sections[i].operations) {
        RuleJudge judge(operation,
                        tables.try_emplace(operation.ports(), Constraint::strips, operation.ports()).first->second);
        // Those that fit the same worlds are judged together, so one of them stands for all.
        for (const ColoringClass& configurations : judge.before().classes()) {
          const Row* const row = certificate.sections[i].row_of(judge.key_of(configurations.first));
          ASSERT_NE(row, nullptr) << operation.name();
          const auto try_one = [&](Mask inner, Mask ports) {
            ++flips;
            const Colors flipped{row->after.inner ^ inner, row->after.ports ^ ports};
            if (judge.judged(configurations.first, flipped).verdict == Verdict::right) ++survivors;
          };
          for (unsigned edge = 0; edge < operation.after.inner_edges(); ++edge) try_one(single(edge), 0);
          for (unsigned port = 0; port < operation.ports(); ++port) try_one(0, single(port));
        }
      }
  }
  std::cout << flips << " flips\n";
  EXPECT_GT(flips, 0U);
  EXPECT_EQ(survivors, 0U);
}

}  // namespace
}  // namespace restrip::verify
