#pragma once
// A patch as an explicit graph: its triangles, its inner edges, and for each port a node that stands for whatever lies
// outside. Numbering: docs/notation.md.

#include <boost/graph/adjacency_list.hpp>
#include <optional>
#include <string>
#include <vector>

#include "masks.hpp"

namespace restrip::verify {

enum class EdgeKind { inner, port };

struct DualEdge {
  EdgeKind kind = EdgeKind::inner;
  unsigned index = 0;  ///< bit of the mask of its kind
  bool chord = false;
};

struct DualNode {
  std::string name;  ///< "t3", "A", "D"; "out3" for what lies behind port 3
  bool outside = false;
  unsigned port = 0;  ///< of an outside node
};

using DualGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, DualNode, DualEdge>;
using Node = boost::graph_traits<DualGraph>::vertex_descriptor;
using Edge = boost::graph_traits<DualGraph>::edge_descriptor;

/// Colours of all edges of a patch.
struct Coloring {
  Mask inner = 0;
  Mask ports = 0;
  friend constexpr bool operator==(Coloring, Coloring) = default;
};

inline bool solid(const DualEdge& edge, Coloring colors) {
  return is_solid(edge.kind == EdgeKind::inner ? colors.inner : colors.ports, edge.index);
}

class Patch {
 public:
  /// t_0 … t_{k-1} in a ring, edge i from t_i to the next.
  static Patch closed_fan(unsigned k);
  /// t_0 … t_{k-1} in a path, edge i from t_i to t_{i+1}.
  static Patch open_fan(unsigned k);
  /// A, t_0 … t_{a-1}, D, t_a … t_{k-1} in a ring, and the chord.
  static Patch ring_with_chord(unsigned k, unsigned a);
  /// A before t_i and D before t_j in a path, and the chord.
  static Patch path_with_chord(unsigned k, unsigned i, unsigned j);
  /// A before t_i in a path.
  static Patch path(unsigned k, unsigned i);
  /// Two triangles that share an edge; the first owns the two ports named.
  static Patch flip(unsigned first_port, unsigned second_port);

  const DualGraph& graph() const { return graph_; }
  /// Triangles in the order in which they lie around or along the fan.
  const std::vector<Node>& triangles() const { return triangles_; }
  /// The node outside of each port.
  const std::vector<Node>& outside() const { return outside_; }
  Node owner_of_port(unsigned port) const;
  unsigned inner_edges() const { return inner_edges_; }
  unsigned ports() const { return static_cast<unsigned>(outside_.size()); }
  bool closed() const { return closed_; }
  std::optional<unsigned> chord() const { return chord_; }

 private:
  Node add_triangle(const std::string& name);
  void add_port(Node owner, unsigned port);
  void add_inner_edge(Node one, Node other, bool is_chord = false);
  void add_fan(unsigned k, std::optional<unsigned> a_before, std::optional<unsigned> d_before);
  void join_neighbors(bool closed);

  DualGraph graph_;
  std::vector<Node> triangles_;
  std::vector<Node> outside_;
  std::optional<Node> a_;
  std::optional<Node> d_;
  std::optional<unsigned> chord_;
  unsigned inner_edges_ = 0;
  bool closed_ = false;
};

}  // namespace restrip::verify
