// Strips of a mesh that does not change: from a triangle list to an index buffer of its strips.
//
//   const IndexBuffer strips = strips_of(list, vertex_count, {.form = StripForm::stitched});   // upload strips.bytes()
//
// If the cost allows it, only the neighbours of the list are computed and no mesh is built. So this is faster than
// StripMesh::build, stripify and strip_indices one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/triangle_list.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/output/strip_order.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"

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

/// Colours and corners of a list. Solid sides alone have an opposite.
template <class Element>
struct ListedStrips : ColoringCopy {
  TriangleList<Element> list;

  [[nodiscard]] static Triangle triangle(Halfedge h) noexcept { return StripMesh::triangle(h); }
  [[nodiscard]] static Halfedge halfedge(Triangle t) noexcept { return StripMesh::halfedge(t); }
  [[nodiscard]] static Halfedge next(Halfedge h) noexcept { return StripMesh::next(h); }
  [[nodiscard]] static bool on_boundary(Halfedge h) noexcept { return StripMesh::on_boundary(h); }
  [[nodiscard]] bool has_triangle(Triangle t) const noexcept { return alive(t); }
  [[nodiscard]] Halfedge opposite(Halfedge h) const noexcept { return {across(h.id)}; }
  [[nodiscard]] Vertex from(Halfedge h) const noexcept { return list.corner(h.id); }
};

template <class Element>
std::vector<std::uint32_t> strips_of_list(const TriangleList<Element>& list, std::size_t vertex_count, Effort effort,
                                          Cost cost) {
  Annealing annealing(ColoringCopy(list, vertex_count), cost, 1);
  color_from_scratch(annealing, effort, cost, 0, 1);
  const ListedStrips<Element> strips{std::move(annealing.colors()), list};
  return strip_indices(strips);
}

}  // namespace detail

template <class Triangles>
IndexBuffer strips_of(const Triangles& triangles, std::size_t vertex_count, const StripFormat& format, Effort effort,
                      Cost cost, const VertexCache& cache, BuildReport* report) {
  if (report == nullptr && cost.swap != 0 && cache.size == 0) {
    return format_strips(detail::strips_of_list(TriangleList(triangles), vertex_count, effort, cost), format);
  }
  StripMesh mesh = StripMesh::build(triangles, vertex_count, report);
  stripify(mesh, effort, cost);
  return format_strips(
      cache.size == 0 ? strip_indices(mesh) : strip_indices(mesh, strips_for_vertex_cache(mesh, cache)), format);
}

}  // namespace restrip
