// split, collapse, flip: the operations of a dynamic mesh, which maintain its strips.
//
// Each reads the colours around the operation, looks up its rule (rules.hpp), lets the mesh change, and writes the new
// colours. Nothing outside the patch is read or written, so operations on disjoint patches commute. The only state is
// the colours. Fans of at most max_word_valence triangles need no allocation. Time is linear in the valence.
//
// Preconditions: as for the mesh operation (checks.hpp); debug builds check them first and abort with the
// reason (precondition.hpp). After an exception (std::bad_alloc, std::length_error) the colouring is valid, though
// perhaps not optimal: first everything is read, then edges are cleared, then the mesh changes, then edges are set.
//
// For operations from an untrusted source the functions checked_… call the check in every build:
//
//   if (const auto done = checked_collapse(mesh, chord))
//     use(done.rewrite.strips);
//   else
//     report(describe(done.refusal));
#pragma once

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip {

/// Splits a vertex and recolours the patch (VertexSplit describes the new triangles). `new_vertex`: see check_split.
Rewrite split(StripMesh& mesh, const VertexSplit& where, Vertex new_vertex = none);

/// Collapses the mesh edge of `chord` = v_s -> v_t into v_s and recolours the patch.
Rewrite collapse(StripMesh& mesh, Halfedge chord);

/// Flips the interior mesh edge of h and recolours the patch. A port is cleared only if no sound recolouring keeps it.
/// The triangle outside may then be isolated, which Rewrite::isolated counts.
Rewrite flip(StripMesh& mesh, Halfedge h);

/// The same if the check grants it. A refused operation changes nothing, nor does one that throws when the mesh grows.
Checked checked_split(StripMesh& mesh, const VertexSplit& where, Vertex new_vertex = none);
Checked checked_collapse(StripMesh& mesh, Halfedge chord);
Checked checked_flip(StripMesh& mesh, Halfedge h);

}  // namespace restrip
