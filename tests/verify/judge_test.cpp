// The verifier of operations agrees with a naive method: on every recolouring of every configuration, and on whole
// certificates and dumps, for the operations of the corpus and for random ones.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <numeric>
#include <random>

#include "judge/operation_judge.hpp"
#include "judge/symmetry.hpp"
#include "model/description.hpp"
#include "verdict.hpp"

namespace restrip::verify::test {
namespace {

Colors colors_of(NaiveColors colors) { return {static_cast<Mask>(colors.inner), static_cast<Mask>(colors.ports)}; }

/// Checks every recolouring of every valid configuration; returns their number.
std::size_t expect_same_judgement(const Operation& operation) {
  const NaiveOperation naive(operation);
  const OperationJudge judge(operation);
  const Keys keys(operation);
  std::size_t compared = 0;
  for (const NaiveColors& configuration : naive.configurations()) {
    const bool valid = judge.definition()->valid(colors_of(configuration));
    const std::optional<Key> key = keys.key_of(colors_of(configuration));
    EXPECT_EQ(valid, naive.valid(false, configuration));
    EXPECT_EQ(valid, key.has_value());
    if (!valid) continue;
    const std::vector<NaiveCandidate> sound = naive.sound(configuration);
    std::vector<long> best;
    for (const NaiveCandidate& candidate : sound) best = best.empty() ? candidate.cost : std::min(best, candidate.cost);
    for (int inner = 0; inner < 1 << operation.after.edges.size(); ++inner)
      for (int kept = 0; kept < 1 << operation.ports(); ++kept, ++compared) {
        const NaiveColors after{inner, kept};
        const auto candidate =
            std::find_if(sound.begin(), sound.end(), [&](const NaiveCandidate& one) { return one.after == after; });
        const int lost = configuration.ports - kept;
        Judged expected;
        if ((configuration.ports & kept) != kept || (lost & static_cast<int>(operation.may_give_up)) != lost)
          expected.verdict = verify::Verdict::wrong_ports;
        else if (candidate == sound.end())
          expected.verdict = verify::Verdict::unsound;
        else if (candidate->cost != best)
          expected = {verify::Verdict::not_best,
                      static_cast<unsigned>(std::mismatch(best.begin(), best.end(), candidate->cost.begin()).first -
                                            best.begin())};
        const Judged found = judge.judged(colors_of(configuration), colors_of(after));
        // The locality lemma.
        if (found.verdict != verify::Verdict::wrong_ports) {
          EXPECT_EQ(keys.sound(*key, colors_of(after)), found.verdict != verify::Verdict::unsound);
        }
        if (found.verdict == expected.verdict && found.criterion == expected.criterion) continue;
        ADD_FAILURE() << operation.name() << ": " << judge.explained(colors_of(configuration), colors_of(after), found);
        return compared;
      }
  }
  return compared;
}

TEST(OperationJudge, AgreesWithANaiveMethodOnTheCorpus) {
  std::size_t compared = 0;
  for (const std::string& name : corpus_operations) compared += expect_same_judgement(corpus_operation(name));
  EXPECT_GT(compared, 5000U);
}

TEST(OperationJudge, GoodCertificatesAndDumpsHold) {
  for (const std::string& name : corpus_operations) {
    const NaiveSection section = naive_section(corpus_operation(name));
    const std::optional<NaiveTable> table = naive_table(name, section, false);
    ASSERT_TRUE(table) << name;
    const Verdict verdict =
        verdict_on(corpus_path(name), certificate_text(name, {*table}), dump_text(section.operations.front(), *table));
    EXPECT_EQ(verdict.exit_code, 0) << name << '\n' << verdict.text;
  }
}

// A custom family, with every position, including positions that share a section or have no rules. A vertex on the
// boundary goes with the triangle of the boundary edge that collapses.
TEST(OperationJudge, ACustomFamily) {
  const std::string name = "wedge";
  const std::string text = R"json({
    "restrip_operation": 1, "name": "wedge", "numbers": ["k", "i"], "where": "2 <= k, k <= 3, i <= k",
    "listed": "2 i <= k", "position": "k {k} at {i}", "give_up": "GIVE", "boundary": [["u[k]", "u[0]"]],
    "before": [["v", "u[j]", "u[j+1]", "j[0,i)"], ["v", "u[i]", "w"], ["w", "u[j]", "u[j+1]", "j[i,k)"]],
    "after": [["v", "u[j]", "u[j+1]", "j[0,k)"]]
  })json";
  for (const std::string give_up : {"none", "all"}) {
    std::string described = text;
    described.replace(described.find("GIVE"), 4, give_up);
    const Family family = families_of(parse_descriptions("f", described), 8).front();
    std::vector<NaiveTable> tables;
    std::vector<std::string> texts;
    const auto add = [&](const NaiveOperation& operation, const NaiveTable& table) {
      texts.push_back(table_text(operation, answers_of(operation, table), true));
    };
    for (const Section& one : family.sections) {
      NaiveSection naive{one.position, one.serves_every_position, {}};
      for (const Operation& operation : one.operations) naive.operations.emplace_back(operation);
      tables.push_back(naive_table(name, naive, true).value());
      for (const NaiveOperation& operation : naive.operations) add(operation, tables.back());
    }
    for (const Operation& operation : family.unlisted) {
      const NaiveSection naive{"", false, {NaiveOperation(operation)}};
      add(naive.operations.front(), naive_table(name, naive, false).value());
    }
    const std::string dump = dump_text(texts);
    const std::string certificate = certificate_text(name, tables);
    const Verdict good = verdict_on_text(described, certificate, dump);
    EXPECT_EQ(good.exit_code, 0) << give_up << '\n' << good.text;
    // One wrong row, and one wrong answer in a position that has no rules.
    std::vector<NaiveTable> worse = tables;
    worse.back().rows.at({0, 0}).after.inner = 0;
    EXPECT_TRUE(verdict_on_text(described, certificate_text(name, worse), {}).says("not best: strips is"));
    const std::size_t unlisted = dump.find("table wedge k 3 at 3\n0 0 ") + 25;
    std::string altered = dump;
    altered.replace(unlisted, dump.find('\n', unlisted) - unlisted, "0 0 -1");
    const Verdict bad = verdict_on_text(described, {}, altered);
    EXPECT_TRUE(bad.says("table wedge k 3 at 3, inner 0, ports 0: ")) << bad.text;
  }
}

