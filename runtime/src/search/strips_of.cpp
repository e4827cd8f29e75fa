// Strips of a triangle list.
//
// Outline. If the cost allows it, colours from scratch (stripify.cpp) on the neighbours of the list alone; the strips
// are then walked with the corners of the list. Otherwise StripMesh::build, stripify and strip_indices one after the
// other.
#include "restrip/search/strips_of.hpp"

#include <array>
#include <utility>
#include <vector>

#include "output/strip_writer.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "search/annealing.hpp"
#include "search/poll.hpp"

namespace restrip::detail {

namespace {

/// Colours and corners of a list. Solid sides alone have an opposite.
template <class Element>
struct ListedStrips : ColoringCopy {
  TriangleList<Element> list;

  [[nodiscard]] Halfedge opposite(Halfedge h) const noexcept { return {across(h.id)}; }
  [[nodiscard]] Vertex from(Halfedge h) const noexcept { return list.corner(h.id); }
};

template <class Element>
StripMesh mesh_of(const TriangleList<Element>& list, std::size_t vertex_count, BuildReport* report) {
  std::vector<std::array<Vertex, 3>> corners(list.size());
  for (Triangle t = 0; t < corners.size(); ++t)
    corners[t] = {list.corner(t << 2), list.corner(t << 2 | 1U), list.corner(t << 2 | 2U)};
  return StripMesh::build(corners, vertex_count, report);
}

}  // namespace

template <class Element>
IndexBuffer strips_of(const TriangleList<Element>& list, std::size_t vertex_count, const StripFormat& format,
                      Effort effort, Cost cost, const VertexCache& cache, BuildReport* report) {
  if (report == nullptr && cost.swap != 0 && cache.size == 0) {
    Annealing annealing(ColoringCopy(list, vertex_count), cost, 1);
    Poll poll({});
    color_from_scratch(annealing, effort, cost, 0, poll);
    const ListedStrips<Element> strips{std::move(annealing.colors()), list};
    return format_strips(indices_of_strips(strips), format);
  }
  StripMesh mesh = mesh_of(list, vertex_count, report);
  stripify(mesh, effort, cost);
  return format_strips(
      cache.size == 0 ? strip_indices(mesh) : strip_indices(mesh, strips_for_vertex_cache(mesh, cache)), format);
}

template IndexBuffer strips_of(const TriangleList<std::uint16_t>&, std::size_t, const StripFormat&, Effort, Cost,
                               const VertexCache&, BuildReport*);
template IndexBuffer strips_of(const TriangleList<std::uint32_t>&, std::size_t, const StripFormat&, Effort, Cost,
                               const VertexCache&, BuildReport*);
template IndexBuffer strips_of(const TriangleList<std::array<Vertex, 3>>&, std::size_t, const StripFormat&, Effort,
                               Cost, const VertexCache&, BuildReport*);

}  // namespace restrip::detail
