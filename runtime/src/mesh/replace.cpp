// Any triangles replaced by any others.
//
// Outline of the check. The vertices concerned are the corners of both lists. Their triangles after the change are
// those around them now without `out`, and `in`. Each is a corner at three vertices: seen from a vertex, it leads from
// its side that leaves the vertex to its side that enters it. The mesh stays a manifold if at each vertex the corners
// form one chain or one ring.
//
// Outline of the change. The *open* sides are those that lose their neighbour, those of the new triangles, and those on
// the boundary at a vertex of a new triangle. Each is joined with the open side between the same vertices in the other
// direction. One that stays open is the first spoke of the vertex that it leaves.
//
// Invariant. Every edge that changes has both ends among the vertices, so that nothing else needs to be looked at. At a
// vertex at most one open side leaves on the boundary, before and after the change.
//
// Cost. The check: O(n log n) for n triangles at the vertices. The change: O(n log n) for n triangles in both lists.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/fan_checks.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace {

using Corners = std::array<Vertex, 3>;

/// A triangle at a vertex: it has the sides vertex -> next and last -> vertex.
struct CornerAt {
  Vertex vertex = none;
  Vertex next = none;
  Vertex last = none;
};

struct OpenSide {
  Vertex from = none;
  Vertex to = none;
  Halfedge h;
  friend bool operator<(const OpenSide& a, const OpenSide& b) noexcept {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  }
};

std::vector<Vertex> corners_of(const StripMesh& mesh, std::span<const Triangle> out, std::span<const Corners> in) {
  std::vector<Vertex> vertices;
  for (const Triangle t : out)
    for (const Vertex v : mesh.corners(t)) vertices.push_back(v);
  for (const Corners& c : in) vertices.insert(vertices.end(), c.begin(), c.end());
  detail::sort_unique(vertices);
  return vertices;
}

/// The corners at the vertices after the change, by vertex. `gone` is sorted.
std::vector<CornerAt> corners_after(const StripMesh& mesh, std::span<const Vertex> vertices,
                                    std::span<const Triangle> gone, std::span<const Corners> in) {
  std::vector<CornerAt> all;
  for (const Vertex v : vertices) {
    if (v >= mesh.vertex_bound() || mesh.spoke(v).id == none) continue;
    for_each_around(mesh, mesh.spoke(v), [&](Halfedge h) {
      if (std::binary_search(gone.begin(), gone.end(), StripMesh::triangle(h))) return;
      all.push_back({v, mesh.to(h), mesh.to(StripMesh::next(h))});
    });
  }
  for (const Corners& c : in)
    for (std::size_t s = 0; s < 3; ++s) all.push_back({c[s], c[(s + 1) % 3], c[(s + 2) % 3]});
  std::sort(all.begin(), all.end(), [](const CornerAt& a, const CornerAt& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.next < b.next;
  });
  return all;
}

/// The corner that begins at next, or null. `fan`: the corners at a vertex, by `next`.
const CornerAt* find(std::span<const CornerAt> fan, Vertex next) {
  const auto at =
      std::lower_bound(fan.begin(), fan.end(), next, [](const CornerAt& corner, Vertex v) { return corner.next < v; });
  return at == fan.end() || at->next != next ? nullptr : &*at;
}

/// Whether the corners at a vertex are one chain or one ring; of a ring there must be three.
Refusal refusal_of_fan(std::span<const CornerAt> fan) {
  for (std::size_t i = 1; i < fan.size(); ++i)
    if (fan[i].next == fan[i - 1].next) return Refusal::no_manifold;
  std::vector<Vertex> lasts;
  for (const CornerAt& corner : fan) lasts.push_back(corner.last);
  std::sort(lasts.begin(), lasts.end());
  if (std::adjacent_find(lasts.begin(), lasts.end()) != lasts.end()) return Refusal::no_manifold;
  // Begin where no other corner ends, if there is such a place.
  const CornerAt* first = fan.data();
  for (const CornerAt& corner : fan)
    if (!std::binary_search(lasts.begin(), lasts.end(), corner.next)) first = &corner;
  std::size_t met = 0;
  const CornerAt* at = first;
  do {
    ++met;
    at = find(fan, at->last);
  } while (at != nullptr && at != first);
  if (met != fan.size()) return Refusal::no_manifold;
  return at != nullptr && met < 3 ? Refusal::too_few_triangles : Refusal::granted;
}

}  // namespace

