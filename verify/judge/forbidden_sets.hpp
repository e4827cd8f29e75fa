#pragma once
// The second formulation: validity and soundness as sets of edges that must not all be solid. Nothing here follows a
// strip or looks at colours to find a way; the sets come from the bare patch.
//
//   * the three edges of a triangle (no triangle has more);
//   * every cycle of the patch;
//   * every path between two ports that were not joined before, with both ports.
//
// A colouring is legal exactly when it contains no forbidden set, so the edges that a best recolouring leaves dashed
// are a smallest set that hits every forbidden set.

#include <vector>

#include "model/side.hpp"

namespace restrip::verify {

/// Edges of a side, inner edges first, then ports.
Mask edge_set(const Side& side, Colors colors);

struct PathBetweenPorts {
  unsigned from = 0;
  unsigned to = 0;
  Mask edges = 0;
};

class ForbiddenSets {
 public:
  explicit ForbiddenSets(const Side& side);

  /// No triangle with three solid edges, no solid cycle.
  bool valid(Mask solid_edges) const;
  /// Ports between which some path is solid throughout.
  PortPairs joined(Mask solid_edges) const;
  /// All forbidden sets when the patch has these solid ports at most and may join these pairs at most; no set contains
  /// another.
  std::vector<Mask> forbidden(Mask ports, PortPairs may_be_joined) const;
  /// Inner edges and ports of each triangle.
  const std::vector<Mask>& edges_of_triangles() const { return edges_of_triangles_; }

 private:
  const Side& side_;
  std::vector<Mask> edges_of_triangles_;
  std::vector<Mask> always_;
  std::vector<PathBetweenPorts> paths_;
};

/// Every smallest set of edges of `universe` that hits all `sets`, each once.
std::vector<Mask> smallest_hitting_sets(const std::vector<Mask>& sets, Mask universe);

}  // namespace restrip::verify
