#include "tables/table_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "automaton/automaton.hpp"
#include "automaton/emit_automaton.hpp"
#include "common/counted.hpp"
#include "common/digest.hpp"
#include "common/output.hpp"
#include "common/progress.hpp"
#include "common/report_output.hpp"
#include "languages/languages.hpp"
#include "tables/certificate_text.hpp"
#include "tables/changed.hpp"
#include "tables/emit.hpp"

namespace restrip::generator {
namespace {

namespace files = restrip::files;

const std::string headers = "include/restrip/tables/";

std::string header_path(const std::string& family) { return headers + identifier(family) + ".hpp"; }

std::string certificate_path(const std::string& family) { return "certificates/" + family + ".cert"; }

/// The two files of the automaton, which serves every valence.
struct AutomatonFiles {
  Automaton automaton = make_automaton();
  RulesHeader header = automaton_header(automaton);
  AutomatonCertificate certificate = automaton_certificate(automaton);

  [[nodiscard]] std::string summary() const {
    return fmt::format("{:<16} {:>3} classes   {:>6} rows   {:>6} bytes\n", "automaton", automaton.classes.size(),
                       certificate.rows, header.bytes);
  }
};

/// The files of the tables, whatever the largest valence; MANIFEST, which lists the others, comes last.
std::vector<std::filesystem::path> table_files(const std::set<std::string>& wanted) {
  std::set<std::filesystem::path> names;
  for (const auto& other : files_in(wanted, "tables")) names.insert(other.first);
  if (!wanted.contains("c++")) return {names.begin(), names.end()};
  names.insert({headers + "rows.hpp", header_path("automaton"), certificate_path("automaton")});
  for (const Patches& section : patches_of(tabled_families(), 3)) {
    names.insert(certificate_path(section.certificate));
    names.insert(header_path(section.certificate));
  }
  std::vector<std::filesystem::path> in_order(names.begin(), names.end());
  in_order.emplace_back("MANIFEST");
  return in_order;
}

std::string summary(const std::string& family, std::size_t sections, std::size_t rules, std::size_t bytes) {
  return fmt::format("{:<16} {:>3} {:<8}  {:>6} {:<5}  {:>6} {}\n", family, sections, plural(sections, "section"),
                     rules, plural(rules, "rule"), bytes, plural(bytes, "byte"));
}

/// Files and their summary.
struct Emitted {
  std::vector<files::NamedBytes> files;
  std::string text;
};

/// The stage `emit`: the files of the languages. MANIFEST, which comes last, lists the C++ files, which restrip-verify
/// reads.
Emitted emit(const std::vector<Certificate>& certificates, const Packing& packing, const TablesOptions& options) {
  const unsigned max_k = options.max_k;
  const TableLayout layout = table_layout(certificates, packing, max_k);
  auto [files, text] = Emitted{};
  for (const auto& [name, file] : files_in(options.languages, "tables")) {
    files.push_back({name, file->of_tables(layout)});
    text += fmt::format("{:<25} {:>8} bytes\n", name, files.back().bytes.size());
  }
  if (!files.empty()) text += fmt::format("rules up to k = {}: {} bytes of data\n", max_k, layout.bytes());
  if (!options.languages.contains("c++")) return {files, text};

  struct Listed {
    std::string text;
    std::size_t rows = 0;  ///< the number that MANIFEST lists
  };
  std::map<std::string, Listed> by_path;
  by_path[headers + "rows.hpp"] = {rows_header(packing, max_k), 0};
  for (const Certificate& family : certificates) {
    by_path[certificate_path(family.name)] = {certificate_text(family), family.rows()};
    const RulesHeader header = rules_header(family, packing, max_k);
    by_path[header_path(family.name)] = {header.text, family.rows()};
    text += summary(family.name, family.sections.size(), family.rows(), header.bytes);
  }
  const AutomatonFiles automaton;
  by_path[header_path("automaton")] = {automaton.header.text, automaton.certificate.rows};
  by_path[certificate_path("automaton")] = {automaton.certificate.text, automaton.certificate.rows};
  text += automaton.summary();

  std::string manifest = "restrip-manifest 1\n";
  for (auto& [path, file] : by_path) {
    manifest += fmt::format("{} {} {} {}\n", sha256(file.text), file.text.size(), file.rows, path);
    files.push_back({path, std::move(file.text)});
  }
  files.push_back({"MANIFEST", manifest});
  return {files, text};
}

/// The files and the sections solved for them.
std::string written_json(unsigned max_k, const std::vector<files::NamedBytes>& files) {
  nlohmann::ordered_json json{{"max_k", max_k}, {"files", nlohmann::ordered_json::array()}};
  for (const auto& [name, bytes] : files) json["files"].push_back({{"path", name.string()}, {"bytes", bytes.size()}});
  return json.dump(2) + "\n";
}

}  // namespace

void make_tables(const TablesOptions& options) {
  files::OutputSet out(options.out, table_files(options.languages));
  const files::ReportOutput report(options.json);
  const bool certified = options.languages.contains("c++");

  std::vector<Section> solved = solve_all(patches_of(tabled_families(), options.max_k), options.threads, Watched::yes);
  std::vector<std::string> texts;
  if (certified) texts = section_texts(solved, options.threads);
  const std::vector<Certificate> certificates = by_certificate(std::move(solved), std::move(texts));
  const Emitted made = emit(certificates, pack(certificates, options.max_k), options);
  out.write(changed(options.out, made.files));
  report.print(made.text, written_json(options.max_k, made.files));
}

void make_automaton_files(const AutomatonOptions& options) {
  const auto& [folder, json, classes, languages] = options;
  std::vector<std::filesystem::path> names;
  if (languages.contains("c++")) names = {header_path("automaton"), certificate_path("automaton")};
  const auto others = files_in(languages, "automaton");
  for (const auto& other : others) names.emplace_back(other.first);
  files::OutputSet out(folder, names);
  const files::ReportOutput report(json);
  std::optional<files::Output> classes_out;
  if (!classes.empty()) classes_out.emplace(classes, files::OutputRules{{".json"}, {}});
  const AutomatonFiles made;
  std::vector<files::NamedBytes> written;
  if (languages.contains("c++"))
    written = {{header_path("automaton"), made.header.text}, {certificate_path("automaton"), made.certificate.text}};
  const AutomatonArrays arrays = automaton_arrays(made.automaton);
  for (const auto& [name, file] : others) written.push_back({name, file->of_automaton(arrays)});
  out.write(changed(folder, std::move(written)));
  if (classes_out) classes_out->write(classes_json(made.automaton));
  report.print(made.summary(), automaton_json(made.automaton));
}

}  // namespace restrip::generator
