// The subcommands of restrip-generate, one file each: NAME_command.cpp has its options, its help and what it does. And
// what several of them share.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

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
CLI::Option* add_json_option(CLI::App& command, std::string& file);

/// Adds the languages; `of_cpp` says what is written in C++, `in_others` in other languages.
CLI::Option* add_language_option(CLI::App& command, std::set<std::string>& languages, const char* of_cpp,
                                 const char* in_others);

/// Adds the name of a shipped family.
CLI::Option* add_family_option(CLI::App& command, std::string& family);

/// A folder for files that are known before the work.
class OutputFolder {
 public:
  /// Tests the files. Throws files::FileError; none may be one of the inputs.
  OutputFolder(const std::string& folder, const std::vector<std::filesystem::path>& names,
               const std::vector<std::string>& inputs = {});

  /// Writes the files, except those that are there with these bytes, so that nothing is compiled again because of them.
  void write(std::vector<files::NamedBytes> files);

 private:
  std::filesystem::path folder_;
  files::OutputSet out_;
};

}  // namespace restrip::generator
