#include "emit/served.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <variant>

#include "describe/description_file.hpp"

namespace restrip::generator {
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

enum class Fan { closed, open };

/// The fan formed by a side: one port at each triangle, each next to the previous one.
std::optional<Fan> fan_of(const Side& side) {
  if (side.ports() != side.nodes) return {};
  std::vector<unsigned> sorted = side.owner;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return {};
  for (std::size_t i = 0; i + 1 < side.owner.size(); ++i)
    if (!are_neighbours(side, side.owner[i], side.owner[i + 1])) return {};
  if (side.edges.size() + 1 == side.nodes) return Fan::open;
  return side.edges.size() == side.nodes && are_neighbours(side, side.owner.back(), side.owner.front())
             ? std::optional(Fan::closed)
             : std::nullopt;
}

/// The same for all its positions.
Fan fan_of(const Description& family) {
  std::optional<Fan> fan;
  const std::vector<Position> positions = positions_up_to(family, default_max_k);
  for (const Position& position : positions) {
    const std::optional<Fan> here = fan_of(make_patch(position).after);
    if (!here || (fan && fan != here))
      refuse(family, fmt::format("the side after of {} is not a fan with one port at each triangle, in their order",
                                 name_of(position)));
    fan = here;
  }
  if (!fan) refuse(family, fmt::format("it has no position up to {}", default_max_k));
  return *fan;
}

/// The number of triangles after the operation, valid at all checked positions.
Sum triangles_after(const Description& family) {
  Sum all;
  const auto add = [&](const std::optional<Stretch::Range>& range) {
    if (!range) ++all.constant;
    for (const auto& [sum, sign] : {std::pair{range ? range->to : Sum{}, 1}, {range ? range->from : Sum{}, -1}}) {
      for (std::size_t i = 0; i < all.factors.size(); ++i) all.factors.at(i) += sign * sum.factors.at(i);
      all.constant += sign * sum.constant;
    }
  };
  if (const auto* triangles = std::get_if<TrianglePatterns>(&family.after))
    for (const TrianglePattern& triangle : *triangles) add(triangle.index ? triangle.index->range : std::nullopt);
  else
    for (const Chain& chain : std::get<SidePattern>(family.after).chains)
      for (const Stretch& stretch : chain.elements) add(stretch.range);
  // A range that ends before it begins is empty, and the sum is smaller.
  for (const Position& position : positions_up_to(family, default_max_k))
    if (const unsigned nodes = make_patch(position).after.nodes; all.at(position.numbers()) != static_cast<int>(nodes))
      refuse(family, fmt::format("{} has {} triangles after the operation, but its ranges as a sum give {}",
                                 name_of(position), nodes, all.at(position.numbers())));
  return all;
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
  const bool closed = fan_of(family) == Fan::closed;
  const Sum size = triangles_after(family);
  const std::string call = fmt::format("best({}_fan({}), ", closed ? "closed" : "open", text_of(size));
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
