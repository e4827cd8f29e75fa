// A description of the last operation: its patch before and after, numbered as in docs/reference/notation.md.
#pragma once

#include "progressive.hpp"

namespace restrip::web {

/// The colours of a patch. `closed`: the fan is closed and fits a word, so that k, a and the colours are known.
struct PatchColors {
  bool closed = false;
  std::uint32_t k = 0;
  std::uint32_t a = 0;
  Word edges = 0;  ///< loop edges of a fan, inner edges of a ring
  Word ports = 0;
};

/// The fan of a vertex, numbered from `left`: t_0 is the triangle to its left.
[[nodiscard]] inline PatchColors fan_colors(const StripMesh& mesh, Halfedge left, Halfedge right) {
  PatchColors out;
  Halfedge h = left;
  do {
    if (StripMesh::on_boundary(h) || out.k == max_word_valence) return {};
    const auto step = mesh.fan_step(h);
    if (step.port) out.ports |= bit(out.k);
    if (step.edge) out.edges |= bit(out.k);
    ++out.k;
    h = step.spoke;
    if (h == right) out.a = out.k;
  } while (!(h == left));
  out.closed = true;
  return out;
}

/// The ring with chord around the edge v_s -> v_t of `chord`.
[[nodiscard]] inline PatchColors ring_colors(const StripMesh& mesh, Halfedge chord) {
  PatchColors out;
  const Halfedge back = mesh.opposite(chord);
  if (StripMesh::on_boundary(chord) || StripMesh::on_boundary(back)) return {};
  std::size_t edge = 0;
  for (const Halfedge start : {chord, back}) {
    Halfedge h = turn_ccw(mesh, start);
    while (true) {
      if (StripMesh::on_boundary(h) || out.k == max_word_valence) return {};
      if (mesh.solid(h)) out.edges |= bit(edge);
      ++edge;
      const auto step = mesh.fan_step(h);
      if (step.spoke == start) break;
      if (step.port) out.ports |= bit(out.k);
      ++out.k;
      h = step.spoke;
    }
    if (start == chord) out.a = out.k;
  }
  if (mesh.solid(chord)) out.edges |= bit(edge);
  out.closed = true;
  return out;
}

struct LastOperation {
  enum class Kind : std::uint32_t { nothing, split, collapse, flip };
  Kind kind = Kind::nothing;
  PatchColors before;
  PatchColors after;
  int strips = 0;
  int isolated = 0;
  std::vector<Corners> triangles_before;
  std::vector<Corners> triangles_after;
};

}  // namespace restrip::web
