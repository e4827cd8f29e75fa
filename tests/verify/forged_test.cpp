// Forged certificates and dumps of operations are refused, each for its own crime.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

/// An operation of the corpus with its good certificate, to be altered.
struct Forgery {
  std::string name;
  NaiveSection section = naive_section(corpus_operation(name));
  const NaiveOperation& naive = section.operations.front();
  NaiveTable good = naive_table(name, section, false).value();

  explicit Forgery(std::string of) : name(std::move(of)) {}

  static NaiveRow& row(NaiveTable& table, int ports, int joined) { return table.rows.at({ports, joined}); }
  std::string good_text() const { return certificate_text(name, {good}); }

  Verdict verdict(const std::string& certificate) const { return verdict_on(corpus_path(name), certificate, {}); }
  void expect_refused(const std::function<void(NaiveTable&)>& forge, int exit_code, const std::string& sentence) const {
    NaiveTable forged = good;
    forge(forged);
    expect_refused_text(certificate_text(name, {forged}), exit_code, sentence);
  }
  void expect_refused_text(const std::string& text, int exit_code, const std::string& sentence) const {
    const Verdict found = verdict(text);
    EXPECT_EQ(found.exit_code, exit_code) << sentence << '\n' << found.text;
    EXPECT_TRUE(found.says(sentence)) << "expected: " << sentence << "\nfound: " << found.text;
  }
};

/// The text with one line replaced, or taken out when the new one is empty, and right sums.
std::string with_line(const std::string& text, const std::string& line, const std::string& replacement,
                      std::size_t rows) {
  std::string above = text.substr(0, text.rfind("end "));
  const std::size_t place = above.find(line + '\n');
  EXPECT_NE(place, std::string::npos) << line;
  above.replace(place, line.size() + 1, replacement.empty() ? "" : replacement + '\n');
  return with_end(above, rows);
}

TEST(ForgedCertificate, RowsMissingOrExtra) {
  const Forgery split("split-face");
  split.expect_refused([](auto& forged) { forged.rows.erase(std::next(forged.rows.begin(), 3)); }, 1,
                       "no row for the key 3 1 of\n    1 triangle without edges, ports 0\" 1\" 2:");
  split.expect_refused(
      [](auto& forged) {
        forged.rows[{7, 7}] = {{0, 7}, {}, {}};
      },
      1, ":19: \"rule 7 7 0 7\"\n  section split-face: extra row: no valid configuration has this key");
}

TEST(ForgedCertificate, UnsoundRows) {
  const Forgery split("split-face");
  split.expect_refused([](auto& forged) { Forgery::row(forged, 1, 0).after.inner = 5; }, 1,
                       "unsound: triangle 0 has 3 solid edges after");
  split.expect_refused([](auto& forged) { Forgery::row(forged, 0, 0).after.inner = 7; }, 1,
                       "unsound: solid inner edges close a cycle after");
  const Forgery bisect("bisect-costs");
  bisect.expect_refused(
      [](auto& forged) { Forgery::row(forged, 5, 0).after.inner = 3; }, 1,
      "    before  edges 0-1, ports 0\" 1: 2\" 3:\n    after   edges 0=1 1=2 2-3 3-0, ports 0\" 1: 2\" 3:\n"
      "  unsound: with ports 0-2 connected outside, there is no solid cycle before, but one after");
  const Forgery flip("flip-forest");
  flip.expect_refused(
      [](auto& forged) {
        Forgery::row(forged, 7, 1).after = {1, 7};
      },
      1, "unsound: with ports 0-2 connected outside, there is no solid cycle before, but one after");
  const Forgery matching("bisect-boundary-matching");
  matching.expect_refused([](auto& forged) { Forgery::row(forged, 1, 0).after.inner = 1; }, 1,
                          "unsound: triangle 0 has 2 solid edges after");
}

