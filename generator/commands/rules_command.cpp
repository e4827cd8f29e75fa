// `restrip-generate rules`: the tables of custom operations.
#include <memory>
#include <optional>

#include "commands/command.hpp"
#include "commands/pipeline.hpp"
#include "common/report_output.hpp"

namespace restrip::generator {
namespace {

struct RulesCommand {
  std::vector<std::string> files;
  std::optional<unsigned> max_k;
  std::set<std::string> languages{"c++"};
  std::string out;
  std::string json;
};

void run(const RulesCommand& command) {
  Order order = order_of(command.files, command.max_k);
  order.languages = command.languages;
  const std::vector<Patches> patches = patches_of(order.descriptions, order.max_k);  // refuses before files are opened
  OutputFolder out(command.out, names_of(order), command.files);
  const files::ReportOutput report(command.json, {command.files.begin(), command.files.end()});
  Emitted made = make(order, patches);
  out.write(std::move(made.files));
  report.print(made.text, made.json);
}

}  // namespace

Subcommand add_rules(CLI::App& app) {
  const auto kept = std::make_shared<RulesCommand>();
  CLI::App* sub = app.add_subcommand("rules",
                                     "Write the table and the certificate of custom operations (operation "
                                     "files), or the table in another language");
  sub->add_option("--operation", kept->files, "Operation file, as docs/reference/operation-file.md describes it")
      ->required();
  sub->add_option("--out", kept->out, "Output directory")->required();
  sub->add_option("--max-k", kept->max_k, "Families: positions whose first number is at most this, by default 8")
      ->check(CLI::Range(3, 10));
  add_language_option(*sub, kept->languages, "header and certificate", "table");
  add_json_option(*sub, kept->json);
  sub->footer(
      "\nExamples, from the top of the source tree; the second writes restrip_rule_of_bisect.h and "
      "restrip_rule_of_bisect.rs:\n"
      "  restrip-generate rules --operation tables/operations/bisect.json --out /tmp/rules\n"
      "  restrip-generate rules --operation tables/operations/bisect.json --language c,rust --out "
      "/tmp/rules\n");
  return {sub, [kept] { run(*kept); }};
}

}  // namespace restrip::generator
