// A dump of compiled tables is accepted if and only if it equals the certificates in every line. In positions without a
// certificate, the accepted answers are exactly those that a naive search finds sound and optimal.

#include "judge/table_dump.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "../support/refusal_of.hpp"
#include "corpus.hpp"
#include "model/input.hpp"
#include "naive_tables.hpp"

namespace restrip::verify::test {
namespace {

NaiveOperation naive_at(const Operation& operation) {
  return NaiveOperation(operation_by_hand(operation.family, operation.numbers));
}

/// The right answers by the naive method: several if several are optimal, none if no answer is allowed.
std::vector<NaiveColors> right_answers(const NaiveOperation& naive, NaiveColors before) {
  std::vector<NaiveColors> best;
  if (!naive.valid(false, before)) return best;
  const std::vector<NaiveCandidate> sound = naive.sound(before);
  for (const NaiveCandidate& one : sound)
    if (std::all_of(sound.begin(), sound.end(), [&](const auto& other) { return one.cost <= other.cost; }))
      best.push_back(one.after);
  return best;
}

/// The first right answer to each configuration.
std::string right_table(const Operation& operation) {
  const NaiveOperation naive = naive_at(operation);
  const auto first = [&](NaiveColors before) -> std::optional<NaiveColors> {
    const std::vector<NaiveColors> right = right_answers(naive, before);
    return right.empty() ? std::nullopt : std::optional(right.front());
  };
  return table_text(naive, first, true);
}

struct Tables {
  std::vector<Family> families = all_families(3);
  std::vector<Certificate> certificates;
  ExpectedDump expected;
  std::vector<std::string> texts;

  Tables() {
    certificates.reserve(families.size());
    for (const NaiveFamily& naive : naive_families(3)) {
      const Family& family = families[certificates.size()];
      std::vector<NaiveTable> tables;
      for (const NaiveSection& section : naive.sections) {
        tables.push_back(naive_table(family.name, section, true).value());
        for (const NaiveOperation& operation : section.operations)
          texts.push_back(table_text(operation, answers_of(operation, tables.back()), true));
      }
      certificates.push_back(parse_certificate("c", certificate_text(family.name, tables), family));
      for (std::size_t s = 0; s < family.sections.size(); ++s)
        for (const Operation& operation : family.sections[s].operations)
          expected.tables.push_back({&operation, Against::certificate, &certificates.back().sections[s]});
    }
    for (const Family& family : families)
      for (const Operation& operation : family.unlisted) {
        expected.tables.push_back({&operation, Against::own_patch, nullptr});
        texts.push_back(right_table(operation));
      }
  }

