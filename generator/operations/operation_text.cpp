#include "operations/operation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "emit.hpp"
#include "number_lines.hpp"

namespace restrip::generator {
namespace {

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
std::string operation_table(const OperationLayout& layout) {
  const Description& named = layout.named();
  const Patch& patch = layout.positions[0].patch;
  const Surface& surface = named.surface;
  const bool has_surface = !surface.before.empty();
  const std::string triangle_counts =
      has_surface ? fmt::format(", {}, {}", surface.before.size(), surface.after.size()) : std::string();
  std::string text = fmt::format("inline constexpr {}<std::uint{}_t, {}{}> {}{{\n",
                                 has_surface ? "SurfaceOperation" : "OperationTable", layout.width,
                                 layout.entries.size(), triangle_counts, identifier(named.name));
  text += fmt::format("    {}{},\n    {},\n    {},\n    {},\n    {{\n", has_surface ? "{" : "", sizes(patch)[0],
                      sizes(patch)[1], patch.before.owner.size(), layout.matching());
  text += numbers(layout.entries);
  return text + (has_surface ? fmt::format("    }}}},\n    {},\n{}{}}};\n", surface.vertices, triangles(surface.before),
                                           triangles(surface.after))
                             : "    }};\n");
}

/// The same of a family.
std::string family_table(const OperationLayout& layout) {
  std::string positions;
  for (const OperationLayout::At& at : layout.positions) {
    const auto& [before, after] = sizes(at.patch);
    positions += fmt::format("    {{{{{}}}, {}, {}, {}, {}}},\n", fmt::join(at.position.numbers(), ", "), before, after,
                             at.patch.before.ports(), at.first);
  }
  return fmt::format(
      "inline constexpr OperationFamily<std::uint{}_t, {}, {}> {}{{\n    {},\n    {},\n    {{{{\n{}    }}}},\n    "
      "{{\n{}    }}}};\n",
      layout.width, layout.entries.size(), layout.positions.size(), identifier(layout.named().name), layout.matching(),
      quoted_place(layout.named()), positions, numbers(layout.entries));
}

}  // namespace

std::string operation_header(const OperationLayout& layout) {
  const Description& named = layout.named();
  std::string text = fmt::format(
      "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained in "
      "restrip/tables/operation_format.hpp.\n#pragma once\n\n#include \"restrip/tables/operation_format.hpp\"\n\n"
      "namespace restrip::tables {{\n\n",
      named.about.empty() ? named.name : named.about, named.name);
  if (named.numbers.empty())
    text += operation_table(layout);
  else
    text += family_table(layout);
  return text + "\n}  // namespace restrip::tables\n";
}

std::string operation_certificate_path(const std::string& name) { return "certificates/operations/" + name + ".cert"; }

std::string operation_header_path(const std::string& name) {
  return "include/restrip/tables/operations/" + identifier(name) + ".hpp";
}

}  // namespace restrip::generator
