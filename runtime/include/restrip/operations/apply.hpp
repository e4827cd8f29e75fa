// apply: a custom operation that maintains strips.
//
// `restrip-generate rules` makes a header from a file that names the triangles before and after the operation
// (docs/reference/operation-file.md, "Triangles"). With the header, the operation can be done at any place of a mesh:
//
//   #include "restrip/tables/operations/refine_face.hpp"
//   const auto done = restrip::apply(mesh, restrip::tables::refine_face, h);
//
// h is a side of the first triangle that the file names under `before`: the one from its first vertex to its second,
// with the triangle to the left of it. All other triangles are found from there.
//
// The header of a family has one table for each of its positions. With hub-goes.json of
// docs/tutorials/custom-operation.md, at a vertex of k triangles:
//
//   apply(mesh, position_of(restrip::tables::hub_goes, {k}), h);
//
// A StripMesh is changed as the file says. Any other mesh changes itself, by a function of yours:
//
//   apply(mesh, table, h, [&](const auto& patch) {
//     mesh.my_operation(patch.between(3, 2), ...);  // a side, from vertex to vertex in the order of the file
//     return my_first_side;                         // of the first triangle under `after`, likewise
//   });
//
// What holds of insert_vertex and its like (mesh.hpp) must hold of that function: it does its work, or throws and
// leaves the mesh as it was; the dual edges of new triangles, and of mesh edges that it merges, are dashed; all others
// keep their colours. When it is called all dual edges inside the patch are dashed. The two halves do the same for code
// that cannot be called in between (hooks.hpp has the halves of split, collapse and flip).
//
// Nothing outside the patch is read or written, except that a rule may give a port up, which dashes an edge of the
// triangle behind it. The only state is the colours, and only the mesh allocates. Linear in the
// triangles of the patch, quadratic where a StripMesh changes itself.
//
// Preconditions are checked in debug builds: that the triangles are there, and are different ones; on a StripMesh what
// check_apply() says. Exceptions of the mesh leave the colouring valid, as mesh.hpp says.
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
/// (One of an operation that is given as a graph has none, and cannot be done on a mesh.)
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
  /// Three sides of each triangle, as the table has them; what is behind the last triangle means nothing.
  std::array<std::array<Halfedge, 3>, Extent == std::dynamic_extent ? tables::most_patch_triangles : Extent> side;

  /// `side` as far as there are triangles.
  [[nodiscard]] std::span<const std::array<Halfedge, 3>> sides() const& {
    return std::span<const std::array<Halfedge, 3>>(side).first(triangles.size());
  }
  void sides() const&& = delete;
  /// The side from one vertex to another, which are numbered from 0 in the order in which the file names them, both
  /// sides of the operation together. One of the triangles must have it.
  [[nodiscard]] Halfedge between(unsigned from, unsigned to) const;
};
/// How many triangles a table has on a side of its operation, or std::dynamic_extent.
template <class Triangles>
inline constexpr std::size_t patch_extent = decltype(std::span(std::declval<const Triangles&>()))::extent;
template <class Halfedge, SurfaceTable Table>
using SidesBefore = PatchSides<Halfedge, patch_extent<decltype(Table::triangles_before)>>;

/// Does the operation, with the best rule for the colours that it finds. Rewrite::halfedge is the side of the first
/// triangle under `after`, from its first vertex to its second; Rewrite::valence the number of ports.
template <SurfaceTable Table>
Rewrite<StripMesh::Halfedge> apply(StripMesh& mesh, const Table& table, StripMesh::Halfedge where);
/// The same where `change`(patch) changes the mesh, see above.
template <ColoredMesh Mesh, SurfaceTable Table, class Change>
Rewrite<typename Mesh::Halfedge> apply(Mesh& mesh, const Table& table, typename Mesh::Halfedge where, Change&& change);

/// May it be done on a StripMesh? Grants it when the triangles are there, all their vertices are different, and the
/// mesh stays as good as it was (check_replace() in checks.hpp); colours that have no rule are refused as well.
template <SurfaceTable Table>
[[nodiscard]] Refusal check_apply(const StripMesh& mesh, const Table& table, StripMesh::Halfedge where);
/// For operations from an untrusted source, see checked.hpp.
template <SurfaceTable Table>
Checked checked_apply(StripMesh& mesh, const Table& table, StripMesh::Halfedge where);
template <KeepsStrips Keeper, SurfaceTable Table>
Checked checked_apply(Keeper& keeper, const Table& table, StripMesh::Halfedge where);

/// An operation whose mesh has not changed yet. Made by before_apply(), used up by after_apply(). Refers to the table.
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
