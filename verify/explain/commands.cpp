#include "explain/commands.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "common/report_output.hpp"
#include "explain/explanation.hpp"
#include "explain/picture.hpp"
#include "explain/rule_set.hpp"
#include "judge/report.hpp"
#include "model/input.hpp"
#include "model/program.hpp"

namespace restrip::verify {
namespace {

Mask mask_of(const std::string& option, const std::string& text, unsigned bits) {
  std::uint64_t value = 0;
  const char* const begin = text.data() + (text.starts_with("0x") ? 2 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size() || value >= wide_mask_count(bits))
    throw std::invalid_argument(
        fmt::format("{} {}: expected a hexadecimal mask of at most {} bits", option, text, bits));
  return static_cast<Mask>(value);
}

/// The shipped descriptions, or those of a file.
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

/// The patch before, the recolouring if there is one, and the best. If the recolouring is invalid in some world, that
/// world is drawn around it; otherwise the sets of edges follow which show that nothing is better.
std::string picture_of(const Definition& definition, const Explanation& explanation,
                       const std::optional<Judgement>& judged) {
  const Side& after = definition.operation().after;
  const auto marked = [](const Obstacle& obstacle) {
    return Colors{obstacle.edges.inner, obstacle.edges.ports | obstacle.ports};
  };
  const Obstacle* const shown = judged && judged->obstacle ? &*judged->obstacle : nullptr;
  const World world = shown != nullptr ? definition.world(shown->world) : World{};
  std::vector<Panel> panels{{"before", &definition.operation().before, explanation.configuration, world, {}}};
  if (judged) {
    Panel yours{fmt::format("yours: {}", name_of(judged->standing)), &after, judged->colors, world, {}};
    if (shown != nullptr) yours.marked = marked(*shown);
    if (judged->standing == Standing::worse) {  // what differs from the best
      yours.title = "yours: " + judged->because;
      yours.marked = {judged->colors.inner ^ explanation.best->colors.inner,
                      judged->colors.ports ^ explanation.best->colors.ports};
    }
    panels.push_back(yours);
  }
  if (explanation.best) panels.push_back({"best", &after, explanation.best->colors, {}, {}});
  if (shown != nullptr) return picture_of(panels);
  for (const Obstacle& obstacle : explanation.obstacles)
    panels.push_back({obstacle.triangle ? "too many at " + name_of(after, *obstacle.triangle) : "a cycle", &after,
                      marked(obstacle), definition.world(obstacle.world), marked(obstacle), true});
  return picture_of(panels);
}

}  // namespace

ExplainCommand::ExplainCommand(CLI::App& app)
    : command_(app.add_subcommand(
          "explain", "One configuration: the best recolouring, why nothing is better, or what is wrong with another")) {
  command_->footer(
      "Masks are hexadecimal and numbered as in docs/reference/notation.md; dumps print the same in decimal.\n"
      "Verdicts:\n"
      "  not valid     a triangle has too many solid edges, the patch has a cycle, or a port changed that may not\n"
      "  unsound       not valid in the world named, in which the configuration is valid; no such world has\n"
      "                fewer connections\n"
      "  worse         sound, and costs more than the best\n"
      "  equally good  costs the same as the best, of which the one with the smallest mask is shown; the rule of a\n"
      "                table is any of them, and describe of restrip-generate prints how ties are broken\n"
      "  best          the one shown\n"
      "t0=A is a solid edge, t0-A a dashed one.\n\n"
      "Exit code: 0 if there is no recolouring to judge or it is as good as the best, 1 if it is not, 2 bad input.\n\n"
      "Example:\n"
      "  restrip-verify explain --family split --k 5 --at 2 --before 1a --ports 5 --after ff --svg why.svg");
  command_->add_option("--family", family_, "A shipped family, such as split; or one of several in the operation file");
  command_->add_option("--operation", operation_, "A custom operation or family: its file");
  command_->add_option("--k", k_, "The first number of the position: triangles of the fan");
  command_->add_option("--at", at_, "Its other numbers: a of split, i,j of open-split")->delimiter(',');
  command_->add_option("--before", before_, "The inner edges before the operation")->required();
  command_->add_option("--ports", ports_, "The solid ports before the operation")->required();
  CLI::Option* const after =
      command_->add_option("--after", after_, "The inner edges of a recolouring, which is judged as well");
  command_->add_option("--ports-after", ports_after_, "The ports that it keeps, if it gives any up")->needs(after);
  command_->add_option("--svg", svg_, "Draw the patch before, the patch after and the worlds that show why");
  add_json_option(*command_, json_);
}

int ExplainCommand::run() const {
  std::optional<files::Output> svg;
  if (!svg_.empty()) svg.emplace(svg_, files::OutputRules{{".svg"}, {operation_}});
  const files::ReportOutput out(json_, {operation_});
  const Description description = named(descriptions_of(operation_), family_);
  Numbers numbers = at_;
  if (command_->count("--k") != 0) numbers.insert(numbers.begin(), k_);
  const Operation operation = operation_at(description, numbers);
  const Colors configuration{mask_of("--before", before_, operation.before.inner_edges()),
                             mask_of("--ports", ports_, operation.ports())};
  const Definition definition(operation);
  if (!definition.valid(configuration))
    throw std::invalid_argument(
        fmt::format("not a valid configuration: {}",
                    invalid_because(operation.before, configuration, most_solid(operation.constraint))));
  std::optional<Judgement> judged;
  if (!after_.empty()) {
    const Colors recoloring{
        mask_of("--after", after_, operation.after.inner_edges()),
        ports_after_.empty() ? configuration.ports : mask_of("--ports-after", ports_after_, operation.ports())};
    judged = judgement_of(definition, configuration, recoloring);
  }
  const Explanation explanation = explanation_of(definition, configuration);
  if (svg) svg->write(picture_of(definition, explanation, judged));
  out.print(text_of(definition, explanation, judged), text_of(json_of(definition, explanation, judged)));
  return !judged || judged->standing >= Standing::equally_good ? all_claims_hold : some_claim_fails;
}

RulesCommand::RulesCommand(CLI::App& app)
    : command_(app.add_subcommand("rules", "A rule set of any source: how many rows are valid, sound and best")) {
  command_->footer(
      "The file has the columns of `restrip-generate dump`, with or without strips,isolated; other operations have\n"
      "their numbers, then inner,ports,inner_after, then perhaps ports_after.\n"
      "Several files may follow each other, with their headers. Configurations without a row are counted and allowed.\n"
      "Exit code: 0 every row is best, 1 some row is not or is no valid configuration, 2 bad input.\n\n"
      "Example:\n"
      "  restrip-generate dump --family split --k 5 > rules.csv && restrip-verify rules rules.csv");
  command_->add_option("file", file_, "The rule set")->required();
  command_->add_option("--operation", operation_, "The operation file that it is for; otherwise a shipped family");
  command_->add_option("--worst", worst_, "How many bad rows are named")->capture_default_str();
  command_->add_option("--threads", threads_, "How many threads; the result does not depend on it")
      ->capture_default_str()
      ->check(CLI::Range(1, 64));
  add_json_option(*command_, json_);
}

int RulesCommand::run() const {
  const files::ReportOutput out(json_, {file_, operation_});
  const RuleSetReport report = judge_rules(file_, read_file(file_), descriptions_of(operation_), worst_, threads_);
  out.print(text_of(report, operation_.empty() ? "--family " + report.operation : "--operation " + operation_),
            text_of(json_of(report)));
  return report.best() ? all_claims_hold : some_claim_fails;
}

}  // namespace restrip::verify
