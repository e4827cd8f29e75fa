// The whole state of a StripMesh: its members, the names of its next insertions, and whether its parts and a locator of
// its strips agree.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "operations/join.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "sample_meshes.hpp"
#include "search/strip_locator.hpp"

namespace restrip {

/// Handles, corners, neighbours, colours, first spokes and marks; and the handles of insertions until none is free any
/// more.
using Look = std::vector<std::uint32_t>;
inline Look look_at(const StripMesh& mesh) {
  Look look{static_cast<std::uint32_t>(mesh.triangle_bound()), static_cast<std::uint32_t>(mesh.vertex_bound())};
  for (const StripMesh::Halfedge h : sample::sides_of(mesh))
    look.insert(look.end(), {h.id, mesh.from(h), mesh.opposite(h).id, mesh.solid(h) ? 1U : 0U});
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
    if (mesh.spoke(v).id != none) look.insert(look.end(), {v, mesh.spoke(v).id, mesh.non_manifold(v) ? 1U : 0U});
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
    look.insert(look.end(), {chord.id, next.to(chord)});
  }
  return look;
}

/// Where the ends of strips lie.
struct Ends {
  std::size_t strips = 0;
  std::size_t isolated = 0;
  std::size_t meeting = 0;         ///< dashed edges between ends of different strips
  std::size_t own = 0;             ///< dashed edges between the two ends of one strip
  std::size_t boundary_sides = 0;  ///< of strip ends and isolated triangles
};

inline Ends ends_of(const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  std::vector<std::size_t> strip_of(mesh.triangle_bound(), 0);
  Ends count{strips.size()};
  for (std::size_t s = 0; s < strips.size(); ++s) {
    count.isolated += strips[s].size() == 1 ? 1U : 0U;
    for (const Triangle t : strips[s]) strip_of[t] = s;
  }
  for (const StripMesh::Halfedge h : sample::sides_of(mesh)) {
    const Triangle t = StripMesh::triangle(h);
    if (mesh.solid_degree(t) > 1) continue;
    const StripMesh::Halfedge across = mesh.opposite(h);
    if (StripMesh::on_boundary(across)) {
      ++count.boundary_sides;
      continue;
    }
    const Triangle u = StripMesh::triangle(across);
    if (mesh.solid(h) || mesh.solid_degree(u) > 1 || u < t) continue;
    ++(strip_of[t] == strip_of[u] ? count.own : count.meeting);
  }
  return count;
}

/// Wherever no ends of different strips meet, the bounds of docs/explanation/theory.md, "What holds for the whole
/// mesh", hold.
inline std::string fault_of_ends(const StripMesh& mesh) {
  const Ends ends = ends_of(mesh);
  if (ends.meeting != 0) return "ends of two strips meet";
  if (6 * ends.strips > mesh.triangle_count() + 2 * ends.isolated + 2 * ends.own + ends.boundary_sides)
    return "more strips than the bound";
  return ends.isolated + ends.own > ends.strips ? "more ends than strips have" : "";
}

/// Joins all strip ends that meet.
inline ColoringChange join_all(StripMesh& mesh) {
  ColoringChange sum;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) sum += detail::join_end(mesh, StripMesh::halfedge(t));
  return sum;
}

/// Adjacency from its definition: opposite halfedges run between the same vertices, first spokes are first, fans are
/// whole.
inline std::string fault_of(const StripMesh& mesh) {
  std::vector<std::size_t> corners(mesh.vertex_bound(), 0);
  for (const StripMesh::Halfedge h : sample::sides_of(mesh)) {
    const StripMesh::Halfedge g = mesh.opposite(h);
    if (mesh.from(h) != mesh.to(g) || mesh.to(h) != mesh.from(g)) return "opposite halfedges disagree";
    if (!(mesh.opposite(g) == h)) return "opposite is not an involution";
    if (!StripMesh::on_boundary(g) && !mesh.alive(g)) return "a link to a removed triangle";
    if (mesh.solid(h) != mesh.solid(g)) return "a colour differs between the two sides";
    ++corners[mesh.from(h)];
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

/// The triangles that only one of two meshes has, and those with other corners, neighbours or colours.
inline std::set<Triangle> differing_triangles(const StripMesh& one, const StripMesh& other) {
  const auto numbers = [](const StripMesh& mesh, Triangle t) {
    Look look;
    for (unsigned side = 0; mesh.alive(t) && side < 3; ++side) {
      const StripMesh::Halfedge h = StripMesh::halfedge(t, side);
      look.insert(look.end(), {mesh.from(h), mesh.opposite(h).id, mesh.solid(h) ? 1U : 0U});
    }
    return look;
  };
  std::set<Triangle> differing;
  for (Triangle t = 0; t < std::max(one.triangle_bound(), other.triangle_bound()); ++t)
    if (numbers(one, t) != numbers(other, t)) differing.insert(t);
  return differing;
}

/// Is every triangle in which two meshes differ in the list?
inline bool names_all_changes(const std::vector<Triangle>& list, const StripMesh& before, const StripMesh& now) {
  const std::set<Triangle> named(list.begin(), list.end());
  const std::set<Triangle> differing = differing_triangles(before, now);
  return std::includes(named.begin(), named.end(), differing.begin(), differing.end());
}

/// What is wrong with a locator, or nothing: along every strip the order grows or falls in steps of one, and no two
/// strips share a name.
inline std::string disagreement(const StripLocator& locator, const StripMesh& mesh) {
  const Strips strips = extract_strips(mesh);
  if (strips.size() != locator.strips())
    return std::to_string(locator.strips()) + " strips in the locator, " + std::to_string(strips.size()) +
           " in the mesh";
  std::set<std::uint32_t> names;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const auto strip = strips[s];
    const StripLocator::Position first = locator.position(strip.front());
    if (!names.insert(first.strip).second) return "two strips with one name";
    const bool up = strip.size() < 2 || locator.position(strip[1]).order > first.order;
    for (std::size_t i = 1; i < strip.size(); ++i) {
      const StripLocator::Position a = locator.position(strip[i - 1]);
      const StripLocator::Position b = locator.position(strip[i]);
      if (b.strip != first.strip) return "a strip with two names";
      if (b.order != (up ? a.order + 1 : a.order - 1)) return "out of order";
      const auto forwards = locator.position(strip[i - 1], strip[i]);
      const auto backwards = locator.position(strip[i], strip[i - 1]);
      if (forwards.first.strip != a.strip || forwards.first.order != a.order || forwards.second != b.order ||
          backwards.first.strip != a.strip || backwards.first.order != b.order || backwards.second != a.order)
        return "two triangles together are not where each is";
    }
  }
  return "";
}

}  // namespace restrip
