// Claims: the program keeps its word to the shell: exit codes, JSON keys, files whole or not at all, examples that
// work.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "run_program.hpp"
#include "scratch_folder.hpp"

namespace restrip::replay {
namespace {

using Program = ScratchFolder;

TEST_F(Program, HelpAndVersion) {
  EXPECT_EQ(run_program("--version").code, 0);
  EXPECT_TRUE(run_program("--version").out.starts_with("restrip "));
  for (const char* command : {"", "stats", "replay", "simplify", "make-mesh", "stripify", "bake", "draw", "paper"}) {
    const Outcome help = run_program(fmt::format("{} --help", command));
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_NE(help.out.find("Example: restrip "), std::string::npos) << command;
  }
}

TEST_F(Program, WrongUsageIsTwo) {
  for (const char* arguments :
       {"", "fly", "stats", "replay", "replay --base 0 --built-in", "replay --base 2 --built-in",
        "replay --boundary melt --built-in", "replay --levels 1 --built-in", "replay x.obj --built-in",
        "stats /no/such/mesh.obj", "replay --policy best --built-in", "replay --states 9 --built-in",
        "replay --states 9 --policy local --built-in", "replay --tie-break indices --built-in",
        "replay --policy full --tie-break beauty --built-in", "stripify x.obj --effort some",
        "draw -o /no/such/folder/a.svg", "make-mesh -o /no/such/folder/a.obj", "make-mesh --triangles 5 -o a.obj"})
    EXPECT_EQ(run_program(arguments).code, 2) << arguments;
}

TEST_F(Program, FullCircle) {
  EXPECT_EQ(run_program(fmt::format("make-mesh --triangles 2000 -o '{}'", file("a.ply"))).code, 0);
  const Outcome stats = run_program(fmt::format("stats '{}' --json", file("a.ply")));
  EXPECT_EQ(stats.code, 0);
  EXPECT_EQ(nlohmann::json::parse(stats.out).at("genus"), 1);
  EXPECT_EQ(run_program(fmt::format("simplify '{}' --base 0.1 -o '{}'", file("a.ply"), file("a.pm"))).code, 0);
  const Outcome replay =
      run_program(fmt::format("replay '{}' --repeats 1 --cycles 2 --walk 500 --seed 9 --json -", file("a.pm")), true);
  EXPECT_EQ(replay.code, 0);
  const auto json = nlohmann::json::parse(replay.out);  // and nothing else on either stream: silent in a pipe
  EXPECT_EQ(json.at("triangles"), nlohmann::json::parse(stats.out).at("triangles"));
  EXPECT_EQ(json.at("walk").at("seed"), 9);
  EXPECT_EQ(json.at("cycles").size(), 2U);
}

TEST_F(Program, LargerSearchesKeepFewerStrips) {
  const auto strips = [](const std::string& states) {
    const Outcome replay =
        run_program("replay --built-in --triangles 20000 --repeats 0 --policy quick --json - " + states);
    EXPECT_EQ(replay.code, 0);
    return nlohmann::json::parse(replay.out).at("levels").back().at("strips").get<int>();
  };
  const int usual = strips("");
  EXPECT_GT(strips("--states 10"), usual);
  EXPECT_LT(strips("--states 200"), usual);
}

TEST_F(Program, IndicesMayBreakTies) {
  const auto indices = [](const std::string& tie_break) {
    const Outcome replay =
        run_program("replay --built-in --triangles 20000 --repeats 0 --policy quick --json - --tie-break " + tie_break);
    EXPECT_EQ(replay.code, 0);
    const auto json = nlohmann::json::parse(replay.out);
    EXPECT_EQ(json.at("tie_break"), tie_break);
    return json.at("levels").back().at("indices").get<double>();
  };
  EXPECT_LT(indices("indices"), 0.98 * indices("strips"));
}

TEST_F(Program, StripifyCountsStrips) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 4000 -o '{}'", file("a.off"))).code, 0);
  const auto fast = nlohmann::json::parse(run_program(fmt::format("stripify '{}' --json", file("a.off"))).out);
  const auto full =
      nlohmann::json::parse(run_program(fmt::format("stripify '{}' --effort full --json", file("a.off"))).out);
  EXPECT_TRUE(fast.at("valid"));
  EXPECT_TRUE(full.at("valid"));
  EXPECT_LT(full.at("strips"), fast.at("strips"));
  EXPECT_LE(full.at("strips"), 2);
  // n triangles, two more indices a strip, one restart between two strips, one for each swap.
  EXPECT_GE(full.at("indices"), 4000);
}

TEST_F(Program, PoliciesKeepLongerStrips) {
  const auto strips_under = [&](const char* policy) {
    const Outcome run = run_program(
        fmt::format("replay --built-in --triangles 6000 --repeats 0 --cycles 1 --policy {} --json -", policy));
    EXPECT_EQ(run.code, 0) << policy;
    return nlohmann::json::parse(run.out).at("levels").back().at("strips").get<int>();
  };
  const int local = strips_under("local");
  const int quick = strips_under("quick");
  const int full = strips_under("full");
  EXPECT_LT(5 * quick, local);
  EXPECT_LT(full, quick);
}

TEST_F(Program, BakedStripsArePlayed) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 3000 -o '{}'", file("a.ply"))).code, 0);
  const Outcome bake = run_program(fmt::format("bake '{}' --base 0.1 -o '{}' --json", file("a.ply"), file("a.baked")));
  ASSERT_EQ(bake.code, 0);
  const auto made = nlohmann::json::parse(bake.out);
  EXPECT_EQ(made.at("most_strips"), 1);
  EXPECT_EQ(made.at("bytes"), std::filesystem::file_size(file("a.baked")));
  // A baked mesh is played by default; its mesh can be replayed by the rules as well, and baked again.
  for (const char* policy : {"", "--policy baked", "--policy local"}) {
    const Outcome run = run_program(fmt::format("replay '{}' --repeats 1 {} --json -", file("a.baked"), policy));
    ASSERT_EQ(run.code, 0) << policy;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json.at("triangles"), made.at("triangles"));
    const bool baked = std::string(policy) != "--policy local";
    EXPECT_EQ(json.contains("baked"), baked);
    EXPECT_EQ(json.at("most_strips") == 1, baked);
    if (!baked) continue;
    EXPECT_EQ(json.at("policy"), "baked");
    EXPECT_EQ(json.at("baked").at("levels_compared"), 2 * json.at("levels").size());
  }
  EXPECT_EQ(run_program(fmt::format("bake '{}' -o '{}'", file("a.baked"), file("b.baked"))).code, 0);
  EXPECT_EQ(run_program(fmt::format("stats '{}'", file("a.baked"))).code, 0);
  EXPECT_EQ(run_program("replay --built-in --triangles 1000 --repeats 0 --policy baked").code, 0);

  std::filesystem::resize_file(file("a.baked"), std::filesystem::file_size(file("a.baked")) - 1);
  const Outcome truncated = run_program(fmt::format("replay '{}'", file("a.baked")), true);
  EXPECT_EQ(truncated.code, 2);
  EXPECT_NE(truncated.out.find("truncated or altered"), std::string::npos);
}

