#include "operations/write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "counted.hpp"
#include "files/output.hpp"
#include "operations/operation_text.hpp"

namespace restrip::generator {
namespace {

nlohmann::ordered_json figures(const NamedOperation& named, const OperationRules& rules, std::size_t bytes) {
  const Claims& claims = rules.claims;
  return {{"name", named.name},
          {"configurations", claims.configurations},
          {"valid", claims.valid},
          {"orbits", claims.orbits},
          {"valid_orbits", claims.valid_orbits},
          {"symmetries", rules.symmetry.size()},
          {"keys", rules.rows.size()},
          {"costing", claims.costing},
          {"worst_strips", claims.worst_strips},
          {"worst_isolated", claims.worst_isolated},
          {"bytes", bytes}};
}

}  // namespace

void make_rules(const RulesOptions& options) {
  std::vector<NamedOperation> operations;
  std::vector<std::filesystem::path> paths;
  for (const std::string& file : options.files) {
    operations.push_back(read_operation(file));
    const std::string& name = operations.back().name;
    if (std::find(paths.begin(), paths.end(), operation_certificate_path(name)) != paths.end())
      throw std::runtime_error(fmt::format("{}: another of these files is named {} as well", file, name));
    paths.emplace_back(operation_certificate_path(name));
    paths.emplace_back(operation_header_path(name));
  }
  files::OutputSet out(options.out, paths);
  std::optional<files::Output> json_out;
  if (!options.json.empty() && options.json != "-") json_out.emplace(options.json, files::OutputRules{{".json"}, {}});

  std::vector<files::NamedBytes> texts;
  nlohmann::ordered_json json;
  std::string told;
  for (const NamedOperation& named : operations) {
    const OperationRules rules = solve(named);
    const OperationHeader header = operation_header(named, rules);
    texts.push_back({operation_certificate_path(named.name), operation_certificate(named, rules)});
    texts.push_back({operation_header_path(named.name), header.text});
    json["operations"].push_back(figures(named, rules, header.bytes));
    told += fmt::format("{:<24} {:>6} {:<14}  {:>5} {:<5}  {:>6} {}\n", named.name, rules.claims.configurations,
                        plural(rules.claims.configurations, "configuration"), rules.rows.size(),
                        plural(rules.rows.size(), "rule"), header.bytes, plural(header.bytes, "byte"));
  }
  out.write(texts);
  const std::string json_text = json.dump(2) + "\n";
  if (json_out) json_out->write(json_text);
  fmt::print("{}", options.json == "-" ? json_text : told);
}

}  // namespace restrip::generator
