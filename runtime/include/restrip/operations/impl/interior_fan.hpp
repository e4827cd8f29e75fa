// The common case, kept fast: an interior vertex of ordinary valence. One turn around the vertex reads all colours and
// remembers the spokes; afterwards only dual edges whose colour really changes are written.
#pragma once

#include <bit>
#include <cstddef>

#include "restrip/mesh/mesh.hpp"
#include "restrip/rules/bits.hpp"

namespace restrip::detail {

/// Larger fans use the general code (patch_walk.hpp).
inline constexpr std::size_t max_interior_valence = 16;

/// The closed fan of a vertex before a split or after a collapse, numbered as in docs/reference/notation.md.
template <class Halfedge>
struct InteriorFan {
  std::size_t k = 0;
  std::size_t a = 0;
  Word loop = 0;  ///< colours of the loop; before a collapse, of the edges that it keeps
  Word ports = 0;
  Halfedge spokes[max_interior_valence];  ///< the mesh edge that loop edge i crosses, seen from the vertex; not the
                                          ///< edges next to A and D, which an operation makes or removes

  /// Colours kept loop edges. Edges are cleared before the mesh changes and set after it, so that the colouring is
  /// valid all the time (mesh.hpp, "Exceptions").
  template <ColoredMesh Mesh>
  void write(Mesh& mesh, Word edges, bool solid) const {
    const Word made = bit(a - 1) | bit(k - 1);
    for (Word rest = edges & ~made; rest != 0; rest &= rest - 1)
      mesh.set_solid(spokes[static_cast<std::size_t>(std::countr_zero(rest))], solid);
  }
};

/// Reads the fan between two spokes of an interior vertex. False when it is open or too large.
template <ColoredMesh Mesh>
bool read_interior_fan(const Mesh& mesh, typename Mesh::Halfedge left, typename Mesh::Halfedge right,
                       InteriorFan<typename Mesh::Halfedge>& fan) {
  auto h = left;
  std::size_t i = 0;
  do {
    if (i == max_interior_valence || mesh.on_boundary(h)) return false;
    const auto step = fan_step(mesh, h);
    fan.ports |= Word{step.port} << i;
    fan.loop |= Word{step.edge} << i;
    h = step.spoke;
    fan.spokes[i] = h;
    ++i;
    if (h == right) fan.a = i;
  } while (!(h == left));
  fan.k = i;
  return true;
}

/// The inner edges of a ring with chord that lie between fan triangles, as loop edges.
constexpr Word kept_loop(std::size_t k, std::size_t a, Word inner) noexcept {
  return (inner >> 1 & low_bits(a - 1)) | (inner >> (a + 2) & low_bits(k - a - 1)) << a;
}

/// Reads the ring with chord around an interior mesh edge whose ends are interior. False when they are not, or the fan
/// is too large.
template <ColoredMesh Mesh>
bool read_ring(const Mesh& mesh, typename Mesh::Halfedge chord, InteriorFan<typename Mesh::Halfedge>& fan,
               Word& inner) {
  std::size_t i = 0;     // fan triangles met
  std::size_t edge = 0;  // inner edges met
  for (const auto start : {chord, mesh.opposite(chord)}) {
    if (mesh.on_boundary(start)) return false;
    const auto removed = fan_step(mesh, start);  // the triangle to be removed
    inner |= Word{removed.edge} << edge++;
    auto h = removed.spoke;
    for (;;) {
      if (mesh.on_boundary(h)) return false;
      const auto step = fan_step(mesh, h);
      if (step.spoke == start) break;
      if (i == max_interior_valence) return false;
      if (i > 0) fan.spokes[i - 1] = h;
      fan.ports |= Word{step.port} << i++;
      inner |= Word{step.edge} << edge++;
      h = step.spoke;
    }
    if (start == chord) fan.a = i;
  }
  fan.k = i;
  inner |= Word{mesh.solid(chord)} << edge;
  // A patch has at least one triangle on each side; the general code reports others.
  if (fan.a == 0 || fan.a == fan.k) return false;
  fan.loop = kept_loop(fan.k, fan.a, inner);
  return true;
}

}  // namespace restrip::detail
