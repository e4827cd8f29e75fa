#include "sat/encoding.hpp"

#include <algorithm>

namespace restrip::verify::sat {
namespace {

/// together[u][v]: a solid path leads from node u to node v.
using Together = std::vector<std::vector<Literal>>;

/// A colouring: literals of inner edges and ports.
struct Colors {
  const PatchGraph& graph;
  const std::vector<Literal>& inner;
  const std::vector<Literal>& ports;

  std::vector<std::vector<Literal>> edges_by_node() const {
    std::vector<std::vector<Literal>> edges(graph.nodes);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      edges[graph.edges[i].one].push_back(inner[i]);
      edges[graph.edges[i].other].push_back(inner[i]);
    }
    for (std::size_t i = 0; i < ports.size(); ++i) edges[graph.owner[i]].push_back(ports[i]);
    return edges;
  }
};

/// No three edges of a triangle are solid. Triangles have at most three dual edges.
void require_degrees(Circuit& circuit, const Colors& colors) {
  const auto edges = colors.edges_by_node();
  for (unsigned node = 0; node < colors.graph.nodes; ++node)
    if (edges[node].size() == 3) circuit.require({-edges[node][0], -edges[node][1], -edges[node][2]});
}

/// Lays the edges down one after the other (Kruskal): a solid edge must not join two nodes that are together already,
/// and then it joins whoever is together with its two ends.
Together require_no_cycles(Circuit& circuit, const Colors& colors) {
  const unsigned n = colors.graph.nodes;
  Together together(n, std::vector<Literal>(n, Circuit::no));
  for (unsigned node = 0; node < n; ++node) together[node][node] = Circuit::yes;
  for (std::size_t i = 0; i < colors.inner.size(); ++i) {
    const Literal edge = colors.inner[i];
    const auto [u, v] = colors.graph.edges[i];
    circuit.require({-edge, -together[u][v]});
    Together now = together;
    for (unsigned x = 0; x < n; ++x)
      for (unsigned y = x + 1; y < n; ++y)
        now[x][y] = now[y][x] = circuit.any_of({together[x][y], circuit.all_of({edge, together[x][u], together[v][y]}),
                                                circuit.all_of({edge, together[x][v], together[u][y]})});
    together = std::move(now);
  }
  return together;
}

/// For all ports i < j: both are solid, and joined.
std::vector<std::vector<Literal>> joined_pairs(Circuit& circuit, const Position& position,
                                               const std::vector<Literal>& ports, const Together& together) {
  std::vector<std::vector<Literal>> joined(ports.size());
  for (std::size_t j = 0; j < ports.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const unsigned one = position.before.owner[i];
      const unsigned other = position.before.owner[j];
      joined[j].push_back(circuit.all_of({ports[i], ports[j], together[one][other]}));
    }
  return joined;
}

/// Ports joined after were joined before.
void require_pairs(Circuit& circuit, const Position& position, const Encoding& names, const Together& before,
                   const Together& after) {
  for (std::size_t i = 0; i < names.ports.size(); ++i)
    for (std::size_t j = i + 1; j < names.ports.size(); ++j)
      circuit.require({-names.ports_after[i], -names.ports_after[j],
                       -after[position.after.owner[i]][position.after.owner[j]],
                       before[position.before.owner[i]][position.before.owner[j]]});
}

/// Literals "at least m of these", with m of any size.
class Count {
 public:
  Count(Circuit& circuit, const std::vector<Literal>& terms) : at_least_(circuit.at_least(terms)) {}
  Literal at_least(int m) const {
    if (m <= 0) return Circuit::yes;
    return static_cast<std::size_t>(m) < at_least_.size() ? at_least_[static_cast<std::size_t>(m)] : Circuit::no;
  }
  Literal at_most(int m) const { return -at_least(m + 1); }

