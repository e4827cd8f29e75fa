// Maintains strips while another library changes the mesh: a decimater, a remesher, an editor.
//
// split(), collapse() and flip() call your mesh to change itself. If a library must change it instead, call the two
// halves around its change: the first reads the colours, looks the rule up and clears edges, the second sets edges.
//
//   auto pending = before_collapse(mesh, chord);                       // chord = v_s -> v_t, v_t is removed
//   library.collapse(...);
//   const auto done = after_collapse(mesh, std::move(pending), spoke);  // spoke leaves v_s, as in CollapsibleMesh
//
// The mesh needs to model only ColoredMesh. Colours must stay with mesh edges: an edge property that is false for new
// edges will do. The library's change has the contract of insert_vertex, remove_vertex and turn_edge (mesh.hpp), with
// one exception: merged edges and edges of removed triangles may keep any colour, because the first half clears them.
// Nothing else may change the patch between the two halves.
//
// Between the halves the colouring is valid, perhaps with fewer solid edges. It stays valid if the library gives up its
// change: then drop the pending object, and count the strips again. The result and the time are the same as for
// split(), collapse() and flip(), which are made of these halves. A pending object allocates only for fans of more than
// max_word_valence triangles.
//
// Debug builds check the preconditions before the change, and after it that the mesh has the patch that the operation
// makes. On meshes other than StripMesh every operation also checks that the colours it reads can belong to a valid
// colouring (Refusal::colors_not_valid), so changes made without restrip are soon noticed; check_coloring
// (output/strips.hpp) checks the whole mesh. Ready-made adapters:
// operations/adapters/openmesh_decimater.hpp and operations/adapters/cgal_edge_collapse.hpp.
#pragma once

#include <cstddef>

#include "restrip/mesh/mesh.hpp"
#include "restrip/operations/operations.hpp"

namespace restrip {

/// A split, collapse or flip whose mesh has not changed yet. Made by before_*(), consumed by after_*().
template <class Halfedge>
class PendingSplit;
template <class Halfedge>
class PendingCollapse;
template <class Halfedge>
class PendingFlip;

/// Announces a split.
template <ColoredMesh Mesh>
[[nodiscard]] PendingSplit<typename Mesh::Halfedge> before_split(Mesh& mesh,
                                                                 const VertexSplit<typename Mesh::Halfedge>& where);
/// `chord`: the new halfedge v_s -> v_t.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_split(Mesh& mesh, PendingSplit<typename Mesh::Halfedge> pending,
                                             typename Mesh::Halfedge chord);

/// Announces a collapse of the mesh edge of `chord` = v_s -> v_t into v_s.
template <ColoredMesh Mesh>
[[nodiscard]] PendingCollapse<typename Mesh::Halfedge> before_collapse(Mesh& mesh, typename Mesh::Halfedge chord);
/// `spoke`: from v_s to v_l, the apex of the triangle that was to the left of the chord, or to v_r if that did not
/// exist.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_collapse(Mesh& mesh, PendingCollapse<typename Mesh::Halfedge> pending,
                                                typename Mesh::Halfedge spoke);

/// Announces a flip of the interior mesh edge of h.
template <ColoredMesh Mesh>
[[nodiscard]] PendingFlip<typename Mesh::Halfedge> before_flip(Mesh& mesh, typename Mesh::Halfedge h);
/// h: the turned edge, either of its halfedges.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_flip(Mesh& mesh, PendingFlip<typename Mesh::Halfedge> pending,
                                            typename Mesh::Halfedge h);

/// Changes by the operations of another library so far.
struct HookTally : ColoringChange {
  std::size_t operations = 0;
  /// Operations that the library made without a prior callback. The colouring is valid, but count its strips again:
  /// `strips` and `isolated` do not include these operations.
  std::size_t unannounced = 0;

  void add(const ColoringChange& done) noexcept {
    ++operations;
    *this += done;
  }
};

}  // namespace restrip

#include "restrip/operations/impl/hooks.hpp"
