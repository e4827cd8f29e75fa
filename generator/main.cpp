// restrip-generate: writes the tables, their certificates, and the dumps that other programs check.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "automaton/served.hpp"
#include "common/report_output.hpp"
#include "common/system_calls.hpp"
#include "languages/languages.hpp"
#include "operations/description_file.hpp"
#include "operations/operation_words.hpp"
#include "operations/write.hpp"
#include "tables/count.hpp"
#include "tables/dump.hpp"
#include "tables/table_files.hpp"

using namespace restrip::generator;

namespace {

/// The option of every command with a report.
CLI::Option* add_json_option(CLI::App& command, std::string& file) {
  return command.add_option("--json", file,
                            "Write the report as JSON to this file; - for standard output, in place of the text");
}

/// Adds the option of the languages; `of_cpp` says what is written in C++, `in_others` in other languages.
CLI::Option* add_language_option(CLI::App& command, std::set<std::string>& languages, const char* of_cpp,
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

/// The position given by the options --k, --at and --to.
Position position_of(const Description& family, PositionNumbers numbers,
                     const std::array<const CLI::Option*, 3>& given) {
  constexpr std::array<const char*, 3> options{"--k", "--at", "--to"};
  std::vector<std::string> expected;
  for (std::size_t i = 0; i < options.size(); ++i)
    if (i < family.numbers.size())
      expected.push_back(fmt::format("{} by {}", family.numbers[i], options.at(i)));
    else if (!given.at(i)->empty())
      throw std::invalid_argument(
          fmt::format("--family {}: its positions do not depend on {}; leave it out", family.name, options.at(i)));
  if (family.numbers.empty()) return positions(family, 0).at(0);
  if (!hold(family.where, numbers))
    throw std::invalid_argument(
        fmt::format("--family {}: expected {}; {}", family.name, family.range, fmt::join(expected, ", ")));
  for (std::size_t i = family.numbers.size(); i < numbers.size(); ++i) numbers.at(i) = 0;
  return {&family, numbers[0], numbers[1], numbers[2]};
}

}  // namespace

int main(int argc, char** argv) {
  restrip::files::ignore_file_size_signal();
  CLI::App app{
      "Writes restrip's rewriting tables by exhaustive search.\n\nExample:\n  restrip-generate tables --out "
      "/tmp/tables\n"};
  app.name("restrip-generate");
  app.require_subcommand(1);
  app.set_version_flag("--version", RESTRIP_VERSION);

  TablesOptions tables;
  auto* tables_command = app.add_subcommand(
      "tables", "Write constexpr headers, certificates and MANIFEST, or the rules in another language");
  tables_command->add_option("--out", tables.out, "Output directory")->required();
  tables_command->add_option("--max-k", tables.max_k, "Largest valence")
      ->check(CLI::Range(3, 13))
      ->capture_default_str();
  tables_command
      ->add_option("--threads", tables.threads,
                   "Threads, 0: one for each processor; the bytes written do not depend on it")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  add_language_option(*tables_command, tables.languages, "headers, certificates and MANIFEST", "data");
  add_json_option(*tables_command, tables.json);
  tables_command->footer(
      "\nExample, restrip_tables.h and restrip_tables.json:\n"
      "  restrip-generate tables --language c,json --out /tmp/tables\n");

  AutomatonOptions automaton;
  auto* automaton_command =
      app.add_subcommand("automaton", "Write the automaton that answers fans of every valence, and its certificate");
  automaton_command->add_option("--out", automaton.out, "Output directory")->required();
  std::vector<std::string> served;
  auto* served_option = automaton_command->add_option(
      "--operation", served,
      "Write the look-up of custom families (operation files) that the shipped automaton answers, instead");
  add_language_option(*automaton_command, automaton.languages, "header and certificate", "data")
      ->excludes(served_option);
  add_json_option(*automaton_command, automaton.json)->excludes(served_option);
  automaton_command
      ->add_option("--classes", automaton.classes,
                   "Write every class with a best colouring of each case to this JSON file, for pictures")
      ->excludes(served_option);
  automaton_command->footer(
      "\nExamples:\n"
      "  restrip-generate automaton --out /tmp/automaton\n"
      "  restrip-generate automaton --language c,rust --out /tmp/automaton\n"
      "  restrip-generate automaton --operation my-family.json --out /tmp/automaton\n");

  RulesOptions rules;
  auto* rules_command = app.add_subcommand("rules",
                                           "Write the table and the certificate of custom operations (operation "
                                           "files), or the table in another language");
  rules_command
      ->add_option("--operation", rules.files, "Operation file, as docs/reference/operation-file.md describes it")
      ->required();
  rules_command->add_option("--out", rules.out, "Output directory")->required();
  rules_command
      ->add_option("--max-k", rules.max_k, "Families: positions whose first number is at most this, by default 8")
      ->check(CLI::Range(3, 10));
  add_language_option(*rules_command, rules.languages, "header and certificate", "table");
  add_json_option(*rules_command, rules.json);
  rules_command->footer(
      "\nExamples, from the top of the source tree; the second writes restrip_rule_of_bisect.h and "
      "restrip_rule_of_bisect.rs:\n"
      "  restrip-generate rules --operation tables/operations/bisect.json --out /tmp/rules\n"
      "  restrip-generate rules --operation tables/operations/bisect.json --language c,rust --out "
      "/tmp/rules\n");

  std::string family = "split";
  unsigned k = 0;
  auto* dump_command = app.add_subcommand("dump", "Print every rule as CSV, one row for each valid configuration");
  dump_command->footer("Columns:\n" + dump_columns() +
                       "  others             their numbers, then inner,ports,inner_after,strips,isolated; ports_after "
                       "before strips\n                     if ports may be given up\n"
                       "\nExamples, from the top of the source tree:\n  restrip-generate dump --family split --k 4\n"
                       "  restrip-generate dump --operation tables/operations/bisect.json\n");
  std::vector<std::string> names;
  for (const Description& one : families()) names.push_back(one.name);
  dump_command->add_option("--family", family, fmt::format("One of {}", fmt::join(names, ", ")))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  auto* k_option =
      dump_command->add_option("--k", k, "Valence: 3 … 13 (open families: 1 … 13)")->check(CLI::Range(1, 13));
  std::string dumped;
  std::optional<unsigned> dumped_max_k;
  auto* dumped_option =
      dump_command->add_option("--operation", dumped, "Instead, a custom operation or family: its file")
          ->excludes("--family")
          ->excludes("--k");
  dump_command->add_option("--max-k", dumped_max_k, "Of its family: the largest first number; default 8")
      ->check(CLI::Range(3, 10))
      ->needs(dumped_option);

  PositionNumbers numbers{};
  std::string described_family = "split";
  auto* describe_command =
      app.add_subcommand("describe", "Print the operation file of a family at one position, to start from");
  describe_command->add_option("--family", described_family, fmt::format("One of {}", fmt::join(names, ", ")))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  const std::array<const CLI::Option*, 3> place_options{
      describe_command->add_option("--k", numbers[0], "Valence, 1 … 8; not for the flip")->check(CLI::Range(1, 8)),
      describe_command->add_option("--at", numbers[1], "Arc a of a closed fan, gap i of an open one")
          ->check(CLI::Range(0, 8)),
      describe_command->add_option("--to", numbers[2], "Gap j of an open fan")->check(CLI::Range(0, 8))};
  std::string described_constraint = "strips";
  describe_command
      ->add_option("--constraint", described_constraint,
                   "strips, matching (triangles in pairs) or forest; except for strips, the file names no cost and so "
                   "has the default")
      ->check(CLI::IsMember(std::vector<std::string>(constraint_words.begin(), constraint_words.end())))
      ->capture_default_str();
  describe_command->footer(
      "\nExamples:\n"
      "  restrip-generate describe --family split --k 4 --at 2 > split.json\n"
      "  restrip-generate describe --family collapse --k 6 --at 3 --constraint matching > pairs.json\n");

  unsigned count_max_k = 8;
  std::string count_to;
  auto* count_command = app.add_subcommand("count", "Count configurations and orbits, next to the paper's figures");
  count_command->add_option("--max-k", count_max_k, "Largest valence")->check(CLI::Range(3, 12))->capture_default_str();
  add_json_option(*count_command, count_to);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return restrip::files::exit_code(app.get_name(), app.exit(error) == 0 ? 0 : 2);
  }
  try {
    if (tables.threads == 0) tables.threads = std::max(1U, std::thread::hardware_concurrency());
    if (*tables_command) make_tables(tables);
    if (*automaton_command)
      served.empty() ? make_automaton_files(automaton) : make_served_headers(served, automaton.out);
    if (*rules_command) make_rules(rules);
    if (*dump_command && !dumped.empty()) {
      dump_rules(dumped, dumped_max_k, stdout);
    } else if (*dump_command) {
      const Description& chosen = family_named(family);
      if (chosen.numbers.empty() && !k_option->empty())
        throw std::invalid_argument(fmt::format("--family {}: it has one position, without --k", family));
      if (!chosen.numbers.empty() && (k_option->empty() || k < smallest_valence(chosen)))
        throw std::invalid_argument(fmt::format("--family {} needs --k {} or more", family, smallest_valence(chosen)));
      dump(chosen, k, stdout);
    }
    if (*describe_command) {
      const auto word = std::find(constraint_words.begin(), constraint_words.end(), described_constraint);
      const Constraint constraint{static_cast<unsigned>(word - constraint_words.begin()) + 1};
      fmt::print("{}",
                 operation_file_text(position_of(family_named(described_family), numbers, place_options), constraint));
    }
    if (*count_command) {
      const restrip::files::ReportOutput out(count_to);
      const CountReport report = count(count_max_k);
      out.print(report.text, report.json);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "restrip-generate: {}\n", error.what());
    return 2;
  }
  return restrip::files::exit_code(app.get_name(), 0);
}
