// The dual graph for Boost.Graph: it models the concepts, has the edges of the mesh, its components of solid edges are
// the strips after every operation, and Boost's algorithms read and write it.
#include "restrip/mesh/adapters/boost_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/graph/graphviz.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <random>
#include <sstream>
#include <vector>

#include "../runtime/random_operation.hpp"
#include "../runtime/sample_meshes.hpp"
#include "../support/half_edge_mesh.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {
namespace {

template <class Mesh>
constexpr void models_concepts() {
  using Graph = DualGraph<Mesh>;
  using Edge = typename boost::graph_traits<Graph>::edge_descriptor;
  BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::IncidenceGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Graph>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyMapConcept<EdgeSolidMap<Mesh>, Edge>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, std::uint32_t, boost::vertex_index_t>));
  BOOST_CONCEPT_ASSERT((boost::ReadablePropertyGraphConcept<Graph, Edge, edge_solid_t>));
  if constexpr (!std::is_const_v<Mesh>) {
    BOOST_CONCEPT_ASSERT((boost::ReadWritePropertyMapConcept<EdgeSolidMap<Mesh>, Edge>));
    BOOST_CONCEPT_ASSERT((boost::PropertyGraphConcept<Graph, Edge, edge_solid_t>));
  }
}
[[maybe_unused]] void of_any_numbered_mesh() {
  models_concepts<StripMesh>();
  models_concepts<const StripMesh>();
  models_concepts<half_edge::Mesh>();
  models_concepts<half_edge::OnlyFlips>();
}

template <class Graph>
int components(const Graph& graph) {
  std::vector<int> component(num_vertices(graph));
  return boost::connected_components(graph, component.data());
}

