#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <variant>

#include "describe/description.hpp"
#include "emit/emit.hpp"

namespace restrip::generator {
namespace {

std::string banner(const std::string& what) {
  return fmt::format(
      "// {}\n// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target "
      "`regenerate`.\n"
      "// Format 1, explained in restrip/tables/format.hpp.\n#pragma once\n\n#include "
      "\"restrip/tables/format.hpp\"\n\n"
      "namespace restrip::tables {{\n\n",
      what);
}

constexpr const char* footer = "\n}  // namespace restrip::tables\n";

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
      const auto& [before, after] = sizes(at.position.patch);
      positions += fmt::format("    {{{{{}}}, {}, {}, {}, {}}},\n", fmt::join(at.position.numbers(), ", "), before,
                               after, at.position.patch.before.ports(), at.first);
    }
    rules = fmt::format("{},\n    {},\n    {{{{\n{}    }}}},\n    {{\n{}    }}}}", layout.matching(),
                        quoted_place(layout.named()), positions, numbers(layout.entries));
  } else {
    const auto& [before, after] = sizes(first.position.patch);
    rules = fmt::format("{},\n    {},\n    {},\n    {},\n    {{\n{}    }}}}", before, after,
                        first.position.patch.before.ports(), layout.matching(), numbers(layout.entries));
  }
  // The triangles of all positions, one after another; and for each position, the number of vertices and the start of
  // its triangles.
  Surface all;
  std::string positions;
  for (const OperationLayout::At& at : layout.positions) {
    const auto& [before, after, vertices] = at.position.patch.surface;
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

std::string rows_header(const Packing& packing, unsigned max_k) {
  return banner("Where the rows of keys start, index 1 << k | ports.") +
         fmt::format("inline constexpr RowStarts<{}> closed_rows{{\n", max_k) + numbers(packing.start) + "};\n" +
         footer;
}

RulesHeader rules_header(const Certificate& family, const Packing& packing, unsigned max_k) {
  const Section& first = family.sections.at(0);
  if (first.position.family->numbers.empty()) {
    // FlipTable of restrip/tables/format.hpp is the table of an operation with one position.
    const OperationLayout layout = operation_layout({{first.serves.at(0), &first}});
    const auto none = std::count(layout.entries.begin(), layout.entries.end(), layout.none());
    const auto valid = static_cast<std::ptrdiff_t>(layout.entries.size()) - none;
    return {banner(fmt::format("Rules of the {}: {} valid configurations.", family.name, valid)) +
                fmt::format("inline constexpr FlipTable {}{{\n", identifier(family.name)) + numbers(layout.entries) +
                "};\n" + footer,
            layout.bytes()};
  }
  const RuleBlocks blocks = fill(family.sections, packing, max_k);
  const bool wide = *std::max_element(blocks.rules.begin(), blocks.rules.end()) > 0xff;
  std::string text = banner(
      fmt::format("Rules of the family {}: {} in {} blocks.", family.name, family.rows(), family.sections.size()));
  text += fmt::format("inline constexpr RuleTable<{}, {}, {}> {}{{\n", wide ? "std::uint16_t" : "std::uint8_t", max_k,
                      blocks.rules.size(), identifier(family.name));
  text += "    {" + numbers(blocks.first).substr(4) + "    },\n    {" + numbers(blocks.cells).substr(4) +
          "    },\n    {\n" + numbers(blocks.rules) + "    },\n};\n";
  return {text + footer, blocks.rules.size() * (wide ? 2 : 1)};
}

std::string operation_header(const OperationLayout& layout) {
  const Description& named = layout.named();
  return fmt::format(
      "// {}\n// Written by `restrip-generate rules` from the operation file of {}. Do not edit.\n// Explained in "
      "restrip/tables/operation_format.hpp.\n#pragma once\n\n#include \"restrip/tables/operation_format.hpp\"\n\n"
      "namespace restrip::tables {{\n\ninline constexpr {}\n}}  // namespace restrip::tables\n",
      named.about.empty() ? named.name : named.about, named.name, table(layout, identifier(named.name) + "_rules"));
}

RulesHeader automaton_header(const Automaton& automaton) {
  const auto [seconds, table] = automaton_arrays(automaton);
  const std::vector<TableArray>& arrays = table.arrays;
  std::vector<std::size_t> next;
  for (const ArcClass& c : automaton.classes)
    for (const auto& step : c.steps) next.push_back(step ? step->to : UINT8_MAX);
  std::vector<std::uint64_t> before;
  for (std::size_t i = 0; i < next.size(); ++i)
    before.push_back(arrays[1].values[2 * i] | std::uint64_t{arrays[1].values[2 * i + 1]} << 32U);
  std::string text = fmt::format(
      "// Rules of fans of any valence: {} classes of arcs, {} pairs of classes.\n"
      "// The cost: {} for a strip, 0 for a swap, {} for an isolated triangle.\n"
      "// Written by `restrip-generate tables`. Do not edit: change the generator, then build the target "
      "`regenerate`.\n"
      "// Format 2, explained in restrip/tables/automaton_format.hpp.\n#pragma once\n\n"
      "#include \"restrip/tables/automaton_format.hpp\"\n\nnamespace restrip::tables {{\n\n",
      automaton.classes.size(), automaton.meets.size() * seconds, strip_cost, isolated_cost);
  text +=
      fmt::format("inline constexpr ArcAutomaton<std::uint8_t, {}, {}, {}, {}, {}> automaton{{\n", all_letters.size(),
                  automaton.classes.size(), automaton.meets.size(), seconds, arrays.back().values.size());
  const auto block = [&](const std::string& lines) { text += "    {\n" + lines + "    },\n"; };
  block(numbers(next));
  block(numbers(before, " {:#x},"));
  for (std::size_t i = 2; i < arrays.size(); ++i) block(numbers(arrays[i].values));
  return {text + "};\n\n}  // namespace restrip::tables\n", table.bytes()};
}

namespace {

[[noreturn]] void refuse(const Description& family, const std::string& reason) {
  throw std::runtime_error(
      fmt::format("{}: {}; no automaton answers it, try `restrip-generate rules`", family.name, reason));
}

bool are_neighbours(const Side& side, unsigned one, unsigned other) {
  return std::any_of(side.edges.begin(), side.edges.end(), [&](const Edge& edge) {
    return edge == Edge{one, other} || edge == Edge{other, one};
  });
}

enum class FanKind { closed, open };

/// The fan formed by a side: one port at each triangle, each next to the previous one.
std::optional<FanKind> fan_of(const Side& side) {
  if (side.ports() != side.nodes) return {};
  std::vector<unsigned> sorted = side.owner;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return {};
  for (std::size_t i = 0; i + 1 < side.owner.size(); ++i)
    if (!are_neighbours(side, side.owner[i], side.owner[i + 1])) return {};
  if (side.edges.size() + 1 == side.nodes) return FanKind::open;
  return side.edges.size() == side.nodes && are_neighbours(side, side.owner.back(), side.owner.front())
             ? std::optional(FanKind::closed)
             : std::nullopt;
}

/// What the side after is at every position up to the default limit, at all of which it is checked.
struct FanAfter {
  FanKind kind = FanKind::open;
  Sum triangles;
};
FanAfter fan_after(const Description& family) {
  FanAfter fan;
  for (const TrianglePattern& pattern : std::get<TrianglePatterns>(family.after)) {
    if (!pattern.index) ++fan.triangles.constant;
    if (!pattern.index) continue;
    const auto& [from, to] = *pattern.index->range;
    for (std::size_t i = 0; i < fan.triangles.factors.size(); ++i)
      fan.triangles.factors.at(i) += to.factors.at(i) - from.factors.at(i);
    fan.triangles.constant += to.constant - from.constant;
  }
  const std::vector<Position> positions = positions_up_to(family, default_max_k);
  if (positions.empty()) refuse(family, fmt::format("it has no position up to {}", default_max_k));
  std::optional<FanKind> first;
  for (const Position& position : positions) {
    const Side side = make_patch(position).after;
    const std::optional<FanKind> here = fan_of(side);
    if (!here || first.value_or(*here) != *here)
      refuse(family, fmt::format("the side after of {} is not a fan with one port at each triangle, in their order",
                                 name_of(position)));
    first = here;
    // A range that ends before it begins is empty, and the sum is smaller.
    if (const int sum = fan.triangles.at(position.numbers()); sum != static_cast<int>(side.nodes))
      refuse(family, fmt::format("{} has {} triangles after the operation, but its ranges as a sum give {}",
                                 name_of(position), side.nodes, sum));
  }
  fan.kind = *first;
  return fan;
}

/// "k + 2 * i - 1", with the numbers' names by index.
constexpr std::array<const char*, 3> number_names{"k", "i", "j"};
std::string text_of(const Sum& sum) {
  std::string text;
  const auto add = [&](int factor, const std::string& what) {
    if (factor != 0)
      text += fmt::format("{}{}{}", text.empty() ? "" : " ", factor < 0 ? "- " : text.empty() ? "" : "+ ", what);
  };
  for (std::size_t i = 0; i < sum.factors.size(); ++i) {
    const int size = std::abs(sum.factors.at(i));
    add(sum.factors.at(i), size == 1 ? number_names.at(i) : fmt::format("{} * {}", size, number_names.at(i)));
  }
  add(sum.constant, std::to_string(std::abs(sum.constant)));
  return text.empty() ? "0" : text;
}

}  // namespace

std::string served_header(const Description& family) {
  if (family.numbers.empty()) refuse(family, "it is an operation with one position");
  if (family.constraint.most_edges != 2) refuse(family, "its solid edges are not strips");
  if (family.own_cost) refuse(family, "it has a custom cost");
  if (family.may_give_up != 0) refuse(family, "it may give ports up");
  const FanAfter fan = fan_after(family);
  const Sum& size = fan.triangles;
  const std::string call =
      fmt::format("best({}_fan({}), ", fan.kind == FanKind::closed ? "closed" : "open", text_of(size));
  // The call uses those on which the number of ports depends.
  std::string parameters;
  for (std::size_t i = 0; i < family.numbers.size(); ++i)
    parameters +=
        fmt::format("{}std::size_t {}, ", size.factors.at(i) == 0 ? "[[maybe_unused]] " : "", number_names.at(i));
  const std::string name = identifier(family.name);
  return fmt::format(
      "// {}\n"
      "// Written by `restrip-generate automaton --operation` from the operation file of {}. Do not edit.\n"
      "// Explained in docs/explanation/automaton.md, \"Custom families\".\n"
      "#pragma once\n\n"
      "#include \"restrip/rules/exact.hpp\"\n\n"
      "namespace restrip::exact {{\n\n"
      "/// The best recolouring that keeps every port. The numbers of the family in their order: {}; {}.\n"
      "constexpr Recoloring best_of_{}({}Word ports, Word joined) noexcept {{\n"
      "  return {}ports, joined);\n"
      "}}\n"
      "/// The same for bit strings, which may have any length.\n"
      "inline Value best_of_{}({}BitSpan ports, BitSpan joined, MutableBitSpan colors) {{\n"
      "  return {}ports, joined, colors);\n"
      "}}\n\n"
      "}}  // namespace restrip::exact\n",
      family.about.empty() ? family.name : family.about, family.name, fmt::join(family.numbers, ", "),
      family.range.empty() ? "any" : family.range, name, parameters, call, name, parameters, call);
}

}  // namespace restrip::generator
