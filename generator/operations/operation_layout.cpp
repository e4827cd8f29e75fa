#include "operations/operation_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "tables/emit.hpp"
#include "tables/number_lines.hpp"

namespace restrip::generator {
namespace {

/// Bits of an entry's type: at least one more than a rule has, so that all ones means none.
unsigned width_of(const std::vector<OperationLayout::At>& positions) {
  std::size_t bits = 0;
  for (const OperationLayout::At& at : positions)
    bits = std::max(bits, at.patch.after.edges.size() + at.patch.after.owner.size());
  return bits < 8 ? 8 : bits < 16 ? 16 : 32;
}

/// Appends the entries of one position.
void append_entries(const AnsweredPosition& answered, OperationLayout& layout) {
  const Operation operation = operation_at(answered.position);
  const Side& before = operation.patch.before;
  const unsigned ports = before.ports();
  const std::size_t first = layout.entries.size();
  // For matchings, whose keys are the ports, entry P serves every colouring.
  const bool matching = layout.matching();
  layout.entries.resize(first + (std::size_t{1} << (matching ? ports : before.edges.size() + ports)), layout.none());
  for_each_valid(operation, [&](const Configuration& c) {
    const Row& row = row_of(*answered.section, c.ports, c.outcome.joined);
    layout.entries[first + (matching ? c.ports : std::size_t{c.before} << ports | c.ports)] =
        row.recoloring << ports | row.kept;
  });
}

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

/// The form of the list in the header.
std::string triangles(const std::vector<SurfaceTriangle>& met) {
  std::vector<std::string> words;
  words.reserve(met.size());
  for (const SurfaceTriangle& t : met)
    words.push_back(fmt::format("{{{}, {}, {{{}}}, {{{}}}}}", t.from, t.from_side, fmt::join(t.vertex, ", "),
                                fmt::join(t.side, ", ")));
  return "    {{\n" + numbers(words) + "    }},\n";
}

/// The triangles of all positions, one after another.
struct Triangles {
  std::vector<SurfaceTriangle> before;
  std::vector<SurfaceTriangle> after;
  std::string positions;  ///< for each position, the number of vertices and the start of its triangles
  unsigned vertices = 0;  ///< of the last one

  explicit Triangles(const OperationLayout& layout) {
    for (const OperationLayout::At& at : layout.positions) {
      const Surface surface = surface_at(at.position);
      vertices = surface.vertices;
      positions += fmt::format("    {{{}, {}, {}}},\n", vertices, before.size(), after.size());
      before.insert(before.end(), surface.before.begin(), surface.before.end());
      after.insert(after.end(), surface.after.begin(), surface.after.end());
    }
  }
  [[nodiscard]] std::string counts() const { return fmt::format(", {}, {}", before.size(), after.size()); }
  [[nodiscard]] std::string text() const { return triangles(before) + triangles(after) + "};\n"; }
};

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
  const Triangles surface(layout);
  return fmt::format("Surface{}<{}{}> {}{{\n    {{{},\n    {},\n{}", is_family ? "Family" : "Operation", arguments,
                     surface.counts(), name, rules,
                     is_family ? fmt::format("{{{{\n{}    }}}}", surface.positions) : std::to_string(surface.vertices),
                     surface.text());
}

}  // namespace

OperationLayout operation_layout(const std::vector<AnsweredPosition>& positions) {
  OperationLayout layout;
  for (const AnsweredPosition& answered : positions)
    layout.positions.push_back({answered.position, make_patch(answered.position), 0});
  layout.width = width_of(layout.positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    layout.positions[i].first = layout.entries.size();
    append_entries(positions[i], layout);
  }
  return layout;
}

std::string operation_header(const OperationLayout& layout) {
  const Description& named = layout.named();
  return fmt::format(
      "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained in "
      "restrip/tables/operation_format.hpp.\n#pragma once\n\n#include \"restrip/tables/operation_format.hpp\"\n\n"
      "namespace restrip::tables {{\n\ninline constexpr {}\n}}  // namespace restrip::tables\n",
      named.about.empty() ? named.name : named.about, named.name, table(layout, identifier(named.name)));
}

std::string operation_certificate_path(const std::string& name) { return "certificates/operations/" + name + ".cert"; }

std::string operation_header_path(const std::string& name) {
  return "include/restrip/tables/operations/" + identifier(name) + ".hpp";
}

}  // namespace restrip::generator
