// Boost.Graph on a mesh: the strips are the connected components of the solid edges, a largest matching of the dual
// graph pairs the triangles into quadrilaterals, and Graphviz draws both.
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graphviz.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <cstdio>
#include <iostream>
#include <restrip/mesh/adapters/boost_graph.hpp>
#include <restrip/restrip.hpp>
#include <vector>

int main() {
  // A sheet of 2 x 3 squares, two triangles each.
  std::vector<restrip::Vertex> corners;
  for (restrip::Vertex v = 0; v < 12; ++v)
    if (v % 4 != 3 && v < 8) corners.insert(corners.end(), {v, v + 1, v + 5, v, v + 5, v + 4});
  restrip::StripMesh mesh = restrip::StripMesh::build(corners, 12);
  restrip::stripify(mesh);

  const restrip::DualGraph graph(mesh);
  std::vector<int> component(num_vertices(graph));
  const int strips = boost::connected_components(solid_edges(graph), component.data());
  std::printf("%zu triangles, %zu adjacent pairs, %d strips\n", num_vertices(graph), num_edges(graph), strips);

  // The fewest possible triangles without a partner; solid edges are then the pairs.
  std::vector<std::uint32_t> mate(num_vertices(graph));
  boost::edmonds_maximum_cardinality_matching(graph, mate.data());
  for (auto [edge, end] = edges(graph); edge != end; ++edge)
    put(restrip::edge_solid, graph, *edge, mate[edge->source] == edge->target);
  std::printf("%zu pairs\n", boost::matching_size(graph, mate.data()));

  std::fflush(stdout);
  boost::write_graphviz(std::cout, graph, boost::default_writer(), [&](std::ostream& out, const auto& edge) {
    out << (get(restrip::edge_solid, graph, edge) ? "[style=bold]" : "[style=dashed]");
  });
}
