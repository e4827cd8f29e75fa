// The whole state of a StripMesh: its members, the names of its next insertions, and whether its parts agree.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip {

struct Look {
  std::vector<std::uint32_t> numbers;
  friend bool operator==(const Look&, const Look&) = default;
};
/// Handles, corners, neighbours, colours, first spokes; and the handles of insertions until none is free any more.
inline Look look_at(const StripMesh& mesh) {
  Look look;
  look.numbers = {static_cast<std::uint32_t>(mesh.triangle_bound()), static_cast<std::uint32_t>(mesh.vertex_bound())};
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    look.numbers.push_back(t);
    for (unsigned s = 0; s < 3; ++s) {
      const StripMesh::Halfedge h = StripMesh::halfedge(t, s);
      look.numbers.insert(look.numbers.end(), {mesh.from(h), mesh.opposite(h).id, mesh.solid(h) ? 1U : 0U});
    }
  }
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v) look.numbers.push_back(mesh.spoke(v).id);
  StripMesh next = mesh;
  Vertex v = 0;
  while (v < next.vertex_bound() &&
         (next.triangle_bound() == mesh.triangle_bound() || next.vertex_bound() == mesh.vertex_bound())) {
    const StripMesh::Halfedge h = next.spoke(v);
    if (h.id == none || check_split(next, {h, turn_ccw(next, h)}) != Refusal::granted) {
      ++v;
      continue;
    }
    const auto chord = next.insert_vertex({h, turn_ccw(next, h)});
    look.numbers.insert(look.numbers.end(), {chord.id, next.to(chord)});
  }
  return look;
}

/// Adjacency from its definition: opposite halfedges run between the same vertices, first spokes are first, fans are
/// whole.
inline std::string fault_of(const StripMesh& mesh) {
  std::vector<std::size_t> corners(mesh.vertex_bound(), 0);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    for (unsigned s = 0; s < 3; ++s) {
      const StripMesh::Halfedge h = StripMesh::halfedge(t, s);
      const StripMesh::Halfedge g = mesh.opposite(h);
      if (mesh.from(h) != mesh.to(g) || mesh.to(h) != mesh.from(g)) return "opposite halfedges disagree";
      if (!(mesh.opposite(g) == h)) return "opposite is not an involution";
      if (!StripMesh::on_boundary(g) && !mesh.alive(g)) return "a link to a removed triangle";
      if (mesh.solid(h) != mesh.solid(g)) return "a colour differs between the two sides";
      ++corners[mesh.from(h)];
    }
  }
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v) {
    if ((mesh.spoke(v).id == none) != (corners[v] == 0)) return "a first spoke without triangles, or the reverse";
    if (corners[v] == 0 || mesh.non_manifold(v)) continue;
    if (!mesh.alive(mesh.spoke(v)) || mesh.from(mesh.spoke(v)) != v) return "a wrong first spoke";
    std::size_t met = 0;
    for_each_spoke(mesh, v, [&](StripMesh::Halfedge h) { met += StripMesh::on_boundary(h) ? 0U : 1U; });
    if (met != corners[v]) return "a fan that is not whole from its first spoke";
  }
  return "";
}

}  // namespace restrip
