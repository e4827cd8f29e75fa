// Claim: every command reports counts in correct English, with a singular for one.
#include "common/counted.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "run_program.hpp"

namespace restrip::tools {
namespace {

TEST(Counted, OneIsSingular) {
  EXPECT_EQ(counted(0, "strip"), "0 strips");
  EXPECT_EQ(counted(1, "strip"), "1 strip");
  EXPECT_EQ(counted(21, "strip"), "21 strips");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(11, "vertex", "vertices"), "11 vertices");
}

/// "1 strips", "1 degenerate triangles", "1 vertices lie"; empty if the text has no such fault.
std::string plural_of_one(const std::string& text) {
  static const std::regex plural(
      R"((?:^|[^\d.,])(1 (?:(?:degenerate|connected|solid) )?(?!(?:is|has|was|as)\b)[a-z]+s)\b)");
  std::smatch found;
  return std::regex_search(text, found, plural) ? found[1].str() : "";
}

TEST(Counted, ThePluralOfOneIsRecognised) {
  for (const char* wrong : {"1 strips", "1 degenerate triangles", "1 vertices", "1 connected components"})
    EXPECT_EQ(plural_of_one(fmt::format("2 of them in {} here", wrong)), wrong);
  for (const char* right : {"in 1 strip", "1 degenerate triangle left out", "0.1 strips", "21 strips", "1 edge lies",
                            "1 is solid", "1,001 strips"})
    EXPECT_EQ(plural_of_one(right), "") << right;
}

class CountedByTheProgram : public ProgramFolder {
 protected:
  /// Runs a command, which reports these words of counts on one of both streams, in correct English.
  void expect(const std::string& command, const char* words) const {
    const Outcome outcome = run(command, true);
    EXPECT_EQ(outcome.code, 0) << command << outcome.out;
    EXPECT_EQ(plural_of_one(outcome.out), "") << command;
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << " is not in:\n" << outcome.out;
  }
};

TEST_F(CountedByTheProgram, OneTriangle) {
  put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect("stats a.obj", "in 1 loop\n");
  expect("stripify a.obj -o a.glb", "1 triangle (0 degenerate ones left out) in 1 strip, 1 connected component\n");
  expect("convert a.obj -o a.ply", "3 vertices, 1 triangle\n");
  expect("simplify a.obj -o a.pm", "1 triangle and 0 splits to 1\n");
  expect("simplify a.obj -o b.glb", "1 of 1 triangle, in 1 strip\n");
  expect("replay a.obj -o a.bin", "1 triangle in 1 strip\n");
  expect("replay a.obj --repeats 0 --walk 1 --seed 1", "walk of 1 step, seed 1: ");
  expect("bake a.obj -o a.baked", "1 triangle and 0 records to 1\n1 strip at the base");
  expect("draw a.obj -o a.svg", "1 triangle in 1 strip; ");
  expect("paper a.obj -o figures", "a.obj: 1 triangle, base 1\n");
}

TEST_F(CountedByTheProgram, OneFault) {
  put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\nf 1 1 2\n");
  expect("stripify a.obj", "(1 degenerate one left out)");
  expect("stripify a.obj", "\n1 edge lies between");
  expect("stripify a.obj --orient", "oriented: 1 triangle turned\n");
  expect("replay a.obj --repeats 0", "left out: 1 degenerate triangle\n");
  put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 2 4 5\n");
  expect("stripify a.obj", "\n1 vertex lies where others do");
  expect("stripify a.obj --weld", "welded: 1 vertex with others");
}

}  // namespace
}  // namespace restrip::tools
