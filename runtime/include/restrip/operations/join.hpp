// Joins: ends of different strips that lie side by side become one strip.
//
// A local rule leaves strip ends where they are, and two ends that meet across a dashed edge may belong to two strips.
// Whether they do is found by walking from both ends at once, in at most one step for each triangle of the shorter
// strip (all of it, where both are ends of the same strip). After an operation three things are done:
//  1. Where a strip was cut, its far ends may be neighbours that now belong to two strips. They are found by following
//     the strips that end around the operation, all at once and until at most one has not come to its other end, and
//     joined there.
//  2. Ends in the patch, and behind ports that were given up, are joined with the ends next to them.
//  3. Triangles that are still isolated are adopted (adopt.hpp), and the ends that this leaves are treated as in 1
//  and 2.
//
// What follows. A mesh in which no dashed edge joins ends of two different strips keeps this property under
// split_and_join(), collapse_and_join() and flip_and_join(). Then the number of strips is bounded for the whole mesh,
// at every moment: docs/explanation/theory.md, "What holds for the whole mesh". join_all() establishes the property.
//
// The only state is the colours, and nothing is allocated. Colours outside the patch are read and written, so
// these operations do not commute with their neighbours as the ones of operations.hpp do.
#pragma once

#include <array>
#include <cstddef>

#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/numbered_mesh.hpp"
#include "restrip/operations/adopt.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/operations.hpp"

namespace restrip {

/// Whether a strip end that no other end meets may give up an adjacent edge x - y for two others: u - x, where u is
/// the end, and y - w, where w is an end of another strip. One strip less for each; strips get two to three times as
/// long. Step 1 is left out then, so a few ends that meet may stay apart. The operations of linked.hpp exchange.
enum class Exchange { no, yes };

/// Are the triangles to the left of g and h, which must be two strip ends or isolated triangles, ends of one strip?
/// Time linear in the shorter strip.
template <ColoredMesh Mesh>
[[nodiscard]] bool same_strip(const Mesh& mesh, typename Mesh::Halfedge g, typename Mesh::Halfedge h);

/// If a strip ends in the triangle to the left of h, joins it with adjacent ends of other strips: at most two. Time
/// linear in the shorter strip of each pair that meets.
template <ColoredMesh Mesh>
Mending join_end(Mesh& mesh, typename Mesh::Halfedge h);

/// Joins all ends that meet in the whole mesh. Linear in the number of triangles times the mean length of the strips
/// that end next to each other.
template <NumberedMesh Mesh>
Mending join_all(Mesh& mesh);

/// Steps 1 to 3 above after an operation that has been done, for custom operations and the ones of refine.hpp: around
/// the vertex that h leaves; or in the triangles at the edge of h, and in the neighbours of these two, where ports may
/// have been given up.
template <ColoredMesh Mesh>
Mending join_around(Mesh& mesh, typename Mesh::Halfedge h, Exchange exchange = Exchange::no);
template <ColoredMesh Mesh>
Mending join_beside(Mesh& mesh, typename Mesh::Halfedge h, Exchange exchange = Exchange::no);

/// split(), then joins and adoption. The Rewrite counts all of it. `name`: the new vertex, for meshes that let the
/// caller name it.
template <SplittableMesh Mesh, class... Name>
Rewrite<typename Mesh::Halfedge> split_and_join(Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where,
                                                Name... name);

/// collapse(), likewise.
template <CollapsibleMesh Mesh>
Rewrite<typename Mesh::Halfedge> collapse_and_join(Mesh& mesh, typename Mesh::Halfedge chord);

/// flip(), likewise.
template <FlippableMesh Mesh>
Rewrite<typename Mesh::Halfedge> flip_and_join(Mesh& mesh, typename Mesh::Halfedge h);

/// apply(), likewise.
template <ColoredMesh Mesh, SurfaceTable Table, class Change>
Rewrite<typename Mesh::Halfedge> apply_and_join(Mesh& mesh, const Table& table, typename Mesh::Halfedge where,
                                                Change&& change, Exchange exchange = Exchange::no);

}  // namespace restrip

#include "restrip/operations/impl/join.hpp"
