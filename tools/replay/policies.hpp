// The ways of keeping strips while vertices split, in one list: whatever compares policies takes them from here.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lod/progressive_mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/keeper.hpp"

namespace restrip::tools {

/// The policies of the runtime by the names that the command line knows.
[[nodiscard]] const std::map<std::string, Policy>& policy_names();

/// A policy at work on one mesh.
struct Upkeep {
  /// Splits one vertex, names the new one, and returns the chord v_s -> v_t.
  std::function<StripMesh::Halfedge(const VertexSplit<StripMesh::Halfedge>&, Vertex)> split;
  /// What it does to all strips between two splits; may be empty.
  std::function<void()> between;
};

/// One way of keeping strips.
struct StripPolicy {
  std::string name;
  std::string says;  ///< what it does, for a reader
  /// Begins at the base of a progressive mesh, whose colouring is valid. The upkeep holds on to both arguments.
  std::function<Upkeep(StripMesh&, const ProgressiveMesh&)> begin;
};

/// Ours, from the least to the most costly.
[[nodiscard]] std::vector<StripPolicy> our_policies();

}  // namespace restrip::tools
