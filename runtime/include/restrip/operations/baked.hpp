// Baked strips: strips chosen offline, played back at the cost of a copy.
//
// A progressive mesh is fixed long before it is shown, so its strips can be precomputed too. `restrip bake` chooses the
// strips of every level with long searches and stores, for each record, the dual edges whose colours change. At run
// time a split flips exactly these colours, and a collapse flips them back, without rules, searches or state. A level
// always has the same strips, bit for bit, whether it is reached by splits or by collapses.
//
//   split_baked(mesh, where, records[i], v_t);         // record i, as the level grows; mesh: at first the base
//   collapse_baked(mesh, chord, records[i]);           // and as it shrinks
//
// The flips of a record are relative to the *plain* colouring, which is valid by itself. A split gives both halves of
// an edge that it cuts the colour of that edge, so that the inserted triangle continues that strip; all other new dual
// edges are dashed. For a collapse the same holds in reverse.
//
// Play records in order: the flips of a record fit only the state just before it. After any other change of the mesh
// or its colours, restore both to a baked level, or use operations.hpp. A LiveMesh made of a baked file does this.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"

namespace restrip {

/// The flips of all records, one after the other. Each is a halfedge of the mesh after the split; a dual edge is named
/// once, by either of its halfedges.
struct BakedRecords {
  std::vector<Halfedge> flips;
  std::vector<std::uint32_t> first{0};  ///< of record i in `flips`; one more than records

  [[nodiscard]] std::size_t size() const noexcept { return first.size() - 1; }
  [[nodiscard]] std::span<const Halfedge> operator[](std::size_t record) const noexcept {
    return {flips.data() + first[record], flips.data() + first[record + 1]};
  }
};

/// Flips colours, first the ones that become dashed; returns the increase in solid dual edges.
int flip_colors(StripMesh& mesh, std::span<const Halfedge> flips);

/// Splits a vertex, colours the mesh plainly and flips `flips`, halfedges of the mesh after the split. Preconditions:
/// as for split(), and the mesh is in the state for which the flips were baked; of the latter, debug builds check only
/// that each flip is a dual edge of the mesh. Takes the
/// time of the mesh operation, and is linear in the flips. Allocates only what the mesh needs to grow, and one bit for
/// each flip of a record with more than 512. After an exception the colouring is valid (operations.hpp), but later
/// flips no longer fit it. `valence` and `isolated` of the result are 0, because counting them would take longer than
/// the flips.
Rewrite split_baked(StripMesh& mesh, const VertexSplit& where, std::span<const Halfedge> flips,
                    Vertex new_vertex = none);

/// The inverse: flips `flips`, collapses the edge of `chord` = v_s -> v_t into v_s, and gives each merged edge the
/// colour that its halves then have. Preconditions and cost as above.
Rewrite collapse_baked(StripMesh& mesh, Halfedge chord, std::span<const Halfedge> flips);

}  // namespace restrip
