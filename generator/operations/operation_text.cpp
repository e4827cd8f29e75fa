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

/// Of all positions, one after another.
struct Triangles {
  std::vector<SurfaceTriangle> before;
  std::vector<SurfaceTriangle> after;
  std::string positions;  ///< for each how many vertices there are, and where its triangles begin
  unsigned vertices = 0;  ///< of the last one

  explicit Triangles(const std::vector<AnsweredPosition>& all) {
    for (const auto& [position, section] : all) {
      const Surface surface = surface_at(position);
      vertices = surface.vertices;
      positions += fmt::format("    {{{}, {}, {}}},\n", vertices, before.size(), after.size());
      before.insert(before.end(), surface.before.begin(), surface.before.end());
      after.insert(after.end(), surface.after.begin(), surface.after.end());
    }
  }
  [[nodiscard]] std::string counts() const { return fmt::format(", {}, {}", before.size(), after.size()); }
  [[nodiscard]] std::string text() const { return triangles(before) + triangles(after) + "};\n"; }
};

/// The table of an operation, from its name on; `start` is what stands before its number of entries.
std::string operation_table(const Position& position, const std::string& start, const std::string& entries,
                            const Triangles& surface) {
  const Operation operation = operation_at(position);
  const Patch& patch = operation.patch;
  const auto& [before, after] = sizes(patch);
  const bool graph = position.family->is_graph_only();
  const std::string rules = fmt::format("{},\n    {},\n    {},\n    {},\n    {{\n{}    }}}}", before, after,
                                        patch.before.ports(), operation.constraint.most_edges == 1, entries);
  if (graph) return fmt::format("OperationTable<{}> {}{{\n    {};\n", start, variable(position.family->name), rules);
  return fmt::format("SurfaceOperation<{}{}> {}{{\n    {{{},\n    {},\n{}", start, surface.counts(),
                     variable(position.family->name), rules, surface.vertices, surface.text());
}

/// The same of a family.
std::string family_table(const Description& family, const std::string& start, const std::string& positions,
                         const std::string& entries, const Triangles& surface) {
  const std::string rules = fmt::format("{},\n    {},\n    {{{{\n{}    }}}},\n    {{\n{}    }}}}",
                                        family.constraint.most_edges == 1, quoted_place(family), positions, entries);
  if (family.is_graph_only())
    return fmt::format("OperationFamily<{}> {}{{\n    {};\n", start, variable(family.name), rules);
  return fmt::format("SurfaceFamily<{}{}> {}{{\n    {{{},\n    {{{{\n{}    }}}},\n{}", start, surface.counts(),
                     variable(family.name), rules, surface.positions, surface.text());
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
  const std::string start = fmt::format("std::uint{}_t, {}", width, entries.size());
  const Triangles surface(positions);
  return {fmt::format(
              "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained "
              "in restrip/tables/operation_format.hpp.\n#pragma once\n\n#include "
              "\"restrip/tables/operation_format.hpp\"\n\nnamespace restrip::tables {{\n\ninline constexpr {}\n}}  // "
              "namespace restrip::tables\n",
              named.about.empty() ? named.name : named.about, named.name,
              named.numbers.empty() ? operation_table(positions[0].position, start, numbers(entries), surface)
                                    : family_table(named, fmt::format("{}, {}", start, positions.size()), of_positions,
                                                   numbers(entries), surface)),
          entries.size() * width / 8};
}

std::string operation_certificate_path(const std::string& name) { return "certificates/operations/" + name + ".cert"; }

std::string operation_header_path(const std::string& name) {
  return "include/restrip/tables/operations/" + variable(name) + ".hpp";
}

}  // namespace restrip::generator
