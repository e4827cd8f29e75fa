// Runs the program through the shell, in the folder of a test, and returns exit code and output.
#pragma once

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "scratch_folder.hpp"

namespace restrip::tools {

struct Outcome {
  int code = -1;
  std::string out;
};

class ProgramFolder : public ScratchFolder {
 protected:
  /// Standard output of a shell command; $restrip is the program.
  [[nodiscard]] Outcome shell(const std::string& command) const {
    const std::string inside = fmt::format("restrip='{}'; cd '{}'; {}", RESTRIP_PROGRAM, folder_.string(), command);
    Outcome outcome;
    FILE* pipe = popen(inside.c_str(), "r");
    std::array<char, 4096> block{};
    while (const std::size_t size = fread(block.data(), 1, block.size(), pipe)) outcome.out.append(block.data(), size);
    outcome.code = WEXITSTATUS(pclose(pipe));
    return outcome;
  }

  /// Standard output of the program, followed by standard error if `errors`.
  [[nodiscard]] Outcome run(const std::string& arguments, bool errors = false) const {
    return shell(fmt::format("\"$restrip\" {} {}", arguments, errors ? "2>&1" : "2>/dev/null"));
  }

  void expect_done(const std::string& arguments) const { ASSERT_EQ(run(arguments).code, 0) << arguments; }

  /// What a command reports by --json.
  [[nodiscard]] nlohmann::json report_of(const std::string& arguments) const {
    const Outcome outcome = run(arguments + " --json -");
    EXPECT_EQ(outcome.code, 0) << arguments;
    return nlohmann::json::parse(outcome.out);
  }
};

}  // namespace restrip::tools
