// Strips from scratch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/search/greedy.hpp"
#include "restrip/search/rounds.hpp"
#include "restrip/search/strip_index.hpp"
#include "restrip/search/tunnel.hpp"

namespace restrip {

enum class Effort {
  fast,  ///< one pass, linear time (greedy.hpp): about 200 to 700 triangles per strip
  full   ///< then rounds of tunnelling (rounds.hpp), towards one strip for each connected component
};

/// Number of connected components of the dual graph: no colouring has fewer strips. Linear time.
[[nodiscard]] inline std::size_t connected_components(const StripMesh& mesh) {
  std::vector<bool> met(mesh.triangle_bound(), false);
  std::vector<Triangle> open;
  std::size_t components = 0;
  for (Triangle start = 0; start < mesh.triangle_bound(); ++start) {
    if (!mesh.alive(start) || met[start]) continue;
    ++components;
    met[start] = true;
    open.push_back(start);
    while (!open.empty()) {
      const Triangle t = open.back();
      open.pop_back();
      for (unsigned s = 0; s < 3; ++s) {
        const StripMesh::Halfedge there = mesh.opposite(StripMesh::halfedge(t, s));
        if (StripMesh::on_boundary(there) || met[StripMesh::triangle(there)]) continue;
        met[StripMesh::triangle(there)] = true;
        open.push_back(StripMesh::triangle(there));
      }
    }
  }
  return components;
}

/// Colours the whole mesh anew and returns the number of strips. All triangles are kept; the result depends on the mesh
/// and the arguments alone. `max_nodes` bounds the work of Effort::full: search states looked at, a few hundred
/// nanoseconds each; 0 means 40 for each triangle, and it stops early when no fewer strips are possible.
inline std::size_t stripify(StripMesh& mesh, Effort effort = Effort::fast, std::size_t max_nodes = 0) {
  const std::size_t strips = stripify_fast(mesh);
  if (effort == Effort::fast) return strips;
  StripIndex index(mesh, StripIndex::chunk_limit_for_long_strips(mesh.triangle_count()));
  Tunnel tunnel;
  TunnelRounds rounds;
  rounds.run(mesh, index, tunnel, max_nodes != 0 ? max_nodes : mesh.triangle_count() * 40, connected_components(mesh));
  return index.strips();
}

}  // namespace restrip
