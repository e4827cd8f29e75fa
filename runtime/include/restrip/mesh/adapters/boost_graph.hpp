// The dual graph of a mesh for the Boost Graph Library: its algorithms run on the triangles and strips of any
// NumberedMesh (StripMesh, the OpenMesh and CGAL adapters, your own).
//
//   const restrip::DualGraph graph(mesh);                                        // a view: nothing is copied
//   std::vector<int> component(num_vertices(graph));
//   boost::connected_components(solid_edges(graph), component.data());           // one component for each strip
//   put(restrip::edge_solid, graph, *edges(graph).first, true);                  // an algorithm may colour edges
//
// A vertex of the graph is the number of a triangle, an edge a pair of adjacent triangles; two triangles that share two
// edges have two edges. Boundary edges of the mesh are not edges of the graph, nor is an edge between a triangle and
// itself. Models VertexListGraph, EdgeListGraph, BidirectionalGraph and AdjacencyGraph (and so IncidenceGraph). Steps
// take constant time; `num_edges` is linear in the mesh.
//
// `num_vertices` is the mesh's `triangle_bound()`, because algorithms allocate arrays of that size. `vertices` skips
// numbers that the mesh does not use, so it may visit fewer vertices.
//
// Include this header only where you have Boost (1.74 or later; headers alone). Descriptors and iterators are valid as
// long as the mesh does not change; colours may change.
#pragma once

#include <boost/graph/adjacency_iterator.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>

#include "restrip/mesh/numbered_mesh.hpp"

namespace restrip {

/// An edge as seen from one of its ends. Equal from either end.
template <class Mesh>
struct DualEdge {
  typename Mesh::Halfedge halfedge{};  ///< of the two halfedges, the one in the triangle with the lower number
  std::uint32_t source = 0xffffffff;
  std::uint32_t target = 0xffffffff;
  friend bool operator==(const DualEdge& one, const DualEdge& other) { return one.halfedge == other.halfedge; }
  friend bool operator!=(const DualEdge& one, const DualEdge& other) { return !(one == other); }
};

/// The property of edges that says which are solid: `get(edge_solid, graph, edge)`, `put(edge_solid, graph, edge,
/// true)`.
struct edge_solid_t {  // NOLINT(readability-identifier-naming): as the library names its tags
  using kind = boost::edge_property_tag;
};
inline constexpr edge_solid_t edge_solid{};

namespace dual_graph {

enum class Over { vertices, edges, out_edges, in_edges };

/// Steps over the sides of triangles: number 3 t + s is side s of triangle t.
template <class Mesh, Over over, class Value>
class Iterator
    : public boost::iterator_facade<Iterator<Mesh, over, Value>, Value, boost::forward_traversal_tag, Value> {
 public:
  Iterator() = default;
  Iterator(Mesh& mesh, std::size_t at, std::size_t end) : mesh_(&mesh), at_(at), end_(end) { skip(); }

 private:
  friend class boost::iterator_core_access;
  using Halfedge = typename Mesh::Halfedge;

  [[nodiscard]] std::uint32_t triangle() const { return static_cast<std::uint32_t>(at_ / 3); }
  [[nodiscard]] Halfedge side() const {
    Halfedge h = mesh_->halfedge(triangle());
    for (std::size_t s = at_ % 3; s > 0; --s) h = mesh_->next(h);
    return h;
  }
  [[nodiscard]] bool here() const {
    if (!mesh_->has_triangle(triangle())) return false;
    if constexpr (over == Over::vertices) return at_ % 3 == 0;
    const Halfedge other = mesh_->opposite(side());
    if (mesh_->on_boundary(other)) return false;
    const std::uint32_t neighbour = mesh_->triangle(other);
    return over == Over::edges ? triangle() < neighbour : triangle() != neighbour;
  }
  void skip() {
    while (at_ < end_ && !here()) ++at_;
  }
  void increment() {
    ++at_;
    skip();
  }
  [[nodiscard]] bool equal(const Iterator& other) const { return at_ == other.at_; }
  [[nodiscard]] Value dereference() const {
    if constexpr (over == Over::vertices) {
      return triangle();
    } else {
      const Halfedge h = side();
      const Halfedge other = mesh_->opposite(h);
      const std::uint32_t neighbour = mesh_->triangle(other);
      Value edge{triangle() < neighbour ? h : other, triangle(), neighbour};
      if constexpr (over == Over::in_edges) std::swap(edge.source, edge.target);
      return edge;
    }
  }

  Mesh* mesh_ = nullptr;
  std::size_t at_ = 0;
  std::size_t end_ = 0;
};

}  // namespace dual_graph

/// Whether edges are solid: a property map, writable unless the mesh is const.
template <class Mesh>
struct EdgeSolidMap {
  using key_type = DualEdge<std::remove_const_t<Mesh>>;
  using value_type = bool;
  using reference = bool;
  using category =
      std::conditional_t<std::is_const_v<Mesh>, boost::readable_property_map_tag, boost::read_write_property_map_tag>;
  Mesh* mesh = nullptr;
};
template <class Mesh>
bool get(const EdgeSolidMap<Mesh>& map, const typename EdgeSolidMap<Mesh>::key_type& edge) {
  return map.mesh->solid(edge.halfedge);
}
template <class Mesh>
requires(!std::is_const_v<Mesh>) void put(const EdgeSolidMap<Mesh>& map,
                                          const typename EdgeSolidMap<Mesh>::key_type& edge, bool solid) {
  map.mesh->set_solid(edge.halfedge, solid);
}

/// The predicate of boost::filtered_graph that keeps the solid edges.
template <class Mesh>
struct IsSolid {
  const Mesh* mesh = nullptr;
  bool operator()(const DualEdge<std::remove_const_t<Mesh>>& edge) const { return mesh->solid(edge.halfedge); }
};

/// The mesh must outlive it. The colours of a const mesh are read-only.
template <class Mesh>
requires NumberedMesh<std::remove_const_t<Mesh>>
class DualGraph {
  using Edge = DualEdge<std::remove_const_t<Mesh>>;
  using Traits = boost::graph_traits<DualGraph>;

