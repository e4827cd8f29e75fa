// Claim: every command reports counts in correct English, with a singular for one.
#include "common/counted.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <string>

#include "run_program.hpp"
#include "scratch_folder.hpp"

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

class CountedByTheProgram : public ScratchFolder {
 protected:
  /// Writes a mesh of these lines of an .obj file.
  void make(const std::string& lines) { std::ofstream(file("mesh.obj")) << lines; }
  /// What a command reports about the mesh, on both streams, after checking its exit code and its English.
  std::string reported(const std::string& command, const std::string& more = "") {
    const Outcome outcome = run_program(fmt::format("{} '{}' {}", command, file("mesh.obj"), more), true);
    EXPECT_EQ(outcome.code, 0) << command << outcome.out;
    EXPECT_EQ(plural_of_one(outcome.out), "") << command;
    return outcome.out;
  }
  std::string reported_and_written(const std::string& command, const char* out) {
    return reported(command, fmt::format("-o '{}'", file(out)));
  }
  static void expect(const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in:\n" << text;
  }
};

TEST_F(CountedByTheProgram, OneTriangle) {
  make("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect(reported("stats"), "in 1 loop\n");
  expect(reported_and_written("stripify", "a.glb"),
         "1 triangle (0 degenerate ones left out) in 1 strip, 1 connected component\n");
  expect(reported_and_written("convert", "a.ply"), "3 vertices, 1 triangle\n");
  expect(reported_and_written("simplify", "a.pm"), "1 triangle and 0 splits to 1\n");
  expect(reported_and_written("simplify", "b.glb"), "1 of 1 triangle, in 1 strip\n");
  expect(reported_and_written("replay", "a.bin"), "1 triangle in 1 strip\n");
  expect(reported("replay", "--repeats 0 --walk 1 --seed 1"), "walk of 1 step, seed 1: ");
  expect(reported_and_written("bake", "a.baked"), "1 triangle and 0 records to 1\n1 strip at the base");
  expect(reported_and_written("draw", "a.svg"), "1 triangle in 1 strip; ");
  expect(reported("paper", fmt::format("-o '{}'", file("figures"))), "mesh.obj: 1 triangle, base 1\n");
}

TEST_F(CountedByTheProgram, OneFault) {
  make("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\nf 1 1 2\n");
  expect(reported("stripify"), "(1 degenerate one left out)");
  expect(reported("stripify"), "\n1 edge lies between");
  expect(reported("stripify", "--orient"), "oriented: 1 triangle turned\n");
  expect(reported("replay", "--repeats 0"), "left out: 1 degenerate triangle\n");
  make("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 2 4 5\n");
  expect(reported("stripify"), "\n1 vertex lies where others do");
  expect(reported("stripify", "--weld"), "welded: 1 vertex with others");
}

}  // namespace
}  // namespace restrip::tools
