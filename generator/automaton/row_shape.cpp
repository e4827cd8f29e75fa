#include "automaton/row_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <vector>

#include "operations/description_file.hpp"
#include "solve/section.hpp"

namespace restrip::generator {
namespace {

/// The port at a place of the row, the one in front included.
unsigned port_at(const RowShape& shape, unsigned place, unsigned ports) {
  return (place + (shape.from_end ? ports - shape.first : shape.first)) % ports;
}

bool fits(const Side& side, const RowShape& shape) {
  const unsigned front = shape.front ? 1 : 0;
  const unsigned back = shape.back ? 1 : 0;
  const unsigned ports = side.ports();
  if (side.nodes + front + back != ports || side.edges.size() + 1 != side.nodes || shape.first >= ports) return false;
  std::vector<unsigned> row;
  for (unsigned i = 0; i < side.nodes; ++i) row.push_back(side.owner[port_at(shape, front + i, ports)]);
  return is_row(side, row) && (!shape.front || side.owner[port_at(shape, 0, ports)] == row.front()) &&
         (!shape.back || side.owner[port_at(shape, ports - 1, ports)] == row.back());
}

/// In cyclic order: no solid port lies between them on one side.
bool follow_each_other(Mask ports, Mask pair) {
  const auto low = static_cast<unsigned>(std::countr_zero(pair));
  const auto high = static_cast<unsigned>(std::bit_width(pair)) - 1;
  const Mask between = ((Mask{1} << high) - 1) & ~((Mask{2} << low) - 1);
  return (ports & between) == 0 || (ports & ~between & ~pair) == 0;
}

}  // namespace

bool are_neighbours(const Side& side, unsigned one, unsigned other) {
  return std::any_of(side.edges.begin(), side.edges.end(), [&](const Edge& edge) {
    return edge == Edge{one, other} || edge == Edge{other, one};
  });
}

bool is_row(const Side& side, const std::vector<unsigned>& triangles) {
  std::vector<unsigned> sorted = triangles;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
  for (std::size_t i = 0; i + 1 < triangles.size(); ++i)
    if (!are_neighbours(side, triangles[i], triangles[i + 1])) return false;
  return true;
}

RowShape row_shape_of(const Description& family) {
  std::vector<RowShape> shapes;
  for (const bool from_end : {false, true})
    for (unsigned first = from_end ? 1 : 0; first < most_ports; ++first)
      for (const unsigned ends : {3U, 2U, 1U, 0U}) shapes.push_back({(ends & 1U) != 0, ends >= 2, first, from_end});
  const std::vector<Position> positions = positions_up_to(family, most_ports);
  if (positions.empty()) throw std::runtime_error(fmt::format("it has no position up to {}", most_ports));
  for (const Position& position : positions) {
    const Operation operation = operation_at(position);
    std::erase_if(shapes, [&](const RowShape& shape) { return !fits(operation.patch.after, shape); });
    if (shapes.empty())
      throw std::runtime_error(
          fmt::format("the side after of {} is no row of triangles, open at both ends, with one port at each, in "
                      "their order, and at most one more at the first and at the last",
                      name_of(position)));
    for_each_valid(operation, [&](const Configuration& configuration) {
      for (const Mask pair : configuration.outcome.joined.masks())
        if (!follow_each_other(configuration.ports, pair))
          throw std::runtime_error(fmt::format(
              "before the operation, {} joins solid ports that do not follow each other", name_of(position)));
    });
  }
  return shapes.front();
}

}  // namespace restrip::generator