TEST_F(Program, SimplifyingWhatIsProgressiveIsRefused) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 500 -o '{}'", file("a.off"))).code, 0);
  ASSERT_EQ(run_program(fmt::format("simplify '{}' -o '{}'", file("a.off"), file("a.pm"))).code, 0);
  ASSERT_EQ(run_program(fmt::format("bake '{}' -o '{}'", file("a.pm"), file("a.baked"))).code, 0);
  for (const char* arguments :
       {"replay '{}' --base 0.5", "replay '{}' --boundary lock", "bake '{}' --base 0.5 -o b.baked"})
    for (const char* name : {"a.pm", "a.baked"}) {
      const Outcome refused = run_program(fmt::format(fmt::runtime(arguments), file(name)), true);
      EXPECT_EQ(refused.code, 2) << arguments;
      EXPECT_NE(refused.out.find("--base and --boundary do not apply"), std::string::npos) << refused.out;
    }
}

TEST_F(Program, AnOutputThatIsNoFileIsWrittenTo) {
  std::ofstream(file("target")) << "old";
  std::filesystem::create_symlink(file("target"), file("link"));
  ASSERT_EQ(run_program(fmt::format("replay --built-in --triangles 500 --repeats 0 --json '{}'", file("link"))).code,
            0);
  EXPECT_TRUE(std::filesystem::is_symlink(file("link")));
  std::ifstream in(file("target"));
  EXPECT_TRUE(nlohmann::json::parse(in).at("valid"));
  // A pipe: what goes in comes out, and the pipe is still there.
  const Outcome piped = run_program("replay --built-in --triangles 500 --repeats 0 --json /dev/stdout");
  EXPECT_EQ(piped.code, 0);
  EXPECT_TRUE(piped.out.starts_with("{"));
}

