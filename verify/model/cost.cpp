#include "model/cost.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace restrip::verify {
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
