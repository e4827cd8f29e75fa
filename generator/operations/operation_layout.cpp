#include "operations/operation_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "tables/emit.hpp"
#include "tables/number_lines.hpp"

namespace restrip::generator {
namespace {

/// Triangles and inner edges before and after.
std::array<std::string, 2> sizes(const Patch& patch) {
  const auto size = [](const Side& side) { return fmt::format("{{{}, {}}}", side.nodes, side.edges.size()); };
  return {size(patch.before), size(patch.after)};
}

/// A position as dumps write it, with indices instead of the numbers' names: "k {0} a {1}", as a C++ string.
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

/// The list of triangles in the header.
std::string triangle_list(const std::vector<SurfaceTriangle>& met) {
  std::vector<std::string> words;
  words.reserve(met.size());
  for (const SurfaceTriangle& t : met)
    words.push_back(fmt::format("{{{}, {}, {{{}}}, {{{}}}}}", t.from, t.from_side, fmt::join(t.vertex, ", "),
                                fmt::join(t.side, ", ")));
  return "    {{\n" + numbers(words) + "    }},\n";
}

/// The table of an operation or a family, starting with its type.
std::string table(const OperationLayout& layout, const std::string& name) {
  const OperationLayout::At& first = layout.positions[0];
  const bool is_family = !layout.named().numbers.empty();
  std::string arguments = fmt::format("std::uint{}_t, {}", layout.width, layout.entries.size());
  std::string rules;
  if (is_family) {
    arguments += fmt::format(", {}", layout.positions.size());
    std::string positions;
    for (const OperationLayout::At& at : layout.positions) {
      const auto& [before, after] = sizes(at.patch);
      positions += fmt::format("    {{{{{}}}, {}, {}, {}, {}}},\n", fmt::join(at.position.numbers(), ", "), before,
                               after, at.patch.before.ports(), at.first);
    }
    rules = fmt::format("{},\n    {},\n    {{{{\n{}    }}}},\n    {{\n{}    }}}}", layout.matching(),
                        quoted_place(layout.named()), positions, numbers(layout.entries));
  } else {
    const auto& [before, after] = sizes(first.patch);
    rules = fmt::format("{},\n    {},\n    {},\n    {},\n    {{\n{}    }}}}", before, after, first.patch.before.ports(),
                        layout.matching(), numbers(layout.entries));
  }
  if (layout.named().is_graph_only())
    return fmt::format("Operation{}<{}> {}{{\n    {};\n", is_family ? "Family" : "Table", arguments, name, rules);
  // The triangles of all positions, one after another; and for each position, the number of vertices and the start of
  // its triangles.
  Surface all;
  std::string positions;
  for (const OperationLayout::At& at : layout.positions) {
    const auto [before, after, vertices] = surface_at(at.position);
    positions += fmt::format("    {{{}, {}, {}}},\n", vertices, all.before.size(), all.after.size());
    all.before.insert(all.before.end(), before.begin(), before.end());
    all.after.insert(all.after.end(), after.begin(), after.end());
    all.vertices = vertices;
  }
  return fmt::format("Surface{}<{}, {}, {}> {}{{\n    {{{},\n    {},\n{}{}}};\n", is_family ? "Family" : "Operation",
                     arguments, all.before.size(), all.after.size(), name, rules,
                     is_family ? fmt::format("{{{{\n{}    }}}}", positions) : std::to_string(all.vertices),
                     triangle_list(all.before), triangle_list(all.after));
}

}  // namespace

OperationLayout operation_layout(const std::vector<AnsweredPosition>& positions) {
  OperationLayout layout;
  // An entry has at least one bit more than a rule, so that all ones means none.
  std::size_t bits = 0;
  for (const auto& [position, section] : positions) {
    const Patch& patch = layout.positions.emplace_back(OperationLayout::At{position, make_patch(position), 0}).patch;
    bits = std::max(bits, patch.after.edges.size() + patch.after.owner.size());
  }
  layout.width = bits < 8 ? 8 : bits < 16 ? 16 : 32;
  // For matchings, whose keys are the ports, entry P serves every colouring.
  const bool matching = layout.matching();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Operation operation = operation_at(positions[i].position);
    const Side& before = operation.patch.before;
    const unsigned ports = before.ports();
    const std::size_t first = layout.entries.size();
    layout.positions[i].first = first;
    layout.entries.resize(first + (std::size_t{1} << (matching ? ports : before.edges.size() + ports)), layout.none());
    for_each_valid(operation, [&](const Configuration& c) {
      const Row& row = row_of(*positions[i].section, c.ports, c.outcome.joined);
      layout.entries[first + (matching ? c.ports : std::size_t{c.before} << ports | c.ports)] =
          row.recoloring << ports | row.kept;
    });
  }
  return layout;
}

std::string operation_header(const OperationLayout& layout) {
  const Description& named = layout.named();
  return fmt::format(
      "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained in "
      "restrip/tables/operation_format.hpp.\n#pragma once\n\n#include \"restrip/tables/operation_format.hpp\"\n\n"
      "namespace restrip::tables {{\n\ninline constexpr {}\n}}  // namespace restrip::tables\n",
      named.about.empty() ? named.name : named.about, named.name, table(layout, identifier(named.name) + "_rules"));
}

}  // namespace restrip::generator
