// The preconditions of operations, on any mesh. The concepts of mesh.hpp have no vertices, so only the checks of
// checks.hpp are possible that a walk around the patch can make, and a check that the colours there are valid, which
// fails after changes made without restrip. If these grant an operation and the mesh has check_split(),
// check_collapse() or check_flip(), found by argument-dependent lookup, that decides. The checks of a StripMesh are
// complete by themselves.
//
// Nothing outside the patch is read, so that operations on disjoint patches may be checked at the same time.
#pragma once

#include <concepts>
#include <cstddef>

#include "restrip/mesh/mesh.hpp"
#include "restrip/mesh/refusal.hpp"
#include "restrip/precondition.hpp"

namespace restrip {
class StripMesh;
}

namespace restrip::detail {

template <ColoredMesh Mesh>
bool knows(const Mesh& mesh, typename Mesh::Halfedge h) {
  if constexpr (requires { mesh.alive(h); }) return mesh.alive(h);
  return true;
}

/// The triangles around the vertex that a halfedge leaves.
struct FanSize {
  std::size_t triangles = 0;
  bool closed = false;
  bool met = false;          ///< whether the other spoke leaves the same vertex
  bool colors_valid = true;  ///< no triangle has three solid edges, and no spoke on the boundary is solid
};

template <ColoredMesh Mesh>
bool has_dashed_side(const Mesh& mesh, typename Mesh::Halfedge h) {
  const auto second = mesh.next(h);
  return !mesh.solid(h) || !mesh.solid(second) || !mesh.solid(mesh.next(second));
}

template <ColoredMesh Mesh>
FanSize fan_size(const Mesh& mesh, typename Mesh::Halfedge start, typename Mesh::Halfedge other) {
  FanSize fan{0, false, start == other};
  auto h = start;
  while (!mesh.on_boundary(h)) {
    fan.colors_valid = fan.colors_valid && has_dashed_side(mesh, h);
    h = turn_ccw(mesh, h);
    ++fan.triangles;
    if (h == start) {
      fan.closed = true;
      return fan;
    }
    if (h == other) fan.met = true;
  }
  fan.colors_valid = fan.colors_valid && !mesh.solid(h);
  for (h = start; !mesh.on_boundary(mesh.opposite(h));) {
    h = turn_cw(mesh, h);
    fan.colors_valid = fan.colors_valid && has_dashed_side(mesh, h);
    ++fan.triangles;
    if (h == other) fan.met = true;
  }
  fan.colors_valid = fan.colors_valid && !mesh.solid(h);
  return fan;
}

template <ColoredMesh Mesh>
Refusal check_split_patch(const Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where) {
  using Spokes = typename VertexSplit<typename Mesh::Halfedge>::Spokes;
  const bool both = where.spokes == Spokes::both;
  const auto first = where.spoke();
  if (!knows(mesh, first) || (both && !knows(mesh, where.right))) return Refusal::no_such_edge;
  if (both && where.left == where.right) return Refusal::same_spoke;
  const FanSize fan = fan_size(mesh, first, both ? where.right : first);
  if (!fan.met) return Refusal::different_vertices;
  if (!both && fan.closed) return Refusal::spoke_on_boundary;
  if (fan.closed && fan.triangles < 3) return Refusal::too_few_triangles;
  return fan.colors_valid ? Refusal::granted : Refusal::colors_not_valid;
}

template <ColoredMesh Mesh>
Refusal check_collapse_patch(const Mesh& mesh, typename Mesh::Halfedge chord) {
  if (!knows(mesh, chord)) return Refusal::no_such_edge;
  const auto back = mesh.opposite(chord);
  const FanSize tail = fan_size(mesh, chord, chord);
  const FanSize head = fan_size(mesh, back, back);
  const bool interior = !mesh.on_boundary(chord) && !mesh.on_boundary(back);
  if (interior && !tail.closed && !head.closed) return Refusal::joins_boundaries;
  for (const auto inward : {chord, back}) {
    if (mesh.on_boundary(inward)) continue;
    const auto up = mesh.next(inward);
    if (mesh.on_boundary(mesh.opposite(up)) && mesh.on_boundary(mesh.opposite(mesh.next(up))))
      return Refusal::dangling_edge;
  }
  if (tail.closed && head.closed && tail.triangles + head.triangles < 3 + 4) return Refusal::too_few_triangles;
  return tail.colors_valid && head.colors_valid ? Refusal::granted : Refusal::colors_not_valid;
}

template <ColoredMesh Mesh>
Refusal check_flip_patch(const Mesh& mesh, typename Mesh::Halfedge h) {
  if (!knows(mesh, h)) return Refusal::no_such_edge;
  const auto back = mesh.opposite(h);
  if (mesh.on_boundary(h) || mesh.on_boundary(back)) return Refusal::boundary_edge;
  for (const auto end : {h, back}) {
    const FanSize fan = fan_size(mesh, end, end);
    if (fan.closed && fan.triangles < 3 + 1) return Refusal::too_few_triangles;
    if (!fan.colors_valid) return Refusal::colors_not_valid;
  }
  return Refusal::granted;
}

template <class Mesh>
inline constexpr bool checks_are_complete = std::derived_from<Mesh, StripMesh>;

/// The checks of debug builds before split(), collapse() and flip(). `name`: the caller's name for the new vertex.
template <ColoredMesh Mesh, class... Name>
Refusal refusal_of_split(const Mesh& mesh, const VertexSplit<typename Mesh::Halfedge>& where, const Name&... name) {
  if constexpr (!checks_are_complete<Mesh>)
    if (const Refusal refusal = check_split_patch(mesh, where); refusal != Refusal::granted) return refusal;
  if constexpr (requires {
                  { check_split(mesh, where, name...) } -> std::same_as<Refusal>;
                })
    return check_split(mesh, where, name...);
  else if constexpr (requires {
                       { check_split(mesh, where) } -> std::same_as<Refusal>;
                     })
    return check_split(mesh, where);
  else
    return Refusal::granted;
}

template <ColoredMesh Mesh>
Refusal refusal_of_collapse(const Mesh& mesh, typename Mesh::Halfedge chord) {
  if constexpr (!checks_are_complete<Mesh>)
    if (const Refusal refusal = check_collapse_patch(mesh, chord); refusal != Refusal::granted) return refusal;
  if constexpr (requires {
                  { check_collapse(mesh, chord) } -> std::same_as<Refusal>;
                })
    return check_collapse(mesh, chord);
  else
    return Refusal::granted;
}

template <ColoredMesh Mesh>
Refusal refusal_of_flip(const Mesh& mesh, typename Mesh::Halfedge h) {
  if constexpr (!checks_are_complete<Mesh>)
    if (const Refusal refusal = check_flip_patch(mesh, h); refusal != Refusal::granted) return refusal;
  if constexpr (requires {
                  { check_flip(mesh, h) } -> std::same_as<Refusal>;
                })
    return check_flip(mesh, h);
  else
    return Refusal::granted;
}

}  // namespace restrip::detail
