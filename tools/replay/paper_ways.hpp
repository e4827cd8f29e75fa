// The method of the paper: handmade rules for the 4-vertex and none for other vertices.
//
// A split without a rule leaves the strips as they are. If it cuts a dual edge in two, both halves inherit its colour:
// a cut strip passes through the new triangle, and a new triangle on a dashed edge stays isolated. The paper does not
// say whether two isolated new triangles form a strip, nor how the share of splits that it counts depends on its
// tunnelling, so both are switches. Its 4-vertex rules are assumed to be the optimal ones, as it claims. It does not
// describe collapses and flips in enough detail to reproduce them: they use the rules of the tables.
#pragma once

#include <vector>

#include "replay/ways.hpp"

namespace restrip::tools {

/// Splits a vertex as the paper would. `join`: the two new triangles form a strip if both cut edges were dashed.
/// Preconditions and result as for restrip::split.
StripMesh::Halfedge split_as_the_paper(StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where, Vertex v_t,
                                       bool join);

/// The four settings of the switches, named paper, paper-alone, paper-tunnel, paper-alone-tunnel.
[[nodiscard]] std::vector<Way> paper_ways();

}  // namespace restrip::tools
