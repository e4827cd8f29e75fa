// The subcommands of restrip-generate, each with its options, its help and what it does: tables_command.cpp writes
// tables, rules and the automaton, dump_command.cpp prints rules. And what several of them share.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <set>
#include <string>

#include "emit/emit.hpp"

namespace restrip::generator {

/// A subcommand of the command line. `run` does its work after parsing; it tests its outputs before the work, reports
/// on standard output and throws std::exception with place and remedy.
struct Subcommand {
  CLI::App* line;
  std::function<void()> run;
};

Subcommand add_tables(CLI::App& app);
Subcommand add_automaton(CLI::App& app);
Subcommand add_rules(CLI::App& app);
Subcommand add_dump(CLI::App& app);

/// Adds the destination of the report as JSON.
inline CLI::Option* add_json_option(CLI::App& command, std::string& file) {
  return command.add_option("--json", file,
                            "Write the report as JSON to this file; - for standard output, in place of the text");
}

/// Adds the languages; `of_cpp` says what is written in C++, `in_others` in other languages.
inline CLI::Option* add_language_option(CLI::App& command, std::set<std::string>& languages, const char* of_cpp,
                                        const char* in_others) {
  return command
      .add_option("--language", languages,
                  fmt::format("c++ (the default: {}), c, rust, json, glsl or wgsl: {} and look-up; several "
                              "separated by commas",
                              of_cpp, in_others))
      ->delimiter(',')
      ->check(CLI::IsMember(language_files()))
      ->allow_extra_args(false);
}

}  // namespace restrip::generator
