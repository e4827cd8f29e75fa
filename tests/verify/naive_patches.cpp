// The patches of docs/reference/notation.md, written by hand: triangles t_0 …, then A, then D.

#include <fmt/format.h>

#include "naive_tables.hpp"

namespace restrip::verify::test {
namespace {

/// Triangles in their order around or along the fan.
using Order = std::vector<unsigned>;

Side fan_side(unsigned k, const Order& order, bool closed, bool chord) {
  Side side;
  side.triangles = static_cast<unsigned>(order.size());
  for (unsigned port = 0; port < k; ++port) {
    side.owner_of_port.push_back(port);
    side.names.push_back(fmt::format("t{}", port));
  }
  if (order.size() > k) side.names.emplace_back("A");
  if (order.size() > k + 1) side.names.emplace_back("D");
  for (std::size_t i = 0; i + 1 < order.size(); ++i) side.edges.push_back({order[i], order[i + 1]});
  if (closed) side.edges.push_back({order.back(), order.front()});
  if (chord) side.edges.push_back({k, k + 1});
  return side;
}

/// A precedes the triangle of its gap, and D, if it exists, the triangle of its gap.
Order order_with(unsigned k, std::optional<unsigned> gap_of_a, std::optional<unsigned> gap_of_d) {
  Order order;
  for (unsigned i = 0; i <= k; ++i) {
    if (gap_of_a == i) order.push_back(k);
    if (gap_of_d == i) order.push_back(k + 1);
    if (i < k) order.push_back(i);
  }
  return order;
}

}  // namespace

Operation operation_by_hand(const std::string& name, const std::vector<unsigned>& position) {
  Operation operation;
  operation.family = name;
  operation.numbers = position;
  operation.cost = {{{Count::strips}}, {{Count::isolated}, {Count::given_up}}, {{Count::given_up}}};
  if (name == "flip") {
    operation.before = {2, {{0, 1}}, {0, 0, 1, 1}, {}, {}, {}};
    operation.after = {2, {{0, 1}}, {1, 0, 0, 1}, {}, {}, {}};
    operation.may_give_up = 15;
    return operation;
  }
  const unsigned k = position.at(0);
  const bool closed = name == "split" || name == "collapse";
  const bool one_triangle = name.starts_with("boundary");
  const unsigned a = closed ? 0 : position.at(1);
  const auto d = one_triangle ? std::nullopt : std::optional(position.at(closed ? 1 : 2));
  operation.before = fan_side(k, order_with(k, {}, {}), closed, false);
  operation.after = fan_side(k, order_with(k, a, d), closed, !one_triangle);
  if (!name.ends_with("split")) std::swap(operation.before, operation.after);
  operation.position = closed         ? fmt::format("k {} a {}", k, position[1])
                       : one_triangle ? fmt::format("k {} gap {}", k, a)
                                      : fmt::format("k {} gaps {} {}", k, a, *d);
  return operation;
}

std::vector<NaiveFamily> naive_families(int max_k) {
  const auto at = [](const std::string& name, const std::vector<unsigned>& position) {
    return NaiveOperation(operation_by_hand(name, position));
  };
  NaiveFamily split{"split", {}};
  NaiveFamily collapse{"collapse", {}};
  NaiveFamily open_split{"open-split", {}};
  NaiveFamily boundary_split{"boundary-split", {}};
  NaiveFamily fan_collapse{"fan-collapse", {}};
  for (unsigned k = 1; k <= static_cast<unsigned>(max_k); ++k) {
    const std::string all_of_k = fmt::format("k {}", k);
    if (k >= 3) collapse.sections.push_back({all_of_k, true, {}});
    for (unsigned a = 1; a <= k / 2 && k >= 3; ++a) {
      split.sections.push_back({fmt::format("k {} a {}", k, a), false, {at("split", {k, a})}});
      collapse.sections.back().operations.push_back(at("collapse", {k, a}));
    }
    fan_collapse.sections.push_back({all_of_k, true, {}});
    for (unsigned i = 0; i <= k; ++i)
      for (unsigned j = i + 1; i + j <= k; ++j) {
        open_split.sections.push_back({fmt::format("k {} gaps {} {}", k, i, j), false, {at("open-split", {k, i, j})}});
        fan_collapse.sections.back().operations.push_back(at("open-collapse", {k, i, j}));
      }
    for (unsigned i = 0; i <= k / 2; ++i) {
      boundary_split.sections.push_back({fmt::format("k {} gap {}", k, i), false, {at("boundary-split", {k, i})}});
      fan_collapse.sections.back().operations.push_back(at("boundary-collapse", {k, i}));
    }
  }
  return {split, collapse, open_split, boundary_split, fan_collapse, {"flip", {{"flip", false, {at("flip", {})}}}}};
}

NaiveSection naive_section(const Operation& operation) {
  return {operation.family, false, {NaiveOperation(operation)}};
}

}  // namespace restrip::verify::test
