// The verifier of operations agrees with a naive method: on every recolouring of every configuration, and on whole
// certificates and dumps, for the operations of the corpus and for random ones.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <random>

#include "operation_verdict.hpp"
#include "patch_symmetry.hpp"
#include "rule_judge.hpp"

namespace restrip::verify::operations::test {
namespace {

Colors colors_of(NaiveColors colors) { return {static_cast<Mask>(colors.inner), static_cast<Mask>(colors.ports)}; }

/// Every recolouring of every valid configuration; how many there were.
std::size_t expect_same_judgement(const OperationFile& operation) {
  const NaiveOperation naive(operation);
  RuleJudge judge(operation);
  std::size_t compared = 0;
  for (const NaiveColors& configuration : naive.configurations()) {
    const bool valid = judge.before().class_of(colors_of(configuration)) != FitClasses::not_valid;
    EXPECT_EQ(valid, naive.valid(false, configuration));
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
          expected.verdict = Verdict::wrong_ports;
        else if (candidate == sound.end())
          expected.verdict = Verdict::unsound;
        else if (candidate->cost != best)
          expected = {Verdict::not_best,
                      static_cast<unsigned>(std::mismatch(best.begin(), best.end(), candidate->cost.begin()).first -
                                            best.begin())};
        const Judged found = judge.judged(colors_of(configuration), colors_of(after));
        if (found.verdict == expected.verdict && found.criterion == expected.criterion) continue;
        ADD_FAILURE() << operation.name << ": " << judge.explained(colors_of(configuration), colors_of(after), found);
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
    const OperationFile operation = corpus_operation(name);
    const NaiveOperation naive(operation);
    const std::optional<NaiveCertificate> certificate = naive.certificate();
    ASSERT_TRUE(certificate) << name;
    const OperationVerdict verdict =
        verdict_on(corpus_path(name, "json"), certificate->text(), naive.dump(*certificate));
    EXPECT_EQ(verdict.exit_code, 0) << name << '\n' << verdict.text;
  }
}

// The four symmetries of a flip, less those that the ports that may be given up or the cost forbid.
TEST(OperationJudge, SymmetriesLeaveTheCostAsItIs) {
  const auto symmetries = [](const std::string& cost, const std::string& give_up) {
    const OperationFile operation = parse_operation_file(
        "flip", fmt::format(R"({{"restrip_operation": 1, "name": "turn", "constraint": "strips", "cost": {},
 "before": {{"triangles": 2, "edges": [[0, 1]], "ports": [0, 0, 1, 1]}},
 "after": {{"triangles": 2, "edges": [[0, 1]], "ports": [1, 0, 0, 1]}}, "give_up": {}}})",
                            cost, give_up));
    return PatchSymmetries(operation).order();
  };
  const std::string all = "\"all\"";
  EXPECT_EQ(symmetries(R"([[{"count": "strips"}]])", all), 4);
  EXPECT_EQ(symmetries(R"([[{"count": "strips"}]])", "[0, 1]"), 2);
  EXPECT_EQ(symmetries(R"([[{"count": "strips"}]])", "[0]"), 1);
  EXPECT_EQ(symmetries(R"([[{"count": "kept", "ports": [0]}]])", all), 1);
  EXPECT_EQ(symmetries(R"([[{"count": "kept", "ports": [0, 1, 2, 3]}]])", all), 4);
  EXPECT_EQ(symmetries(R"([[{"count": "ends", "triangles": [0]}]])", all), 2);
  EXPECT_EQ(symmetries(R"([[{"count": "ends", "triangles": [0]}, {"count": "ends", "triangles": [1]}]])", all), 4);
  // Other weights, other counts, in other criteria, and more often.
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

/// A random side with so many ports: edges and ports where triangles have room.
std::string random_side(std::mt19937& random, unsigned ports) {
  const auto triangles = static_cast<unsigned>(1 + random() % 4);
  std::vector<unsigned> room(triangles, 3);
  std::vector<unsigned> owners;
  while (owners.size() < ports) {
    const auto triangle = static_cast<unsigned>(random() % triangles);
    if (room[triangle] == 0) {
      if (std::all_of(room.begin(), room.end(), [](unsigned left) { return left == 0; })) return {};
      continue;
    }
    --room[triangle];
    owners.push_back(triangle);
  }
  std::vector<std::string> edges;
  for (unsigned i = 0; i < triangles; ++i)
    for (unsigned j = i + 1; j < triangles; ++j)
      if (room[i] > 0 && room[j] > 0 && random() % 4 != 0) {
        --room[i];
        --room[j];
        edges.push_back(random() % 2 == 0 ? fmt::format("[{}, {}]", i, j) : fmt::format("[{}, {}]", j, i));
      }
  return fmt::format(R"({{"triangles": {}, "edges": [{}], "ports": [{}]}})", triangles, fmt::join(edges, ", "),
                     fmt::join(owners, ", "));
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
  const std::string path = fmt::format("{}/random-operation-{}.json", testing::TempDir(), getpid());
  for (unsigned round = 0; round < 40; ++round) {
    const auto ports = static_cast<unsigned>(1 + random() % 4);
    const std::string before = random_side(random, ports);
    const std::string after = random_side(random, ports);
    if (before.empty() || after.empty()) continue;
    const std::string text = fmt::format(
        R"({{"restrip_operation": 1, "name": "random", "constraint": "{}",
 "before": {}, "after": {}, "give_up": {}, "cost": {}}})",
        constraint_names[random() % 3], before, after, std::array{"\"none\"", "\"all\"", "[0]"}[random() % 3],
        random_cost(random));
    const OperationFile operation = parse_operation_file("random", text);
    judged += expect_same_judgement(operation);
    ASSERT_FALSE(HasFailure()) << text;
    const NaiveOperation naive(operation);
    const std::optional<NaiveCertificate> certificate = naive.certificate();
    if (!certificate) continue;
    std::ofstream(path) << text;
    const OperationVerdict verdict = verdict_on(path, certificate->text(), naive.dump(*certificate));
    ASSERT_EQ(verdict.exit_code, 0) << text << '\n' << verdict.text;
    ++certified;
  }
  std::remove(path.c_str());
  EXPECT_GT(judged, 10000U);
  EXPECT_GT(certified, 15U);
}

}  // namespace
}  // namespace restrip::verify::operations::test
