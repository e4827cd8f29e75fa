#include "explain/commands.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "common/output.hpp"
#include "explain/explanation.hpp"
#include "explain/rule_set.hpp"
#include "judge/report.hpp"
#include "model/input.hpp"
#include "model/program.hpp"

namespace restrip::verify {
namespace {

Mask mask_of(const std::string& option, const std::string& text, unsigned bits) {
  std::uint64_t value = 0;
  const bool is_hexadecimal = text.starts_with("0x");
  const char* const begin = text.data() + (is_hexadecimal ? 2 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value, is_hexadecimal ? 16 : 10);
  if (error != std::errc() || end != text.data() + text.size() || value >= wide_mask_count(bits))
    throw std::invalid_argument(fmt::format(
        "{} {}: expected a mask of at most {} bits, decimal as in dumps or hexadecimal after 0x", option, text, bits));
  return static_cast<Mask>(value);
}

/// The shipped descriptions, or the descriptions in a file.
std::vector<Description> descriptions_of(const std::string& file) {
  return file.empty() ? shipped_descriptions() : parse_descriptions(file, read_file(file));
}

/// The one of this name; without a name the only one.
Description named(const std::vector<Description>& all, const std::string& name) {
  std::string names;
  for (const Description& one : all) {
    if (one.name == name || (name.empty() && all.size() == 1)) return one;
    names += ' ' + one.name;
  }
  throw std::invalid_argument(fmt::format("--family {}: expected one of{}", name, names));
}

struct ExplainOptions {
  std::string family, operation, before, ports, after, ports_after, json;
  unsigned k = 0;
  Numbers at;
};

int explain(const CLI::App& command, const ExplainOptions& given) {
  const files::ReportOutput out(given.json, {given.operation});
  const Description description = named(descriptions_of(given.operation), given.family);
  Numbers numbers = given.at;
  if (command.count("--k") != 0) numbers.insert(numbers.begin(), given.k);
  const Operation operation = operation_at(description, numbers);
  const Colors configuration{mask_of("--before", given.before, operation.before.inner_edges()),
                             mask_of("--ports", given.ports, operation.ports())};
  const Definition definition(operation);
  if (!definition.valid(configuration))
    throw std::invalid_argument(
        fmt::format("not a valid configuration: {}",
                    invalid_because(operation.before, configuration, most_solid(operation.constraint))));
  std::optional<Judgement> judged;
  if (!given.after.empty()) {
    const Colors recoloring{mask_of("--after", given.after, operation.after.inner_edges()),
                            given.ports_after.empty() ? configuration.ports
                                                      : mask_of("--ports-after", given.ports_after, operation.ports())};
    judged = judgement_of(definition, configuration, recoloring);
  }
  const Explanation explanation = explanation_of(definition, configuration);
  out.print(text_of(definition, explanation, judged), text_of(json_of(definition, explanation, judged)));
  return !judged || judged->standing >= Standing::equally_good ? all_claims_hold : some_claim_fails;
}

struct RulesOptions {
  std::string file, family, operation, json;
  std::size_t worst = 10;
  unsigned threads = 2;
};

}  // namespace

std::function<int()> add_explain(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "explain", "One configuration: the best recolouring, why nothing is better, or what is wrong with another");
  command->footer(
      "Masks are numbered as in docs/reference/notation.md and decimal, as `restrip-generate dump` prints them;\n"
      "0x begins a hexadecimal one, as in certificates.\n"
      "Verdicts:\n"
      "  not valid     a triangle has too many solid edges, the patch has a cycle, or a port changed that may not\n"
      "  unsound       not valid in the world named, in which the configuration is valid; no such world has\n"
      "                fewer connections\n"
      "  worse         sound, and costs more than the best\n"
      "  equally good  costs the same as the best, of which the one with the smallest mask is shown; the rule of a\n"
      "                table is any of them (docs/reference/tables.md, \"Tie-break\")\n"
      "  best          the one shown\n"
      "t0=A is a solid edge, t0-A a dashed one.\n\n"
      "Exit code: 0 if there is no recolouring to judge or it is as good as the best, 1 if it is not, 2 bad input.\n\n"
      "Example:\n"
      "  restrip-verify explain --family split --k 5 --at 2 --before 26 --ports 5 --after 255");
  const auto given = std::make_shared<ExplainOptions>();
  command->add_option("--family", given->family,
                      "A shipped family, such as split; or one of several in the operation file");
  command->add_option("--operation", given->operation, "A custom operation or family: its file");
  command->add_option("--k", given->k, "The first number of the position: triangles of the fan");
  command->add_option("--at", given->at, "Its other numbers: a of split, i,j of open-split")->delimiter(',');
  command->add_option("--before", given->before, "The inner edges before the operation")->required();
  command->add_option("--ports", given->ports, "The solid ports before the operation")->required();
  CLI::Option* const after =
      command->add_option("--after", given->after, "The inner edges of a recolouring, which is judged as well");
  command->add_option("--ports-after", given->ports_after, "The ports that it keeps, if it gives any up")->needs(after);
  add_json_option(*command, given->json);
  return [command, given] { return explain(*command, *given); };
}

std::function<int()> add_rules(CLI::App& app) {
  CLI::App* const command =
      app.add_subcommand("rules", "A rule set of any source: how many rows are valid, sound and best");
  command->footer(
      "The file has the columns of `restrip-generate dump`, with or without strips,isolated; other operations have\n"
      "their numbers, then inner,ports,inner_after, then perhaps ports_after.\n"
      "Several files may follow each other, with their headers. Configurations without a row are counted and allowed.\n"
      "If several operations of a file have the same columns, --family says which one is meant.\n"
      "Exit code: 0 every row is best, 1 some row is not or is no valid configuration, 2 bad input.\n\n"
      "Example:\n"
      "  restrip-generate dump --family split --k 5 > rules.csv && restrip-verify rules rules.csv");
  const auto given = std::make_shared<RulesOptions>();
  command->add_option("file", given->file, "The rule set")->required();
  command->add_option("--family", given->family, "The shipped family, or the one of several in the operation file");
  command->add_option("--operation", given->operation, "The operation file that it is for; otherwise a shipped family");
  command->add_option("--worst", given->worst, "How many bad rows are named")->capture_default_str();
  command->add_option("--threads", given->threads, "How many threads; the result does not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  add_json_option(*command, given->json);
  return [given] {
    const files::ReportOutput out(given->json, {given->file, given->operation});
    const std::vector<Description> descriptions = descriptions_of(given->operation);
    if (!given->family.empty()) (void)named(descriptions, given->family);
    const RuleSetReport report =
        judge_rules(given->file, read_file(given->file), descriptions, given->family, given->worst, given->threads);
    std::string source = given->operation.empty() ? "" : "--operation " + given->operation;
    if (descriptions.size() > 1) source += (source.empty() ? "--family " : " --family ") + report.operation;
    out.print(text_of(report, source), text_of(json_of(report)));
    return report.best() ? all_claims_hold : some_claim_fails;
  };
}

}  // namespace restrip::verify
