// What the paper had: rules for the 4-vertex, worked out by hand, and no rule for any other.
//
// A split without a rule leaves the strips as they are: where it cuts a dual edge in two, both halves inherit its
// colour, so that a strip that was cut passes through the new triangle, and a new triangle on a dashed edge is left
// alone. The paper does not say whether the two new triangles become a strip where both are alone, nor how the share of
// splits that it counts depends on its tunnelling, so both are switches. Its 4-vertex rules are taken to be the optimal
// ones, which it claims for them. Of collapses and flips it says nothing that could be done again: they go by the rules
// of the tables.
#pragma once

#include <vector>

#include "replay/ways.hpp"

namespace restrip::tools {

/// Splits a vertex as the paper would. `join`: the two new triangles become a strip where both cut edges were dashed.
/// Preconditions and result as for restrip::split.
StripMesh::Halfedge split_as_the_paper(StripMesh& mesh, const VertexSplit<StripMesh::Halfedge>& where, Vertex v_t,
                                       bool join);

/// The four settings of the switches, by the names paper, paper-alone, paper-tunnel, paper-alone-tunnel.
[[nodiscard]] std::vector<Way> paper_ways();

}  // namespace restrip::tools
