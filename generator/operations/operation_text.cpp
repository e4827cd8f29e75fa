#include "operations/operation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
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
unsigned width_of(const std::vector<AnsweredPosition>& positions) {
  std::size_t bits = 0;
  for (const auto& [position, section] : positions) {
    const Side after = make_patch(position).after;
    bits = std::max(bits, after.edges.size() + after.owner.size());
  }
  return bits < 8 ? 8 : bits < 16 ? 16 : 32;
}

/// Appends the entries of one position.
void append_entries(const Section& section, const Operation& operation, unsigned width,
                    std::vector<std::int64_t>& entries) {
  const Side& before = operation.patch.before;
  const bool matching = operation.constraint.most_edges == 1;
  const unsigned ports = before.ports();
  const std::size_t first = entries.size();
  // For matchings, whose keys are the ports, entry P serves every colouring.
  entries.resize(first + (std::size_t{1} << (matching ? ports : before.edges.size() + ports)),
                 (std::int64_t{1} << width) - 1);
  for_each_valid(operation, [&](const Configuration& c) {
    const Row& row = row_of(section, c.ports, c.outcome.joined);
    entries[first + (matching ? c.ports : std::size_t{c.before} << ports | c.ports)] =
        std::int64_t{row.recoloring} << ports | row.kept;
  });
}

/// Triangles and inner edges before and after.
std::array<std::string, 2> sizes(const Patch& patch) {
  const auto size = [](const Side& side) { return fmt::format("{{{}, {}}}", side.nodes, side.edges.size()); };
  return {size(patch.before), size(patch.after)};
}

/// How dumps name a position, with the places of the numbers for their names: "k {0} a {1}", as C++ writes a string.
std::string quoted_place(const Description& family) {
  std::string place = family.place;
  for (std::size_t i = 0; i < family.numbers.size(); ++i) {
    const std::string name = fmt::format("{{{}}}", family.numbers[i]);
    place.replace(place.find(name), name.size(), fmt::format("{{{}}}", i));
  }
  std::string quoted;
  for (const char c : place) quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return '"' + quoted + '"';
}

/// As the header lists them.
std::string triangles(const std::vector<SurfaceTriangle>& met) {
  std::vector<std::string> words;
  for (const SurfaceTriangle& t : met)
    words.push_back(fmt::format("{{{}, {}, {{{}}}, {{{}}}}}", t.from, t.from_side, fmt::join(t.vertex, ", "),
                                fmt::join(t.side, ", ")));
  return "    {{\n" + numbers(words) + "    }},\n";
}

/// The table of an operation, from its name on.
std::string operation_table(const Description& named, const Operation& operation, unsigned width,
                            const std::vector<std::int64_t>& entries) {
  const Patch& patch = operation.patch;
  const Surface& surface = named.surface;
  const bool has_surface = !surface.before.empty();
  const std::string triangle_counts =
      has_surface ? fmt::format(", {}, {}", surface.before.size(), surface.after.size()) : std::string();
  std::string text = fmt::format("inline constexpr {}<std::uint{}_t, {}{}> {}{{\n",
                                 has_surface ? "SurfaceOperation" : "OperationTable", width, entries.size(),
                                 triangle_counts, variable(named.name));
  text += fmt::format("    {}{},\n    {},\n    {},\n    {},\n    {{\n", has_surface ? "{" : "", sizes(patch)[0],
                      sizes(patch)[1], patch.before.owner.size(), operation.constraint.most_edges == 1);
  text += numbers(entries);
  return text + (has_surface ? fmt::format("    }}}},\n    {},\n{}{}}};\n", surface.vertices, triangles(surface.before),
                                           triangles(surface.after))
                             : "    }};\n");
}

}  // namespace

OperationHeader operation_header(const std::vector<AnsweredPosition>& positions) {
  const Description& named = *positions.at(0).position.family;
  const unsigned width = width_of(positions);
  std::vector<std::int64_t> entries;
  std::string of_positions;
  for (const auto& [position, section] : positions) {
    const Operation operation = operation_at(position);
    const auto& [before, after] = sizes(operation.patch);
    of_positions += fmt::format("    {{{{{}}}, {}, {}, {}, {}}},\n", fmt::join(position.numbers(), ", "), before, after,
                                operation.patch.before.ports(), entries.size());
    append_entries(*section, operation, width, entries);
  }
  std::string text = fmt::format(
      "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained in "
      "restrip/tables/operation_format.hpp.\n#pragma once\n\n#include \"restrip/tables/operation_format.hpp\"\n\n"
      "namespace restrip::tables {{\n\n",
      named.about.empty() ? named.name : named.about, named.name);
  if (named.numbers.empty())
    text += operation_table(named, operation_at(positions[0].position), width, entries);
  else
    text += fmt::format(
        "inline constexpr OperationFamily<std::uint{}_t, {}, {}> {}{{\n    {},\n    {},\n    {{{{\n{}    }}}},\n    "
        "{{\n{}    }}}};\n",
        width, entries.size(), positions.size(), variable(named.name), named.constraint.most_edges == 1,
        quoted_place(named), of_positions, numbers(entries));
  return {text + "\n}  // namespace restrip::tables\n", entries.size() * width / 8};
}

std::string operation_certificate_path(const std::string& name) { return "certificates/operations/" + name + ".cert"; }

std::string operation_header_path(const std::string& name) {
  return "include/restrip/tables/operations/" + variable(name) + ".hpp";
}

}  // namespace restrip::generator
