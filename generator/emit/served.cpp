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
