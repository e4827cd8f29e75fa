#pragma once
// Isomorphisms of small graphs with coloured nodes and edges: colours are refined by those of the neighbours until that
// tells no more nodes apart, then images are tried one after the other and taken back.

#include <optional>
#include <vector>

#include "model/key.hpp"

namespace restrip::verify {

class ColoredGraph {
 public:
  void add_node(unsigned color);
  /// Colours of edges are greater than 0.
  void add_edge(unsigned one, unsigned other, unsigned color);

  unsigned size() const { return static_cast<unsigned>(colors_.size()); }
  unsigned color(unsigned node) const { return colors_[node]; }
  void set_color(unsigned node, unsigned color) { colors_[node] = color; }
  /// 0 where there is no edge.
  unsigned edge(unsigned one, unsigned other) const { return edges_[one][other]; }

 private:
  std::vector<unsigned> colors_;
  std::vector<std::vector<unsigned>> edges_;
};

/// Colours that differ where no isomorphism takes the one node to the other.
std::vector<unsigned> refined_colors(const ColoredGraph& graph);

/// One that takes the first nodes where `fixed` says, as many as it has; nullopt when there is none.
std::optional<Permutation> isomorphism(const ColoredGraph& from, const ColoredGraph& to, const Permutation& fixed);

}  // namespace restrip::verify