TEST_F(Program, ANegativeCountIsNamed) {
  const Outcome refused = run_program(fmt::format("make-mesh --triangles -5 -o '{}'", file("a.obj")), true);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.out.find("-5"), std::string::npos) << refused.out;
}

TEST_F(Program, DrawingIsTheOneShipped) {
  ASSERT_EQ(run_program(fmt::format("draw -o '{}'", file("a.svg"))).code, 0);
  std::stringstream made;
  made << std::ifstream(file("a.svg")).rdbuf();
  std::stringstream shipped;
  shipped << std::ifstream(RESTRIP_PICTURE).rdbuf();
  EXPECT_EQ(made.str(), shipped.str()) << "write docs/picture.svg anew: restrip draw -o docs/picture.svg";
}

TEST_F(Program, JsonHasItsKeys) {
  ASSERT_EQ(run_program(fmt::format("replay --built-in --triangles 3000 --repeats 1 --json '{}'", file("a.json"))).code,
            0);
  std::ifstream in(file("a.json"));
  const auto json = nlohmann::json::parse(in);
  for (const char* key : {"triangles", "operations", "operations_without_rule", "operations_isolating",
                          "operations_adding_strip", "by_valence", "levels", "ns_per_operation",
                          "ns_per_operation_bare", "valid", "triangles_per_strip", "left_out"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_GE(json.at("levels").size(), 10U);
  for (const char* key : {"triangles", "strips", "isolated", "indices"})
    EXPECT_TRUE(json.at("levels").at(0).contains(key)) << key;
  EXPECT_TRUE(json.at("valid").get<bool>());
}

TEST_F(Program, AProgressiveMeshThatDoesNotFitIsOne) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 500 -o '{}'", file("a.off"))).code, 0);
  ASSERT_EQ(run_program(fmt::format("simplify '{}' --base 0.2 -o '{}'", file("a.off"), file("a.pm"))).code, 0);
  std::fstream pm(file("a.pm"), std::ios::in | std::ios::out | std::ios::binary);
  pm.seekp(-4, std::ios::end);
  const std::array<char, 4> first_vertex{};
  pm.write(first_vertex.data(), 4);
  pm.close();
  const Outcome replay = run_program(fmt::format("replay '{}'", file("a.pm")));
  EXPECT_EQ(replay.code, 1);
  EXPECT_NE(replay.out.find("FAULT"), std::string::npos);
}

TEST_F(Program, AFailedWriteLeavesTheTargetAlone) {
  std::ofstream(file("a.obj")) << "mine";
  std::filesystem::create_directory(file("a.obj.part"));  // in the way of the half-written file
  EXPECT_EQ(run_program(fmt::format("make-mesh -o '{}'", file("a.obj"))).code, 2);
  std::stringstream kept;
  kept << std::ifstream(file("a.obj")).rdbuf();
  EXPECT_EQ(kept.str(), "mine");
}

}  // namespace
}  // namespace restrip::replay
