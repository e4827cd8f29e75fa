// Strips kept while another library changes the mesh: a decimater, a remesher, an editor.
//
// split(), collapse() and flip() call your mesh to change itself. Where a library insists on changing it, call the two
// halves around its change: the first reads the colours, looks the rule up and dashes what will be dashed, the second
// makes solid what will be solid.
//
//   auto pending = before_collapse(mesh, chord);                       // chord = v_s -> v_t, v_t will go
//   library.collapse(...);
//   const auto done = after_collapse(mesh, std::move(pending), spoke);  // spoke leaves v_s, as in CollapsibleMesh
//
// The mesh needs to model ColoredMesh only, and colours must go with mesh edges: an edge property that is false for new
// edges will do. What holds of insert_vertex, remove_vertex and turn_edge (mesh.hpp) must hold of the library's change,
// with one exception: edges that merge and edges of triangles that go may keep any colour, because the first half
// dashes them. Nothing else may change the patch between the two halves.
//
// Between the halves the colouring is valid, with fewer solid edges perhaps, and it stays so if the library gives up
// its change: then drop the pending object, and count the strips again. The result is the one of split(), collapse()
// and flip(), which are made of the same halves, and takes the same time. A pending object allocates only for fans of
// more than max_word_valence triangles.
//
// Debug builds check the preconditions of the operation before, and after it that the mesh has the patch that the
// operation makes. On meshes other than StripMesh every operation also checks that the colours it reads can belong to
// a valid colouring (Refusal::colors_not_valid), so that changes past restrip do not go unnoticed for long;
// check_coloring (output/strips.hpp) looks at the whole mesh. Linked rules: linked_hooks.hpp. Ready for use:
// operations/adapters/openmesh_decimater.hpp and operations/adapters/cgal_edge_collapse.hpp.
#pragma once

#include <cstddef>

#include "restrip/mesh/mesh.hpp"
#include "restrip/operations/operations.hpp"

namespace restrip {

namespace detail {
template <class Halfedge>
class PendingFan;
}

/// A split, collapse or flip whose mesh has not changed yet. Made by before_*(), used up by after_*().
template <class Halfedge>
class PendingSplit;
template <class Halfedge>
class PendingCollapse;
template <class Halfedge>
class PendingFlip;

/// The vertex will be split there.
template <ColoredMesh Mesh>
[[nodiscard]] PendingSplit<typename Mesh::Halfedge> before_split(Mesh& mesh,
                                                                 const VertexSplit<typename Mesh::Halfedge>& where);
/// `chord`: the new halfedge v_s -> v_t.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_split(Mesh& mesh, PendingSplit<typename Mesh::Halfedge> pending,
                                             typename Mesh::Halfedge chord);

/// The mesh edge of `chord` = v_s -> v_t will be collapsed into v_s.
template <ColoredMesh Mesh>
[[nodiscard]] PendingCollapse<typename Mesh::Halfedge> before_collapse(Mesh& mesh, typename Mesh::Halfedge chord);
/// `spoke`: from v_s to v_l, the apex of the triangle that was to the left of the chord, or where there was none to
/// v_r.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_collapse(Mesh& mesh, PendingCollapse<typename Mesh::Halfedge> pending,
                                                typename Mesh::Halfedge spoke);

/// The interior mesh edge of h will be flipped.
template <ColoredMesh Mesh>
[[nodiscard]] PendingFlip<typename Mesh::Halfedge> before_flip(Mesh& mesh, typename Mesh::Halfedge h);
/// h: the turned edge, either of its halfedges.
template <ColoredMesh Mesh>
Rewrite<typename Mesh::Halfedge> after_flip(Mesh& mesh, PendingFlip<typename Mesh::Halfedge> pending,
                                            typename Mesh::Halfedge h);

/// What the operations of another library changed so far.
struct HookTally {
  std::size_t operations = 0;
  long strips = 0;    ///< change in the number of strips
  long isolated = 0;  ///< change in the number of isolated triangles
  /// Operations that the library made without a callback before. The colouring is valid, but count its strips again:
  /// the change that these made is not in `strips` and `isolated`.
  std::size_t untold = 0;

  template <class Halfedge>
  void add(const Rewrite<Halfedge>& done) noexcept {
    ++operations;
    strips += done.strips;
    isolated += done.isolated;
  }
};

}  // namespace restrip

#include "restrip/operations/impl/hooks.hpp"