// For each criterion a sound recolouring that is as good in all before it and worse in this one.
TEST(ForgedCertificate, RowsThatAreWorseByOneCriterion) {
  const Forgery bisect("bisect-costs");
  const std::vector<std::string> criteria = {"strips + -1 joined", "2 isolated + given_up",
                                             "-1 squares + ends_at_port(0,3)",
                                             "neighbouring_ends + -1 solid(1) + 3 ends(0,1,2,3)"};
  std::vector<int> tried(criteria.size());
  for (const NaiveColors& configuration : bisect.naive.configurations()) {
    if (!bisect.naive.valid(false, configuration)) continue;
    const int joined = bisect.naive.key(configuration).second;
    const std::vector<NaiveCandidate> sound = bisect.naive.sound(configuration);
    const std::vector<long> best = std::min_element(sound.begin(), sound.end(), [](const auto& a, const auto& b) {
                                     return a.cost < b.cost;
                                   })->cost;
    for (const NaiveCandidate& candidate : sound) {
      const auto worse = std::mismatch(best.begin(), best.end(), candidate.cost.begin());
      if (worse.first == best.end()) continue;
      const auto criterion = static_cast<std::size_t>(worse.first - best.begin());
      if (++tried[criterion] > 6) continue;
      bisect.expect_refused(
          [&](auto& forged) { Forgery::row(forged, configuration.ports, joined).after = candidate.after; }, 1,
          fmt::format("not best: {} is {}, and may be {}\n", criteria[criterion], *worse.second, *worse.first));
    }
  }
  for (const int count : tried) EXPECT_GT(count, 0);
}

TEST(ForgedCertificate, PortsGivenUpOrTaken) {
  Forgery("merge-face")
      .expect_refused([](auto& forged) { Forgery::row(forged, 1, 0).after.ports = 0; }, 1,
                      "not best: strips is 1, and may be 0");
  const Forgery bisect("bisect-costs");
  bisect.expect_refused([](auto& forged) { Forgery::row(forged, 2, 0).after.ports = 0; }, 1,
                        "port 1 is given up and may not be");
  bisect.expect_refused([](auto& forged) { Forgery::row(forged, 1, 0).after.ports = 5; }, 1,
                        "port 2 was dashed and becomes solid");
}

TEST(ForgedCertificate, CopiesThatFollowFromNoRule) {
  const Forgery bisect("bisect-costs");
  bisect.expect_refused(
      [](auto& forged) {
        Forgery::row(forged, 4, 0).by = {2, 1, 0, 3};
      },
      1, "wrong witness: no symmetry moves the ports so");
  // A symmetry of the triangles, but ports 0 and 1 differ in what may be given up.
  bisect.expect_refused(
      [](auto& forged) {
        Forgery::row(forged, 4, 0).by = {1, 0, 3, 2};
      },
      1, "wrong witness: no symmetry moves the ports so");
  bisect.expect_refused(
      [](auto& forged) {
        Forgery::row(forged, 4, 0).by = {0, 1, 2, 3};
      },
      1, "wrong witness: it takes the key to 4 0, which has no rule row");
  // Giving up the other port is as good, but not the image of what the rule does.
  Forgery("merge-face")
      .expect_refused([](auto& forged) { Forgery::row(forged, 5, 0).after.ports = 4; }, 1,
                      "wrong witness: no symmetry that moves the ports so takes the recolouring to");
  const Forgery split("split-face");
  // As good a recolouring, but not the image of the rule's.
  split.expect_refused([](auto& forged) { Forgery::row(forged, 2, 0).after.inner = 6; }, 1,
                       "wrong witness: no symmetry that moves the ports so takes the recolouring to that of line 13");
  split.expect_refused([](auto& forged) { Forgery::row(forged, 2, 0).by.clear(); }, 1,
                       "wrong representative: 1 0 is a smaller key of this orbit, so the row must be a copy");
  split.expect_refused(
      [](auto& forged) {
        Forgery::row(forged, 1, 0).by = {0, 1, 2};
      },
      1, "wrong representative: the smallest key of its orbit must be a rule, not a copy");
}

TEST(ForgedCertificate, EveryClaimThatIsWrong) {
  std::size_t tried = 0;
  for (const char* name : {"bisect-costs", "merge-face-matching"}) {
    const Forgery forgery(name);
    for (std::size_t i = 0; i < forgery.good.claims.size(); ++i)
      for (const long by : {-1, 1}) {
        const auto& [word, number] = forgery.good.claims[i];
        forgery.expect_refused(
            [&](auto& forged) { forged.claims[i].second += by; }, 1,
            fmt::format("\"claim {} {}\"\n  wrong claim: recounted {}\n", word, number + by, number));
        ++tried;
      }
  }
  EXPECT_EQ(tried, 32U);
}

