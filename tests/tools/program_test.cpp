// Claims: the program behaves as documented: exit codes, JSON keys, files written whole or not at all, working
// examples.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "run_program.hpp"
#include "support/sanitizers.hpp"

namespace restrip::tools {
namespace {

using Program = ProgramFolder;

TEST_F(Program, HelpAndVersion) {
  EXPECT_EQ(run("--version").code, 0);
  EXPECT_TRUE(run("--version").out.starts_with("restrip "));
  for (const char* command :
       {"", "stats", "replay", "simplify", "convert", "make-mesh", "stripify", "bake", "draw", "paper"}) {
    const Outcome help = run(fmt::format("{} --help", command));
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
                                "replay --boundary melt --built-in",
                                "replay --levels 1 --built-in",
                                "replay x.obj --built-in",
                                "stats /no/such/mesh.obj",
                                "replay --policy better --built-in",
                                "replay --states 9 --built-in",
                                "replay --states 9 --policy local --built-in",
                                "replay --tie-break indices --built-in",
                                "replay --policy full --tie-break beauty --built-in",
                                "replay --policy rules --cost indices --built-in",
                                "replay --policy baked --cost indices --built-in",
                                "replay --cost swaps --built-in",
                                "replay --policy quick --tie-break indices --built-in",
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
    EXPECT_EQ(run(arguments).code, 2) << arguments;
}

TEST_F(Program, BadNumbersAreNamed) {
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
           {"make-mesh -o x.obj --triangles -5", "-5"},
           {"make-mesh -o x.obj --seed 99999999999999999999", "--seed"},
           {"bake x.pm -o x.baked --effort 0", "--effort"},
       }) {
    const Outcome refused = run(arguments, true);
    EXPECT_EQ(refused.code, 2) << arguments;
    EXPECT_NE(refused.out.find(named), std::string::npos) << arguments << '\n' << refused.out;
  }
}

TEST_F(Program, FullCircle) {
  expect_done("make-mesh --triangles 2000 -o a.ply");
  const auto stats = report_of("stats a.ply");
  EXPECT_EQ(stats.at("genus"), 1);
  expect_done("simplify a.ply --base 0.1 -o a.pm");
  const Outcome replay =
      run("replay a.pm --policy local --cost strips --repeats 1 --cycles 2 --walk 500 --seed 9 --json -", true);
  EXPECT_EQ(replay.code, 0);
  const auto json = nlohmann::json::parse(replay.out);  // and nothing else on either stream: silent in a pipe
  EXPECT_EQ(json.at("triangles"), stats.at("triangles"));
  EXPECT_EQ(json.at("walk").at("seed"), 9);
  EXPECT_EQ(json.at("cycles").size(), 2U);
}

/// The options of a replay of the built-in mesh.
std::string built_in(std::uint32_t triangles, const char* policy, const char* cost, const char* more = "") {
  return fmt::format("replay --built-in --triangles {} --repeats 0 --policy {} --cost {} {}", test::large(triangles),
                     policy, cost, more);
}

int strips_at_the_end(const nlohmann::json& replay) { return replay.at("levels").back().at("strips").get<int>(); }

TEST_F(Program, LargerSearchesKeepFewerStrips) {
  const auto strips = [&](const char* states) {
    return strips_at_the_end(report_of(built_in(20'000, "quick", "strips", states)));
  };
  const int usual = strips("");
  EXPECT_GT(strips("--states 10"), usual);
  EXPECT_LT(strips("--states 200"), usual);
}

TEST_F(Program, PoliciesKeepLongerStrips) {
  const auto strips_under = [&](const char* policy) {
    return strips_at_the_end(report_of(built_in(6000, policy, "strips", "--cycles 1")));
  };
  const int quick = strips_under("quick");
  EXPECT_LT(5 * quick, strips_under("local"));
  EXPECT_LT(strips_under("full"), quick);
}

TEST_F(Program, ReplaysKeepIndicesFewWhereTheyAreTheCost) {
  const auto indices_per_triangle = [&](const char* policy, const char* cost) {
    const auto json = report_of(built_in(6000, policy, cost));
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
}

TEST_F(Program, StripifyCountsStrips) {
  expect_done("make-mesh --triangles 4000 -o a.off");
  const auto fast = report_of("stripify a.off --cost strips");
  const auto full = report_of("stripify a.off --cost strips --effort full");
  EXPECT_TRUE(fast.at("valid"));
  EXPECT_TRUE(full.at("valid"));
  EXPECT_FALSE(fast.contains("lower_bound_indices")) << "only --bound computes it";
  EXPECT_LT(full.at("strips"), fast.at("strips"));
  EXPECT_LE(full.at("strips"), 2);
  // n triangles, two more indices a strip, one restart between two strips, one for each swap.
  EXPECT_GE(full.at("indices"), 4000);
}

TEST_F(Program, StripifyReportsTheCostOfIndices) {
  expect_done("make-mesh --triangles 2000 -o a.off");
  const auto stripified = [&](const std::string& options) {
    auto json = report_of("stripify a.off --bound " + options);
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

TEST_F(Program, BakedStripsArePlayed) {
  expect_done("make-mesh --triangles 3000 -o a.ply");
  const auto made = report_of("bake a.ply --base 0.1 -o a.baked");
  EXPECT_EQ(made.at("most_strips"), 1);
  EXPECT_EQ(made.at("bytes"), std::filesystem::file_size(file("a.baked")));
  // A baked mesh is played by default; its mesh can also be replayed by the rules, or baked again.
  for (const std::string policy : {"", "--policy baked", "--policy local"}) {
    const auto json = report_of("replay a.baked --repeats 1 " + policy);
    EXPECT_EQ(json.at("triangles"), made.at("triangles"));
    const bool baked = policy != "--policy local";
    EXPECT_EQ(json.contains("baked"), baked);
    EXPECT_EQ(json.at("most_strips") == 1, baked);
    if (!baked) continue;
    EXPECT_EQ(json.at("policy"), "baked");
    EXPECT_EQ(json.at("baked").at("levels_compared"), 2 * json.at("levels").size());
  }
  expect_done("bake a.baked -o b.baked");
  expect_done("stats a.baked");
  expect_done("replay --built-in --triangles 1000 --repeats 0 --policy baked");

  std::filesystem::resize_file(file("a.baked"), std::filesystem::file_size(file("a.baked")) - 1);
  const Outcome truncated = run("replay a.baked", true);
  EXPECT_EQ(truncated.code, 2);
  EXPECT_NE(truncated.out.find("truncated or altered"), std::string::npos);
}

TEST_F(Program, AnOutputThatIsNotAFileIsWrittenTo) {
  put("target", "old");
  std::filesystem::create_symlink(file("target"), file("link.json"));
  expect_done("replay --built-in --triangles 500 --repeats 0 --json link.json");
  EXPECT_TRUE(std::filesystem::is_symlink(file("link.json")));
  EXPECT_TRUE(nlohmann::json::parse(bytes_of(file("target"))).at("valid"));
  // A pipe: the output arrives, and the pipe still exists.
  const Outcome piped = run("replay --built-in --triangles 500 --repeats 0 --json /dev/stdout");
  EXPECT_EQ(piped.code, 0);
  EXPECT_TRUE(piped.out.starts_with("{"));
}

TEST_F(Program, JsonHasItsKeys) {
  expect_done("replay --built-in --triangles 3000 --policy local --cost strips --repeats 1 --json a.json");
  const auto json = nlohmann::json::parse(bytes_of(file("a.json")));
  for (const char* key : {"triangles", "operations", "operations_without_rule", "operations_isolating",
                          "operations_adding_strip", "by_valence", "levels", "ns_per_operation",
                          "ns_per_operation_bare", "valid", "triangles_per_strip", "left_out"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_GE(json.at("levels").size(), 10U);
  for (const char* key : {"triangles", "strips", "isolated", "indices"})
    EXPECT_TRUE(json.at("levels").at(0).contains(key)) << key;
  EXPECT_TRUE(json.at("valid").get<bool>());
}

/// A mesh in three formats.
class Meshes : public ProgramFolder {
 protected:
  void SetUp() override {
    ProgramFolder::SetUp();
    expect_done("make-mesh --triangles 500 -o a.obj");
    expect_done("simplify a.obj -o a.pm");
    expect_done("bake a.pm -o a.baked");
  }

  /// A refused command: exit code 2 and one line, which says this.
  void expect_refused(const std::string& arguments, const char* said) const {
    const Outcome refused = run(arguments, true);
    EXPECT_EQ(refused.code, 2) << arguments << '\n' << refused.out;
    EXPECT_EQ(refused.out.find('\n'), refused.out.size() - 1) << refused.out;
    EXPECT_NE(refused.out.find(said), std::string::npos) << arguments << '\n' << refused.out;
  }
  void expect_refused(const std::vector<std::array<const char*, 2>>& commands) const {
    for (const auto& [arguments, said] : commands) expect_refused(arguments, said);
  }
};

TEST_F(Meshes, SimplifyingWhatIsProgressiveIsRefused) {
  for (const char* arguments : {"replay {} --base 0.5", "replay {} --boundary lock", "bake {} --base 0.5 -o b.baked"})
    for (const char* name : {"a.pm", "a.baked"})
      expect_refused(fmt::format(fmt::runtime(arguments), name), "--base and --boundary do not apply");
}

// Where a mesh is expected, a progressive or baked one stands for its finest level.
TEST_F(Meshes, LevelsAreReadWhereverAMeshIs) {
  for (const char* arguments : {"stats {}", "stripify {} -o out.ply", "convert {} -o out.ply",
                                "simplify {} --base 0.5 -o out.ply", "stats {} --weld"}) {
    const auto triangles = [&](const char* name) {
      return report_of(fmt::format(fmt::runtime(arguments), name)).at("triangles").get<std::size_t>();
    };
    const std::size_t wanted = triangles("a.obj");
    for (const char* name : {"a.pm", "a.baked"}) EXPECT_EQ(triangles(name), wanted) << arguments << name;
  }
  EXPECT_NE(run("stats a.pm").out.find("a.pm (its finest level)"), std::string::npos);
}

TEST_F(Meshes, AnInputIsNeverAnOutput) {
  std::filesystem::create_symlink("a.obj", file("link.pm"));
  std::filesystem::create_hard_link(file("a.obj"), file("hard.svg"));
  std::filesystem::create_hard_link(file("a.pm"), file("hard.baked"));
  std::filesystem::create_hard_link(file("a.obj"), file("hard.json"));
  std::filesystem::create_directory(file("report"));
  std::filesystem::create_hard_link(file("a.obj"), folder_ / "report" / "strips.csv");
  const auto before = contents_of(folder_);
  for (const char* command : {"simplify a.obj -o a.obj", "simplify a.obj -o link.pm", "bake a.pm -o hard.baked",
                              "bake a.baked -o \"$PWD/a.baked\"", "draw a.obj -o hard.json", "draw a.obj -o hard.svg",
                              "replay a.obj --json hard.json", "paper a.obj --out report"})
    expect_refused(command, "is the input");
  EXPECT_EQ(contents_of(folder_), before);
}

// For every subcommand: no output is another output, nor a file that the input names.
TEST_F(Meshes, NoFileIsWrittenTwice) {
  put("x.gltf",
      R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,)"
      R"("componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[)"
      R"({"byteLength":36,"uri":"x.bin"}]})");
  put("x.bin", std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0", 36));
  std::filesystem::create_hard_link(file("x.bin"), file("hard.json"));
  std::filesystem::create_symlink("new.json", file("link.json"));
  const std::string buffer = bytes_of(file("x.bin"));
  for (const char* command :
       {"stripify x.gltf -o x.bin", "convert x.gltf -o x.bin", "stats x.gltf --json hard.json",
        "simplify x.gltf -o x.bin", "replay x.gltf -o x.bin", "bake x.gltf -o b.baked --json hard.json",
        "draw x.gltf -o hard.json", "paper x.gltf --out report --json hard.json"})
    expect_refused(command, "is the input");
  for (const char* command : {"draw -o new.json --json new.json", "draw -o new.json --json \"../${PWD##*/}/new.json\"",
                              "draw -o new.json --json link.json", "paper a.obj --out report --json report/report.json",
                              "replay a.pm --trace /dev/stdout --json -"})
    expect_refused(command, "as well");
  EXPECT_EQ(bytes_of(file("x.bin")), buffer);
  EXPECT_FALSE(std::filesystem::exists(file("new.json")));
}

// Pipes have no name: the format is detected from the first bytes, for every readable format, or named by the user.
TEST_F(Meshes, PipesAreReadAndWritten) {
  expect_done("stripify a.obj -o a.glb");
  for (const char* to : {"off", "ply", "stl"}) expect_done(fmt::format("convert a.obj -o a.{}", to));
  const std::string triangles = shell("$restrip stats a.obj --json - | grep '\"triangles\"'").out;
  EXPECT_NE(triangles, "");
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.glb", "a.pm", "a.baked"})
    for (const char* command : {"$restrip stats - --json - < {}", "cat {} | $restrip stats /dev/stdin --json -",
                                "cp {0} bare; $restrip stats bare --json -"}) {
      const Outcome counted = shell(fmt::format(fmt::runtime(command), name) + " | grep '\"triangles\"'");
      EXPECT_EQ(counted.out, triangles) << name << ' ' << command;
    }
  const std::string obj = bytes_of(file("a.obj"));
  for (const char* command :
       {"$restrip convert a.obj -o - --to off 2>/dev/null | $restrip convert - -o - --to obj 2>/dev/null",
        "$restrip make-mesh --triangles 500 -o - --to obj 2>/dev/null",
        "cp a.off a.txt; $restrip convert a.txt --from off -o same --to obj > text && cat same"})
    EXPECT_EQ(shell(command).out, obj) << command;
  EXPECT_TRUE(run("draw a.obj -o - --to svg").out.starts_with("<svg"));
  // Standard output contains only the file written there.
  const Outcome piped = run("bake a.pm -o -");
  EXPECT_EQ(piped.code, 0);
  EXPECT_EQ(piped.out, bytes_of(file("a.baked")));
  expect_refused("convert a.obj -o -", "name it by --to");
  expect_refused("convert a.obj -o b.off --to obj", "has the extension");
}

TEST_F(Meshes, AnOutputIsOfItsFormat) {
  for (const auto& [command, out] : std::vector<std::array<const char*, 2>>{{"simplify a.obj -o", "b.off"},
                                                                            {"convert a.obj -o", "b.xyz"},
                                                                            {"bake a.pm -o", "b.pm"},
                                                                            {"draw -o", "x.gif"},
                                                                            {"make-mesh -o", "x.xyz"},
                                                                            {"make-mesh -o", "x"},
                                                                            {"replay --built-in --json", "b.baked"}}) {
    expect_refused(fmt::format("{} {}", command, out), "has the extension");
    EXPECT_FALSE(std::filesystem::exists(file(out)));
  }
}

TEST_F(Meshes, OutputsAreTestedBeforeTheWork) {
  // So a bad output is reported even if the input is at fault as well.
  std::filesystem::create_directory(file("folder.pm"));
  expect_refused({
      {"simplify none.obj -o none/b.pm", "does not exist; make it first"},
      {"simplify none.obj -o folder.pm", "it is a folder; name a file inside it"},
      {"simplify none.obj -o a.pm/b.pm", "Not a directory"},
      {"bake none.pm -o none/b.baked", "does not exist; make it first"},
      {"draw none.obj -o none/draw.json", "does not exist; make it first"},
      {"replay none.obj --json none/b.json", "does not exist; make it first"},
      {"replay none.obj --json /proc/self/b.json", "name a file in a folder that you may write to"},
      {"paper none.obj --out a.obj", "Not a directory; name a file in a folder"},
      {"paper none.obj --out /proc/self/report", "name a folder that you may write to"},
  });
}

TEST_F(Meshes, InputsThatCannotBeReadAreNamed) {
  put("bad.obj", "v 0 0 1e300\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::string unfinished = bytes_of(file("a.pm"));
  const std::uint32_t not_a_number = 0x7FC00000U;
  std::memcpy(unfinished.data() + 20, &not_a_number, 4);
  put("nan.pm", unfinished);
  std::filesystem::create_directory(file("folder.obj"));
  put("what", "what is this?\n");
  for (const char* name : {"zero.xyz", "zero.obj"}) std::filesystem::create_symlink("/dev/zero", file(name));
  // A line of a gigabyte, and a file of a terabyte: both are sparse and take no room on the disk.
  for (const auto& [name, bytes] :
       {std::pair{"line.off", std::uintmax_t{65} << 20}, {"huge.ply", std::uintmax_t{1} << 40}}) {
    put(name, "");
    std::filesystem::resize_file(file(name), bytes);
  }
  expect_refused({
      {"stats none.obj", "none.obj: no such file; check the path"},
      {"stats folder.obj", "folder.obj: is a directory; name a file inside it"},
      {"stats \"$PWD\"", "is a directory"},
      {"stats bad.obj", "vertex 0 has a coordinate that is infinite or not a number; mend or remove it"},
      {"stats nan.pm", "vertex 0 has a coordinate that is infinite or not a number"},
      {"stats zero.xyz", "unknown extension '.xyz'; name the format by --from"},
      {"stats zero.obj", "larger than 256 MiB, the limit"},
      {"stats /dev/zero", "larger than 256 MiB"},
      {"stats /dev/null", "the file is empty"},
      {"stats what", "neither its name nor how it begins says what it is; name the format by --from"},
      {"stats line.off", "line.off:1: a line of more than 64 MiB, the limit"},
      {"stats huge.ply", "huge.ply: is larger than 16 GiB, the limit for a file"},
      {"replay none.pm", "none.pm: no such file"},
      {"bake none.baked -o b.baked", "none.baked: no such file"},
      {"paper none.obj --out report", "none.obj: no such file"},
  });
  EXPECT_FALSE(std::filesystem::exists(file("report")));  // created by the test of the output, and removed again
}

TEST_F(Meshes, AFullDiskLeavesTheTargetAlone) {
  put("old.json", "mine");
  std::filesystem::create_symlink("old.json", file("link.json"));
  const auto before = contents_of(folder_);
  // The limit on file sizes, at most a kilobyte, simulates a full disk.
  for (const char* name : {"old.json", "link.json"}) {
    const Outcome full =
        shell(fmt::format("ulimit -f 1; $restrip replay --built-in --triangles 500 --repeats 0 --json {} 2>&1", name));
    EXPECT_EQ(full.code, 2);
    EXPECT_NE(full.out.find("cannot be written: File too large"), std::string::npos) << full.out;
  }
  EXPECT_EQ(contents_of(folder_), before);
}

TEST_F(Meshes, AProgressiveMeshThatDoesNotFitIsNamed) {
  std::string bytes = bytes_of(file("a.pm"));
  bytes.replace(bytes.size() - 4, 4, 4, '\0');
  put("bad.pm", bytes);
  for (const char* command : {"draw bad.pm -o b.svg", "bake bad.pm -o b.baked", "stats bad.pm",
                              "convert bad.pm -o b.obj", "replay bad.pm --policy baked"})
    expect_refused(command, "bad.pm: split ");
  const Outcome replay = run("replay bad.pm");
  EXPECT_EQ(replay.code, 1);
  EXPECT_NE(replay.out.find("FAULT"), std::string::npos);
}

// A terminal executes some bytes, and a line of a megabyte is unreadable.
TEST_F(Meshes, MessagesArePlainAndShort) {
  put("bad.ply", "ply\nformat \033[2J\u009b1m\377\n");
  std::string name = "\033]0;x\a";
  name.resize(100'000, 'n');
  put("long.gltf", fmt::format(R"({{"asset":{{"version":"2.0"}},"extensionsRequired":[{{"{}":1}}]}})", name));
  put("long.ply", fmt::format("ply\nformat ascii 1.0\nelement vertex 1\nproperty float {0}\nelement face 1\n"
                              "property list uchar int {0}\nend_header\n0\n9\n",
                              name));
  for (const char* command :
       {"stats bad.ply", "stats long.gltf", "stats long.ply", "stats \"$(printf '\\033[31m.obj')\"",
        "stats --json \"$(printf '\\033[31m')\" a.obj", "stats \"$(printf -- '--\\033[31m')\""}) {
    const Outcome refused = run(command, true);
    EXPECT_EQ(refused.code, 2) << command;
    EXPECT_LT(refused.out.size(), 2000U) << command;
    for (const char* raw : {"\033", "\a", "\xC2\x9B", "\377"})
      EXPECT_EQ(refused.out.find(raw), std::string::npos) << command;
  }
  expect_refused("stats bad.ply", "\\x1b[2J\\xc2\\x9b1m\\xff");
}

}  // namespace
}  // namespace restrip::tools
