#include "operations/operation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "emit.hpp"
#include "number_lines.hpp"
#include "progress.hpp"
#include "reason.hpp"

namespace restrip::generator {
namespace {

/// As C++ names it.
std::string variable(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Bits of an entry's type: one more at least than a rule has, so that all ones is none.
unsigned width_of(const Operation& operation) {
  const std::size_t bits = operation.patch.after.edges.size() + operation.patch.after.owner.size();
  return bits < 8 ? 8 : bits < 16 ? 16 : 32;
}

}  // namespace

std::string operation_certificate(const NamedOperation& named, const OperationRules& rules) {
  std::string text = fmt::format("restrip-operation-certificate 1\noperation {}\n", named.name);
  auto out = std::back_inserter(text);
  const Claims& claims = rules.claims;
  fmt::format_to(out, "claim configurations {}\nclaim valid {}\nclaim orbits {}\nclaim valid-orbits {}\n",
                 claims.configurations, claims.valid, claims.orbits, claims.valid_orbits);
  fmt::format_to(out, "claim keys {}\nclaim costing {}\nclaim worst-strips {}\nclaim worst-isolated {}\n",
                 rules.rows.size(), claims.costing, claims.worst_strips, claims.worst_isolated);
  std::optional<Reasoner> reasoner;
  if (has_reasons(named.operation)) reasoner.emplace(named.operation);
  Progress progress("found reasons of", rules.rows.size(), "rules");
  for (const OperationRow& row : rules.rows) {
    fmt::format_to(out, "{} {:x} {:x} {:x} {:x}", row.witness < 0 ? "rule" : "copy", row.key.ports, row.key.joined,
                   row.choice.recoloring, row.choice.kept);
    if (row.witness < 0 && reasoner)
      fmt::format_to(out, " because {}",
                     reasoner->find(row.key.ports, pairs_of(row.key.joined), row.choice).reason.text());
    if (row.witness >= 0)
      fmt::format_to(out, " by {}", fmt::join(rules.symmetry[static_cast<std::size_t>(row.witness)].port, " "));
    text += '\n';
    progress.step();
  }
  return sealed(std::move(text), rules.rows.size());
}

OperationHeader operation_header(const NamedOperation& named, const OperationRules& rules) {
  const Patch& patch = named.operation.patch;
  const unsigned width = width_of(named.operation);
  const std::int64_t none = (std::int64_t{1} << width) - 1;
  std::vector<std::int64_t> entries;
  for (const std::int32_t entry : rules.entries) entries.push_back(entry < 0 ? none : entry);
  std::string text = fmt::format(
      "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained in "
      "restrip/tables/operation_format.hpp.\n#pragma once\n\n#include \"restrip/tables/operation_format.hpp\"\n\n"
      "namespace restrip::tables {{\n\n",
      named.about.empty() ? named.name : named.about, named.name);
  text += fmt::format("inline constexpr OperationTable<std::uint{}_t, {}> {}{{\n", width, entries.size(),
                      variable(named.name));
  text += fmt::format("    {{{}, {}}},\n    {{{}, {}}},\n    {},\n    {},\n    {{\n", patch.before.nodes,
                      patch.before.edges.size(), patch.after.nodes, patch.after.edges.size(), patch.before.owner.size(),
                      named.operation.constraint.most_edges == 1);
  text += numbers(entries) + "    }};\n\n}  // namespace restrip::tables\n";
  return {text, entries.size() * width / 8};
}

std::string operation_certificate_path(const std::string& name) { return "certificates/operations/" + name + ".cert"; }

std::string operation_header_path(const std::string& name) {
  return "include/restrip/tables/operations/" + variable(name) + ".hpp";
}

}  // namespace restrip::generator
