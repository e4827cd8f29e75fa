// `restrip-generate tables`: the tables of the shipped families.
#include <algorithm>
#include <memory>
#include <thread>

#include "commands/command.hpp"
#include "commands/pipeline.hpp"
#include "common/report_output.hpp"

namespace restrip::generator {
namespace {

struct TablesCommand {
  Order order{tabled_families()};
  std::string out;
  std::string json;
};

void run(const TablesCommand& command) {
  const std::vector<Patches> patches =
      patches_of(command.order.descriptions, command.order.max_k);  // refuses before files are opened
  OutputFolder out(command.out, names_of(command.order));
  const files::ReportOutput report(command.json);
  Emitted made = make(command.order, patches);
  out.write(std::move(made.files));
  report.print(made.text, made.json);
}

}  // namespace

Subcommand add_tables(CLI::App& app) {
  const auto kept = std::make_shared<TablesCommand>();
  CLI::App* sub = app.add_subcommand(
      "tables", "Write constexpr headers, certificates and MANIFEST, or the rules in another language");
  sub->add_option("--out", kept->out, "Output directory")->required();
  sub->add_option("--max-k", kept->order.max_k, "Largest valence")->check(CLI::Range(3, 13))->capture_default_str();
  sub->add_option("--threads", kept->order.threads,
                  "Threads, 0: one for each processor; the bytes written do not depend on it")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  sub->callback([kept] {
    if (kept->order.threads == 0) kept->order.threads = std::max(1U, std::thread::hardware_concurrency());
  });
  add_language_option(*sub, kept->order.languages, "headers, certificates and MANIFEST", "data");
  add_json_option(*sub, kept->json);
  sub->footer(
      "\nExample, restrip_tables.h and restrip_tables.json:\n"
      "  restrip-generate tables --language c,json --out /tmp/tables\n");
  return {sub, [kept] { run(*kept); }};
}

}  // namespace restrip::generator
