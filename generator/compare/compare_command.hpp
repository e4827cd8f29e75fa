// `restrip-generate compare`: its options, its command line and what it does.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace restrip::generator {

/// A subcommand as it stands on the command line. `run` does it, once the line is parsed, and returns the exit code;
/// bad input is thrown.
struct Subcommand {
  CLI::App* line;
  std::function<int()> run;
};

Subcommand add_compare(CLI::App& app);

}  // namespace restrip::generator