 private:
  std::vector<Literal> at_least_;
};

/// Isolated triangles and ports given up.
std::vector<Literal> isolated_terms(Circuit& circuit, const Colors& after, const std::vector<Literal>& ports_before) {
  std::vector<Literal> terms;
  for (Clause edges : after.edges_by_node()) terms.push_back(-circuit.any_of(std::move(edges)));
  for (std::size_t i = 0; i < ports_before.size(); ++i)
    terms.push_back(circuit.all_of({ports_before[i], -after.ports[i]}));
  return terms;
}

/// Requires that the recolouring of every configuration that has the key of a bound beats the bound, in lexicographic
/// order.
void require_better(Circuit& circuit, const Position& position, const Encoding& names,
                    const std::vector<Bound>& bounds) {
  std::vector<Literal> solid_terms = names.after;
  if (position.gives_ports_up)
    solid_terms.insert(solid_terms.end(), names.ports_after.begin(), names.ports_after.end());
  const Count solid(circuit, solid_terms);
  const Count isolated(circuit, isolated_terms(circuit, {position.after, names.after, names.ports_after}, names.ports));
  const Count kept(circuit, names.ports_after);
  for (const Bound& bound : bounds) {
    Clause other_key;
    for (unsigned i = 0; i < names.ports.size(); ++i)
      other_key.push_back(is_solid(bound.key.ports, i) ? -names.ports[i] : names.ports[i]);
    for (unsigned j = 0; j < names.joined.size(); ++j)
      for (unsigned i = 0; i < j; ++i)
        if (bound.matter.has(i, j))
          other_key.push_back(bound.key.joined.has(i, j) ? -names.joined[j][i] : names.joined[j][i]);
    const auto require = [&](const Clause& better) {
      Clause clause = other_key;
      clause.insert(clause.end(), better.begin(), better.end());
      circuit.require(std::move(clause));
    };
    const Literal more_solid = solid.at_least(bound.solid + 1);
    const Literal fewer_isolated = isolated.at_most(bound.isolated - 1);
    require({solid.at_least(bound.solid)});
    if (position.gives_ports_up) {
      require({more_solid, isolated.at_most(bound.isolated)});
      require({more_solid, fewer_isolated, kept.at_least(bound.kept + 1)});
    } else {
      require({more_solid, fewer_isolated});
    }
  }
}

}  // namespace

std::vector<Bound> bounds_of(const Position& position, const std::vector<Row>& rows) {
  std::vector<Bound> bounds;
  for (const Row& row : rows) {
    std::vector<bool> lonely(position.after.nodes, true);
    for (unsigned i = 0; i < position.after.edges.size(); ++i)
      if (is_solid(row.after.inner, i))
        lonely[position.after.edges[i].one] = lonely[position.after.edges[i].other] = false;
    for (unsigned i = 0; i < position.after.owner.size(); ++i)
      if (is_solid(row.after.ports, i)) lonely[position.after.owner[i]] = false;
    const int kept = static_cast<int>(solid_count(row.after.ports));
    const int given_up = static_cast<int>(solid_count(row.key.ports)) - kept;
    PortPairs matter;
    for (const Row& other : rows)
      if (other.key.ports == row.key.ports) matter.add(other.key.joined);
    bounds.push_back({row.key, matter,
                      static_cast<int>(solid_count(row.after.inner)) + (position.gives_ports_up ? kept : 0),
                      static_cast<int>(std::count(lonely.begin(), lonely.end(), true)) + given_up, kept});
  }
  return bounds;
}

Encoding encode(const Position& position, const std::vector<Bound>& bounds) {
  Circuit circuit;
  Encoding names;
  for (std::size_t i = 0; i < position.before.owner.size(); ++i) names.ports.push_back(circuit.input());
  for (std::size_t i = 0; i < position.before.edges.size(); ++i) names.before.push_back(circuit.input());
  for (std::size_t i = 0; i < position.after.edges.size(); ++i) names.after.push_back(circuit.input());
  names.ports_after = names.ports;
  if (position.gives_ports_up)
    for (std::size_t i = 0; i < names.ports.size(); ++i) {
      names.ports_after[i] = circuit.input();
      circuit.require({-names.ports_after[i], names.ports[i]});
    }

  const Colors before{position.before, names.before, names.ports};
  require_degrees(circuit, before);
  const Together together_before = require_no_cycles(circuit, before);

  const Colors after{position.after, names.after, names.ports_after};
  require_degrees(circuit, after);
  const Together together_after = require_no_cycles(circuit, after);

  require_pairs(circuit, position, names, together_before, together_after);
  names.joined = joined_pairs(circuit, position, names.ports, together_before);
  require_better(circuit, position, names, bounds);
  names.cnf = circuit.cnf();
  return names;
}

}  // namespace restrip::verify::sat