TEST(ForgedCertificate, Form) {
  const Forgery split("split-face");
  const std::string good = split.good_text();
  const auto expect = [&](const std::string& line, const std::string& replacement, std::size_t rows,
                          const std::string& sentence) {
    split.expect_refused_text(with_line(good, line, replacement, rows), 2, sentence);
  };
  expect("operation split-face", "operation merge-face", 7,
         ":2: expected \"operation split-face\", found \"operation merge-face\"");
  expect("restrip-certificate 3", "restrip-certificate 4", 7, ":1: expected \"restrip-certificate 3\"");
  expect("section split-face", "section merge-face", 7, ":3: expected \"section split-face\"");
  expect("claim valid 7", "", 7, ":5: claim valid missing: expected \"claim valid\" number, found \"claim orbits 4\"");
  expect("claim valid 7", "claim valid 7\nclaim valid 7", 7,
         ":6: claim orbits missing: expected \"claim orbits\" number");
  expect("claim worst-isolated 0", "claim worst-isolated 00", 7, "expected a decimal number without leading zeros");
  expect("rule 1 0 3 1", "rule 1 0 3 1\nrule 1 0 3 1", 8, "duplicate row: the key 1 0 already has a row in line 13");
  expect("rule 0 0 3 0", "rule 7 0 3 0", 7, "expected rows in ascending order of (P, J)");
  expect("rule 0 0 3 0", "rule 0 0 8 0", 7, "expected a mask of at most 3 bits, found \"8\"");
  expect("rule 0 0 3 0", "rule 0 8 3 0", 7, "expected a mask of at most 3 bits, found \"8\"");
  expect("rule 0 0 3 0", "rule 0 0 03 0", 7, "mask without leading zeros, found \"03\"");
  expect("rule 0 0 3 0", "rule 0 0 3", 7,
         "expected \"rule\" and 4 masks, or behind them \"because\" and a reason, found \"rule 0 0 3\"");
  expect("rule 0 0 3 0", "rules 0 0 3 0", 7, "expected \"rule\" or \"copy\", found \"rules 0 0 3 0\"");
  expect("copy 2 0 5 2 by 1 0 2", "copy 2 0 5 2 by 1 1 2", 7, "expected each port from 0 to 2 once, found \"1 1 2\"");
  expect("copy 2 0 5 2 by 1 0 2", "copy 2 0 5 2 by 1 0 3", 7, "expected each port from 0 to 2 once");
  expect("copy 2 0 5 2 by 1 0 2", "copy 2 0 5 2 by 1 0", 7, "expected \"copy\", 4 masks, \"by\" and 3 ports");
  expect("copy 2 0 5 2 by 1 0 2", "copy 2 0 5 2 as 1 0 2", 7, "expected \"by\", found \"as\"");
  expect("rule 1 0 3 1", "rule 1 0 3 1", 8, "expected \"end 7\", the number of rows of this file");
  std::string altered = good;
  altered[good.find("rule 1 0 3 1") + 9] = '1';
  split.expect_refused_text(altered, 2, ":13: byte 10 of this line was altered");
  std::string other_sums = good;
  other_sums.insert(other_sums.size() - 1, "0");
  split.expect_refused_text(other_sums, 2, "the sums of the bytes above");
  split.expect_refused_text(good + "more\n", 2, "expected the end of the file after \"end\"");
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_EQ(split.verdict(good.substr(0, length)).exit_code, 2) << length;
}

/// Dumps of `bisect-costs` and of an operation on matchings.
struct ForgedDump {
  Forgery forgery;
  std::string good = dump_text(forgery.naive, forgery.good);

  explicit ForgedDump(const std::string& name) : forgery(name) {}

  Verdict verdict(const std::string& dump, bool with_certificate = false) const {
    return verdict_on(corpus_path(forgery.name), with_certificate ? std::optional(forgery.good_text()) : std::nullopt,
                      dump);
  }
  /// With something else for the beginning of a line. What it tells behind it stays, unless nothing is answered any
  /// more.
  std::string replaced(const std::string& line, const std::string& replacement) const {
    const std::size_t place = std::min(good.find('\n' + line + ' '), good.find('\n' + line + '\n')) + 1;
    EXPECT_NE(place, 0U) << line << '\n' << good;
    const std::size_t end = good.find('\n', place);
    std::string told = good.substr(place + line.size(), end + 1 - place - line.size());
    if (replacement.ends_with('-')) told = "\n";
    return good.substr(0, place) + (replacement.empty() ? "" : replacement + told) + good.substr(end + 1);
  }
  void expect_refused(const std::string& line, const std::string& replacement, const std::string& sentence) const {
    const Verdict found = verdict(replaced(line, replacement));
    EXPECT_EQ(found.exit_code, 1) << sentence;
    EXPECT_TRUE(found.says(sentence)) << "expected: " << sentence << "\nfound: " << found.text;
  }
};

