// The program as a whole: the shipped tables, the controls, wrong tables, solvers that lie or are missing.
#include "sat/prove.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "model/input.hpp"
#include "naive_rup.hpp"
#include "sat/solver.hpp"
#include "sat/work_folder.hpp"
#include "support.hpp"

namespace restrip::verify::sat::test {
namespace {

namespace fs = std::filesystem;

Options shipped() {
  Options options;
  options.tables_dir = RESTRIP_TABLES_DIR;
  options.threads = 2;
  return options;
}

std::vector<PositionResult> results_of(const Options& options) {
  std::vector<PositionResult> results;
  prove_tables(options, [&](const PositionResult& result) { results.push_back(result); });
  return results;
}

std::string error_of(const Options& options) {
  try {
    results_of(options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

/// A folder that goes with the test.
class Scratch {
 public:
  Scratch() : folder_("") {}
  std::string path(const std::string& name) const { return folder_.path(name); }
  /// An executable shell script.
  std::string script(const std::string& name, const std::string& text) const {
    folder_.write(name, "#!/bin/sh\n" + text);
    chmod(path(name).c_str(), 0755);
    return path(name);
  }

 private:
  WorkFolder folder_;
};

TEST(SatProofs, TheShippedTablesCannotBeBeaten) {
  RESTRIP_NEEDS_CADICAL();
  const std::vector<PositionResult> results = results_of(shipped());
  EXPECT_GT(results.size(), 200U);
  for (const PositionResult& result : results) {
    EXPECT_TRUE(result.held()) << result.name << ": " << result.fault;
    EXPECT_GE(result.core, 1U) << result.name;
  }
}

TEST(SatProofs, ControlsHold) {
  RESTRIP_NEEDS_CADICAL();
  Options options = shipped();
  options.controls = true;
  std::size_t altered = 0;
  std::size_t refused = 0;
  const auto count = [&] {
    for (const PositionResult& result : results_of(options)) {
      EXPECT_TRUE(result.held()) << result.name << ": " << result.fault << result.controls.fault;
      EXPECT_GE(result.controls.altered_formulas, 6U) << result.name;
      altered += result.controls.altered_formulas;
      refused += result.controls.refused;
    }
  };
  options.families = {"flip"};
  options.control_rows = 0;
  count();
  options.families = {"split"};
  options.control_rows = 2;
  count();
  EXPECT_GT(altered, 150U);
  EXPECT_GT(refused, 30U);
}

/// Lines that a plain checker can do without are taken out until none is left; then every line must be missed.
TEST(SatProofs, EveryLineThatIsNeededIsMissed) {
  RESTRIP_NEEDS_CADICAL();
  std::size_t needed = 0;
  for (const std::string position : {"flip", "split-k-3-a-1"}) {
    const Scratch scratch;
    Options options = shipped();
    options.families = {position.substr(0, position.find('-'))};
    options.out = scratch.path("kept");
    results_of(options);
    const std::string name = options.out + "/" + position;
    const Cnf cnf = parse_dimacs(name + ".cnf", read_file(name + ".cnf"));
    Proof proof = parse_proof(name + ".drat", read_file(name + ".drat"), cnf.variables);
    std::erase_if(proof, [](const ProofStep& step) { return step.deletes; });
    ASSERT_TRUE(naively_proved(cnf, proof));
    ASSERT_TRUE(check_proof(cnf, proof).proved);
    for (std::size_t step = proof.size() - 1; step-- > 0;) {
      Proof shorter = without_step(proof, step);
      const bool still_right = naively_proved(cnf, shorter);
      ASSERT_EQ(check_proof(cnf, shorter).proved, still_right) << name << " line " << proof[step].line;
      if (still_right) proof = std::move(shorter);
    }
    for (std::size_t step = 0; step < proof.size(); ++step) {
      EXPECT_FALSE(check_proof(cnf, without_step(proof, step)).proved) << name << " line " << proof[step].line;
      ++needed;
      // Nor may a literal be turned round, unless the proof happens to be right with it.
      for (Literal& literal : proof[step].clause) {
        literal = -literal;
        EXPECT_EQ(check_proof(cnf, proof).proved, naively_proved(cnf, proof)) << name << " line " << proof[step].line;
        literal = -literal;
      }
    }
  }
  EXPECT_GT(needed, 20U);
}

TEST(SatProofs, AWorseRuleIsBeatenAndNamed) {
  RESTRIP_NEEDS_CADICAL();
  const std::string file = std::string(RESTRIP_TABLES_DIR) + "/certificates/flip.cert";
  std::string text = read_file(file);
  const Certificate certificate = parse_certificate(file, text, all_families().back());
  const Row row = certificate.sections.front().rows.front();
  // The first row is the empty one; its inner edge is solid afterwards and need not be.
  ASSERT_EQ(row.key, Key{});
  ASSERT_EQ(row.after, (Colors{1, 0}));
  std::vector<Bound> bounds = bounds_of(position_of("flip", ""), certificate.sections.front().rows);
  bounds.front().solid = 0;
  bounds.front().isolated = 2;
  const Position position = position_of("flip", "");
  const Encoding encoding = encode(position, bounds);
  const WorkFolder folder("");
  folder.write("f.cnf", dimacs_of(encoding.cnf, "flip"));
  const Model model =
      solve("cadical", folder.path("f.cnf"), folder.path("f.drat"), folder.path("f.answer"), encoding.cnf.variables);
  ASSERT_TRUE(model);
  const std::vector<Family> families = all_families();
  const Counterexample found = read_back(encoding, *model);
  EXPECT_EQ(objection(families.back().sections.front().operations.front(), found, bounds.front()), "");
  EXPECT_EQ(found.after.inner, 1U);
}

TEST(SatProofs, ProofsAreKeptWhole) {
  RESTRIP_NEEDS_CADICAL();
  const Scratch scratch;
  Options options = shipped();
  options.families = {"flip"};
  options.out = scratch.path("kept/here");
  ASSERT_EQ(results_of(options).size(), 1U);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(options.out)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  ASSERT_EQ(names, (std::vector<std::string>{"flip.cnf", "flip.drat", "flip.lrat"}));
  const Cnf cnf = parse_dimacs("flip.cnf", read_file(options.out + "/flip.cnf"));
  const Proof proof = parse_proof("flip.drat", read_file(options.out + "/flip.drat"), cnf.variables);
  EXPECT_TRUE(check_proof(cnf, proof).proved);
  EXPECT_TRUE(naively_proved(cnf, proof));
}

TEST(SatProofs, SolversThatCannotBeTrusted) {
  const Scratch scratch;
  Options options = shipped();
  options.families = {"flip"};
  const auto with_solver = [&](const std::string& solver) {
    options.solver = solver;
    return options;
  };
  EXPECT_NE(error_of(with_solver("no-such-solver")).find("install the package cadical"), std::string::npos);
  EXPECT_NE(error_of(with_solver("true")).find("no answer"), std::string::npos);
  EXPECT_NE(error_of(with_solver(scratch.script("mute", "exit 20\n"))).find("cannot be opened"), std::string::npos);
  EXPECT_NE(error_of(with_solver(scratch.script("vague", "exit 10\n"))).find("printed no assignment"),
            std::string::npos);
  EXPECT_NE(error_of(with_solver(scratch.script("binary", "printf 'a\\004' >$4; exit 20\n"))).find("cut off"),
            std::string::npos);
  const auto fault_with = [&](const std::string& script) {
    return results_of(with_solver(scratch.script("liar", script))).front().fault;
  };
  EXPECT_NE(fault_with("echo 0 >$4; exit 20\n").find("line 1: does not follow"), std::string::npos);
  EXPECT_NE(fault_with(": >$4; exit 20\n").find("the empty clause is missing"), std::string::npos);
  EXPECT_NE(fault_with("echo 'v 0'; exit 10\n").find("beats its row"), std::string::npos);
}

TEST(SatProofs, ForeignCheckersHaveTheLastWord) {
  const Scratch scratch;
  Options options = shipped();
  options.families = {"flip"};
  options.solver = scratch.script("solver", "echo 0 >$4; exit 20\n");
  options.checker = scratch.script("yes", "echo 's VERIFIED'\n");
  EXPECT_EQ(results_of(options).front().fault, "");
  options.checker = scratch.script("no", "echo 's NOT VERIFIED'\n");
  EXPECT_NE(results_of(options).front().fault.find("does not accept"), std::string::npos);
  options.checker = scratch.script("sick", "echo 's VERIFIED'; exit 1\n");
  EXPECT_NE(results_of(options).front().fault.find("does not accept"), std::string::npos);
  options.checker = "no-such-checker";
  EXPECT_NE(error_of(options).find("--checker"), std::string::npos);
}

}  // namespace
}  // namespace restrip::verify::sat::test
