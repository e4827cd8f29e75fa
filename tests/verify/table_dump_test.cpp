// A dump of compiled tables is accepted when it equals the certificates in every line, and at no other time. In the
// positions without a certificate the answers accepted are just those that a naive search calls sound and optimal.

#include "table_dump.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "dump_judge.hpp"
#include "input.hpp"
#include "naive_tables.hpp"

namespace restrip::verify {
namespace {

/// Answers as a certificate would give them: any will do here.
std::vector<Answer> some_answers(const Operation& operation) {
  std::vector<Answer> answers(mask_count(operation.before.inner_edges() + operation.before.ports()));
  for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = i % 3 == 0 ? not_valid : static_cast<Answer>(i % 2);
  return answers;
}

/// The configurations of an operation as the naive method sees it, and what it says of each.
class NaiveAnswers {
 public:
  explicit NaiveAnswers(const Operation& operation) : operation_(operation) {
    std::istringstream words(operation.position);
    std::vector<int> numbers;
    for (std::string word; words >> word;)
      if (word.front() >= '0' && word.front() <= '9') numbers.push_back(std::stoi(word));
    naive_ = test::naive_operation(operation.family, numbers);
    for (Mask both = 0; both < mask_count(operation.before.inner_edges() + operation.before.ports()); ++both)
      best_.push_back(best_of(both));
  }
  /// The answers that are right: several where several are optimal, `not_valid` alone where nothing is to be answered.
  const std::vector<Answer>& right(std::size_t both) const { return best_[both]; }
  std::vector<Answer> answers() const {
    std::vector<Answer> all;
    for (const std::vector<Answer>& right : best_) all.push_back(right.front());
    return all;
  }

 private:
  std::vector<Answer> best_of(Mask both) const {
    const test::NaiveColors before{static_cast<int>(high_part(both, operation_.before.ports())),
                                   static_cast<int>(low_part(both, operation_.before.ports()))};
    if (!test::anatomy(naive_.before, before)) return {not_valid};
    const std::vector<test::Candidate> sound = test::sound_recolorings(naive_, before);
    std::vector<Answer> best;
    for (const test::Candidate& one : sound)
      if (std::all_of(sound.begin(), sound.end(), [&](const test::Candidate& c) { return c.merit <= one.merit; }))
        best.push_back(static_cast<Answer>(one.colors.inner));
    return best;
  }

  const Operation& operation_;
  test::NaiveOperation naive_;
  std::vector<std::vector<Answer>> best_;
};

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
    const std::size_t listed = operations.size();
    for (const Family& family : families)
      for (const Operation& operation : family.unlisted) {
        operations.push_back(&operation);
        answers.push_back(NaiveAnswers(operation).answers());
      }
    for (std::size_t i = 0; i < operations.size(); ++i)
      if (i < listed)
        expected.tables.push_back({operations[i], Against::certificate, &answers[i]});
      else
        expected.tables.push_back({operations[i], Against::own_patch, nullptr});
    for (const LinkedFamily& family : linked)
      for (const Section& section : family.local.sections)
        expected.lists.push_back({family.name, section.position, section.ports, &lists});
  }