// The four symmetries of a flip, except those excluded by the cost or by the ports that may be given up.
TEST(OperationJudge, SymmetriesLeaveTheCostAsItIs) {
  const auto symmetries = [](const std::string& cost, const std::string& give_up) {
    const Operation operation = parse_operation(
        "flip", fmt::format(R"({{"restrip_operation": 1, "name": "turn", "constraint": "strips", "cost": {},
 "before": [["a", "b", "c"], ["b", "a", "d"]], "after": [["c", "a", "d"], ["d", "b", "c"]], "give_up": {}}})",
                            cost, give_up));
    return Symmetries(operation, Symmetries::Keep::both_sides).order();
  };
  const std::string all = "\"all\"";
  EXPECT_EQ(symmetries(R"([[{"count": "strips"}]])", all), 4);
  EXPECT_EQ(symmetries(R"([[{"count": "strips"}]])", "[0, 1]"), 2);
  EXPECT_EQ(symmetries(R"([[{"count": "strips"}]])", "[0]"), 1);
  EXPECT_EQ(symmetries(R"([[{"count": "kept", "ports": [0]}]])", all), 1);
  EXPECT_EQ(symmetries(R"([[{"count": "kept", "ports": [0, 1, 2, 3]}]])", all), 4);
  EXPECT_EQ(symmetries(R"([[{"count": "ends", "triangles": [0]}]])", all), 2);
  EXPECT_EQ(symmetries(R"([[{"count": "ends", "triangles": [0]}, {"count": "ends", "triangles": [1]}]])", all), 4);
  // Other weights, other counts, in other criteria, and repeated.
  EXPECT_EQ(
      symmetries(R"([[{"count": "ends", "triangles": [0]}, {"count": "ends", "triangles": [1], "weight": 2}]])", all),
      2);
  EXPECT_EQ(symmetries(R"([[{"count": "ends", "triangles": [0]}, {"count": "ends_at_port", "triangles": [1]}]])", all),
            2);
  EXPECT_EQ(symmetries(R"([[{"count": "ends", "triangles": [0]}], [{"count": "ends", "triangles": [1]}]])", all), 2);
  EXPECT_EQ(symmetries(R"([[{"count": "ends", "triangles": [0]}, {"count": "ends", "triangles": [0]},
 {"count": "ends", "triangles": [1]}]])",
                       all),
            2);
}

