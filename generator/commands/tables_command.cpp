// `restrip-generate tables`, `rules` and `automaton`: write the tables of the shipped families, the tables of custom
// operations, and the automaton of all fans or look-ups of custom families that it answers.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "automaton/automaton.hpp"
#include "commands/command.hpp"
#include "commands/pipeline.hpp"
#include "common/output.hpp"
#include "describe/description.hpp"
#include "emit/emit.hpp"

namespace restrip::generator {
namespace {

/// What the three subcommands have in common.
struct Writing {
  std::filesystem::path out;               ///< the folder
  std::vector<std::string> inputs;         ///< operation files
  std::set<std::string> languages{"c++"};  ///< C++ has header and certificate
  std::string json;
};

/// Writes into the folder what make() returns, and prints its report. All outputs are tested before the work. Files
/// that are there with their bytes stay, so that nothing is compiled again because of them.
template <class Make>
void write(const Writing& to, const Names& names, Make&& make) {
  const std::vector<std::filesystem::path> inputs(to.inputs.begin(), to.inputs.end());
  files::OutputSet out(to.out, names, {{}, inputs});
  const files::ReportOutput report(to.json, inputs);
  Emitted made = make();
  std::erase_if(made.files, [&](const files::NamedBytes& file) {
    std::ifstream old(to.out / file.name, std::ios::binary);  // not read_whole(), which refuses outputs
    return old && std::string(std::istreambuf_iterator<char>(old), {}) == file.bytes;
  });
  out.write(made.files);
  report.print(made.text, made.json);
}

void write(const Writing& to, Order order) {
  order.languages = to.languages;
  const std::vector<Patches> patches = patches_of(order.descriptions, order.max_k);  // refuses before files are opened
  write(to, names_of(order), [&] { return make(order, patches); });
}

/// The look-ups of custom families that the automaton answers.
Emitted served_headers(const std::vector<std::string>& inputs) {
  Emitted made;
  nlohmann::ordered_json json{{"files", nlohmann::ordered_json::array()}};
  for (const Description& family : read_descriptions(inputs)) {
    const std::string name = fmt::format("include/restrip/automaton/{}.hpp", identifier(family.name));
    made.files.push_back({name, served_header(family)});
    made.text += name + '\n';
    json["files"].push_back({{"path", name}, {"bytes", made.files.back().bytes.size()}});
  }
  made.json = json.dump(2) + '\n';
  return made;
}

void write_automaton(const Writing& to) {
  if (to.inputs.empty()) {
    write(to, names_of_automaton(to.languages), [&] { return emit_automaton(make_automaton(), to.languages); });
    return;
  }
  Emitted made = served_headers(to.inputs);
  Names names;
  for (const files::NamedBytes& file : made.files) names.push_back(file.name);
  write(to, names, [&] { return std::move(made); });
}

}  // namespace

Subcommand add_tables(CLI::App& app) {
  struct TablesCommand : Writing {
    Order order{tabled_families()};
  };
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
  add_language_option(*sub, kept->languages, "headers, certificates and MANIFEST", "data");
  add_json_option(*sub, kept->json);
  sub->footer(
      "\nExample, restrip_tables.h and restrip_tables.json:\n"
      "  restrip-generate tables --language c,json --out /tmp/tables\n");
  return {sub, [kept] { write(*kept, kept->order); }};
}

Subcommand add_rules(CLI::App& app) {
  struct RulesCommand : Writing {
    std::optional<unsigned> max_k;
  };
  const auto kept = std::make_shared<RulesCommand>();
  CLI::App* sub = app.add_subcommand("rules",
                                     "Write the table and the certificate of custom operations (operation "
                                     "files), or the table in another language");
  sub->add_option("--operation", kept->inputs, "Operation file, as docs/reference/operation-file.md describes it")
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
  return {sub, [kept] { write(*kept, order_of(kept->inputs, kept->max_k)); }};
}

Subcommand add_automaton(CLI::App& app) {
  const auto kept = std::make_shared<Writing>();
  CLI::App* sub =
      app.add_subcommand("automaton", "Write the automaton that answers fans of every valence, and its certificate");
  sub->add_option("--out", kept->out, "Output directory")->required();
  auto* served = sub->add_option(
      "--operation", kept->inputs,
      "Write the look-up of custom families (operation files) that the shipped automaton answers, instead");
  add_language_option(*sub, kept->languages, "header and certificate", "data")->excludes(served);
  add_json_option(*sub, kept->json);
  sub->footer(
      "\nExamples:\n"
      "  restrip-generate automaton --out /tmp/automaton\n"
      "  restrip-generate automaton --language c,rust --out /tmp/automaton\n"
      "  restrip-generate automaton --operation my-family.json --out /tmp/automaton\n");
  return {sub, [kept] { write_automaton(*kept); }};
}

}  // namespace restrip::generator
