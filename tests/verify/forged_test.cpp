// Forged certificates and dumps of operations are refused, each for its own fault.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "corpus.hpp"
#include "model/input.hpp"
#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

/// An operation of the corpus with its good certificate and dump, to be altered; or the shipped `merge`, whose
/// certificate has reasons.
struct Forgery {
  std::string path;
  std::string certificate;
  std::optional<NaiveSection> section;
  NaiveTable table;
  std::string dump;

  explicit Forgery(const std::string& name) : path(corpus_path(name)) {
    if (name == "merge") {
      path = RESTRIP_TABLES_DIR "/operations/merge.json";
      certificate = read_file(RESTRIP_TABLES_DIR "/certificates/operations/merge.cert");
      return;
    }
    section = naive_section(corpus_operation(name));
    table = naive_table(name, *section, false).value();
    certificate = certificate_text(name, {table});
    dump = dump_text(naive(), table);
  }
  const NaiveOperation& naive() const { return section->operations.front(); }
};

const Forgery& forgery_of(const char* name) {
  static std::map<std::string, Forgery> known;
  return known.try_emplace(name, name).first->second;
}

void expect_refused(const Verdict& found, const std::string& crime) {
  EXPECT_EQ(found.exit_code, 1) << crime << '\n' << found.text;
  EXPECT_TRUE(found.says(crime)) << "expected: " << crime << "\nfound: " << found.text;
}

/// With the number of its rows and the right sums in the last line.
std::string sealed(const std::string& certificate) {
  std::istringstream lines(certificate.substr(0, certificate.rfind("end ")));
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);)
    rows += line.starts_with("rule ") || line.starts_with("copy ") ? 1U : 0U;
  return with_end(lines.str(), rows);
}

TEST(ForgedCertificate, IsRefusedForItsCrime) {
  for (const Alteration& alteration : alterations("certificates.txt")) {
    const Forgery& good = forgery_of(alteration.of.c_str());
    expect_refused(verdict_on(good.path, sealed(alteration.in(good.certificate)), {}), alteration.says);
  }
  EXPECT_EQ(verdict_on(forgery_of("merge").path, forgery_of("merge").certificate, {}).exit_code, 0);
}

// For each criterion, a sound recolouring that is equal in all earlier criteria and worse in this one.
TEST(ForgedCertificate, RowsThatAreWorseByOneCriterion) {
  const Forgery& bisect = forgery_of("bisect-costs");
  const std::vector<std::string> criteria = {"strips + -1 joined", "2 isolated + given_up",
                                             "-1 squares + ends_at_port(0,3)",
                                             "neighbouring_ends + -1 solid(1) + 3 ends(0,1,2,3)"};
  std::vector<int> tried(criteria.size());
  for_each_valid(*bisect.section, [&](const NaiveOperation& naive, NaiveColors configuration) {
    const std::vector<NaiveCandidate> sound = naive.sound(configuration);
    const std::vector<long> best = std::min_element(sound.begin(), sound.end(), [](const auto& a, const auto& b) {
                                     return a.cost < b.cost;
                                   })->cost;
    for (const NaiveCandidate& candidate : sound) {
      const auto worse = std::mismatch(best.begin(), best.end(), candidate.cost.begin());
      if (worse.first == best.end()) continue;
      const auto criterion = static_cast<std::size_t>(worse.first - best.begin());
      if (++tried[criterion] > 6) continue;
      NaiveTable forged = bisect.table;
      forged.rows.at(naive.key(configuration)).after = candidate.after;
      expect_refused(
          verdict_on(bisect.path, certificate_text("bisect-costs", {forged}), {}),
          fmt::format("not best: {} is {}, and may be {}\n", criteria[criterion], *worse.second, *worse.first));
    }
  });
  for (const int count : tried) EXPECT_GT(count, 0);
}

TEST(ForgedCertificate, EveryClaimThatIsWrong) {
  std::size_t tried = 0;
  for (const char* const name : {"bisect-costs", "merge-face-matching"}) {
    const Forgery& good = forgery_of(name);
    for (std::size_t i = 0; i < good.table.claims.size(); ++i)
      for (const long by : {-1, 1}) {
        NaiveTable forged = good.table;
        const auto& [word, number] = good.table.claims[i];
        forged.claims[i].second += by;
        expect_refused(verdict_on(good.path, certificate_text(name, {forged}), {}),
                       fmt::format("\"claim {} {}\"\n  wrong claim: recounted {}\n", word, number + by, number));
        ++tried;
      }
  }
  EXPECT_EQ(tried, 32U);
}

// Reasons prove nothing if another criterion than strips comes first.
TEST(ForgedCertificate, WhoseRulesCannotHaveReasons) {
  const Forgery& good = forgery_of("merge-face-matching");
  NaiveTable table = good.table;
  for (auto& [key, row] : table.rows)
    if (row.by.empty()) row.because = "-";
  const Verdict found = verdict_on(good.path, certificate_text("merge-face-matching", {table}), {});
  EXPECT_EQ(found.exit_code, 2);
  EXPECT_TRUE(found.says("reasons require strips whose cost")) << found.text;
}

TEST(ForgedCertificate, WithoutItsEnd) {
  const Forgery& split = forgery_of("split-face-own");
  for (std::size_t length = 0; length < split.certificate.size(); ++length)
    EXPECT_EQ(verdict_on(split.path, split.certificate.substr(0, length), {}).exit_code, 2) << length;
}

TEST(ForgedDump, IsRefusedForItsCrime) {
  for (const Alteration& alteration : alterations("dumps.txt")) {
    const Forgery& good = forgery_of(alteration.of.c_str());
    expect_refused(verdict_on(good.path, {}, alteration.in(good.dump)), alteration.says);
  }
  const Forgery& bisect = forgery_of("bisect-costs");
  for (std::size_t length = 0; length < bisect.dump.size(); length += 7)
    EXPECT_EQ(verdict_on(bisect.path, {}, bisect.dump.substr(0, length)).exit_code, 1) << length;
  EXPECT_EQ(verdict_on(bisect.path, {}, bisect.dump).exit_code, 0);
}

// An answer as good as the certificate's row is right by itself, but differs from the certificate.
TEST(ForgedDump, OtherThanTheCertificate) {
  const Forgery& split = forgery_of("split-face-own");
  const std::string other = Alteration{"split-face-own", "0 2 5 2", "0 2 6 2", {}}.in(split.dump);
  EXPECT_EQ(verdict_on(split.path, {}, other).exit_code, 0);
  const Verdict found = verdict_on(split.path, split.certificate, other);
  EXPECT_EQ(found.crimes.size(), 1U);
  expect_refused(
      found,
      "line 5, table split-face-own, inner 0, ports 2: the table answers \"6 2\", the certificate has \"copy 2 0 "
      "5 2 by 1 0 2\" in line 14");
}

}  // namespace
}  // namespace restrip::verify::test
