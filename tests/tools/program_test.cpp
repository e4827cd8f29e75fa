// Claims: the program behaves as documented: exit codes, JSON keys, files written whole or not at all, working
// examples.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

#include "run_program.hpp"
#include "scratch_folder.hpp"
#include "support/sanitizers.hpp"

namespace restrip::tools {
namespace {

using Program = ScratchFolder;

TEST_F(Program, HelpAndVersion) {
  EXPECT_EQ(run_program("--version").code, 0);
  EXPECT_TRUE(run_program("--version").out.starts_with("restrip "));
  for (const char* command :
       {"", "stats", "replay", "simplify", "convert", "make-mesh", "stripify", "bake", "draw", "paper"}) {
    const Outcome help = run_program(fmt::format("{} --help", command));
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_NE(help.out.find("Example: restrip "), std::string::npos) << command;
  }
}

TEST_F(Program, WrongUsageIsTwo) {
  for (const char* arguments : {"",
                                "fly",
                                "stats",
                                "replay",
                                "replay --base 0 --built-in",
                                "replay --base 2 --built-in",
                                "replay --boundary melt --built-in",
                                "replay --levels 1 --built-in",
                                "replay x.obj --built-in",
                                "stats /no/such/mesh.obj",
                                "replay --policy better --built-in",
                                "replay --states 9 --built-in",
                                "replay --states 9 --policy local --built-in",
                                "replay --tie-break indices --built-in",
                                "replay --policy full --tie-break beauty --built-in",
                                "stripify x.obj --effort some",
                                "stripify x.obj --cost bytes",
                                "stripify x.obj --limit 9",
                                "stripify x.obj --effort best --limit 0",
                                "stripify x.obj --effort full --seed 2",
                                "stripify x.obj --cost indices --seed 2",
                                "stripify x.obj --effort full --cost indices --seed -1",
                                "draw -o /no/such/folder/a.json",
                                "make-mesh -o /no/such/folder/a.obj",
                                "make-mesh --triangles 5 -o a.obj"})
    EXPECT_EQ(run_program(arguments).code, 2) << arguments;
}

TEST_F(Program, FullCircle) {
  EXPECT_EQ(run_program(fmt::format("make-mesh --triangles 2000 -o '{}'", file("a.ply"))).code, 0);
  const Outcome stats = run_program(fmt::format("stats '{}' --json -", file("a.ply")));
  EXPECT_EQ(stats.code, 0);
  EXPECT_EQ(nlohmann::json::parse(stats.out).at("genus"), 1);
  EXPECT_EQ(run_program(fmt::format("simplify '{}' --base 0.1 -o '{}'", file("a.ply"), file("a.pm"))).code, 0);
  const Outcome replay = run_program(
      fmt::format("replay '{}' --policy local --cost strips --repeats 1 --cycles 2 --walk 500 --seed 9 --json -",
                  file("a.pm")),
      true);
  EXPECT_EQ(replay.code, 0);
  const auto json = nlohmann::json::parse(replay.out);  // and nothing else on either stream: silent in a pipe
  EXPECT_EQ(json.at("triangles"), nlohmann::json::parse(stats.out).at("triangles"));
  EXPECT_EQ(json.at("walk").at("seed"), 9);
  EXPECT_EQ(json.at("cycles").size(), 2U);
}

TEST_F(Program, LargerSearchesKeepFewerStrips) {
  const auto strips = [](const std::string& states) {
    const Outcome replay =
        run_program(fmt::format("replay --built-in --triangles {} --repeats 0 --policy quick --cost strips --json - {}",
                                test::large(20'000), states));
    EXPECT_EQ(replay.code, 0);
    return nlohmann::json::parse(replay.out).at("levels").back().at("strips").get<int>();
  };
  const int usual = strips("");
  EXPECT_GT(strips("--states 10"), usual);
  EXPECT_LT(strips("--states 200"), usual);
}

TEST_F(Program, ReplaysKeepIndicesFewWhereTheyAreTheCost) {
  const auto indices_per_triangle = [](const char* policy, const char* cost) {
    const Outcome replay =
        run_program(fmt::format("replay --built-in --triangles {} --repeats 0 --policy {} --cost {} --json -",
                                test::large(6000), policy, cost));
    EXPECT_EQ(replay.code, 0);
    const auto json = nlohmann::json::parse(replay.out);
    EXPECT_EQ(json.at("cost"), cost);
    EXPECT_EQ(json.at("levels").size(), json.at("levels_down").size());
    double most = 0;
    for (const char* way : {"levels", "levels_down"})
      for (const auto& level : json.at(way)) {
        const auto number = [&](const char* key) { return level.at(key).template get<double>(); };
        EXPECT_EQ(number("indices"), number("triangles") + 3 * number("strips") + number("swaps") - 1);
        if (number("triangles") > 1000) most = std::max(most, number("indices") / number("triangles"));
      }
    return most;
  };
  for (const auto& [policy, at_most] : {std::pair{"local", 1.55}, {"linked", 1.46}, {"quick", 1.42}, {"full", 1.36}}) {
    const double indices = indices_per_triangle(policy, "indices");
    EXPECT_LT(indices, at_most) << policy;
    EXPECT_LT(indices, indices_per_triangle(policy, "strips") * 0.95) << policy;
  }
  for (const char* refused : {"--policy rules --cost indices", "--policy baked --cost indices", "--cost swaps",
                              "--policy quick --tie-break indices"})
    EXPECT_EQ(run_program(fmt::format("replay --built-in --triangles 2000 {}", refused)).code, 2) << refused;
}

TEST_F(Program, StripifyCountsStrips) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 4000 -o '{}'", file("a.off"))).code, 0);
  const auto fast =
      nlohmann::json::parse(run_program(fmt::format("stripify '{}' --cost strips --json -", file("a.off"))).out);
  const auto full = nlohmann::json::parse(
      run_program(fmt::format("stripify '{}' --cost strips --effort full --json -", file("a.off"))).out);
  EXPECT_TRUE(fast.at("valid"));
  EXPECT_TRUE(full.at("valid"));
  EXPECT_FALSE(fast.contains("lower_bound_indices")) << "only --bound computes it";
  EXPECT_LT(full.at("strips"), fast.at("strips"));
  EXPECT_LE(full.at("strips"), 2);
  // n triangles, two more indices a strip, one restart between two strips, one for each swap.
  EXPECT_GE(full.at("indices"), 4000);
}

TEST_F(Program, StripifyReportsTheCostOfIndices) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 2000 -o '{}'", file("a.off"))).code, 0);
  const auto stripified = [&](const char* options) {
    const Outcome run = run_program(fmt::format("stripify '{}' {} --bound --json -", file("a.off"), options));
    EXPECT_EQ(run.code, 0) << options;
    auto json = nlohmann::json::parse(run.out);
    const auto number = [&](const char* key) { return json.at(key).get<double>(); };
    EXPECT_TRUE(json.at("valid"));
    EXPECT_EQ(number("indices"), number("triangles") + 3 * number("strips") + number("swaps") - 1) << options;
    EXPECT_GE(number("indices"), number("lower_bound_indices")) << options;
    EXPECT_GT(number("lower_bound_indices"), number("triangles"));
    EXPECT_GE(number("acmr"), 0.5);  // a closed mesh has half as many vertices as triangles
    EXPECT_LE(number("acmr") * number("triangles"), number("indices"));
    for (const char* key : {"seconds", "seconds_to_build", "seconds_to_write"}) {
      EXPECT_GE(number(key), 0);
      json.erase(key);
    }
    return json;
  };
  const auto strips = stripified("--effort full --cost strips");
  const auto fast = stripified("");
  EXPECT_EQ(fast, stripified("--effort fast --cost indices"));
  const auto full = stripified("--effort full --cost indices");
  EXPECT_EQ(full, stripified("--effort full --cost indices --seed 1"));
  const auto best = stripified("--effort best --cost indices --limit 300");
  EXPECT_LT(full.at("indices"), fast.at("indices"));
  EXPECT_LT(full.at("indices"), strips.at("indices"));
  EXPECT_LT(strips.at("strips"), full.at("strips"));
  EXPECT_LE(best.at("indices"), full.at("indices"));
}

TEST_F(Program, PoliciesKeepLongerStrips) {
  const auto strips_under = [&](const char* policy) {
    const Outcome run = run_program(
        fmt::format("replay --built-in --triangles {} --repeats 0 --cycles 1 --policy {} --cost strips --json -",
                    test::large(6000), policy));
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
  const Outcome bake =
      run_program(fmt::format("bake '{}' --base 0.1 -o '{}' --json -", file("a.ply"), file("a.baked")));
  ASSERT_EQ(bake.code, 0);
  const auto made = nlohmann::json::parse(bake.out);
  EXPECT_EQ(made.at("most_strips"), 1);
  EXPECT_EQ(made.at("bytes"), std::filesystem::file_size(file("a.baked")));
  // A baked mesh is played by default; its mesh can also be replayed by the rules, or baked again.
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

// Where a mesh is expected, a progressive or baked one stands for its finest level.
TEST_F(Program, LevelsAreReadWhereverAMeshIs) {
  ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 500 -o '{}'", file("a.ply"))).code, 0);
  ASSERT_EQ(run_program(fmt::format("simplify '{}' -o '{}'", file("a.ply"), file("a.pm"))).code, 0);
  ASSERT_EQ(run_program(fmt::format("bake '{}' -o '{}'", file("a.pm"), file("a.baked"))).code, 0);
  const auto triangles = [&](const char* arguments, const char* name) {
    const Outcome run = run_program(fmt::format(fmt::runtime(arguments), file(name), file("out.ply")));
    EXPECT_EQ(run.code, 0) << arguments << ": " << run.out;
    return nlohmann::json::parse(run.out).at("triangles").get<std::size_t>();
  };
  for (const char* arguments :
       {"stats '{0}' --json -", "stripify '{0}' -o '{1}' --json -", "convert '{0}' -o '{1}' --json -",
        "simplify '{0}' --base 0.5 -o '{1}' --json -", "stats '{0}' --weld --json -"}) {
    const std::size_t wanted = triangles(arguments, "a.ply");
    for (const char* name : {"a.pm", "a.baked"}) EXPECT_EQ(triangles(arguments, name), wanted) << arguments << name;
  }
  EXPECT_NE(run_program(fmt::format("stats '{}'", file("a.pm"))).out.find("a.pm (its finest level)"),
            std::string::npos);
}

TEST_F(Program, AnOutputThatIsNotAFileIsWrittenTo) {
  std::ofstream(file("target")) << "old";
  std::filesystem::create_symlink(file("target"), file("link.json"));
  ASSERT_EQ(
      run_program(fmt::format("replay --built-in --triangles 500 --repeats 0 --json '{}'", file("link.json"))).code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(file("link.json")));
  std::ifstream in(file("target"));
  EXPECT_TRUE(nlohmann::json::parse(in).at("valid"));
  // A pipe: the output arrives, and the pipe still exists.
  const Outcome piped = run_program("replay --built-in --triangles 500 --repeats 0 --json /dev/stdout");
  EXPECT_EQ(piped.code, 0);
  EXPECT_TRUE(piped.out.starts_with("{"));
}

TEST_F(Program, ANegativeCountIsNamed) {
  const Outcome refused = run_program(fmt::format("make-mesh --triangles -5 -o '{}'", file("a.obj")), true);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.out.find("-5"), std::string::npos) << refused.out;
}

TEST_F(Program, JsonHasItsKeys) {
  ASSERT_EQ(
      run_program(fmt::format("replay --built-in --triangles 3000 --policy local --cost strips --repeats 1 --json '{}'",
                              file("a.json")))
          .code,
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

/// The message of a refused command: exit code 2 and one line.
std::string refusal(const std::string& arguments) {
  const Outcome refused = run_program(arguments, true);
  EXPECT_EQ(refused.code, 2) << arguments << '\n' << refused.out;
  EXPECT_EQ(refused.out.find('\n'), refused.out.size() - 1) << refused.out;
  return refused.out;
}

/// A mesh in three formats.
class Meshes : public ScratchFolder {
 protected:
  void SetUp() override {
    ScratchFolder::SetUp();
    ASSERT_EQ(run_program(fmt::format("make-mesh --triangles 500 -o '{}'", file("a.obj"))).code, 0);
    ASSERT_EQ(run_program(fmt::format("simplify '{}' -o '{}'", file("a.obj"), file("a.pm"))).code, 0);
    ASSERT_EQ(run_program(fmt::format("bake '{}' -o '{}'", file("a.pm"), file("a.baked"))).code, 0);
  }
};

TEST_F(Meshes, AnInputIsNeverAnOutput) {
  std::filesystem::create_symlink("a.obj", file("link.pm"));
  std::filesystem::create_hard_link(file("a.obj"), file("hard.svg"));
  std::filesystem::create_hard_link(file("a.pm"), file("hard.baked"));
  std::filesystem::create_hard_link(file("a.obj"), file("hard.json"));
  std::filesystem::create_directory(file("report"));
  std::filesystem::create_hard_link(file("a.obj"), folder_ / "report" / "strips.csv");
  const std::string mesh = bytes_of(file("a.obj"));
  const std::string progressive = bytes_of(file("a.pm"));
  const std::string baked = bytes_of(file("a.baked"));
  for (const auto& [command, in, out] : std::vector<std::array<const char*, 3>>{
           {"simplify '{}' -o '{}'", "a.obj", "a.obj"},
           {"simplify '{}' -o '{}'", "a.obj", "link.pm"},
           {"bake '{}' -o '{}'", "a.pm", "hard.baked"},
           {"bake '{}' -o '{}'", "a.baked", "./a.baked"},
           {"draw '{}' -o '{}'", "a.obj", "hard.json"},
           {"draw '{}' -o '{}'", "a.obj", "hard.svg"},
           {"replay '{}' --json '{}'", "a.obj", "hard.json"},
           {"paper '{}' --out '{}'", "a.obj", "report"},
       })
    EXPECT_NE(refusal(fmt::format(fmt::runtime(command), file(in), file(out))).find("is the input"), std::string::npos)
        << command << out;
  EXPECT_EQ(bytes_of(file("a.obj")), mesh);
  EXPECT_EQ(bytes_of(file("a.pm")), progressive);
  EXPECT_EQ(bytes_of(file("a.baked")), baked);
}

// For every subcommand: no output is another output, nor a file that the input names.
TEST_F(Meshes, NoFileIsWrittenTwice) {
  std::ofstream(file("x.gltf"))
      << R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
         R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[)"
         R"({"byteLength":36,"uri":"x.bin"}]})";
  std::ofstream(file("x.bin"), std::ios::binary)
      << std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0", 36);
  std::filesystem::create_hard_link(file("x.bin"), file("hard.json"));
  std::filesystem::create_symlink("new.json", file("link.json"));
  const std::string buffer = bytes_of(file("x.bin"));
  for (const char* command :
       {"stripify '{0}/x.gltf' -o '{0}/x.bin'", "convert '{0}/x.gltf' -o '{0}/x.bin'",
        "stats '{0}/x.gltf' --json '{0}/hard.json'", "simplify '{0}/x.gltf' -o '{0}/x.bin'",
        "replay '{0}/x.gltf' -o '{0}/x.bin'", "bake '{0}/x.gltf' -o '{0}/b.baked' --json '{0}/hard.json'",
        "draw '{0}/x.gltf' -o '{0}/hard.json'", "paper '{0}/x.gltf' --out '{0}/report' --json '{0}/hard.json'"})
    EXPECT_NE(refusal(fmt::format(fmt::runtime(command), folder_.string())).find("is the input"), std::string::npos)
        << command;
  for (const char* command :
       {"draw -o '{0}/new.json' --json '{0}/new.json'", "draw -o '{0}/new.json' --json '{0}/../{1}/new.json'",
        "draw -o '{0}/new.json' --json '{0}/link.json'",
        "paper '{0}/a.obj' --out '{0}/report' --json '{0}/report/report.json'",
        "replay '{0}/a.pm' --trace /dev/stdout --json -"})
    EXPECT_NE(
        refusal(fmt::format(fmt::runtime(command), folder_.string(), folder_.filename().string())).find("as well"),
        std::string::npos)
        << command;
  EXPECT_EQ(bytes_of(file("x.bin")), buffer);
  EXPECT_FALSE(std::filesystem::exists(file("new.json")));
}

// Pipes have no name: the format is detected from the first bytes, for every readable format, or named by the user.
TEST_F(Meshes, PipesAreReadAndWritten) {
  const std::string folder = folder_.string();
  const auto shell = [&](const std::string& command) {
    return run_command(fmt::format("export restrip='{}'; cd '{}'; {}", RESTRIP_PROGRAM, folder, command));
  };
  ASSERT_EQ(run_program(fmt::format("stripify '{0}/a.obj' -o '{0}/a.glb'", folder)).code, 0);
  for (const char* to : {"off", "ply", "stl"})
    ASSERT_EQ(run_program(fmt::format("convert '{0}/a.obj' -o '{0}/a.{1}'", folder, to)).code, 0);
  const std::string triangles = shell("$restrip stats a.obj --json - | grep '\"triangles\"'").out;
  EXPECT_NE(triangles, "");
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.glb", "a.pm", "a.baked"})
    for (const char* command : {"$restrip stats - --json - < {}", "cat {} | $restrip stats /dev/stdin --json -",
                                "cp {0} bare; $restrip stats bare --json -"}) {
      const Outcome counted = shell(fmt::format(fmt::runtime(command), name) + " | grep '\"triangles\"'");
      EXPECT_EQ(counted.out, triangles) << name << ' ' << command;
    }
  EXPECT_EQ(
      shell("$restrip convert a.obj -o - --to off 2>/dev/null | $restrip convert - -o - --to obj 2>/dev/null").out,
      bytes_of(file("a.obj")));
  EXPECT_EQ(shell("$restrip make-mesh --triangles 500 -o - --to obj 2>/dev/null").out, bytes_of(file("a.obj")));
  EXPECT_EQ(shell("cp a.off a.txt; $restrip convert a.txt --from off -o same --to obj > text && cat same").out,
            bytes_of(file("a.obj")));
  EXPECT_TRUE(shell("$restrip draw a.obj -o - --to svg 2>/dev/null").out.starts_with("<svg"));
  EXPECT_NE(refusal(fmt::format("convert '{}' -o -", file("a.obj"))).find("name it by --to"), std::string::npos);
  EXPECT_NE(refusal(fmt::format("convert '{0}/a.obj' -o '{0}/b.off' --to obj", folder)).find("has the extension"),
            std::string::npos);
}

// Standard output contains only the file written there.
TEST_F(Meshes, TextMakesRoomForAFile) {
  const Outcome piped = run_program(fmt::format("bake '{}' -o -", file("a.pm")));
  EXPECT_EQ(piped.code, 0);
  EXPECT_EQ(piped.out, bytes_of(file("a.baked")));
}

TEST_F(Meshes, AnOutputIsOfItsFormat) {
  for (const auto& [command, out] : std::vector<std::array<const char*, 2>>{
           {"simplify '{0}/a.obj' -o '{0}/{1}'", "b.off"},
           {"convert '{0}/a.obj' -o '{0}/{1}'", "b.xyz"},
           {"bake '{0}/a.pm' -o '{0}/{1}'", "b.pm"},
           {"draw -o '{0}/{1}'", "x.gif"},
           {"make-mesh -o '{0}/{1}'", "x.xyz"},
           {"make-mesh -o '{0}/{1}'", "x"},
           {"replay --built-in --json '{0}/{1}'", "b.baked"},
       }) {
    EXPECT_NE(refusal(fmt::format(fmt::runtime(command), folder_.string(), out)).find("has the extension"),
              std::string::npos)
        << command;
    EXPECT_FALSE(std::filesystem::exists(file(out)));
  }
}

TEST_F(Meshes, OutputsAreTestedBeforeTheWork) {
  // So a bad output is reported even if the input is at fault as well.
  std::filesystem::create_directory(file("folder.pm"));
  for (const auto& [command, complaint] : std::vector<std::array<const char*, 2>>{
           {"simplify '{0}/none.obj' -o '{0}/none/b.pm'", "does not exist; make it first"},
           {"simplify '{0}/none.obj' -o '{0}/folder.pm'", "it is a folder; name a file inside it"},
           {"simplify '{0}/none.obj' -o '{0}/a.pm/b.pm'", "Not a directory"},
           {"bake '{0}/none.pm' -o '{0}/none/b.baked'", "does not exist; make it first"},
           {"draw '{0}/none.obj' -o '{0}/none/draw.json'", "does not exist; make it first"},
           {"replay '{0}/none.obj' --json '{0}/none/b.json'", "does not exist; make it first"},
           {"replay '{0}/none.obj' --json /proc/self/b.json", "name a file in a folder that you may write to"},
           {"paper '{0}/none.obj' --out '{0}/a.obj'", "Not a directory; name a file in a folder"},
           {"paper '{0}/none.obj' --out /proc/self/report", "name a folder that you may write to"},
       })
    EXPECT_NE(refusal(fmt::format(fmt::runtime(command), folder_.string())).find(complaint), std::string::npos)
        << command;
}

TEST_F(Meshes, InputsThatCannotBeReadAreNamed) {
  std::ofstream(file("bad.obj")) << "v 0 0 1e300\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::string unfinished = bytes_of(file("a.pm"));
  const std::uint32_t not_a_number = 0x7FC00000U;
  std::memcpy(unfinished.data() + 20, &not_a_number, 4);
  std::ofstream(file("nan.pm"), std::ios::binary) << unfinished;
  std::filesystem::create_directory(file("folder.obj"));
  std::ofstream(file("what")) << "what is this?\n";
  std::filesystem::create_symlink("/dev/zero", file("zero.xyz"));
  for (const auto& [command, complaint] : std::vector<std::array<const char*, 2>>{
           {"stats '{0}/none.obj'", "none.obj: no such file; check the path"},
           {"stats '{0}/folder.obj'", "folder.obj: is a directory; name a file inside it"},
           {"stats '{0}'", "is a directory"},
           {"stats '{0}/bad.obj'", "vertex 0 has a coordinate that is infinite or not a number; mend or remove it"},
           {"stats '{0}/nan.pm'", "vertex 0 has a coordinate that is infinite or not a number"},
           {"stats '{0}/zero.xyz'", "unknown extension '.xyz'; name the format by --from"},
           {"stats /dev/zero", "larger than 256 MiB"},
           {"stats /dev/null", "the file is empty"},
           {"stats '{0}/what'", "neither its name nor how it begins says what it is; name the format by --from"},
           {"replay '{0}/none.pm'", "none.pm: no such file"},
           {"bake '{0}/none.baked' -o '{0}/b.baked'", "none.baked: no such file"},
           {"paper '{0}/none.obj' --out '{0}/report'", "none.obj: no such file"},
       })
    EXPECT_NE(refusal(fmt::format(fmt::runtime(command), folder_.string())).find(complaint), std::string::npos)
        << command;
  EXPECT_FALSE(std::filesystem::exists(file("report")));  // created by the test of the output, and removed again
}

TEST_F(Meshes, InputWithoutEndIsRefusedWithTheLimit) {
  std::filesystem::create_symlink("/dev/zero", file("zero.obj"));
  EXPECT_NE(refusal(fmt::format("stats '{}'", file("zero.obj"))).find("larger than 256 MiB, the limit"),
            std::string::npos);
  // A line of a gigabyte, and a file of a terabyte: both are sparse and take no room on the disk.
  for (const auto& [name, bytes, limit] : std::vector<std::tuple<const char*, std::uintmax_t, const char*>>{
           {"line.off", std::uintmax_t{65} << 20, "line.off:1: a line of more than 64 MiB, the limit"},
           {"huge.ply", std::uintmax_t{1} << 40, "huge.ply: is larger than 16 GiB, the limit for a file"}}) {
    std::ofstream(file(name)).flush();
    std::filesystem::resize_file(file(name), bytes);
    EXPECT_NE(refusal(fmt::format("stats '{}'", file(name))).find(limit), std::string::npos) << name;
  }
}

TEST_F(Meshes, AFullDiskLeavesTheTargetAlone) {
  std::ofstream(file("old.json")) << "mine";
  std::filesystem::create_symlink("old.json", file("link.json"));
  // The limit on file sizes, at most a kilobyte, simulates a full disk.
  for (const char* name : {"old.json", "link.json"}) {
    const Outcome full =
        run_command(fmt::format("ulimit -f 1; '{}' replay --built-in --triangles 500 --repeats 0 --json '{}' 2>&1",
                                RESTRIP_PROGRAM, file(name)));
    EXPECT_EQ(full.code, 2);
    EXPECT_NE(full.out.find("cannot be written: File too large"), std::string::npos) << full.out;
  }
  EXPECT_EQ(bytes_of(file("old.json")), "mine");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{"a.baked", "a.obj", "a.pm", "link.json", "old.json"}));
}

TEST_F(Meshes, BystandersAndTheNamesOfOldStay) {
  for (const char* name : {"b.pm.part", "b.pm.partial"}) std::ofstream(file(name)) << "mine";
  EXPECT_EQ(run_program(fmt::format("simplify '{}' -o '{}'", file("a.obj"), file("b.pm"))).code, 0);
  EXPECT_EQ(bytes_of(file("b.pm")), bytes_of(file("a.pm")));
  for (const char* name : {"b.pm.part", "b.pm.partial"}) EXPECT_EQ(bytes_of(file(name)), "mine");
}

TEST_F(Meshes, AProgressiveMeshThatDoesNotFitIsNamed) {
  std::string bytes = bytes_of(file("a.pm"));
  bytes.replace(bytes.size() - 4, 4, 4, '\0');
  std::ofstream(file("bad.pm"), std::ios::binary) << bytes;
  for (const char* command :
       {"draw '{0}/bad.pm' -o '{0}/b.svg'", "bake '{0}/bad.pm' -o '{0}/b.baked'", "stats '{0}/bad.pm'",
        "convert '{0}/bad.pm' -o '{0}/b.obj'", "replay '{0}/bad.pm' --policy baked"}) {
    const std::string said = refusal(fmt::format(fmt::runtime(command), folder_.string()));
    EXPECT_NE(said.find("bad.pm: split "), std::string::npos) << said;
  }
}

// A terminal executes some bytes, and a line of a megabyte is unreadable.
TEST_F(Meshes, MessagesArePlainAndShort) {
  std::ofstream(file("bad.ply")) << "ply\nformat \033[2J\u009b1m\377\n";
  std::string name = "\033]0;x\a";
  name.resize(100'000, 'n');
  std::ofstream(file("long.gltf")) << R"({"asset":{"version":"2.0"},"extensionsRequired":[{")" << name << R"(":1}]})";
  std::ofstream(file("long.ply")) << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float " << name
                                  << "\nelement face 1\nproperty list uchar int " << name << "\nend_header\n0\n9\n";
  for (const char* command :
       {"stats '{0}/bad.ply'", "stats '{0}/long.gltf'", "stats '{0}/long.ply'",
        "stats \"$(printf '{0}/\\033[31m.obj')\"", "stats --json \"$(printf '\\033[31m')\" '{0}/a.obj'",
        "stats \"$(printf -- '--\\033[31m')\""}) {
    const Outcome refused = run_program(fmt::format(fmt::runtime(command), folder_.string()), true);
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_LT(refused.out.size(), 2000U) << command;
    for (const char* raw : {"\033", "\a", "\xC2\x9B", "\377"})
      EXPECT_EQ(refused.out.find(raw), std::string::npos) << command;
  }
  EXPECT_NE(refusal(fmt::format("stats '{}'", file("bad.ply"))).find("\\x1b[2J\\xc2\\x9b1m\\xff"), std::string::npos);
}

TEST(Numbers, BadOnesAreNamed) {
  for (const auto& [arguments, named] : std::vector<std::array<const char*, 2>>{
           {"replay --built-in --base nan", "--base"},
           {"replay --built-in --base 2", "2 is not a share of the triangles; give a number above 0 and at most 1"},
           {"replay --built-in --walk -1", "--walk"},
           {"replay --built-in --base -1", "--base"},
           {"replay --built-in --base 1e999", "--base"},
           {"replay --built-in --levels 1e3", "--levels"},
           {"replay --built-in --cycles -1", "--cycles"},
           {"replay --built-in --walk x", "--walk"},
           {"replay --built-in --walk 5 --seed -1", "--seed"},
           {"replay --built-in --policy full --states 0", "--states"},
           {"replay --built-in --triangles 99999999999999999999", "--triangles"},
           {"make-mesh -o x.obj --seed 99999999999999999999", "--seed"},
           {"bake x.pm -o x.baked --effort 0", "--effort"},
       }) {
    const Outcome refused = run_program(arguments, true);
    EXPECT_EQ(refused.code, 2) << arguments;
    EXPECT_NE(refused.out.find(named), std::string::npos) << arguments << '\n' << refused.out;
  }
}

}  // namespace
}  // namespace restrip::tools
