#include "patch_symmetry.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <stdexcept>

#include "operation_mutants.hpp"

namespace restrip::verify::operations {
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
std::map<PlacedTerm, unsigned> counted_terms(const OperationFile& operation) {
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

/// Sets of nodes that generators take to each other.
class NodeOrbits {
 public:
  explicit NodeOrbits(unsigned nodes) : parent_(nodes) { std::iota(parent_.begin(), parent_.end(), 0U); }
  unsigned root(unsigned node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }
  void merge(const Permutation& permutation) {
    for (unsigned node = 0; node < permutation.size(); ++node) parent_[root(node)] = root(permutation[node]);
  }
  unsigned size_of(unsigned node) const {
    unsigned size = 0;
    for (unsigned other = 0; other < parent_.size(); ++other) size += root(other) == root(node) ? 1U : 0U;
    return size;
  }

 private:
  std::vector<unsigned> parent_;
};

}  // namespace

PatchSymmetries::PatchSymmetries(const OperationFile& operation) : operation_(operation) {
  const unsigned ports = operation.ports();
  // From the last node to the first: the symmetries that leave all nodes before it where they are.
  const ColoredGraph plain = graph({});
  NodeOrbits orbits(plain.size());
  for (unsigned node = plain.size(); node-- > 0;) {
    Permutation fixed(node + 1);
    std::iota(fixed.begin(), fixed.end(), 0U);
    for (unsigned image = node + 1; image < plain.size(); ++image) {
      if (plain.color(image) != plain.color(node) || orbits.root(image) == orbits.root(node)) continue;
      fixed[node] = image;
      const std::optional<Permutation> found = isomorphism(plain, plain, fixed);
      if (!found) continue;
      orbits.merge(*found);
      SideSymmetry& symmetry = generators_.emplace_back();
      symmetry.ports.assign(found->begin(), found->begin() + ports);
      for (const auto& [one, other] : operation.before.edges)
        symmetry.edges.push_back(
            edge_between(operation.before, (*found)[ports + one] - ports, (*found)[ports + other] - ports));
    }
    order_ *= orbits.size_of(node);
  }
}

ColoredGraph PatchSymmetries::graph(Colors after) const {
  const unsigned first_before = operation_.ports();
  const unsigned first_after = first_before + operation_.before.triangles;
  const unsigned first_edge = first_after + operation_.after.triangles;
  ColoredGraph graph;
  for (unsigned port = 0; port < operation_.ports(); ++port)
    graph.add_node(is_solid(operation_.may_give_up, port) && !mutated(OperationMutant::symmetries_move_ports)
                       ? port_that_may_go
                       : port_that_stays);
  for (unsigned triangle = 0; triangle < operation_.before.triangles; ++triangle) graph.add_node(triangle_before);
  for (unsigned triangle = 0; triangle < operation_.after.triangles; ++triangle) graph.add_node(triangle_after);
  for (unsigned edge = 0; edge < operation_.after.inner_edges(); ++edge)
    graph.add_node(is_solid(after.inner, edge) ? solid_after : dashed_after);

  for (unsigned port = 0; port < operation_.ports(); ++port) {
    graph.add_edge(port, first_before + operation_.before.owner_of_port[port], owner_before);
    graph.add_edge(port, first_after + operation_.after.owner_of_port[port], owner_after);
  }
  for (const auto& [one, other] : operation_.before.edges)
    graph.add_edge(first_before + one, first_before + other, inner_before);
  for (unsigned edge = 0; edge < operation_.after.inner_edges(); ++edge)
    for (const unsigned triangle : operation_.after.edges[edge])
      graph.add_edge(first_edge + edge, first_after + triangle, end_of_inner_after);

  if (mutated(OperationMutant::symmetries_move_cost)) return graph;
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

bool PatchSymmetries::allows(const Permutation& ports) const {
  const ColoredGraph plain = graph({});
  return isomorphism(plain, plain, ports).has_value();
}

bool PatchSymmetries::carries(const Permutation& ports, Colors from, Colors to) const {
  return moved(from.ports, ports) == to.ports && isomorphism(graph(from), graph(to), ports).has_value();
}

Mask moved(Mask mask, const Permutation& permutation) {
  Mask result = 0;
  for (unsigned i = 0; i < permutation.size(); ++i)
    if (is_solid(mask, i)) result |= single(permutation[i]);
  return result;
}

OperationKey moved(OperationKey key, const Permutation& ports) {
  OperationKey result{moved(key.ports, ports), {}};
  for (unsigned j = 1; j < ports.size(); ++j)
    for (unsigned i = 0; i < j; ++i)
      if (key.joined.has(i, j)) result.joined.add(ports[i], ports[j]);
  return result;
}

}  // namespace restrip::verify::operations
