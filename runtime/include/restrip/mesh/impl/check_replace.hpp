// Included by checks.hpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/impl/replace.hpp"
#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {
namespace detail {

/// Whether a mesh edge between the two vertices remains when `out` is removed.
inline bool edge_stays(const StripMesh& mesh, std::span<const Triangle> out, Vertex v, Vertex w) {
  const StripMesh::Halfedge h = mesh.spoke(v, w);
  if (h.id == none) return false;
  for (const auto side : {h, mesh.opposite(h)})
    if (!StripMesh::on_boundary(side) && !PatchRim::has(out, StripMesh::triangle(side))) return true;
  return false;
}

/// The number of triangles that have the vertex.
inline std::size_t count_around(const StripMesh& mesh, std::span<const Triangle> triangles, Vertex v) {
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [&](Triangle t) {
    const auto corners = mesh.corners(t);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }));
}

/// Whether the vertex then has at least three triangles, or is on the boundary.
inline bool has_enough(const StripMesh& mesh, std::span<const Triangle> out, const NewSides& sides, std::size_t place,
                       Vertex v) {
  std::size_t more = 0;
  bool closed = true;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides.from(i) == place) {
      ++more;
      closed = closed && sides.find(sides.to(i), sides.from(i)) < sides.size();
    }
  // Closed by only the new triangles, or by the remaining ones.
  if (closed) return more >= 3;
  if (v == none || mesh.leaves_boundary(mesh.spoke(v))) return true;
  const std::size_t fewer = count_around(mesh, out, v);
  const std::size_t valence = spokes_up_to(mesh, v, 3 + fewer);
  return valence == fewer || valence - fewer + more >= 3;
}

}  // namespace detail

inline Refusal check_replace(const StripMesh& mesh, std::span<const Triangle> out,
                             std::span<const StripMesh::Places> in, std::span<const Vertex> vertices) {
  if (out.empty() || in.empty() || out.size() > StripMesh::most_replaced || in.size() > StripMesh::most_replaced)
    return Refusal::other_patch;
  const auto listed = [&](Vertex v) { return std::count(vertices.begin(), vertices.end(), v) != 0; };
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!mesh.alive(out[i]) || detail::PatchRim::has(out.first(i), out[i])) return Refusal::other_patch;
    const auto corners = mesh.corners(out[i]);
    if (!std::all_of(corners.begin(), corners.end(), listed)) return Refusal::other_patch;
  }
  for (const Vertex& v : vertices) {
    if (v == none) continue;
    if (std::find(vertices.data(), &v, v) != &v) return Refusal::same_vertex;
    if (detail::count_around(mesh, out, v) == 0) return Refusal::other_patch;
    if (mesh.non_manifold(v)) return Refusal::non_manifold_vertex;
  }
  const detail::PatchRim rim(mesh, out);
  const detail::NewSides sides(in);
  std::size_t ports = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides.from(i) >= vertices.size() || sides.to(i) >= vertices.size()) return Refusal::other_patch;
    if (sides.from(i) == sides.to(i) || sides.find(sides.from(i), sides.to(i)) < i) return Refusal::other_patch;
    const Vertex from = vertices[sides.from(i)];
    const Vertex to = vertices[sides.to(i)];
    if (from == none || to == none) continue;
    if (const detail::RimSide* side = rim.find(from, to)) {
      ports += StripMesh::on_boundary(side->across) ? 0U : 1U;
      continue;
    }
    if (detail::edge_stays(mesh, out, from, to)) return Refusal::edge_exists;
  }
  if (ports != rim.ports()) return Refusal::other_patch;
  for (std::size_t place = 0; place < vertices.size(); ++place)
    if (sides.leaving(place) < sides.size() && !detail::has_enough(mesh, out, sides, place, vertices[place]))
      return Refusal::too_few_triangles;
  return Refusal::granted;
}

}  // namespace restrip
