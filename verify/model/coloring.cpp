#include "model/coloring.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

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

namespace {

/// Intermediate values shared by several counts.
struct Counted {
  const Side& side;
  Colors colors;
  Degrees degree;
  unsigned given_up;

  bool is_end(unsigned triangle) const { return degree[triangle] == 1; }
};

/// The sum over connected sets of triangles of the squared number of ports.
std::int64_t squares(const Counted& counted) {
  const std::optional<SolidGraph> graph = inner_graph(counted.side, counted.colors.inner);
  if (!graph) throw std::logic_error("the cost of a colouring with a cycle");
  std::array<std::int64_t, most_triangles> ports{};
  for (unsigned port = 0; port < counted.side.ports(); ++port) ++ports[graph->root(counted.side.owner_of_port[port])];
  std::int64_t sum = 0;
  for (const std::int64_t count : ports) sum += count * count;
  return sum;
}

std::int64_t ends(const Counted& counted, const Term& term) {
  std::int64_t count = 0;
  for (unsigned triangle = 0; triangle < counted.side.triangles; ++triangle) {
    if (!is_solid(term.among, triangle) || !counted.is_end(triangle)) continue;
    bool counts = term.count == Count::ends;  // or it must have a solid port
    for (unsigned port = 0; port < counted.side.ports(); ++port)
      counts = counts || (is_solid(counted.colors.ports, port) && counted.side.owner_of_port[port] == triangle);
    count += counts ? 1 : 0;
  }
  return count;
}

std::int64_t count_of(const Term& term, const Counted& counted) {
  const Side& side = counted.side;
  switch (term.count) {
    case Count::strips:
      return strips_of(side, counted.colors);
    case Count::isolated:
      return isolated_of(side, counted.colors);
    case Count::given_up:
      return counted.given_up;
    case Count::kept:
      return solid_count(counted.colors.ports & term.among);
    case Count::joined: {
      const std::optional<SolidGraph> graph = inner_graph(side, counted.colors.inner);
      if (!graph) throw std::logic_error("the joined ports of a colouring with a cycle");
      return joined_ports(side, *graph, counted.colors.ports).count();
    }
    case Count::solid:
      return solid_count(counted.colors.inner & term.among);
    case Count::ends:
    case Count::ends_at_port:
      return ends(counted, term);
    case Count::neighbouring_ends:
      return std::count_if(side.edges.begin(), side.edges.end(), [&](const std::array<unsigned, 2>& edge) {
        return counted.is_end(edge[0]) && counted.is_end(edge[1]);
      });
    case Count::squares:
      break;
  }
  return squares(counted);
}

}  // namespace

CostValues cost_of(const Operation& operation, Colors after, unsigned given_up) {
  const Counted counted{operation.after, after, degrees(operation.after, after), given_up};
  CostValues values{};
  for (std::size_t i = 0; i < operation.cost.size(); ++i)
    for (const Term& term : operation.cost[i]) values[i] += term.weight * count_of(term, counted);
  return values;
}

std::string text_of(const Criterion& criterion) {
  std::string text;
  for (const Term& term : criterion) {
    text += text.empty() ? "" : " + ";
    if (term.weight != 1) text += fmt::format("{} ", term.weight);
    text += count_names[static_cast<std::size_t>(term.count)];
    if (among_of(term.count) == Among::nothing) continue;
    std::vector<unsigned> members;
    for (unsigned i = 0; i < most_colors; ++i)
      if (is_solid(term.among, i)) members.push_back(i);
    text += fmt::format("({})", fmt::join(members, ","));
  }
  return text;
}

}  // namespace restrip::verify
