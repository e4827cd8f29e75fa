#include "judge/symmetry.hpp"

#include <fmt/format.h>

#include <boost/graph/vf2_sub_graph_iso.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>

#include "model/input.hpp"

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
enum EdgeColor : unsigned { owner_before = 1, owner_after, inner_before, end_of_inner_after, counted_member };

/// A term of the cost, with the index of its criterion.
using PlacedTerm = std::pair<std::size_t, Term>;

/// Nodes may be mapped to nodes of the same colour.
using ColoredGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                           boost::property<boost::vertex_color_t, unsigned>,
                                           boost::property<boost::edge_color_t, unsigned>>;

ColoredGraph graph_of(const Operation& operation, bool before_too, Colors after) {
  const unsigned first_before = operation.ports();
  const unsigned first_after = first_before + (before_too ? operation.before.triangles : 0);
  const unsigned first_edge = first_after + operation.after.triangles;
  ColoredGraph graph;
  for (unsigned port = 0; port < operation.ports(); ++port)
    add_vertex(is_solid(operation.may_give_up, port) ? port_that_may_go : port_that_stays, graph);
  for (unsigned node = first_before; node < first_after; ++node) add_vertex(triangle_before, graph);
  for (unsigned triangle = 0; triangle < operation.after.triangles; ++triangle) add_vertex(triangle_after, graph);
  for (unsigned edge = 0; edge < operation.after.inner_edges(); ++edge)
    add_vertex(is_solid(after.inner, edge) ? solid_after : dashed_after, graph);

  for (unsigned port = 0; port < operation.ports(); ++port) {
    if (before_too) add_edge(port, first_before + operation.before.owner_of_port[port], owner_before, graph);
    add_edge(port, first_after + operation.after.owner_of_port[port], owner_after, graph);
  }
  if (before_too)
    for (const auto& [one, other] : operation.before.edges)
      add_edge(first_before + one, first_before + other, inner_before, graph);
  for (unsigned edge = 0; edge < operation.after.inner_edges(); ++edge)
    for (const unsigned triangle : operation.after.edges[edge])
      add_edge(first_edge + edge, first_after + triangle, end_of_inner_after, graph);

  std::map<PlacedTerm, unsigned> counted_terms;  // how often each term occurs in its criterion
  for (std::size_t i = 0; i < operation.cost.size(); ++i)
    for (const Term& term : operation.cost[i]) ++counted_terms[{i, term}];
  // A term is joined to all that it counts. Terms that differ in nothing else have one colour.
  std::map<std::pair<PlacedTerm, unsigned>, unsigned> colors;
  for (const auto& [placed, times] : counted_terms) {
    PlacedTerm kind = placed;
    kind.second.among = 0;
    const unsigned color = first_term + static_cast<unsigned>(colors.size());
    add_vertex(colors.try_emplace({kind, times}, color).first->second, graph);
    const Among among = among_of(placed.second.count);
    const unsigned first = among == Among::edges ? first_edge : (among == Among::triangles ? first_after : 0);
    for (unsigned i = 0; i < most_colors; ++i)
      if (is_solid(placed.second.among, i)) add_edge(num_vertices(graph) - 1, first + i, counted_member, graph);
  }
  return graph;
}

/// Isomorphisms of the graphs of one operation, found by VF2. A patch with many equal parts has too many candidates:
/// the search, over all isomorphisms, gives up after a few seconds.
class Isomorphisms {
 public:
  explicit Isomorphisms(const Operation& operation) : name_(operation.name()) {}

  /// One that maps the first nodes as `fixed` says; nullopt if none exists.
  std::optional<Permutation> find(ColoredGraph from, ColoredGraph to, const Permutation& fixed) {
    constexpr unsigned steps = 20'000'000;
    constexpr unsigned pinned = 1'000'000;  // a colour that only this node has, the same in both graphs
    if (num_vertices(from) != num_vertices(to)) return {};
    for (unsigned node = 0; node < fixed.size(); ++node) {
      if (fixed[node] >= num_vertices(to) ||
          get(boost::vertex_color, from, node) != get(boost::vertex_color, to, fixed[node]))
        return {};
      put(boost::vertex_color, from, node, pinned + node);
      put(boost::vertex_color, to, fixed[node], pinned + node);
    }
    std::optional<Permutation> found;
    const auto same_color = [&](unsigned one, unsigned other) {
      if (++compared_ > steps)
        throw InputError(name_, 0,
                         "its patches have too many equal parts: their symmetries were not found in 20,000,000 steps");
      return get(boost::vertex_color, from, one) == get(boost::vertex_color, to, other);
    };
    boost::vf2_graph_iso(
        from, to,
        [&](const auto& image_of, const auto& /*inverse*/) {
          found.emplace();
          for (unsigned node = 0; node < num_vertices(from); ++node)
            found->push_back(static_cast<unsigned>(get(image_of, node)));
          return false;  // stop at the first
        },
        boost::vertex_order_by_mult(from),
        boost::vertices_equivalent(same_color)
            .edges_equivalent(
                boost::make_property_map_equivalent(get(boost::edge_color, from), get(boost::edge_color, to))));
    return found;
  }

