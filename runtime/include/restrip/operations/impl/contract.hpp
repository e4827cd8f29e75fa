// The sentences of the lines of the contract. Included by test_adapter.hpp.
#pragma once

#include "restrip/operations/test_adapter.hpp"

namespace restrip {

[[nodiscard]] constexpr const char* describe(Contract line) noexcept {
  switch (line) {
    case Contract::kept:
      return "the mesh keeps the contract";
    case Contract::opposite_is_involution:
      return "opposite: the opposite of the opposite is not the halfedge itself, or a halfedge is its own opposite";
    case Contract::triangle_of_three:
      return "next: three steps do not lead once around a triangle";
    case Contract::triangle_has_no_boundary:
      return "on_boundary: true for a halfedge of a triangle";
    case Contract::edge_has_triangle:
      return "on_boundary: true for both halfedges of a mesh edge";
    case Contract::walk_ends:
      return "next, opposite: they lead to more halfedges than the mesh has";
    case Contract::same_color_on_both_sides:
      return "solid: a halfedge and its opposite have different colours";
    case Contract::boundary_is_dashed:
      return "solid: true on a boundary edge";
    case Contract::set_solid_sets:
      return "set_solid: the halfedge or its opposite has another colour afterwards";
    case Contract::set_solid_sets_one:
      return "set_solid: it changed another dual edge as well";
    case Contract::alive_knows:
      return "alive: false for a halfedge of the mesh";
    case Contract::leaves_boundary_knows:
      return "leaves_boundary: it disagrees with a walk around the vertex";
    case Contract::fan_step_agrees:
      return "fan_step: it disagrees with next, opposite and solid";
    case Contract::strip_step_agrees:
      return "strip_step: it disagrees with next, opposite and solid";
    case Contract::triangle_numbers:
      return "triangle, halfedge, has_triangle, triangle_bound: they do not number each triangle once";
    case Contract::vertex_numbers:
      return "from: halfedges that leave the same vertex have different numbers, or two corners of a triangle the same";
    case Contract::chord_between_new_ends:
      return "insert_vertex: the halfedge returned is not v_s -> v_t with the triangles that VertexSplit says around "
             "each";
    case Contract::new_edges_dashed:
      return "insert_vertex: a dual edge of a new triangle is solid";
    case Contract::spoke_to_apex:
      return "remove_vertex: the halfedge returned is not v_s -> v_l (or v_r if v_l does not exist) with the triangles "
             "of both ends around v_s";
    case Contract::merged_edges_dashed:
      return "remove_vertex: the dual edge of two merged mesh edges is solid";
    case Contract::edge_turned:
      return "turn_edge: the halfedge returned is not r -> l between the triangles (r, l, u) and (l, r, v)";
    case Contract::handles_stay:
      return "insert_vertex, remove_vertex, turn_edge: another halfedge has moved";
    case Contract::numbers_stay:
      return "insert_vertex, remove_vertex, turn_edge: another triangle has another number, or another halfedge(t)";
    case Contract::other_colors_stay:
      return "insert_vertex, remove_vertex, turn_edge: another dual edge changed its colour";
    case Contract::triangle_count:
      return "insert_vertex, remove_vertex, turn_edge: the number of triangles is not what it should be";
    case Contract::coloring_stays_valid:
      return "the colouring is not valid after an operation of restrip, though every other line held";
    case Contract::report_is_true:
      return "an operation of restrip did not report the change in strips, though every other line held";
    case Contract::changes_named:
      return "the list of changes: a triangle changed and is not in it";
  }
  return "unknown";
}

}  // namespace restrip
