// Startup and shutdown of the verifying programs.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "common/output.hpp"

namespace restrip::verify {

inline constexpr int all_claims_hold = 0;
inline constexpr int some_claim_fails = 1;
inline constexpr int bad_input = 2;

/// The option that every program has.
inline void add_json_option(CLI::App& app, std::string& file) {
  app.add_option("--json", file, "Write the report as JSON to this file; - for standard output, in place of the text");
}

/// Parses the command line and does the work. Returns the exit code of `work`, or bad_input if the command line is
/// malformed, the work throws or its output was not written.
template <class Work>
int exit_code_of(CLI::App& app, int argc, char** argv, const Work& work) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return files::exit_code(app.get_name(), app.exit(error) == 0 ? all_claims_hold : bad_input);
  }
  try {
    return files::exit_code(app.get_name(), work());
  } catch (const std::exception& error) {
    std::fflush(stdout);
    fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
    return bad_input;
  }
}

}  // namespace restrip::verify
