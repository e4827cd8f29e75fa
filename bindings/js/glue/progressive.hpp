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

using Record = BakedSplit;
static_assert(sizeof(Corners) == 12 && sizeof(Record) == 16, "JavaScript passes these as numbers of 32 bits");

struct Progressive {
  std::vector<Corners> base;
  std::vector<Record> splits;
  std::size_t points = 0;

  [[nodiscard]] std::size_t fine_triangles() const noexcept {
    std::size_t n = base.size();
    for (const Record& r : splits) n += r.v_l != none && r.v_r != none ? 2 : 1;
    return n;
  }
};

/// The halfedge between two vertices, or {none} if the halfedge or a vertex does not exist.
[[nodiscard]] inline Halfedge find_edge(const StripMesh& mesh, Vertex from, Vertex to) {
  const bool there = from < mesh.vertex_bound() && to < mesh.vertex_bound() && mesh.spoke(from).id != none;
  return there ? mesh.spoke(from, to) : Halfedge{none};
}

/// The spokes of a split, found by its vertices; missing spokes are {none}, and check_split refuses them.
[[nodiscard]] inline Where find_spokes(const StripMesh& mesh, const Record& r) {
  const auto spoke = [&](Vertex to) { return find_edge(mesh, r.v_s, to); };
  if (r.v_r == none) return {spoke(r.v_l), {}, Where::Spokes::left_only};
  if (r.v_l == none) return {{}, spoke(r.v_r), Where::Spokes::right_only};
  return {spoke(r.v_l), spoke(r.v_r), Where::Spokes::both};
}

/// The order of splits that must be kept. Two operations whose fans share a triangle keep the order of the records, all
/// others commute. So a set of records can be played, in any such order, exactly if it contains all records that its
/// members need. A record can be undone if no other played record needs it.
class Hierarchy {
 public:
  /// Plays all records once. Returns the number of the first that the mesh refuses, or the number of records. `report`
  /// is of the base.
  [[nodiscard]] std::size_t read(const Progressive& source, BuildReport& report) {
    first_.assign(1, 0);
    needs_.clear();
    StripMesh mesh = StripMesh::build(source.base, source.points, &report);
    mesh.reserve(source.fine_triangles(), source.points);
    std::vector<std::uint32_t> last(source.fine_triangles(), none);  // by triangle: the record that it was last part of
    std::vector<Triangle> patch;
    for (std::uint32_t i = 0; i < source.splits.size(); ++i) {
      const Where where = find_spokes(mesh, source.splits[i]);
      const Vertex v_t = source.splits[i].v_t;
      if (v_t >= source.points || check_split(mesh, where, v_t) != Refusal::granted) return i;
      fan_triangles(mesh, where.spokes == Where::Spokes::right_only ? where.right : where.left, patch);
      const std::size_t begin = needs_.size();
      for (const Triangle t : patch)
        if (last[t] != none) needs_.push_back(last[t]);
      std::sort(needs_.begin() + static_cast<std::ptrdiff_t>(begin), needs_.end());
      needs_.erase(std::unique(needs_.begin() + static_cast<std::ptrdiff_t>(begin), needs_.end()), needs_.end());
      first_.push_back(static_cast<std::uint32_t>(needs_.size()));
      edge_triangles(mesh, mesh.insert_vertex(where, v_t), patch);
      for (const Triangle t : patch) last[t] = i;
    }
    return source.splits.size();
  }
  [[nodiscard]] std::span<const std::uint32_t> needs(std::size_t record) const noexcept {
    return {needs_.data() + first_[record], needs_.data() + first_[record + 1]};
  }

 private:
  std::vector<std::uint32_t> first_{0};
  std::vector<std::uint32_t> needs_;
};

}  // namespace restrip::web
