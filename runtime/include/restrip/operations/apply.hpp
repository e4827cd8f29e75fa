// apply: custom operations that maintain strips.
//
// `restrip-generate rules` makes a header from a file that names the triangles before and after the operation
// (docs/reference/operation-file.md). With this header, the operation can be done anywhere on a mesh:
//
//   #include "restrip/tables/operations/refine_face.hpp"
//   const auto done = restrip::checked_apply(mesh, restrip::tables::refine_face_rules, h);
//
// h is the side from the first vertex to the second of the first triangle that the file names under `before`; the
// triangle lies to its left. All other triangles are found from there.
//
// The header of a family has one table for each position. With hub-goes.json of docs/tutorials/custom-operation.md, at
// a vertex of k triangles:
//
//   checked_apply(mesh, position_of(restrip::tables::hub_goes_rules, {k}), h);
//
// Nothing outside the patch is read or written, except that a rule may clear a port, which is also an edge of the
// triangle outside. Time quadratic in the triangles of the patch. After an exception the colouring is valid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "restrip/mesh/refusal.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/result.hpp"
#include "restrip/tables/operation_format.hpp"

namespace restrip {

/// A view of a table of rules with the triangles of its operation. The table must outlive it. Anything that has the
/// layout of tables::SurfaceOperation or tables::PositionTable converts to it; so does data that was read at run time
/// and put into arrays of that layout.
struct OperationView {
  tables::PatchSize before;
  tables::PatchSize after;
  unsigned ports = 0;
  bool matching = false;
  unsigned vertices = 0;          ///< of both sides together; triangles name them by numbers below it
  unsigned entry_bytes = 0;       ///< 1, 2 or 4
  const void* entries = nullptr;  ///< null: a position that is not in its family, which no place fits
  std::span<const tables::PatchTriangle> triangles_before;
  std::span<const tables::PatchTriangle> triangles_after;

  OperationView() = default;
  template <class Table>
  requires requires(const Table& table) {
    table.triangles_before;
    table.entries;
  }
  constexpr OperationView(const Table& table) noexcept  // NOLINT(google-explicit-constructor): a view
      : before(table.before),
        after(table.after),
        ports(table.ports),
        matching(table.matching),
        vertices(table.vertices),
        triangles_before(table.triangles_before),
        triangles_after(table.triangles_after) {
    if constexpr (requires { table.entries.data(); })
      entries = table.entries.data();
    else
      entries = table.entries;
    entry_bytes = sizeof(table.entries[0]);
  }

  /// The rule for these solid inner edges and ports; not valid for colours that no valid stripification has.
  [[nodiscard]] tables::OperationRule rule(std::uint32_t inner, std::uint32_t solid_ports) const noexcept;
};

/// Whether the operation may be done: the triangles exist, all their vertices are different, the mesh keeps its
/// properties (checks.hpp), no edge is made that exists already, and the colours have a rule.
[[nodiscard]] Refusal check_apply(const StripMesh& mesh, const OperationView& table, Halfedge where);

/// Does the operation, with the best rule for the present colours. Rewrite::halfedge is the side of the first triangle
/// under `after`, from its first vertex to its second; Rewrite::valence is the number of ports. `added`, if given,
/// receives the new vertices. Precondition: check_apply() grants it.
Rewrite apply(StripMesh& mesh, const OperationView& table, Halfedge where, NewVertices* added = nullptr);
/// The same if check_apply() grants it.
Checked checked_apply(StripMesh& mesh, const OperationView& table, Halfedge where);

/// The first side of a triangle from which check_apply() grants the operation: the first orientation in which it fits
/// with this triangle as the first under `before`. Without one, side 0, for which check_apply() has the reason; {none}
/// for a number that is not a triangle.
[[nodiscard]] Halfedge first_place(const StripMesh& mesh, const OperationView& table, Triangle triangle);

}  // namespace restrip
