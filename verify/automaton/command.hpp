// The subcommand `automaton` of restrip-verify: it proves the certificate of an automaton, for fans of any valence, and
// uses only docs/reference/notation.md and docs/explanation/automaton.md.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace restrip::verify {

/// As add_explain().
std::function<int()> add_automaton(CLI::App& app);

}  // namespace restrip::verify