TEST(ForgedDump, WrongAnswers) {
  const ForgedDump bisect("bisect-costs");
  bisect.expect_refused("0 0 7 0", "0 0 6 0", "line 3, table bisect-costs, inner 0, ports 0: \n");
  bisect.expect_refused("0 0 7 0", "0 0 6 0", "not best: strips + -1 joined is 2, and may be 1");
  bisect.expect_refused("0 5 a 5", "0 5 3 5", "unsound: with ports 0-2 connected outside");
  bisect.expect_refused("0 2 e 2", "0 2 e 0", "port 1 is given up and may not be");
  bisect.expect_refused("0 1 7 1", "0 1 7 5", "port 2 was dashed and becomes solid");
  bisect.expect_refused("0 0 7 0", "0 0 -", "no answer to a valid configuration");
  bisect.expect_refused("1 3 -", "1 3 e 3 0", "an answer to a configuration that is not valid: triangle 0 has 3 solid");
  bisect.expect_refused("0 1 7 1 -1", "0 1 7 1 1", "the table tells +1 strips, there are ");
  ForgedDump("merge-face").expect_refused("7 0 -", "7 0 0 0 0", "not valid: solid inner edges close a cycle");
  ForgedDump("merge-face-matching").expect_refused("0 1 0 1", "0 1 0 0", "not best: isolated + given_up is 2");
}

TEST(ForgedDump, Form) {
  const ForgedDump bisect("bisect-costs");
  bisect.expect_refused("table bisect-costs", "table split-face", "line 2: \"table split-face\" is no table");
  bisect.expect_refused(
      "0 1 7 1", "",
      "expected \"0 1 \" and \"-\" or two masks, 4 and 4 bits at most, and the change in strips, found \"0 2 e 2 ");
  bisect.expect_refused("0 1 7 1", "0 1 7", "expected \"0 1 \" and \"-\" or two masks, 4 and 4 bits at most");
  bisect.expect_refused("0 1 7 1", "0 1 17 1", "two masks, 4 and 4 bits at most");
  bisect.expect_refused("0 1 7 1", "0 1 7  1", "two masks, 4 and 4 bits at most");
  bisect.expect_refused("0 1 7 1", "0 1 7 1 -1 0", "and the change in strips, found");
  bisect.expect_refused("0 1 7 1", "0 1 7 1 ", "two masks, 4 and 4 bits at most");
  bisect.expect_refused("0 1 7 1", "0 1 07 1", "two masks, 4 and 4 bits at most");
  bisect.expect_refused("end 32", "end 31", "expected \"end 32\", found \"end 31\"");
  bisect.expect_refused("end 32", "end 32\nend 32", "text after the end");
  bisect.expect_refused("end 32", "", "expected \"end 32\", found the end");
  for (std::size_t length = 0; length < bisect.good.size(); length += 7)
    EXPECT_EQ(bisect.verdict(bisect.good.substr(0, length)).exit_code, 1) << length;
  EXPECT_EQ(bisect.verdict(bisect.good).exit_code, 0);
}

// An answer that is as good as the certificate's row is right by itself, but not beside the certificate.
TEST(ForgedDump, OtherThanTheCertificate) {
  const ForgedDump split("split-face");
  const std::string other = split.replaced("0 2 5 2", "0 2 6 2");
  EXPECT_EQ(split.verdict(other).exit_code, 0) << split.verdict(other).text;
  const Verdict found = split.verdict(other, true);
  EXPECT_EQ(found.exit_code, 1);
  EXPECT_EQ(found.crimes.size(), 1U);
  EXPECT_TRUE(found.says(
      "line 5, table split-face, inner 0, ports 2: the table answers \"6 2\", the certificate has \"copy 2 0 5 2 by "
      "1 0 2\" in line 14"))
      << found.text;
}

}  // namespace
}  // namespace restrip::verify::test
