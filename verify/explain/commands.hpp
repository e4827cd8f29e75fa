// The subcommands `explain` and `rules` of restrip-verify.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace restrip::verify {

/// They return what does the work of the subcommand, if it was given, and returns the exit code. That throws
/// files::FileError and std::invalid_argument.
std::function<int()> add_explain(CLI::App& app);
std::function<int()> add_rules(CLI::App& app);

}  // namespace restrip::verify
