#include "operations/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "certificate_text.hpp"
#include "counted.hpp"
#include "files/output.hpp"
#include "operations/description_file.hpp"
#include "operations/operation_text.hpp"

namespace restrip::generator {
namespace {

/// Whether the patch was given as a graph, so that it may be no operation on a mesh.
bool is_graph_only(const Section& section) { return section.position.family->surface.before.empty(); }

nlohmann::ordered_json figures(const Section& section, std::size_t bytes) {
  const Claims claims = sum(section.claims);
  return {{"name", section.certificate},
          {"configurations", claims.configurations},
          {"valid", claims.valid},
          {"orbits", claims.orbits},
          {"valid_orbits", claims.valid_orbits},
          {"symmetries", static_cast<std::uint64_t>(section.symmetries)},
          {"keys", section.rows.size()},
          {"costing", claims.costing},
          {"worst_strips", claims.worst_strips},
          {"worst_isolated", claims.worst_isolated},
          {"bytes", bytes},
          {"graph_only", is_graph_only(section)}};
}

}  // namespace

void make_rules(const RulesOptions& options) {
  std::vector<Description> descriptions;
  std::vector<std::filesystem::path> paths;
  for (const std::string& file : options.files)
    for (Description& description : read_descriptions(file)) {
      const std::string& name = description.name;
      if (std::find(paths.begin(), paths.end(), operation_certificate_path(name)) != paths.end())
        throw std::runtime_error(fmt::format("{}: another of these files is named {} as well", file, name));
      if (!description.numbers.empty())
        throw std::runtime_error(fmt::format("{}: {} is a family; name an operation of it", file, name));
      paths.emplace_back(operation_certificate_path(name));
      paths.emplace_back(operation_header_path(name));
      descriptions.push_back(std::move(description));
    }
  files::OutputSet out(options.out, paths);
  std::optional<files::Output> json_out;
  if (!options.json.empty() && options.json != "-") json_out.emplace(options.json, files::OutputRules{{".json"}, {}});

  std::vector<files::NamedBytes> texts;
  nlohmann::ordered_json json;
  std::string told;
  for (Section& section : sections_of(descriptions, most_ports)) {
    solve(section, Watched::yes);
    const OperationHeader header = operation_header(section);
    texts.push_back(
        {operation_certificate_path(section.certificate),
         sealed(certificate_head(section.certificate) + section_text(section, Watched::yes), section.rows.size())});
    texts.push_back({operation_header_path(section.certificate), header.text});
    json["operations"].push_back(figures(section, header.bytes));
    const std::size_t configurations = sum(section.claims).configurations;
    told += fmt::format("{:<24} {:>6} {:<14}  {:>5} {:<5}  {:>6} {}\n", section.certificate, configurations,
                        plural(configurations, "configuration"), section.rows.size(),
                        plural(section.rows.size(), "rule"), header.bytes, plural(header.bytes, "byte"));
    if (is_graph_only(section)) told += "  graph only: not checked to be an operation on a mesh\n";
  }
  out.write(texts);
  const std::string json_text = json.dump(2) + "\n";
  if (json_out) json_out->write(json_text);
  fmt::print("{}", options.json == "-" ? json_text : told);
}

}  // namespace restrip::generator
