#include "model/coloring.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/counted.hpp"

namespace restrip::verify {

std::optional<SolidGraph> inner_graph(const Side& side, Mask inner) {
  SolidGraph graph;
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    if (is_solid(inner, edge) && !graph.join(side.edges[edge][0], side.edges[edge][1])) return {};
  return graph;
}

Degrees degrees(const Side& side, Colors colors) {
  Degrees count{};
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    if (is_solid(colors.inner, edge))
      for (const unsigned triangle : side.edges[edge]) ++count[triangle];
  for (unsigned port = 0; port < side.ports(); ++port)
    if (is_solid(colors.ports, port)) ++count[side.owner_of_port[port]];
  return count;
}

std::optional<SolidGraph> valid_graph(const Side& side, Colors colors, unsigned most_solid) {
  const Degrees count = degrees(side, colors);
  if (*std::max_element(count.begin(), count.end()) > most_solid) return {};
  return inner_graph(side, colors.inner);
}

PortPairs joined_ports(const Side& side, const SolidGraph& inner, Mask ports) {
  PortPairs joined;
  for (unsigned j = 1; j < side.ports(); ++j)
    for (unsigned i = 0; i < j; ++i)
      if (is_solid(ports, i) && is_solid(ports, j) && inner.connected(side.owner_of_port[i], side.owner_of_port[j]))
        joined.add(i, j);
  return joined;
}

unsigned isolated_of(const Side& side, Colors colors) {
  const Degrees degree = degrees(side, colors);
  return static_cast<unsigned>(std::count(degree.begin(), degree.begin() + side.triangles, 0U));
}

int strips_of(const Side& side, Colors colors) {
  return static_cast<int>(side.triangles) - static_cast<int>(solid_count(colors.inner)) -
         static_cast<int>(solid_count(colors.ports));
}

Change change_of(const Operation& operation, Colors configuration, Colors after) {
  return {strips_of(operation.after, after) - strips_of(operation.before, configuration),
          static_cast<int>(isolated_of(operation.after, after) + solid_count(configuration.ports & ~after.ports)) -
              static_cast<int>(isolated_of(operation.before, configuration))};
}

Survey survey(const Side& side, Colors colors) {
  Survey result;
  const std::optional<SolidGraph> inner = valid_graph(side, colors, most_solid(Constraint::strips));
  if (!inner) return result;
  result.valid = true;
  result.isolated = isolated_of(side, colors);
  result.joined = joined_ports(side, *inner, colors.ports);
  return result;
}

std::string name_of(const Side& side, unsigned triangle) {
  return triangle < side.names.size() ? side.names[triangle] : std::to_string(triangle);
}

std::string port_name(const Side& side, unsigned port) {
  return port < side.port_names.size() ? fmt::format("{} ({})", port, side.port_names[port]) : std::to_string(port);
}

std::string invalid_because(const Side& side, Colors colors, unsigned most_solid) {
  const Degrees count = degrees(side, colors);
  for (unsigned triangle = 0; triangle < side.triangles; ++triangle)
    if (count[triangle] > most_solid)
      return fmt::format("triangle {} has {} solid edges", name_of(side, triangle), count[triangle]);
  return inner_graph(side, colors.inner) ? "" : "solid inner edges close a cycle";
}

std::string drawn(const Side& side, Colors colors) {
  std::string text = side.edges.empty() ? counted(side.triangles, "triangle") + " without edges" : "edges";
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    text += fmt::format(" {}{}{}", name_of(side, side.edges[edge][0]), is_solid(colors.inner, edge) ? '=' : '-',
                        name_of(side, side.edges[edge][1]));
  text += colors.ports == 0 ? ", no port solid" : solid_count(colors.ports) == 1 ? ", solid port" : ", solid ports";
  for (unsigned port = 0; port < side.ports(); ++port)
    if (is_solid(colors.ports, port)) text += ' ' + port_name(side, port);
  return text;
}

std::string listed(PortPairs pairs, unsigned ports) {
  std::string text;
  for (unsigned i = 0; i < ports; ++i)
    for (unsigned j = i + 1; j < ports; ++j)
      if (pairs.has(i, j)) text += fmt::format("{}{}-{}", text.empty() ? "" : " ", i, j);
  return text.empty() ? "none" : text;
}

}  // namespace restrip::verify
