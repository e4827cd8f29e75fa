#include "operations/operation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>

#include "number_lines.hpp"

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

/// As the header lists them.
std::string triangles(const std::vector<SurfaceTriangle>& met) {
  std::vector<std::string> words;
  for (const SurfaceTriangle& t : met)
    words.push_back(fmt::format("{{{}, {}, {{{}}}, {{{}}}}}", t.from, t.from_side, fmt::join(t.vertex, ", "),
                                fmt::join(t.side, ", ")));
  return "    {{\n" + numbers(words) + "    }},\n";
}

}  // namespace

OperationHeader operation_header(const Section& section) {
  const Position& position = section.serves.at(0);
  const Description& named = *position.family;
  const Operation operation = operation_at(position);
  const Patch& patch = operation.patch;
  const bool matching = operation.constraint.most_edges == 1;
  const unsigned ports = patch.before.ports();
  const unsigned width = width_of(operation);
  // For matchings, whose keys are the ports, entry P serves every colouring.
  std::vector<std::int64_t> entries(std::size_t{1} << (matching ? ports : patch.before.edges.size() + ports),
                                    (std::int64_t{1} << width) - 1);
  for_each_valid(operation, [&](const Configuration& c) {
    const Row& row = row_of(section, c.ports, c.outcome.joined);
    entries[matching ? c.ports : std::size_t{c.before} << ports | c.ports] =
        std::int64_t{row.recoloring} << ports | row.kept;
  });
  std::string text = fmt::format(
      "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained in "
      "restrip/tables/operation_format.hpp.\n#pragma once\n\n#include \"restrip/tables/operation_format.hpp\"\n\n"
      "namespace restrip::tables {{\n\n",
      named.about.empty() ? named.name : named.about, named.name);
  const Surface& surface = named.surface;
  const bool has_surface = !surface.before.empty();
  const std::string sizes =
      has_surface ? fmt::format(", {}, {}", surface.before.size(), surface.after.size()) : std::string();
  text += fmt::format("inline constexpr {}<std::uint{}_t, {}{}> {}{{\n",
                      has_surface ? "SurfaceOperation" : "OperationTable", width, entries.size(), sizes,
                      variable(named.name));
  text += fmt::format("    {}{{{}, {}}},\n    {{{}, {}}},\n    {},\n    {},\n    {{\n", has_surface ? "{" : "",
                      patch.before.nodes, patch.before.edges.size(), patch.after.nodes, patch.after.edges.size(),
                      patch.before.owner.size(), matching);
  text += numbers(entries);
  text += has_surface ? fmt::format("    }}}},\n    {},\n{}{}}};\n", surface.vertices, triangles(surface.before),
                                    triangles(surface.after))
                      : "    }};\n";
  text += "\n}  // namespace restrip::tables\n";
  return {text, entries.size() * width / 8};
}

std::string operation_certificate_path(const std::string& name) { return "certificates/operations/" + name + ".cert"; }

std::string operation_header_path(const std::string& name) {
  return "include/restrip/tables/operations/" + variable(name) + ".hpp";
}

}  // namespace restrip::generator
