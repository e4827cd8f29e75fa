#include "emit/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "automaton/automaton.hpp"
#include "common/counted.hpp"
#include "common/digest.hpp"

namespace restrip::generator {
namespace {

using OrderedJson = nlohmann::ordered_json;

const std::string headers = "include/restrip/tables/";
std::string header_path(const std::string& name) { return headers + identifier(name) + ".hpp"; }
std::string certificate_path(const std::string& name) { return "certificates/" + name + ".cert"; }
const std::string of_operations = "operations/";

/// A file in C++, and the number of rows that MANIFEST lists.
struct Listed {
  std::string text;
  std::size_t rows = 0;
};
using ByPath = std::map<std::string, Listed>;

/// Adds the automaton's header and certificate; returns their summary.
std::string add_automaton_files(const Automaton& automaton, ByPath& by_path) {
  RulesHeader header = automaton_header(automaton);
  AutomatonCertificate certificate = automaton_certificate(automaton);
  by_path[header_path("automaton")] = {std::move(header.text), certificate.rows};
  by_path[certificate_path("automaton")] = {std::move(certificate.text), certificate.rows};
  return fmt::format("{:<16} {:>3} classes   {:>6} rows   {:>6} bytes\n", "automaton", automaton.classes.size(),
                     certificate.rows, header.bytes);
}

/// Numbers of classes before and after minimisation, letters, cases, bytes.
std::string automaton_json(const Automaton& automaton) {
  OrderedJson json;
  json["arcs"]["by value"] = automaton.counts.values;
  json["arcs"]["by value and ports"] = automaton.counts.with_ports;
  json["arcs"]["with the boundary, too"] = automaton.counts.with_boundary;
  json["classes"]["all"] = automaton.classes.size();
  json["classes"]["empty"] = 1;
  json["classes"]["without boundary"] = std::count_if(automaton.classes.begin(), automaton.classes.end(),
                                                      [](const ArcClass& c) { return c.can_be_first(); });
  // Shorter ones come first.
  json["longest witness"] = automaton.classes.back().witness.size();
  json["letters"] = all_letters.size();
  json["cases"] = all_cases.size();
  json["meetings"]["rows"] = automaton.meets.size();
  const auto [seconds, table] = automaton_arrays(automaton);
  json["meetings"]["columns"] = seconds;
  json["meetings"]["different"] = table.arrays.back().values.size();
  json["bytes"] = table.bytes();
  return json.dump(2) + "\n";
}

/// Adds the figures of an operation's certificate to a report.
void add_figures(const Certificate& certificate, std::size_t bytes, OrderedJson& json, std::string& text) {
  const auto& [name, sections, certificate_text] = certificate;
  const std::size_t rows = certificate.rows();
  std::vector<Claims> parts;
  double symmetries = 0;
  for (const Section& section : sections) {
    parts.insert(parts.end(), section.claims.begin(), section.claims.end());
    symmetries = std::max(symmetries, section.symmetries);
  }
  const Claims claims = sum(parts);
  json.push_back({{"name", name},
                  {"configurations", claims.configurations},
                  {"valid", claims.valid},
                  {"orbits", claims.orbits},
                  {"valid_orbits", claims.valid_orbits},
                  {"symmetries", static_cast<std::uint64_t>(symmetries)},
                  {"keys", rows},
                  {"costing", claims.costing},
                  {"worst_strips", claims.worst_strips},
                  {"worst_isolated", claims.worst_isolated},
                  {"bytes", bytes}});
  text += fmt::format("{:<24} {:>6} {:<14}  {:>5} {:<5}  {:>6} {}\n", name, claims.configurations,
                      plural(claims.configurations, "configuration"), rows, plural(rows, "rule"), bytes,
                      plural(bytes, "byte"));
}

}  // namespace

Names names_of_tables(const std::vector<Description>& families, const Languages& languages) {
  std::set<std::filesystem::path> names;
  for (const auto& other : files_in(languages, "tables")) names.insert(other.first);
  if (!languages.contains("c++")) return {names.begin(), names.end()};
  names.insert({headers + "rows.hpp", header_path("automaton"), certificate_path("automaton")});
  for (const std::string& certificate : certificates_of(families))
    names.insert({certificate_path(certificate), header_path(certificate)});
  Names in_order(names.begin(), names.end());
  in_order.emplace_back("MANIFEST");
  return in_order;
}

Emitted emit_tables(const std::vector<Certificate>& certificates, const Packing& packing, unsigned max_k,
                    const Languages& languages) {
  auto [files, text, json] = Emitted{};
  const TableLayout layout = table_layout(certificates, packing, max_k);
  for (const auto& [name, file] : files_in(languages, "tables")) {
    files.push_back({name, file->of_tables(layout)});
    text += fmt::format("{:<25} {:>8} bytes\n", name, files.back().bytes.size());
  }
  if (!files.empty()) text += fmt::format("rules up to k = {}: {} bytes of data\n", max_k, layout.bytes());
  if (languages.contains("c++")) {
    ByPath by_path;
    by_path[headers + "rows.hpp"] = {rows_header(packing, max_k), 0};
    for (const Certificate& family : certificates) {
      const std::size_t sections = family.sections.size();
      const std::size_t rows = family.rows();
      RulesHeader header = rules_header(family, packing, max_k);
      by_path[certificate_path(family.name)] = {family.text, rows};
      by_path[header_path(family.name)] = {std::move(header.text), rows};
      text +=
          fmt::format("{:<16} {:>3} {:<8}  {:>6} {:<5}  {:>6} {}\n", family.name, sections, plural(sections, "section"),
                      rows, plural(rows, "rule"), header.bytes, plural(header.bytes, "byte"));
    }
    text += add_automaton_files(make_automaton(), by_path);
    std::string manifest = "restrip-manifest 1\n";
    for (auto& [path, file] : by_path) {
      manifest += fmt::format("{} {} {} {}\n", sha256(file.text), file.text.size(), file.rows, path);
      files.push_back({path, std::move(file.text)});
    }
    files.push_back({"MANIFEST", manifest});
  }
  OrderedJson report{{"max_k", max_k}, {"files", OrderedJson::array()}};
  for (const auto& [name, bytes] : files) report["files"].push_back({{"path", name.string()}, {"bytes", bytes.size()}});
  return {std::move(files), std::move(text), report.dump(2) + "\n"};
}

Names names_of_operations(const std::vector<Description>& descriptions, const Languages& languages) {
  std::set<std::filesystem::path> names;
  if (languages.contains("c++"))
    for (const std::string& certificate : certificates_of(descriptions))
      names.insert(certificate_path(of_operations + certificate));
  for (const Description& description : descriptions) {
    if (languages.contains("c++")) names.insert(header_path(of_operations + description.name));
    for (const auto& [name, file] : files_in(languages, "rule_of_" + identifier(description.name)))
      if (file->of_operation != nullptr) names.insert(name);
  }
  return {names.begin(), names.end()};
}

Emitted emit_operations(const std::vector<Certificate>& certificates, const std::vector<OperationLayout>& layouts,
                        const Languages& languages) {
  auto [files, text, json] = Emitted{};
  OrderedJson figures;
  for (const Certificate& certificate : certificates) {
    if (languages.contains("c++"))
      files.push_back({certificate_path(of_operations + certificate.name), certificate.text});
    std::size_t bytes = 0;
    for (const OperationLayout& layout : layouts) {
      const Description& description = layout.named();
      if (description.certificate != certificate.name) continue;
      bytes += layout.bytes();
      if (languages.contains("c++"))
        files.push_back({header_path(of_operations + description.name), operation_header(layout)});
      for (const auto& [name, file] : files_in(languages, "rule_of_" + identifier(description.name)))
        if (file->of_operation != nullptr) files.push_back({name, file->of_operation(layout)});
    }
    add_figures(certificate, bytes, figures["operations"], text);
  }
  return {std::move(files), std::move(text), figures.dump(2) + "\n"};
}

Names names_of_automaton(const Languages& languages) {
  Names names;
  if (languages.contains("c++")) names = {header_path("automaton"), certificate_path("automaton")};
  for (const auto& other : files_in(languages, "automaton")) names.emplace_back(other.first);
  return names;
}

Emitted emit_automaton(const Automaton& automaton, const Languages& languages) {
  ByPath by_path;
  Emitted emitted{{}, add_automaton_files(automaton, by_path), automaton_json(automaton)};
  if (languages.contains("c++"))
    for (auto& [path, file] : by_path) emitted.files.push_back({path, std::move(file.text)});
  const AutomatonArrays arrays = automaton_arrays(automaton);
  for (const auto& [name, file] : files_in(languages, "automaton"))
    emitted.files.push_back({name, file->of_automaton(arrays)});
  return emitted;
}

}  // namespace restrip::generator
