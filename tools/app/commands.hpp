// The subcommands of `restrip`, one file each: NAME_command.cpp has its options, its command line and what it does.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace restrip::tools {

/// A subcommand as it stands on the command line. `run` does it, once the line is parsed, and returns the exit code: 0,
/// or 1 when a check failed or simplify stopped short; bad input is thrown (BadInput).
struct Subcommand {
  CLI::App* line;
  std::function<int()> run;
};

Subcommand add_stats(CLI::App& app);
Subcommand add_replay(CLI::App& app);
Subcommand add_simplify(CLI::App& app);
Subcommand add_convert(CLI::App& app);
Subcommand add_stripify(CLI::App& app);
Subcommand add_draw(CLI::App& app);
Subcommand add_paper(CLI::App& app);
Subcommand add_bake(CLI::App& app);
Subcommand add_make_mesh(CLI::App& app);

}  // namespace restrip::tools