Refusal check_replace(const StripMesh& mesh, std::span<const Triangle> out, std::span<const Corners> in) {
  std::vector<Triangle> gone(out.begin(), out.end());
  std::sort(gone.begin(), gone.end());
  if (std::adjacent_find(gone.begin(), gone.end()) != gone.end()) return Refusal::other_patch;
  for (const Triangle t : gone)
    if (!mesh.alive(t)) return Refusal::other_patch;
  for (const Corners& c : in) {
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return Refusal::same_vertex;
    for (const Vertex v : c)
      if (v == none || detail::refusal_of_name(mesh, v) == Refusal::vertex_too_far) return Refusal::vertex_too_far;
  }
  const std::vector<Vertex> vertices = corners_of(mesh, out, in);
  for (const Vertex v : vertices)
    if (v < mesh.vertex_bound() && mesh.non_manifold(v)) return Refusal::non_manifold_vertex;
  const std::vector<CornerAt> corners = corners_after(mesh, vertices, gone, in);
  for (std::size_t i = 0, end = 0; i < corners.size(); i = end) {
    while (end < corners.size() && corners[end].vertex == corners[i].vertex) ++end;
    const Refusal refusal = refusal_of_fan(std::span(corners).subspan(i, end - i));
    if (refusal != Refusal::granted) return refusal;
  }
  return Refusal::granted;
}

void StripMesh::replace(std::span<const Triangle> out, std::span<const Corners> in, std::span<Triangle> made) {
  RESTRIP_ASSERT_GRANTED(check_replace(*this, out, in), "StripMesh::replace");
  RESTRIP_ASSERT(made.size() == in.size(), "StripMesh::replace", "`made` must have one element for each new triangle");
  // Everything that may throw comes first.
  std::vector<Vertex> corners_of_out;
  corners_of_out.reserve(3 * out.size());
  std::vector<OpenSide> open;
  open.reserve(3 * out.size() + 6 * in.size());
  const std::size_t taken_over = (std::min)(out.size(), in.size());
  expect_triangles(in.size() - taken_over);
  detail::make_room(free_, out.size() - taken_over);
  detail::make_room(free_vertices_, 3 * out.size());
  expect_touches(7 * (out.size() + in.size()));
  Vertex highest = 0;
  for (const Corners& c : in) highest = (std::max)({highest, c[0], c[1], c[2]});
  if (highest >= spoke_.size() && !in.empty()) (void)new_vertex(highest);

  // The triangles go. Vertices whose first spoke goes with them take another one, if they have any.
  for (const Triangle t : out) {
    corners_of_out.insert(corners_of_out.end(), triangles_[t].corner.begin(), triangles_[t].corner.end());
    triangles_[t].corner[0] = none;  // no longer alive
  }
  for (const Triangle t : out)
    for (const std::uint32_t link : triangles_[t].link)
      if (const Halfedge across{link >> 1}; link != edge_of_mesh && alive(triangle(across))) {
        link_of(across) = edge_of_mesh;
        touch(triangle(across));
        open.push_back({from(across), to(across), across});
      }
  for (const Vertex v : corners_of_out)
    if (!alive(triangle(spoke(v)))) set_spoke(v, {none});
  for (const OpenSide& side : open) {
    if (spoke_[side.from] == none) set_spoke(side.from, side.h);
    if (spoke_[side.to] == none) set_spoke(side.to, next(side.h));
  }
  for (std::size_t i = out.size(); i-- > taken_over;) {
    place_triangle(out[i], none, none, none);
    free_.push_back(out[i]);
  }

  // The others come.
  for (const Corners& c : in)
    for (const Vertex v : c)
      if (const Halfedge first = spoke(v); first.id != none && link_of(first) == edge_of_mesh)
        open.push_back({v, to(first), first});
  for (std::size_t i = 0; i < in.size(); ++i) {
    made[i] = i < taken_over ? out[i] : take_triangle();
    place_triangle(made[i], in[i][0], in[i][1], in[i][2]);
    for (unsigned s = 0; s < 3; ++s) {
      open.push_back({in[i][s], in[i][(s + 1) % 3], halfedge(made[i], s)});
      if (spoke_[in[i][s]] == none) set_spoke(in[i][s], halfedge(made[i], s));
    }
  }
  std::sort(open.begin(), open.end());
  for (const OpenSide& side : open) {
    const auto other = std::lower_bound(open.begin(), open.end(), OpenSide{side.to, side.from, {}});
    const bool to_join = side.from < side.to && link_of(side.h) == edge_of_mesh;  // may be listed several times
    if (to_join && other != open.end() && other->from == side.to && other->to == side.from) join(side.h, other->h);
  }
  for (const OpenSide& side : open)
    if (link_of(side.h) == edge_of_mesh) set_spoke(side.from, side.h);

  // Vertices come, and go.
  while (!free_vertices_.empty() && free_vertices_.back() < spoke_.size() && spoke_[free_vertices_.back()] != none)
    free_vertices_.pop_back();
  detail::sort_unique(corners_of_out);
  for (auto v = corners_of_out.rbegin(); v != corners_of_out.rend(); ++v)
    if (spoke_[*v] == none) free_vertices_.push_back(*v);
}

}  // namespace restrip
