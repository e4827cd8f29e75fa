// restrip: inspects a mesh, simplifies it, and replays its levels of detail while the rules keep its strips.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "app/options.hpp"
#include "common/counted.hpp"
#include "common/output.hpp"
#include "common/printable.hpp"
#include "common/reading.hpp"
#include "common/system_calls.hpp"
#include "meshes/soup_builder.hpp"

namespace {

using namespace restrip::tools;

constexpr int exit_bad_input = 2;

int run_command_line(int argc, char** argv) {
  CLI::App app{"Maintains triangle strips while a mesh changes, by proven rules", "restrip"};
  app.set_version_flag("--version", std::string("restrip ") + RESTRIP_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<PlainFormatter>());
  constexpr restrip::files::ReadLimits limits;
  app.footer(fmt::format(
      "Exit codes: 0 success, 1 a check failed or simplify stopped short, 2 the input or the command line is at "
      "fault.\n"
      "Limits: files of {}, pipes and devices of {}, lines of text of {}.\n"
      "Output files are written whole or not at all. Their names end in the extension of the format; inputs are not "
      "overwritten.\n"
      "Example: restrip replay --built-in",
      restrip::size_in_words(limits.regular), restrip::size_in_words(limits.endless),
      restrip::size_in_words(longest_line)));
  std::vector<Subcommand> subcommands;
  for (const auto add :
       {add_stats, add_replay, add_simplify, add_convert, add_stripify, add_draw, add_paper, add_bake, add_make_mesh})
    subcommands.push_back(add(app));
  for (const Subcommand& subcommand : subcommands)
    subcommand.line->set_version_flag("--version", app.version())->description("print the version and exit");
  if (const std::string wrong = argc < 2 ? "" : wrong_subcommand(app, argv[1]); !wrong.empty()) throw BadInput(wrong);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream complaint;
    const int code = app.exit(error, std::cout, complaint);
    if (!complaint.str().empty()) fmt::print(stderr, "{}\n", restrip::files::printable_message(complaint.str()));
    return code == 0 ? 0 : exit_bad_input;
  }
  for (const Subcommand& subcommand : subcommands)
    if (subcommand.line->parsed()) return subcommand.run();
  return exit_bad_input;  // CLI11 requires a return value
}

}  // namespace

int main(int argc, char** argv) {
  restrip::files::ignore_file_size_signal();
  try {
    return restrip::files::exit_code("restrip", run_command_line(argc, argv));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "restrip: not enough memory for a mesh of this size\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "restrip: {}\n", restrip::files::printable_message(error.what()));
  }
  return exit_bad_input;
}
