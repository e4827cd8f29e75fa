// restrip-generate: writes the tables, their certificates, and the dumps that other programs check.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "commands/command.hpp"
#include "common/output.hpp"
#include "common/system_calls.hpp"

using namespace restrip::generator;

int main(int argc, char** argv) {
  restrip::files::ignore_file_size_signal();
  CLI::App app{
      "Writes restrip's rewriting tables by exhaustive search.\n\nExample:\n  restrip-generate tables --out "
      "/tmp/tables\n"};
  app.name("restrip-generate");
  app.require_subcommand(1);
  app.set_version_flag("--version", RESTRIP_VERSION);
  std::vector<Subcommand> subcommands;
  for (const auto add : {add_tables, add_automaton, add_rules, add_dump}) subcommands.push_back(add(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return restrip::files::exit_code(app.get_name(), app.exit(error) == 0 ? 0 : 2);
  }
  try {
    for (const Subcommand& subcommand : subcommands)
      if (subcommand.line->parsed()) subcommand.run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "restrip-generate: {}\n", error.what());
    return 2;
  }
  return restrip::files::exit_code(app.get_name(), 0);
}
