// `restrip-generate automaton`: the automaton of all fans, or look-ups of custom families that it answers.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "automaton/automaton.hpp"
#include "commands/command.hpp"
#include "common/report_output.hpp"
#include "describe/description_file.hpp"
#include "emit/served.hpp"

namespace restrip::generator {
namespace {

struct AutomatonCommand {
  std::string out;
  std::vector<std::string> served;         ///< operation files
  std::set<std::string> languages{"c++"};  ///< C++ has header and certificate
  std::string json;
};

void write_automaton(const AutomatonCommand& command) {
  OutputFolder out(command.out, names_of_automaton(command.languages));
  const files::ReportOutput report(command.json);
  Emitted made = emit_automaton(make_automaton(), command.languages);
  out.write(std::move(made.files));
  report.print(made.text, made.json);
}

void write_served(const AutomatonCommand& command) {
  std::vector<files::NamedBytes> made;
  std::vector<std::filesystem::path> names;
  std::string text;
  nlohmann::ordered_json json{{"files", nlohmann::ordered_json::array()}};
  for (const Description& family : read_descriptions(command.served)) {
    names.emplace_back(fmt::format("include/restrip/automaton/{}.hpp", identifier(family.name)));
    made.push_back({names.back(), served_header(family)});
    text += names.back().string() + '\n';
    json["files"].push_back({{"path", names.back().string()}, {"bytes", made.back().bytes.size()}});
  }
  OutputFolder out(command.out, names, command.served);
  const files::ReportOutput report(command.json, {command.served.begin(), command.served.end()});
  out.write(std::move(made));
  report.print(text, json.dump(2) + '\n');
}

}  // namespace

Subcommand add_automaton(CLI::App& app) {
  const auto kept = std::make_shared<AutomatonCommand>();
  CLI::App* sub =
      app.add_subcommand("automaton", "Write the automaton that answers fans of every valence, and its certificate");
  sub->add_option("--out", kept->out, "Output directory")->required();
  auto* served = sub->add_option(
      "--operation", kept->served,
      "Write the look-up of custom families (operation files) that the shipped automaton answers, instead");
  add_language_option(*sub, kept->languages, "header and certificate", "data")->excludes(served);
  add_json_option(*sub, kept->json);
  sub->footer(
      "\nExamples:\n"
      "  restrip-generate automaton --out /tmp/automaton\n"
      "  restrip-generate automaton --language c,rust --out /tmp/automaton\n"
      "  restrip-generate automaton --operation my-family.json --out /tmp/automaton\n");
  return {sub, [kept] { kept->served.empty() ? write_automaton(*kept) : write_served(*kept); }};
}

}  // namespace restrip::generator
