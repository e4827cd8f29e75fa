#include "automaton/row_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <vector>

#include "operations/description_file.hpp"
#include "solve/coloring.hpp"

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
  std::vector<unsigned> sorted = row;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return false;
  for (unsigned i = 0; i + 1 < side.nodes; ++i)
    if (std::none_of(side.edges.begin(), side.edges.end(), [&](const Edge& edge) {
          return edge == Edge{row[i], row[i + 1]} || edge == Edge{row[i + 1], row[i]};
        }))
      return false;
  return (!shape.front || side.owner[port_at(shape, 0, ports)] == row.front()) &&
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
          fmt::format("{} is after the operation no row of triangles, open at its ends, with one port at each, in "
                      "their order, and perhaps one more at the first and at the last",
                      name_of(position)));
    for (const Coloring& coloring : legal_colorings(operation.patch.before, operation.constraint))
      for (Mask ports = 0; ports <= operation.patch.before.all_ports(); ++ports)
        if (const auto outcome = with_ports(coloring, ports))
          for (const Mask pair : outcome->joined.masks())
            if (!follow_each_other(ports, pair))
              throw std::runtime_error(fmt::format(
                  "{} joins before the operation solid ports that do not follow each other", name_of(position)));
  }
  return shapes.front();
}

}  // namespace restrip::generator