/// Adjacent triangles, each pair as often as it shares an edge.
std::vector<std::pair<Triangle, Triangle>> adjacent(const StripMesh& mesh) {
  std::vector<std::pair<Triangle, Triangle>> pairs;
  for (const StripMesh::Halfedge h : sample::dual_edges(mesh))
    pairs.push_back(std::minmax(StripMesh::triangle(h), StripMesh::triangle(mesh.opposite(h))));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(BoostGraph, HasTheEdgesOfTheMesh) {
  bool parallel = false;
  for (const StripMesh& mesh : sample::meshes()) {
    const DualGraph graph(mesh);
    std::vector<std::pair<Triangle, Triangle>> listed;
    for (auto [edge, end] = edges(graph); edge != end; ++edge)
      listed.push_back(std::minmax(source(*edge, graph), target(*edge, graph)));
    std::sort(listed.begin(), listed.end());
    EXPECT_EQ(listed, adjacent(mesh));
    EXPECT_EQ(num_edges(graph), listed.size());
    parallel = parallel || std::adjacent_find(listed.begin(), listed.end()) != listed.end();
    // From each vertex: the same number of edges, the same ones from both ends, the other end as neighbour.
    std::size_t ends = 0;
    for (auto [v, last] = vertices(graph); v != last; ++v) {
      auto in = in_edges(*v, graph).first;
      auto neighbour = adjacent_vertices(*v, graph).first;
      for (auto [edge, end] = out_edges(*v, graph); edge != end; ++edge, ++in, ++neighbour, ++ends) {
        EXPECT_EQ(source(*edge, graph), *v);
        EXPECT_EQ(target(*edge, graph), *neighbour);
        EXPECT_EQ(*edge, *in);
        EXPECT_EQ(target(*in, graph), *v);
        const auto [back, back_end] = out_edges(*neighbour, graph);
        EXPECT_EQ(std::count(back, back_end, *edge), 1);
      }
      EXPECT_EQ(degree(*v, graph), in_degree(*v, graph));
    }
    EXPECT_EQ(ends, 2 * listed.size());
  }
  EXPECT_TRUE(parallel);
}

TEST(BoostGraph, StripsAreTheComponentsAfterEveryOperation) {
  int gaps = 0;
  unsigned seed = 20261126;
  for (const Policy policy : {Policy::rules, Policy::quick})
    for (StripMesh mesh : {sample::torus(6, 5), sample::rectangle(6, 6)}) {
      stripify(mesh);
      Keeper keeper(mesh, policy);
      std::mt19937 random(seed++);
      const std::size_t triangles = mesh.triangle_count();
      for (int n = 0; n < 600; ++n) {
        random_operation(keeper, random, mesh.triangle_count() < triangles * (n % 200 < 100 ? 2 : 1) / 2 + 20);
        const DualGraph graph(mesh);
        const auto [first, last] = vertices(graph);
        ASSERT_EQ(static_cast<std::size_t>(std::distance(first, last)), mesh.triangle_count());
        ASSERT_EQ(components(solid_edges(graph)), static_cast<int>(keeper.strips())) << "seed " << seed - 1;
        gaps += mesh.triangle_count() < mesh.triangle_bound() ? 1 : 0;
      }
    }
  EXPECT_GT(gaps, 100);
}

TEST(BoostGraph, AlgorithmsRunOnForeignMeshes) {
  for (StripMesh mesh : sample::manifold_meshes()) {
    stripify(mesh);
    half_edge::Mesh foreign = half_edge::copy_of(mesh);
    const DualGraph graph(foreign);  // its numbers begin at 7
    EXPECT_EQ(components(solid_edges(graph)), static_cast<int>(count_strips(mesh)));
    EXPECT_EQ(num_edges(graph), adjacent(mesh).size());
  }
}

/// A spanning tree has every triangle of the graph in one component, and no cycle.
TEST(BoostGraph, AnAlgorithmMayColor) {
  StripMesh mesh = sample::torus(8, 7);
  const DualGraph graph(mesh);
  std::vector<boost::graph_traits<DualGraph<StripMesh>>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(
      graph, std::back_inserter(tree),
      boost::weight_map(boost::make_function_property_map<decltype(tree)::value_type>([](const auto&) { return 1; })));
  for (const auto& edge : tree) put(edge_solid, graph, edge, true);
  EXPECT_EQ(tree.size() + 1, mesh.triangle_count());
  EXPECT_EQ(components(solid_edges(graph)), 1);
  EXPECT_EQ(num_edges(graph), adjacent(mesh).size());
  const auto solid = sample::dual_edges(mesh);
  EXPECT_EQ(static_cast<std::size_t>(std::count_if(solid.begin(), solid.end(), [&](auto h) { return mesh.solid(h); })),
            tree.size());
}

/// A largest matching leaves as few triangles isolated as pairs can. A strip leaves one of its triangles without a
/// partner if their number is odd, so at least that number of strips have odd length.
TEST(BoostGraph, AMatchingBoundsIsolatedTriangles) {
  for (StripMesh mesh : sample::manifold_meshes()) {
    stripify(mesh);
    const DualGraph graph(mesh);
    std::vector<std::uint32_t> mate(num_vertices(graph));
    boost::edmonds_maximum_cardinality_matching(graph, mate.data());
    const std::size_t unmatched = mesh.triangle_count() - 2 * boost::matching_size(graph, mate.data());
    const Strips strips = extract_strips(mesh);
    std::size_t odd = 0;
    for (std::size_t s = 0; s < strips.size(); ++s) odd += strips[s].size() % 2;
    EXPECT_LE(unmatched, odd);

    const auto isolated_if = [&](const auto& wanted) {
      for (auto [edge, end] = edges(graph); edge != end; ++edge) put(edge_solid, graph, *edge, false);
      for (auto [edge, end] = edges(graph); edge != end; ++edge) put(edge_solid, graph, *edge, wanted(*edge));
      return check_coloring(mesh).isolated;
    };
    std::vector<bool> paired(num_vertices(graph));
    EXPECT_EQ(isolated_if([&](const auto& edge) {
                const bool wanted = mate[edge.source] == edge.target && !paired[edge.source];
                if (wanted) paired[edge.source] = true;
                return wanted;
              }),
              unmatched);
    EXPECT_GE(isolated_if([&](const auto& edge) {
                return mesh.solid_degree(edge.source) + mesh.solid_degree(edge.target) == 0;
              }),
              unmatched);
  }
}

TEST(BoostGraph, IsWrittenForGraphviz) {
  StripMesh mesh = StripMesh::build(std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}, 5);
  mesh.set_solid(StripMesh::halfedge(0, 1), true);
  const DualGraph graph(mesh);
  std::ostringstream out;
  boost::write_graphviz(out, graph, boost::default_writer(), [&](std::ostream& edge_out, const auto& edge) {
    edge_out << (get(edge_solid, graph, edge) ? "[style=solid]" : "[style=dashed]");
  });
  EXPECT_EQ(out.str(), "graph G {\n0;\n1;\n2;\n0--1 [style=solid];\n1--2 [style=dashed];\n}\n");
}

}  // namespace
}  // namespace restrip
