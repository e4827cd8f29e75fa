// Any triangles replaced by any others.
//
// Outline. The vertices concerned are the corners of both lists. Their triangles after the change are those around them
// now without `out`, and `in`. Each is a corner at three vertices: seen from a vertex, it leads from its side that
// leaves the vertex to its side that enters it. The mesh stays a manifold if at each vertex the corners form one chain
// or one ring. The change places the new triangles and joins each of their sides, and each side that lost its
// neighbour, with the side between the same vertices in the other direction.
//
// Invariant. Every edge that changes has both ends among the vertices, so that nothing else needs to be looked at.
//
// Cost. O(n log n) for n triangles at the vertices.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
namespace {

using Corners = std::array<Vertex, 3>;

/// A triangle at a vertex: it has the sides vertex -> next and last -> vertex. `side`: the first of these, of a
/// triangle that stays; {none} for a new one.
struct CornerAt {
  Vertex vertex = none;
  Vertex next = none;
  Vertex last = none;
  Halfedge side;
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
      all.push_back({v, mesh.to(h), mesh.to(StripMesh::next(h)), h});
    });
  }
  for (const Corners& c : in)
    for (std::size_t s = 0; s < 3; ++s) all.push_back({c[s], c[(s + 1) % 3], c[(s + 2) % 3], {}});
  std::sort(all.begin(), all.end(), [](const CornerAt& a, const CornerAt& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.next < b.next;
  });
  return all;
}

std::vector<Triangle> sorted(std::span<const Triangle> triangles) {
  std::vector<Triangle> list(triangles.begin(), triangles.end());
  std::sort(list.begin(), list.end());
  return list;
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

/// Calls visit(corners) for each vertex.
template <class Visit>
void for_each_fan(std::span<const CornerAt> corners, Visit&& visit) {
  for (std::size_t i = 0, end = 0; i < corners.size(); i = end) {
    while (end < corners.size() && corners[end].vertex == corners[i].vertex) ++end;
    visit(corners.subspan(i, end - i));
  }
}

}  // namespace

Refusal check_replace(const StripMesh& mesh, std::span<const Triangle> out, std::span<const Corners> in) {
  const std::vector<Triangle> gone = sorted(out);
  if (std::adjacent_find(gone.begin(), gone.end()) != gone.end()) return Refusal::other_patch;
  for (const Triangle t : gone)
    if (!mesh.alive(t)) return Refusal::other_patch;
  for (const Corners& c : in) {
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return Refusal::same_vertex;
    for (const Vertex v : c)
      if (v >= mesh.vertex_bound() && (v == none || v - mesh.vertex_bound() > StripMesh::max_vertex_gap))
        return Refusal::vertex_too_far;
  }
  const std::vector<Vertex> vertices = corners_of(mesh, out, in);
  for (const Vertex v : vertices)
    if (v < mesh.vertex_bound() && mesh.non_manifold(v)) return Refusal::non_manifold_vertex;
  Refusal refusal = Refusal::granted;
  for_each_fan(corners_after(mesh, vertices, gone, in), [&](std::span<const CornerAt> fan) {
    if (refusal == Refusal::granted) refusal = refusal_of_fan(fan);
  });
  return refusal;
}

void StripMesh::replace(std::span<const Triangle> out, std::span<const Corners> in, std::vector<Triangle>& made) {
  RESTRIP_ASSERT_GRANTED(check_replace(*this, out, in), "StripMesh::replace");
  // Everything that may throw comes first.
  const std::vector<Vertex> vertices = corners_of(*this, out, in);
  std::vector<CornerAt> corners = corners_after(*this, vertices, sorted(out), in);
  const std::size_t taken_over = (std::min)(out.size(), in.size());
  const std::size_t more = in.size() - taken_over;
  const std::size_t fresh = more - (std::min)(more, free_.size());
  if (fresh > max_triangles - triangles_.size())
    RESTRIP_THROW(std::length_error, "restrip: the mesh already has the most triangles that a StripMesh can hold");
  detail::make_room(triangles_, fresh);
  detail::make_room(free_, out.size() - taken_over);
  detail::make_room(free_vertices_, vertices.size());
  if (!in.empty() && vertices.back() >= spoke_.size()) (void)new_vertex(vertices.back());
  expect_touches(4 * out.size() + 8 * in.size() + 2 * corners.size());
  made.assign(in.size(), none);

  for (const Triangle t : out)
    for (unsigned s = 0; s < 3; ++s) {
      const Halfedge across = opposite(halfedge(t, s));
      if (on_boundary(across)) continue;
      link_of(across) = edge_of_mesh;
      touch(triangle(across));
    }
  for (std::size_t i = out.size(); i-- > taken_over;) {
    place_triangle(out[i], none, none, none);
    free_.push_back(out[i]);
  }
  for (std::size_t i = 0; i < in.size(); ++i) {
    made[i] = i < taken_over ? out[i] : take_triangle();
    place_triangle(made[i], in[i][0], in[i][1], in[i][2]);
  }
  // The new corners get their sides.
  for (std::size_t i = 0; i < in.size(); ++i)
    for (unsigned s = 0; s < 3; ++s) {
      const auto at = std::partition_point(corners.begin(), corners.end(), [&](const CornerAt& corner) {
        return corner.vertex < in[i][s] || (corner.vertex == in[i][s] && corner.next < in[i][(s + 1) % 3]);
      });
      at->side = halfedge(made[i], s);
    }
  std::size_t next_fan = 0;
  for (const Vertex v : vertices) {
    std::size_t end = next_fan;
    while (end < corners.size() && corners[end].vertex == v) ++end;
    const auto fan = std::span<const CornerAt>(corners).subspan(next_fan, end - next_fan);
    next_fan = end;
    if (fan.empty()) {
      if (v < spoke_.size() && spoke_[v] != none) {
        set_spoke(v, {none});
        free_vertices_.push_back(v);
      }
      continue;
    }
    // Counter-clockwise the side last -> v of one corner meets the side v -> next of the following one.
    for (const CornerAt& corner : fan)
      if (const CornerAt* const after = find(fan, corner.last)) {
        const Halfedge enters = next(next(corner.side));
        if (link_of(enters) == edge_of_mesh) join(enters, after->side);
      }
    const CornerAt* first = fan.data();
    for (const CornerAt& corner : fan)
      if (link_of(corner.side) == edge_of_mesh) first = &corner;
    set_spoke(v, first->side);
  }
}

}  // namespace restrip
