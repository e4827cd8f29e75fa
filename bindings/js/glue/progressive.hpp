// A progressive mesh in the browser: the triangles of the base, and the vertex splits that lead to the fine mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#ifdef __wasm__
// In the browser a refused input ends the call by a trap, which JavaScript sees as an exception.
#define RESTRIP_THROW(exception, sentence) __builtin_trap()
#endif
#include "restrip/restrip.hpp"

namespace restrip::web {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;
using Corners = std::array<Vertex, 3>;

using Record = SplitRecord;
static_assert(sizeof(Corners) == 12 && sizeof(Record) == 16, "JavaScript passes these as numbers of 32 bits");

struct Progressive {
  std::vector<Corners> base;
  std::vector<Record> splits;
  std::size_t points = 0;

  [[nodiscard]] std::size_t fine_triangles() const noexcept {
    std::size_t n = base.size();
    for (const Record& r : splits) n += r.triangles();
    return n;
  }
};

/// A place or a direction.
template <class Number>
struct Vector {
  Number x = 0;
  Number y = 0;
  Number z = 0;
  friend Vector operator-(const Vector& a, const Vector& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Number dot(const Vector& a, const Vector& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Vector cross(const Vector& a, const Vector& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

/// The halfedge between two vertices, or {none} if the halfedge or a vertex does not exist.
[[nodiscard]] inline Halfedge find_edge(const StripMesh& mesh, Vertex from, Vertex to) {
  return from < mesh.vertex_bound() ? mesh.spoke(from, to) : Halfedge{none};
}

/// The spokes of a split, found by its vertices; missing spokes are {none}, and check_split refuses them.
[[nodiscard]] inline Where find_spokes(const StripMesh& mesh, const Record& r) {
  return r.v_s < mesh.vertex_bound() ? spokes_of(mesh, r) : Where{};
}

}  // namespace restrip::web