 public:
  explicit DualGraph(Mesh& mesh) : mesh_(&mesh) {}
  [[nodiscard]] Mesh& mesh() const { return *mesh_; }

  // ---- the functions that the library's concepts name
  friend std::size_t num_vertices(const DualGraph& graph) { return graph.mesh_->triangle_bound(); }
  friend auto vertices(const DualGraph& graph) {
    return graph.template range<typename Traits::vertex_iterator>(0, 3 * num_vertices(graph));
  }
  friend auto edges(const DualGraph& graph) {
    return graph.template range<typename Traits::edge_iterator>(0, 3 * num_vertices(graph));
  }
  friend std::size_t num_edges(const DualGraph& graph) { return length(edges(graph)); }
  friend auto out_edges(std::uint32_t triangle, const DualGraph& graph) {
    const std::size_t first = 3 * std::size_t{triangle};
    return graph.template range<typename Traits::out_edge_iterator>(first, first + 3);
  }
  friend auto in_edges(std::uint32_t triangle, const DualGraph& graph) {
    const std::size_t first = 3 * std::size_t{triangle};
    return graph.template range<typename Traits::in_edge_iterator>(first, first + 3);
  }
  friend auto adjacent_vertices(std::uint32_t triangle, const DualGraph& graph) {
    using Iterator = typename Traits::adjacency_iterator;
    const auto [first, last] = out_edges(triangle, graph);
    return std::pair(Iterator(first, &graph), Iterator(last, &graph));
  }
  friend std::size_t out_degree(std::uint32_t triangle, const DualGraph& graph) {
    return length(out_edges(triangle, graph));
  }
  friend std::size_t in_degree(std::uint32_t triangle, const DualGraph& graph) { return out_degree(triangle, graph); }
  friend std::size_t degree(std::uint32_t triangle, const DualGraph& graph) { return out_degree(triangle, graph); }
  friend std::uint32_t source(const Edge& edge, const DualGraph& /*graph*/) { return edge.source; }
  friend std::uint32_t target(const Edge& edge, const DualGraph& /*graph*/) { return edge.target; }