 private:
  std::string name_;
  unsigned compared_ = 0;
};

}  // namespace

Symmetries::Symmetries(const Operation& operation, Keep keep)
    : operation_(operation), before_too_(keep == Keep::both_sides) {
  // From the last node to the first: the symmetries that fix all earlier nodes.
  const ColoredGraph plain = graph_of(operation, before_too_, {});
  Isomorphisms isomorphisms(operation);
  const auto size = static_cast<unsigned>(num_vertices(plain));
  boost::disjoint_sets_with_storage<> orbits(size);  // of nodes that generators map to each other
  for (unsigned node = size; node-- > 0;) {
    Permutation fixed(node + 1);
    std::iota(fixed.begin(), fixed.end(), 0U);
    for (unsigned image = node + 1; image < size; ++image) {
      if (orbits.find_set(image) == orbits.find_set(node)) continue;
      fixed[node] = image;
      const std::optional<Permutation> found = isomorphisms.find(plain, plain, fixed);
      if (!found) continue;
      for (unsigned from = 0; from < size; ++from) orbits.union_set(from, (*found)[from]);
      generators_.push_back(symmetry_of(*found));
    }
    unsigned images = 0;
    for (unsigned other = 0; other < size; ++other) images += orbits.find_set(other) == orbits.find_set(node) ? 1U : 0U;
    order_ *= images;
  }
}

Symmetry Symmetries::symmetry_of(const Permutation& nodes) const {
  const unsigned ports = operation_.ports();
  Symmetry symmetry{{nodes.begin(), nodes.begin() + ports}, {}, {}};
  const auto images = [&](const Side& side, unsigned first) {
    Permutation edges;
    for (const auto& [one, other] : side.edges)
      edges.push_back(side.edge_between(nodes[first + one] - first, nodes[first + other] - first).value());
    return edges;
  };
  if (before_too_) symmetry.edges_before = images(operation_.before, ports);
  symmetry.edges_after = images(operation_.after, ports + (before_too_ ? operation_.before.triangles : 0));
  return symmetry;
}

const Symmetry* Symmetries::with(const Permutation& ports) const {
  const auto [place, is_new] = known_.try_emplace(ports);
  if (is_new) {
    const ColoredGraph plain = graph_of(operation_, before_too_, {});
    if (const auto found = Isomorphisms(operation_).find(plain, plain, ports)) place->second = symmetry_of(*found);
  }
  return place->second ? &*place->second : nullptr;
}

bool Symmetries::carries(const Permutation& ports, Colors from, Colors to) const {
  const Symmetry* const symmetry = with(ports);
  if (symmetry == nullptr || moved(from.ports, ports) != to.ports) return false;
  // Another symmetry may move the ports in the same way and other triangles.
  return moved(from.inner, symmetry->edges_after) == to.inner ||
         Isomorphisms(operation_)
             .find(graph_of(operation_, before_too_, from), graph_of(operation_, before_too_, to), ports)
             .has_value();
}

bool isomorphic(const Operation& one, const Operation& other) {
  return one.constraint == other.constraint &&
         Isomorphisms(one).find(graph_of(one, true, {}), graph_of(other, true, {}), {}).has_value();
}

namespace {

std::vector<Mask> images_of_masks(const Permutation& permutation) {
  std::vector<Mask> images;
  for (Mask mask = 0; mask < mask_count(static_cast<unsigned>(permutation.size())); ++mask)
    images.push_back(moved(mask, permutation));
  return images;
}

}  // namespace

OrbitCounts merged_orbits(const Operation& operation, const Symmetries& symmetries, const std::vector<bool>& valid) {
  const unsigned ports = operation.ports();
  boost::disjoint_sets_with_storage<> sets(valid.size());
  for (const Symmetry& symmetry : symmetries.generators()) {
    const std::vector<Mask> ports_image = images_of_masks(symmetry.ports);
    const std::vector<Mask> edges_image = images_of_masks(symmetry.edges_before);
    for (Mask both = 0; both < valid.size(); ++both)
      sets.union_set(both,
                     concatenated(edges_image[high_part(both, ports)], ports_image[low_part(both, ports)], ports));
  }
  OrbitCounts orbits;
  for (Mask both = 0; both < valid.size(); ++both)
    if (sets.find_set(both) == both) {
      ++orbits.all;
      orbits.valid += valid[both] ? 1U : 0U;
    }
  return orbits;
}

}  // namespace restrip::verify
