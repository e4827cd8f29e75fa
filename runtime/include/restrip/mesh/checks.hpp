// Preconditions of split, collapse and flip on a StripMesh: whether an operation is legal, and if not, why.
//
// A check changes nothing. An operation is granted exactly when all of this holds:
//  - its halfedges belong to the mesh, and its vertices v_h, v_s, v_t, v_l, v_r are manifold (StripMesh::non_manifold),
//    except the new one, which is part of no triangle yet and not named far beyond all others (max_vertex_gap);
//  - closed fans that are split have three triangles or more;
//  - the mesh keeps its properties: no edge of three triangles, no new non-manifold vertex, three triangles or more at
//    every interior vertex of the operation, no vertex lost except the one that a collapse removes, the same topology.
//
// In debug builds (precondition.hpp) operations call these and abort on a refusal; with NDEBUG they check nothing. For
// operations from an untrusted source call these first, or checked_split() and its siblings (operations.hpp).
#pragma once

#include <array>
#include <span>

#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

/// Whether the vertex may be split there. `new_vertex`: the name of the new vertex; by default the next free one.
/// O(1).
[[nodiscard]] Refusal check_split(const StripMesh& mesh, const VertexSplit& where, Vertex new_vertex = none);

/// Whether the edge of `chord` may be collapsed (link condition: Dey, Edelsbrunner, Guha, Nekhayev 1999). A few steps
/// on ordinary meshes; at worst O(n log n) for n = the sum of the valences of its two ends. Allocates only if both
/// exceed 32.
[[nodiscard]] Refusal check_collapse(const StripMesh& mesh, Halfedge chord);

/// Whether the edge of h may be flipped. O(valence).
[[nodiscard]] Refusal check_flip(const StripMesh& mesh, Halfedge h);

/// Whether any triangles may be replaced by others (StripMesh::replace): `out` are triangles of the mesh, each once,
/// `in` have three different corners each, and the result is a manifold with boundary at all their vertices, with at
/// least three triangles around an interior one. O(n log n) for n triangles at the vertices.
[[nodiscard]] Refusal check_replace(const StripMesh& mesh, std::span<const Triangle> out,
                                    std::span<const std::array<Vertex, 3>> in);

}  // namespace restrip