  friend boost::typed_identity_property_map<std::uint32_t> get(boost::vertex_index_t /*tag*/,
                                                               const DualGraph& /*graph*/) {
    return {};
  }
  friend std::uint32_t get(boost::vertex_index_t /*tag*/, const DualGraph& /*graph*/, std::uint32_t triangle) {
    return triangle;
  }
  friend EdgeSolidMap<Mesh> get(edge_solid_t /*tag*/, const DualGraph& graph) { return {graph.mesh_}; }
  friend bool get(edge_solid_t /*tag*/, const DualGraph& graph, const Edge& edge) {
    return graph.mesh_->solid(edge.halfedge);
  }

 private:
  /// The sides from number `begin` up to number `end`.
  template <class Iterator>
  [[nodiscard]] std::pair<Iterator, Iterator> range(std::size_t begin, std::size_t end) const {
    return {Iterator(*mesh_, begin, end), Iterator(*mesh_, end, end)};
  }
  template <class Iterator>
  static std::size_t length(const std::pair<Iterator, Iterator>& range) {
    return static_cast<std::size_t>(std::distance(range.first, range.second));
  }

  Mesh* mesh_;
};

template <class Mesh>
requires(!std::is_const_v<Mesh>) void put(edge_solid_t /*tag*/, const DualGraph<Mesh>& graph,
                                          const DualEdge<Mesh>& edge, bool solid) {
  graph.mesh().set_solid(edge.halfedge, solid);
}

/// The strips: a view of all triangles and the solid edges between them, whose connected components they are.
template <class Mesh>
boost::filtered_graph<DualGraph<Mesh>, IsSolid<Mesh>> solid_edges(const DualGraph<Mesh>& graph) {
  return {graph, IsSolid<Mesh>{&graph.mesh()}};
}

}  // namespace restrip

namespace boost {

template <class Mesh>
struct graph_traits<restrip::DualGraph<Mesh>> {
  using vertex_descriptor = std::uint32_t;
  using edge_descriptor = restrip::DualEdge<std::remove_const_t<Mesh>>;
  using directed_category = undirected_tag;
  using edge_parallel_category = allow_parallel_edge_tag;
  struct traversal_category : virtual vertex_list_graph_tag,
                              virtual edge_list_graph_tag,
                              virtual bidirectional_graph_tag,
                              virtual adjacency_graph_tag {};
  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using vertex_iterator = restrip::dual_graph::Iterator<Mesh, restrip::dual_graph::Over::vertices, vertex_descriptor>;
  using edge_iterator = restrip::dual_graph::Iterator<Mesh, restrip::dual_graph::Over::edges, edge_descriptor>;
  using out_edge_iterator = restrip::dual_graph::Iterator<Mesh, restrip::dual_graph::Over::out_edges, edge_descriptor>;
  using in_edge_iterator = restrip::dual_graph::Iterator<Mesh, restrip::dual_graph::Over::in_edges, edge_descriptor>;
  using adjacency_iterator =
      typename adjacency_iterator_generator<restrip::DualGraph<Mesh>, vertex_descriptor, out_edge_iterator>::type;
  static vertex_descriptor null_vertex() { return 0xffffffff; }
};

template <class Mesh>
struct property_map<restrip::DualGraph<Mesh>, vertex_index_t> {
  using type = typed_identity_property_map<std::uint32_t>;
  using const_type = type;
};
template <class Mesh>
struct property_map<restrip::DualGraph<Mesh>, restrip::edge_solid_t> {
  using type = restrip::EdgeSolidMap<Mesh>;
  using const_type = type;
};

// Algorithms need the types of a const graph as well.
template <class Mesh>
struct property_map<const restrip::DualGraph<Mesh>, vertex_index_t>
    : property_map<restrip::DualGraph<Mesh>, vertex_index_t> {};
template <class Mesh>
struct property_map<const restrip::DualGraph<Mesh>, restrip::edge_solid_t>
    : property_map<restrip::DualGraph<Mesh>, restrip::edge_solid_t> {};

}  // namespace boost
