// Tests whether your mesh keeps the contract of mesh/mesh.hpp. One call drives it through random operations, checks the
// whole mesh after each, and reports the first line of the contract that it breaks.
//
//   MyMesh mesh = a_small_mesh();                       // some 50 to 200 triangles, with and without boundary
//   const restrip::AdapterReport report = restrip::test_adapter(mesh, any_halfedge);
//   if (!report.kept()) puts(describe(report.broken));  // "remove_vertex: ..."
//
// It tests the members that the mesh has: the walk, colours, insert_vertex, remove_vertex, turn_edge, the optional
// members (alive, leaves_boundary, fan_step, strip_step) and the numbers of numbered_mesh.hpp. Half of the operations
// call the mesh directly, with random colours that need not be valid. Then all edges are cleared, and split(),
// collapse(), flip() and the operations of refine.hpp must keep a valid colouring and report its changes correctly.
//
// Handles are only compared and passed back to the mesh. The mesh is not copied. Expected results do not come from the
// mesh under test, but from notes on its state before the operation. Not included by restrip.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/numbered_mesh.hpp"

namespace restrip {

/// The lines of the contract. docs/how-to/own-mesh.md has a picture.
enum class Contract {
  kept,                      ///< all of them
  opposite_is_involution,    ///< opposite(opposite(h)) is h, and opposite(h) is not h
  triangle_of_three,         ///< three steps of next lead around a triangle over three halfedges
  triangle_has_no_boundary,  ///< the halfedges of a triangle are not on the boundary
  edge_has_triangle,         ///< a halfedge or its opposite has a triangle
  walk_ends,                 ///< the walk meets every halfedge once
  same_color_on_both_sides,  ///< solid(h) is solid(opposite(h))
  boundary_is_dashed,        ///< solid is false on boundary edges
  set_solid_sets,            ///< after set_solid(h, c) solid(h) and solid(opposite(h)) are c
  set_solid_sets_one,        ///< set_solid changes no other dual edge
  alive_knows,               ///< alive is true for the halfedges of the mesh
  leaves_boundary_knows,     ///< leaves_boundary agrees with the walk around the vertex
  fan_step_agrees,           ///< fan_step agrees with next, opposite and solid
  strip_step_agrees,         ///< strip_step agrees with next, opposite and solid
  triangle_numbers,          ///< triangle and halfedge agree; each triangle has a unique number below the bound
  vertex_numbers,            ///< from returns one number for all halfedges that leave a vertex
  chord_between_new_ends,    ///< insert_vertex returns v_s -> v_t: each end has the triangles of VertexSplit
  new_edges_dashed,          ///< insert_vertex leaves the dual edges of the new triangles dashed
  spoke_to_apex,             ///< remove_vertex returns v_s -> v_l, and v_s has the triangles of both ends
  merged_edges_dashed,       ///< remove_vertex leaves the dual edges of merged edges dashed
  edge_turned,               ///< turn_edge returns r -> l, and its triangles are (r, l, u) and (l, r, v)
  handles_stay,              ///< other halfedges stay valid handles of the same mesh edges
  numbers_stay,              ///< other triangles keep their numbers, and halfedge(t) is as it was for them
  other_colors_stay,         ///< other dual edges keep their colours
  triangle_count,            ///< an operation adds and removes the triangles that it should
  coloring_stays_valid,      ///< split(), collapse(), flip() and refine.hpp leave a valid colouring
  report_is_true,            ///< and their Rewrite::strips is the change in strips
  changes_named              ///< a list of changed triangles names all of them
};

/// One human-readable sentence that names the function of the mesh.
[[nodiscard]] constexpr const char* describe(Contract line) noexcept;

struct AdapterTest {
  std::size_t operations = 600;  ///< each costs the square of the number of triangles
  unsigned seed = 1;
};

struct AdapterReport {
  Contract broken = Contract::kept;                ///< the first line that the mesh broke
  const char* during = "the mesh as it is given";  ///< or the last function called
  std::size_t operations = 0;                      ///< the number done
  std::size_t splits = 0;                          ///< calls of insert_vertex
  std::size_t collapses = 0;                       ///< calls of remove_vertex
  std::size_t flips = 0;                           ///< calls of turn_edge

  [[nodiscard]] constexpr bool kept() const noexcept { return broken == Contract::kept; }
};

/// Tests the connected component of `start`, which must be manifold, and changes it. A badly broken mesh may crash.
/// Throws what the mesh throws, and std::bad_alloc.
template <ColoredMesh Mesh>
[[nodiscard]] AdapterReport test_adapter(Mesh& mesh, typename Mesh::Halfedge start, AdapterTest options = {});

/// Also tests a list of changes as buffers need it: after each operation *changed must name every triangle whose
/// corners, neighbours or colours have changed, and every triangle inserted or removed. The test clears the list.
template <NumberedMesh Mesh>
[[nodiscard]] AdapterReport test_adapter(Mesh& mesh, typename Mesh::Halfedge start, std::vector<std::uint32_t>* changed,
                                         AdapterTest options = {});

}  // namespace restrip

#include "restrip/operations/impl/test_adapter.hpp"