/// A random triangulation of a polygon, whose vertices are p0 ... in order, as two to four triangles; perhaps one of
/// them with a vertex inside.
std::string random_side(std::mt19937& random, unsigned corners) {
  std::vector<unsigned> rim(corners);
  std::iota(rim.begin(), rim.end(), 0U);
  std::vector<std::string> triangles;
  while (rim.size() > 2) {
    const std::size_t ear = random() % rim.size();
    const auto vertex = [&](std::size_t i) { return rim[(ear + i) % rim.size()]; };
    triangles.push_back(fmt::format("[\"p{}\", \"p{}\", \"p{}\"]", vertex(0), vertex(1), vertex(2)));
    rim.erase(rim.begin() + static_cast<std::ptrdiff_t>((ear + 1) % rim.size()));
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  if (corners == 3 && random() % 2 == 0)
    triangles = {R"(["p0", "p1", "m"])", R"(["p1", "p2", "m"])", R"(["m", "p2", "p0"])"};
  return fmt::format("[{}]", fmt::join(triangles, ", "));
}

std::string random_cost(std::mt19937& random) {
  std::vector<std::string> criteria;
  for (std::size_t i = 0, count = 1 + random() % 3; i < count; ++i) {
    std::vector<std::string> terms;
    for (std::size_t j = 0, terms_count = 1 + random() % 3; j < terms_count; ++j) {
      const std::string_view name = count_names[random() % count_names.size()];
      std::string more;
      if ((name == "ends" || name == "ends_at_port") && random() % 2 == 0) more = R"(, "triangles": [0])";
      if (name == "kept" && random() % 2 == 0) more = R"(, "ports": [0])";
      terms.push_back(
          fmt::format(R"({{"count": "{}", "weight": {}{}}})", name, static_cast<int>(random() % 7) - 3, more));
    }
    criteria.push_back(fmt::format("[{}]", fmt::join(terms, ", ")));
  }
  return fmt::format("[{}]", fmt::join(criteria, ", "));
}

TEST(OperationJudge, AgreesWithANaiveMethodOnRandomOperations) {
  const unsigned seed = 20261122;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  std::size_t judged = 0;
  std::size_t certified = 0;
  for (unsigned round = 0; round < 40; ++round) {
    const auto corners = static_cast<unsigned>(3 + random() % 3);
    const std::string before = random_side(random, corners);
    const std::string after = random_side(random, corners);
    const std::string text = fmt::format(
        R"({{"restrip_operation": 1, "name": "random", "constraint": "{}",
 "before": {}, "after": {}, "give_up": {}, "cost": {}}})",
        constraint_names[random() % 2], before, after, std::array{"\"none\"", "\"all\"", "[0]"}[random() % 3],
        random_cost(random));
    const Operation operation = parse_operation("random", text);
    judged += expect_same_judgement(operation);
    ASSERT_FALSE(HasFailure()) << text;
    const NaiveSection section = naive_section(operation);
    const std::optional<NaiveTable> table = naive_table("random", section, false);
    if (!table) continue;
    const Verdict verdict =
        verdict_on_text(text, certificate_text("random", {*table}), dump_text(section.operations.front(), *table));
    ASSERT_EQ(verdict.exit_code, 0) << text << '\n' << verdict.text;
    ++certified;
  }
  EXPECT_GT(judged, 10000U);
  EXPECT_GT(certified, 15U);
}

}  // namespace
}  // namespace restrip::verify::test