  std::string dump() const {
    std::string text = "restrip-table-dump 2\n";
    std::size_t entries = 0;
    for (std::size_t i = 0; i < operations.size(); ++i) {
      const Operation& operation = *operations[i];
      text += fmt::format("table {}\n", operation.name());
      for (Mask both = 0; both < answers[i].size(); ++both, ++entries) {
        const Answer answer = answers[i][both];
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
      text += fmt::format("table {} {}\n{}\n", table.family, table.position, fmt::join(lists, "\n"));
      entries += lists.size();
    }
    return text + fmt::format("end {}\n", entries);
  }
};

DumpComparison comparison_of(const Tables& tables, std::string text) {
  std::FILE* stream = fmemopen(text.data(), text.size(), "r");
  DumpComparison comparison = compare_dump(stream, tables.expected);
  std::fclose(stream);
  return comparison;
}

/// The first difference, or what is wrong with the form; empty when the dump agrees.
std::string difference(const Tables& tables, const std::string& text) {
  const DumpComparison comparison = comparison_of(tables, text);
  if (comparison.agrees()) return {};
  for (const auto* all : {&comparison.tables, &comparison.lists})
    for (const Compared& compared : *all)
      if (compared.differences.count != 0) return compared.differences.first;
  return comparison.fault;
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

TEST(TableDump, CountsWhatItComparedAndNothingElse) {
  Tables tables;
  const DumpComparison whole = comparison_of(tables, tables.dump());
  EXPECT_EQ(whole.of(Against::certificate).sum().entries + whole.of(Against::own_patch).sum().entries +
                whole.of_lists(Against::certificate).sum().entries,
            whole.lines);
  EXPECT_EQ(whole.of(Against::own_patch).families.at("split").positions, 1U);  // k 3 a 2
  EXPECT_EQ(whole.of(Against::own_patch).families.at("split").entries, 64U);
  EXPECT_TRUE(whole.of(Against::nothing).families.empty());
  // A table that is read but not compared may say anything, and is counted as such.
  const auto split = std::find_if(tables.expected.tables.begin(), tables.expected.tables.end(),
                                  [](const auto& table) { return table.operation->name() == "split k 3 a 1"; });
  ASSERT_NE(split, tables.expected.tables.end());
  *split = {split->operation, Against::nothing, nullptr};
  const std::string altered =
      replaced(tables.dump(), "table split k 3 a 1\n0 0 -\n0 1 1\n", "table split k 3 a 1\n0 0 3f\n0 1 0\n");
  EXPECT_EQ(difference(tables, altered), "");
  const DumpComparison part = comparison_of(tables, altered);
  EXPECT_EQ(part.of(Against::nothing).families.at("split").entries, 64U);
  EXPECT_EQ(part.of(Against::nothing).sum().positions, 1U);
  EXPECT_EQ(part.of(Against::certificate).sum().entries + 64, whole.of(Against::certificate).sum().entries);
  EXPECT_EQ(part.of(Against::certificate).families.count("split"), 0U);
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

TEST(TableDump, WhereNoCertificateIsTheRightAnswersAreAccepted) {
  std::size_t tried = 0;
  for (const Family& family : all_families(3))
    for (const Operation& operation : family.unlisted) {
      const NaiveAnswers naive(operation);
      const std::vector<Answer> good = naive.answers();
      EXPECT_FALSE(wrong_answer(operation, good)) << operation.name();
      if (operation.before.ports() > 2 && operation.family != "split") continue;
      for (std::size_t both = 0; both < good.size(); ++both) {
        std::vector<Answer> altered = good;
        for (Mask answer = 0; answer <= mask_count(operation.after.inner_edges()); ++answer, ++tried) {
          altered[both] = answer == mask_count(operation.after.inner_edges()) ? not_valid : static_cast<Answer>(answer);
          const std::vector<Answer>& right = naive.right(both);
          const bool is_right = std::find(right.begin(), right.end(), altered[both]) != right.end();
          const std::optional<WrongAnswer> wrong = wrong_answer(operation, altered);
          ASSERT_EQ(!wrong, is_right) << operation.name() << ", configuration " << both << ", answer " << answer;
          if (wrong) {
            ASSERT_EQ(wrong->configuration, both);
          }
        }
      }
    }
  EXPECT_GT(tried, 4000U);
}

TEST(TableDump, WrongAnswersWhereNoCertificateIsAreNamed) {
  const Tables tables;
  const std::string good = tables.dump();
  const std::string found =
      difference(tables, replaced(good, "table split k 3 a 2\n0 0 ", "table split k 3 a 2\n0 0 3"));
  EXPECT_NE(found.find("table split k 3 a 2, inner 0, ports 0, answer 3"), std::string::npos) << found;
  EXPECT_NE(difference(tables, replaced(good, "table split k 3 a 2\n0 0 ", "table split k 3 a 2\n0 0 g")), "");
  EXPECT_NE(difference(tables, replaced(good, "table split k 3 a 2\n0 0 ", "table split k 3 a 2\n0 0 0")), "");
  EXPECT_NE(difference(tables, replaced(good, "table split k 3 a 2\n0 0 ", "table split k 3 a 2\n0 0 fffff")), "");
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
  EXPECT_NE(difference(tables, replaced(good, "dump 2", "dump 1")), "");
  EXPECT_NE(difference(tables, replaced(good, "table flip", "table flop")), "");
  EXPECT_NE(difference(tables, replaced(good, "table collapse k 3 a 1", "table split k 3 a 1")), "");
  EXPECT_NE(difference(tables, replaced(good, "end ", "end 1")), "");
}

TEST(TableDump, ALineWithoutEndIsRefused) {
  const Tables tables;
  EXPECT_NE(difference(tables, "restrip-table-dump 2\n" + std::string(1U << 19U, '1')).find("the limit"),
            std::string::npos);
  EXPECT_NE(compare_dump_of("cat /dev/zero", tables.expected).fault.find("the limit"), std::string::npos);
}

TEST(Input, WithoutEndIsRefused) {
  const auto complaint = [](const auto& read) {
    try {
      read();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(
      complaint([] { (void)read_file("/dev/zero"); }).find("/dev/zero: is larger than 268435456 bytes, the limit"),
      std::string::npos);
  LineReader lines("f", "a b\n" + std::string(1U << 17U, 'c') + "\n");
  lines.next("two words");
  EXPECT_NE(
      complaint([&] { lines.next("a word"); }).find("f:2: expected a word, found a line of more than 65536 bytes"),
      std::string::npos);
}

TEST(TableDump, AFailingProgramIsNoticed) {
  const Tables tables;
  EXPECT_NE(compare_dump_of("false", tables.expected).fault, "");
  EXPECT_FALSE(compare_dump_of("false", tables.expected).agrees());
}

}  // namespace
}  // namespace restrip::verify
