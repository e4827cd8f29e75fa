// Strips of a mesh that does not change: from a triangle list to an index buffer of its strips.
//
//   const IndexBuffer strips = strips_of(list, vertex_count, {.form = StripForm::stitched});   // upload strips.bytes()
//
// If the cost allows it, only the neighbours of the list are computed and no mesh is built. So this is faster than
// StripMesh::build, stripify and strip_indices one after the other.
#pragma once

#include <cstddef>

#include "restrip/fwd.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/triangle_list.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/output/strip_order.hpp"

namespace restrip {

/// Returns the strips of a triangle list (anything that a TriangleList can be made of), in a form of
/// output/strip_format.hpp: the same strips as StripMesh::build(), stripify() and strip_indices(). If a list has fewer
/// indices, it is returned instead, and IndexBuffer::form says so. With a size of `cache`,
/// strips_for_vertex_cache() makes the strips. `report` receives the counts of triangles left out. Cache and report
/// take the time of building a mesh. Throws as TriangleList, find_neighbors(), stripify(), strips_for_vertex_cache()
/// and format_strips() do.
template <class Triangles>
[[nodiscard]] IndexBuffer strips_of(const Triangles& triangles, std::size_t vertex_count,
                                    const StripFormat& format = {}, Effort effort = default_effort,
                                    Cost cost = default_cost, const VertexCache& cache = {},
                                    BuildReport* report = nullptr);

namespace detail {

template <class Element>
[[nodiscard]] IndexBuffer strips_of(const TriangleList<Element>& list, std::size_t vertex_count,
                                    const StripFormat& format, Effort effort, Cost cost, const VertexCache& cache,
                                    BuildReport* report);

}  // namespace detail

template <class Triangles>
IndexBuffer strips_of(const Triangles& triangles, std::size_t vertex_count, const StripFormat& format, Effort effort,
                      Cost cost, const VertexCache& cache, BuildReport* report) {
  return detail::strips_of(TriangleList(triangles), vertex_count, format, effort, cost, cache, report);
}

}  // namespace restrip
