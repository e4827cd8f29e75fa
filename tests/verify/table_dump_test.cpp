// A dump of compiled tables is accepted when it equals the certificates in every line, and at no other time.

#include "table_dump.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>

namespace restrip::verify {
namespace {

/// Answers as a certificate would give them: any will do here.
std::vector<Answer> some_answers(const Operation& operation) {
  std::vector<Answer> answers(mask_count(operation.before.inner_edges() + operation.before.ports()));
  for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = i % 3 == 0 ? not_valid : static_cast<Answer>(i % 2);
  return answers;
}

struct Tables {
  std::vector<Family> families = all_families(3);
  std::vector<const Operation*> operations;
  std::vector<std::vector<Answer>> answers;
  std::vector<LinkedFamily> linked = linked_families(3);
  std::vector<std::string> lists = {"0 2d 76543210", "1 2d 76543210",
                                    "2 17 76543210", "3 3a 76543201 15 76543210",
                                    "4 1 76543210",  "5 2d 76543012 16 76543210",
                                    "6 2 76543210",  "7 0 76543210"};
  ExpectedDump expected;

  Tables() {
    for (const Family& family : families)
      for (const Section& section : family.sections)
        for (const Operation& operation : section.operations) operations.push_back(&operation);
    for (const Operation* operation : operations) answers.push_back(some_answers(*operation));
    for (std::size_t i = 0; i < operations.size(); ++i) expected.tables.push_back({operations[i], &answers[i]});
    for (const LinkedFamily& family : linked)
      for (const Section& section : family.local.sections)
        expected.lists.push_back({family.name + ' ' + section.position, section.ports, &lists});
  }

  std::string dump() const {
    std::string text = "restrip-table-dump 1\n";
    std::size_t entries = 0;
    for (const ExpectedTable& table : expected.tables) {
      const Operation& operation = *table.operation;
      text += fmt::format("table {}\n", operation.name());
      for (Mask both = 0; both < table.answers->size(); ++both, ++entries) {
        const Answer answer = (*table.answers)[both];
        text += fmt::format("{:x} {:x} ", high_part(both, operation.before.ports()),
                            low_part(both, operation.before.ports()));
        if (answer == not_valid)
          text += "-\n";
        else if (operation.gives_ports_up)
          text += fmt::format("{:x} {:x}\n", low_part(answer, 1), high_part(answer, 1));
        else
          text += fmt::format("{:x}\n", answer);
      }
    }
    for (const ExpectedLists& table : expected.lists) {
      text += fmt::format("table {}\n{}\n", table.name, fmt::join(lists, "\n"));
      entries += lists.size();
    }
    return text + fmt::format("end {}\n", entries);
  }
};

std::string difference(const Tables& tables, std::string text) {
  std::FILE* stream = fmemopen(text.data(), text.size(), "r");
  const DumpComparison comparison = compare_dump(stream, tables.expected);
  std::fclose(stream);
  return comparison.difference;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), with);
}

TEST(TableDump, EqualTablesAreAccepted) {
  const Tables tables;
  EXPECT_EQ(difference(tables, tables.dump()), "");
}

TEST(TableDump, EveryAlteredLineIsNoticed) {
  const Tables tables;
  const std::string good = tables.dump();
  const std::size_t end = good.find("table collapse");
  for (std::size_t newline = good.find('\n'); newline < end; newline = good.find('\n', newline + 1)) {
    std::string bad = good;
    bad[newline - 1] = bad[newline - 1] == '1' ? '0' : '1';
    EXPECT_NE(difference(tables, bad), "") << newline;
  }
}

TEST(TableDump, EveryAlteredListIsNoticed) {
  Tables tables;
  const std::string good = tables.dump();
  for (const std::string& line : tables.lists)
    for (const char digit : {'0', '9'}) {
      std::string bad = line;
      bad.back() = digit;
      if (bad != line) {
        EXPECT_NE(difference(tables, replaced(good, line + '\n', bad + '\n')), "") << line;
      }
      EXPECT_NE(difference(tables, replaced(good, line + '\n', line + " 0 76543210\n")), "") << line;
      EXPECT_NE(difference(tables, replaced(good, line + '\n', "")), "") << line;
    }
  EXPECT_NE(difference(tables, replaced(good, "table linked-collapse k 3", "table linked-split k 3 a 1")), "");
  // A table that is read but not compared may say anything, in the right order.
  tables.expected.lists.front().lines = nullptr;
  EXPECT_EQ(difference(tables, replaced(good, "0 2d 76543210", "0 1 12")), "");
  EXPECT_NE(difference(tables, replaced(good, "1 2d 76543210", "2 2d 76543210")), "");
}

TEST(TableDump, FormIsChecked) {
  const Tables tables;
  const std::string good = tables.dump();
  EXPECT_NE(difference(tables, ""), "");
  EXPECT_NE(difference(tables, good.substr(0, good.size() - 1)), "");
  EXPECT_NE(difference(tables, good.substr(0, good.size() / 2)), "");
  EXPECT_NE(difference(tables, good + "more\n"), "");
  EXPECT_NE(difference(tables, good + "more"), "");
  EXPECT_NE(difference(tables, replaced(good, "dump 1", "dump 2")), "");
  EXPECT_NE(difference(tables, replaced(good, "table flip", "table flop")), "");
  EXPECT_NE(difference(tables, replaced(good, "table collapse k 3 a 1", "table split k 3 a 1")), "");
  EXPECT_NE(difference(tables, replaced(good, "end ", "end 1")), "");
}

TEST(TableDump, AFailingProgramIsNoticed) {
  const Tables tables;
  EXPECT_NE(compare_dump_of("false", tables.expected).difference, "");
}

}  // namespace
}  // namespace restrip::verify
