#pragma once
// A patch as an explicit graph: its triangles, its inner edges, and for each port a node that stands for whatever lies
// outside. Numbering: docs/notation.md.

#include <boost/graph/adjacency_list.hpp>
#include <optional>
#include <string>
#include <utility>
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

struct PatchTriangle {
  std::string name;
  std::vector<unsigned> ports;
};

class Patch {
 public:
  /// Inner edge i joins triangle i to the next one, in a ring also the last to the first; the chord comes last. The
  /// ports of all triangles are 0, 1, 2 … in any order. std::logic_error when they are not, or no triangle has the
  /// name of an end of the chord.
  Patch(const std::vector<PatchTriangle>& triangles, bool ring,
        const std::optional<std::pair<std::string, std::string>>& chord);

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
  void add_inner_edge(Node one, Node other, bool is_chord = false);
  std::size_t index_of(const std::string& name) const;

  DualGraph graph_;
  std::vector<Node> triangles_;
  std::vector<Node> outside_;
  std::optional<unsigned> chord_;
  unsigned inner_edges_ = 0;
  bool closed_ = false;
};

}  // namespace restrip::verify
