// The subcommands of `restrip`, one file each: NAME_command.cpp has its options, its command line and what it does.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace restrip::tools {

/// A subcommand of the command line. `run` executes it after parsing and returns the exit code: 0, or 1 if a check
/// failed or simplify stopped short. It throws BadInput on bad input.
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
