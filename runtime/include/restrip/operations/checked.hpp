// split, collapse and flip for operations from an untrusted source: checked in every build, and refused with a reason.
//
//   if (const auto done = checked_collapse(mesh, chord))
//     use(done.rewrite.strips);
//   else
//     report(describe(done.refusal));
//
// Each calls its check (checks.hpp) and does the operation if it is granted; a refused operation changes nothing. May
// throw when the mesh grows (std::bad_alloc, std::length_error); nothing has changed then.
#pragma once

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip {

/// `new_vertex`: see check_split. Takes the time of the check and of the operation.
Checked checked_split(StripMesh& mesh, const VertexSplit& where, Vertex new_vertex = none);
Checked checked_collapse(StripMesh& mesh, Halfedge chord);
Checked checked_flip(StripMesh& mesh, Halfedge h);

}  // namespace restrip