  std::string dump() const { return dump_text(texts); }
};

DumpComparison comparison_of(const ExpectedDump& expected, std::string text) {
  std::FILE* stream = fmemopen(text.data(), text.size(), "r");
  DumpComparison comparison = compare_dump(stream, expected);
  std::fclose(stream);
  return comparison;
}

/// The first difference, or the fault of form; empty if the dump agrees.
std::string difference(const Tables& tables, const std::string& text) {
  const DumpComparison comparison = comparison_of(tables.expected, text);
  if (comparison.agrees()) return {};
  for (const Compared& compared : comparison.tables)
    for (const Failures* found : {&compared.differences, &compared.wrong})
      if (found->count != 0) return found->first;
  return comparison.misstated.count != 0 ? comparison.misstated.first : comparison.fault;
}

TEST(TableDump, EqualTablesAreAccepted) {
  const Tables tables;
  EXPECT_EQ(difference(tables, tables.dump()), "");
}

TEST(TableDump, CountsWhatItComparedAndNothingElse) {
  Tables tables;
  const DumpComparison whole = comparison_of(tables.expected, tables.dump());
  EXPECT_EQ(
      sum_of(whole.of(Against::certificate).families).entries + sum_of(whole.of(Against::own_patch).families).entries,
      whole.lines);
  EXPECT_EQ(whole.of(Against::own_patch).families.at("split").positions, 1U);  // k 3 a 2
  EXPECT_EQ(whole.of(Against::own_patch).families.at("split").entries, 64U);
  EXPECT_TRUE(whole.of(Against::nothing).families.empty());
  // A table that is read but not compared may have any content, and is counted as such.
  const auto split = std::find_if(tables.expected.tables.begin(), tables.expected.tables.end(),
                                  [](const auto& table) { return table.operation->name() == "split k 3 a 1"; });
  ASSERT_NE(split, tables.expected.tables.end());
  *split = {split->operation, Against::nothing, nullptr};
  std::string altered = tables.dump();
  const std::size_t first = altered.find("table split k 3 a 1\n0 0 ") + 24;
  altered.replace(first, altered.find('\n', first) - first, "3f 0 9 -9");
  EXPECT_EQ(difference(tables, altered), "");
  const DumpComparison part = comparison_of(tables.expected, altered);
  EXPECT_EQ(part.of(Against::nothing).families.at("split").entries, 64U);
  EXPECT_EQ(sum_of(part.of(Against::nothing).families).positions, 1U);
  EXPECT_EQ(sum_of(part.of(Against::certificate).families).entries + 64,
            sum_of(whole.of(Against::certificate).families).entries);
  EXPECT_EQ(part.of(Against::certificate).families.count("split"), 0U);
}

TEST(TableDump, EveryAlteredLineIsNoticed) {
  const Tables tables;
  const std::string good = tables.dump();
  const std::size_t end = good.find("table open-split");
  ASSERT_NE(end, std::string::npos);
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
      const NaiveOperation naive = naive_at(operation);
      ExpectedDump expected;
      expected.tables.push_back({&operation, Against::own_patch, nullptr});
      const auto wrong = [&](const std::string& table) {
        const DumpComparison comparison = comparison_of(expected, dump_text({table}));
        EXPECT_EQ(comparison.fault, "");
        return comparison.of(Against::own_patch).wrong.count;
      };
      EXPECT_EQ(wrong(right_table(operation)), 0U) << operation.name();
      // Every answer to every configuration, all configurations at once; finally none.
      const auto answers = static_cast<int>(mask_count(operation.after.inner_edges()));
      for (int inner = 0; inner <= answers; ++inner) {
        std::uint64_t bad = 0;
        const auto altered = [&](NaiveColors before) -> std::optional<NaiveColors> {
          ++tried;
          const NaiveColors other{inner, before.ports};
          const std::vector<NaiveColors> right = right_answers(naive, before);
          const bool is_right =
              inner < answers ? std::find(right.begin(), right.end(), other) != right.end() : right.empty();
          bad += is_right ? 0U : 1U;
          return inner < answers ? std::optional(other) : std::nullopt;
        };
        const std::string table = table_text(naive, altered, true);
        EXPECT_EQ(wrong(table), bad) << operation.name() << ", answer " << inner;
      }
    }
  EXPECT_GT(tried, 4000U);
}

TEST(TableDump, OneAlterationIsNamed) {
  const Tables tables;
  const std::string good = tables.dump();
  for (const Alteration& alteration : alterations("tables_dump.txt")) {
    const std::string found = difference(tables, alteration.in(good));
    EXPECT_NE(found.find(alteration.says), std::string::npos)
        << "expected: " << alteration.says << "\nfound: " << found;
  }
}

TEST(TableDump, FormIsChecked) {
  const Tables tables;
  const std::string good = tables.dump();
  EXPECT_NE(difference(tables, ""), "");
  EXPECT_NE(difference(tables, good.substr(0, good.size() - 1)), "");
  EXPECT_NE(difference(tables, good.substr(0, good.size() / 2)), "");
  EXPECT_NE(difference(tables, good + "more\n"), "");
  EXPECT_NE(difference(tables, good + "more"), "");
  const DumpComparison failed = compare_dump_of("false", tables.expected);
  EXPECT_NE(failed.fault, "");
  EXPECT_FALSE(failed.agrees());
}

TEST(TableDump, ALineWithoutEndIsRefused) {
  const Tables tables;
  EXPECT_NE(difference(tables, "restrip-table-dump 4\n" + std::string(1U << 19U, '1')).find("the limit"),
            std::string::npos);
  EXPECT_NE(compare_dump_of("cat /dev/zero", tables.expected).fault.find("the limit"), std::string::npos);
}

TEST(Input, ALineWithoutEndIsRefused) {
  LineReader lines("f", "a b\n" + std::string(1U << 17U, 'c') + "\n");
  lines.next("two words");
  EXPECT_NE(
      refusal_of([&] { lines.next("a word"); }).find("f:2: expected a word, found a line of more than 65536 bytes"),
      std::string::npos);
}

}  // namespace
}  // namespace restrip::verify::test
