// apply: custom operations that maintain strips.
//
// `restrip-generate rules` makes a header from a file that names the triangles before and after the operation
// (docs/reference/operation-file.md, "Triangles"). With this header, the operation can be done anywhere on a mesh:
//
//   #include "restrip/tables/operations/refine_face.hpp"
//   const auto done = restrip::apply(mesh, restrip::tables::refine_face_rules, h);
//
// h is the side from the first vertex to the second of the first triangle that the file names under `before`; the
// triangle lies to its left. All other triangles are found from there.
//
// The header of a family has one table for each position. With hub-goes.json of docs/tutorials/custom-operation.md, at
// a vertex of k triangles:
//
//   apply(mesh, position_of(restrip::tables::hub_goes_rules, {k}), h);
//
// A StripMesh is changed as the file says. For any other mesh, pass a function that changes it:
//
//   apply(mesh, table, h, [&](const auto& patch) {
//     mesh.my_operation(patch.between(3, 2), ...);  // a side, from vertex to vertex in the order of the file
//     return my_first_side;                         // of the first triangle under `after`, likewise
//   });
//
// That function has the contract of insert_vertex and remove_vertex (mesh.hpp). It does its work, or throws and leaves
// the mesh as it was. The dual edges of new triangles, and of mesh edges that it merges, are dashed; all others keep
// their colours. When it is called, all dual edges inside the patch are dashed. For code that cannot be called in
// between, use before_apply() and after_apply() (hooks.hpp has the same for split, collapse and flip).
//
// Nothing outside the patch is read or written, except that a rule may clear a port, which is also an edge of the
// triangle outside. The only state is the colours, and only the mesh allocates. Linear in the triangles of the patch,
// quadratic if a StripMesh changes itself.
//
// Debug builds check the preconditions: the triangles exist and differ; on a StripMesh, check_apply() grants the
// operation. Exceptions of the mesh leave the colouring valid (mesh.hpp).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/checked.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/tables/operation_format.hpp"

namespace restrip {

/// A table of rules that comes with the triangles of its operation: tables::SurfaceOperation, tables::PositionTable.
/// (An operation that is given as a graph lacks triangles and cannot be done on a mesh.)
template <class Table>
concept SurfaceTable = requires(const Table& table, std::uint32_t colors) {
  { tables::rule_of(table, colors, colors) } -> std::same_as<tables::OperationRule>;
  { table.triangles_before[0] } -> std::convertible_to<tables::PatchTriangle>;
  { table.triangles_after[0] } -> std::convertible_to<tables::PatchTriangle>;
  { table.vertices } -> std::convertible_to<unsigned>;
};

/// The triangles of a patch in a mesh: Extent of them, or std::dynamic_extent.
template <class Halfedge, std::size_t Extent>
struct PatchSides {
  explicit PatchSides(std::span<const tables::PatchTriangle, Extent> of) : triangles(of) {}

  std::span<const tables::PatchTriangle, Extent> triangles;  ///< of the table
  /// The three sides of each triangle, as in the table. Entries after the last triangle have no meaning.
  std::array<std::array<Halfedge, 3>, Extent == std::dynamic_extent ? tables::most_patch_triangles : Extent> side;

  /// The entries of `side` that belong to triangles.
  [[nodiscard]] std::span<const std::array<Halfedge, 3>> sides() const& {
    return std::span<const std::array<Halfedge, 3>>(side).first(triangles.size());
  }
  void sides() const&& = delete;
  /// The side from one vertex to another. Vertices are numbered from 0 in the order in which the file names them,
  /// before and after together. One of the triangles must have this side.
  [[nodiscard]] Halfedge between(unsigned from, unsigned to) const;
};
/// The number of triangles that a table has before or after its operation, or std::dynamic_extent.
template <class Triangles>
inline constexpr std::size_t patch_extent = decltype(std::span(std::declval<const Triangles&>()))::extent;
template <class Halfedge, SurfaceTable Table>
using SidesBefore = PatchSides<Halfedge, patch_extent<decltype(Table::triangles_before)>>;

/// Does the operation, with the best rule for the present colours. Rewrite::halfedge is the side of the first triangle
/// under `after`, from its first vertex to its second; Rewrite::valence is the number of ports.
template <SurfaceTable Table>
Rewrite<StripMesh::Halfedge> apply(StripMesh& mesh, const Table& table, StripMesh::Halfedge where);
/// The same, but `change`(patch) changes the mesh, see above.
template <ColoredMesh Mesh, SurfaceTable Table, class Change>
Rewrite<typename Mesh::Halfedge> apply(Mesh& mesh, const Table& table, typename Mesh::Halfedge where, Change&& change);

/// Whether the operation may be done on a StripMesh: the triangles exist, all their vertices are different, the mesh
/// keeps its properties (check_replace() in checks.hpp), and the colours have a rule.
template <SurfaceTable Table>
[[nodiscard]] Refusal check_apply(const StripMesh& mesh, const Table& table, StripMesh::Halfedge where);
/// On a StripMesh or a Keeper of one, for operations from an untrusted source: see checked.hpp.
template <CheckedTarget Target, SurfaceTable Table>
Checked checked_apply(Target& target, const Table& table, StripMesh::Halfedge where);

/// Sides of one triangle, in the order 0, 1, 2.
struct Places {
  std::array<StripMesh::Halfedge, 3> side{};
  std::size_t count = 0;

  [[nodiscard]] std::size_t size() const noexcept { return count; }
  [[nodiscard]] bool empty() const noexcept { return count == 0; }
  [[nodiscard]] const StripMesh::Halfedge* begin() const noexcept { return side.data(); }
  [[nodiscard]] const StripMesh::Halfedge* end() const noexcept { return side.data() + count; }
};
/// The sides of a triangle from which check_apply() grants the operation: the orientations in which it fits with this
/// triangle as the first under `before`. None for a number that is not a triangle.
template <SurfaceTable Table>
[[nodiscard]] Places places(const StripMesh& mesh, const Table& table, Triangle triangle);
/// Does the operation at the first of these places; without a place, it is refused with the reason for side 0.
template <CheckedTarget Target, SurfaceTable Table>
Checked apply_anywhere(Target& target, const Table& table, Triangle triangle);

/// An operation whose mesh has not changed yet. Made by before_apply(), consumed by after_apply(). Refers to the table.
template <class Halfedge, SurfaceTable Table>
class PendingApply;

template <ColoredMesh Mesh, SurfaceTable Table>
[[nodiscard]] PendingApply<typename Mesh::Halfedge, Table> before_apply(Mesh& mesh, const Table& table,
                                                                        typename Mesh::Halfedge where);
template <ColoredMesh Mesh, SurfaceTable Table>
void before_apply(Mesh& mesh, const Table&& table, typename Mesh::Halfedge where) = delete;  // it would be gone
/// `first`: what the function above returns.
template <ColoredMesh Mesh, SurfaceTable Table>
Rewrite<typename Mesh::Halfedge> after_apply(Mesh& mesh, const PendingApply<typename Mesh::Halfedge, Table>& pending,
                                             typename Mesh::Halfedge first);

}  // namespace restrip

#include "restrip/operations/impl/apply.hpp"
