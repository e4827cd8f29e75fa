// Runs the program through the shell and returns exit code and output.
#pragma once

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace restrip::tools {

struct Outcome {
  int code = -1;
  std::string out;
};

/// Standard output of a shell command.
inline Outcome run_command(const std::string& command) {
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> block{};
  while (const std::size_t size = fread(block.data(), 1, block.size(), pipe)) outcome.out.append(block.data(), size);
  outcome.code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

/// Standard output, followed by standard error if `errors`.
inline Outcome run_program(const std::string& arguments, bool errors = false) {
  return run_command(fmt::format("'{}' {} {}", RESTRIP_PROGRAM, arguments, errors ? "2>&1" : "2>/dev/null"));
}

}  // namespace restrip::tools
