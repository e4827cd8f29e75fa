#pragma once
// The option that every command with a report has.

#include <CLI/CLI.hpp>
#include <string>

namespace restrip::generator {

inline CLI::Option* add_json_option(CLI::App& command, std::string& file) {
  return command.add_option("--json", file,
                            "Write the report as JSON to this file; - for standard output, in place of the text");
}

}  // namespace restrip::generator
