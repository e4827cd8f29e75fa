#include "judge/symmetry.hpp"

#include <map>
#include <numeric>
#include <stdexcept>

#include "judge/merged_sets.hpp"

namespace restrip::verify {
namespace {

enum NodeColor : unsigned {
  port_that_stays,
  port_that_may_go,
  triangle_before,
  triangle_after,
  dashed_after,
  solid_after,
  first_term
};
enum EdgeColor : unsigned { owner_before = 1, owner_after, inner_before, end_of_inner_after, counted };

/// A term of the cost, with the place of its criterion.
using PlacedTerm = std::pair<std::size_t, Term>;

/// How often each term occurs in its criterion.
std::map<PlacedTerm, unsigned> counted_terms(const Operation& operation) {
  std::map<PlacedTerm, unsigned> terms;
  for (std::size_t i = 0; i < operation.cost.size(); ++i)
    for (const Term& term : operation.cost[i]) ++terms[{i, term}];
  return terms;
}

unsigned edge_between(const Side& side, unsigned one, unsigned other) {
  for (unsigned edge = 0; edge < side.inner_edges(); ++edge)
    if (side.edges[edge] == std::array{one, other} || side.edges[edge] == std::array{other, one}) return edge;
  throw std::logic_error("a symmetry takes an edge to none");
}

}  // namespace

Symmetries::Symmetries(const Operation& operation, Keep keep)
    : operation_(operation), before_too_(keep == Keep::both_sides) {
  // From the last node to the first: the symmetries that leave all nodes before it where they are.
  const ColoredGraph plain = graph({});
  const std::vector<unsigned> kinds = refined_colors(plain);
  MergedSets orbits(plain.size());  // of nodes that generators take to each other
  for (unsigned node = plain.size(); node-- > 0;) {
    Permutation fixed(node + 1);
    std::iota(fixed.begin(), fixed.end(), 0U);
    for (unsigned image = node + 1; image < plain.size(); ++image) {
      if (kinds[image] != kinds[node] || orbits.smallest(image) == orbits.smallest(node)) continue;
      fixed[node] = image;
      const std::optional<Permutation> found = isomorphism(plain, plain, fixed);
      if (!found) continue;
      for (unsigned from = 0; from < found->size(); ++from) orbits.merge(from, (*found)[from]);
      generators_.push_back(symmetry_of(*found));
    }
    unsigned images = 0;
    for (unsigned other = 0; other < plain.size(); ++other)
      images += orbits.smallest(other) == orbits.smallest(node) ? 1U : 0U;
    order_ *= images;
  }
}

Symmetry Symmetries::symmetry_of(const Permutation& nodes) const {
  const unsigned ports = operation_.ports();
  Symmetry symmetry{{nodes.begin(), nodes.begin() + ports}, {}, {}};
  if (before_too_)
    for (const auto& [one, other] : operation_.before.edges)
      symmetry.edges_before.push_back(
          edge_between(operation_.before, nodes[ports + one] - ports, nodes[ports + other] - ports));
  const unsigned first_after = ports + (before_too_ ? operation_.before.triangles : 0);
  for (const auto& [one, other] : operation_.after.edges)
    symmetry.edges_after.push_back(edge_between(operation_.after, nodes[first_after + one] - first_after,
                                                nodes[first_after + other] - first_after));
  return symmetry;
}

ColoredGraph Symmetries::graph(Colors after) const {
  const unsigned first_before = operation_.ports();
  const unsigned first_after = first_before + (before_too_ ? operation_.before.triangles : 0);
  const unsigned first_edge = first_after + operation_.after.triangles;
  ColoredGraph graph;
  for (unsigned port = 0; port < operation_.ports(); ++port)
    graph.add_node(is_solid(operation_.may_give_up, port) ? port_that_may_go : port_that_stays);
  for (unsigned node = first_before; node < first_after; ++node) graph.add_node(triangle_before);
  for (unsigned triangle = 0; triangle < operation_.after.triangles; ++triangle) graph.add_node(triangle_after);
  for (unsigned edge = 0; edge < operation_.after.inner_edges(); ++edge)
    graph.add_node(is_solid(after.inner, edge) ? solid_after : dashed_after);

  for (unsigned port = 0; port < operation_.ports(); ++port) {
    if (before_too_) graph.add_edge(port, first_before + operation_.before.owner_of_port[port], owner_before);
    graph.add_edge(port, first_after + operation_.after.owner_of_port[port], owner_after);
  }
  if (before_too_)
    for (const auto& [one, other] : operation_.before.edges)
      graph.add_edge(first_before + one, first_before + other, inner_before);
  for (unsigned edge = 0; edge < operation_.after.inner_edges(); ++edge)
    for (const unsigned triangle : operation_.after.edges[edge])
      graph.add_edge(first_edge + edge, first_after + triangle, end_of_inner_after);

  // A term is joined to all that it counts. Terms have one colour when they differ in nothing else.
  std::map<std::pair<PlacedTerm, unsigned>, unsigned> colors;
  for (const auto& [placed, times] : counted_terms(operation_)) {
    PlacedTerm kind = placed;
    kind.second.among = 0;
    const unsigned color = first_term + static_cast<unsigned>(colors.size());
    graph.add_node(colors.try_emplace({kind, times}, color).first->second);
    const Among among = among_of(placed.second.count);
    const unsigned first = among == Among::edges ? first_edge : (among == Among::triangles ? first_after : 0);
    for (unsigned i = 0; i < most_colors; ++i)
      if (is_solid(placed.second.among, i)) graph.add_edge(graph.size() - 1, first + i, counted);
  }
  return graph;
}

const Symmetry* Symmetries::with(const Permutation& ports) const {
  const auto [place, is_new] = known_.try_emplace(ports);
  if (is_new) {
    const ColoredGraph plain = graph({});
    if (const std::optional<Permutation> found = isomorphism(plain, plain, ports)) place->second = symmetry_of(*found);
  }
  return place->second ? &*place->second : nullptr;
}

bool Symmetries::carries(const Permutation& ports, Colors from, Colors to) const {
  const Symmetry* const symmetry = with(ports);
  if (symmetry == nullptr || moved(from.ports, ports) != to.ports) return false;
  // Another one may move the ports in the same way, and other triangles.
  return moved(from.inner, symmetry->edges_after) == to.inner || isomorphism(graph(from), graph(to), ports).has_value();
}

}  // namespace restrip::verify
