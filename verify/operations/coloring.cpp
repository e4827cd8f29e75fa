#include "coloring.hpp"

#include <fmt/format.h>

#include "operation_mutants.hpp"
#include "quantity.hpp"

namespace restrip::verify::operations {

std::optional<SolidGraph> inner_graph(const Side& side, Mask inner) {
  SolidGraph graph;
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    if (is_solid(inner, edge) && !graph.join(side.edges[edge][0], side.edges[edge][1]) &&
        !mutated(OperationMutant::forget_cycles))
      return {};
  return graph;
}

std::array<unsigned, most_triangles> degrees(const Side& side, Colors colors) {
  std::array<unsigned, most_triangles> count{};
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    if (is_solid(colors.inner, edge))
      for (const unsigned triangle : side.edges[edge]) ++count[triangle];
  for (unsigned port = 0; port < side.ports(); ++port)
    if (is_solid(colors.ports, port) && !mutated(OperationMutant::forget_port_degree))
      ++count[side.owner_of_port[port]];
  return count;
}

PortPairs joined_ports(const Side& side, const SolidGraph& inner, Mask ports) {
  PortPairs joined;
  for (unsigned j = 1; j < side.ports(); ++j)
    for (unsigned i = 0; i < j; ++i)
      if (is_solid(ports, i) && is_solid(ports, j) && inner.connected(side.owner_of_port[i], side.owner_of_port[j]))
        joined.add(i, j);
  return joined;
}

std::string invalid_because(const Side& side, Colors colors, unsigned most_solid) {
  const std::array<unsigned, most_triangles> count = degrees(side, colors);
  for (unsigned triangle = 0; triangle < side.triangles; ++triangle)
    if (count[triangle] > most_solid) return fmt::format("triangle {} has {} solid edges", triangle, count[triangle]);
  return inner_graph(side, colors.inner) ? "" : "solid inner edges close a cycle";
}

std::string drawn(const Side& side, Colors colors) {
  std::string text = side.edges.empty() ? quantity(side.triangles, "triangle") + " without edges" : "edges";
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    text += fmt::format(" {}{}{}", side.edges[edge][0], is_solid(colors.inner, edge) ? '=' : '-', side.edges[edge][1]);
  text += ", ports";
  for (unsigned port = 0; port < side.ports(); ++port)
    text += fmt::format(" {}{}", port, is_solid(colors.ports, port) ? '"' : ':');
  return text;
}

}  // namespace restrip::verify::operations
