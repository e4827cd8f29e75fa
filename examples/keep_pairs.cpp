// Maintains pairs of triangles while a mesh changes, for example as quadrilaterals. A pair is a solid dual edge, and no
// triangle has two. Edges of a closed mesh are bisected and flipped, and the vertices removed again; the tables of
// tables/operations/*-matching.json say which pairs remain after an operation. docs/tutorials/custom-operation.md says
// how such tables are made and proved.
#include <cstdio>
#include <restrip/restrip.hpp>
#include <restrip/tables/operations/bisect_matching.hpp>
#include <restrip/tables/operations/flip_matching.hpp>
#include <restrip/tables/operations/merge_matching.hpp>
#include <vector>

namespace {

using restrip::StripMesh;
using Halfedge = StripMesh::Halfedge;

/// Pairs an unpaired triangle with an unpaired neighbour.
void pair_up(StripMesh& mesh, Halfedge h) {
  for (int side = 0; side < 3; ++side, h = StripMesh::next(h)) {
    const Halfedge across = mesh.opposite(h);
    if (mesh.solid_degree(StripMesh::triangle(h)) + mesh.solid_degree(StripMesh::triangle(across)) == 0)
      mesh.set_solid(h, true);
  }
}

/// Changed triangles may be unpaired.
template <class Table>
Halfedge rewrite(StripMesh& mesh, const Table& table, Halfedge h) {
  std::vector<restrip::Triangle> changed;
  mesh.watch(&changed);
  const Halfedge first = restrip::apply(mesh, table, h).halfedge;
  mesh.watch(nullptr);
  for (const restrip::Triangle t : changed)
    if (mesh.alive(t)) pair_up(mesh, StripMesh::halfedge(t));
  return first;
}

void print(const char* what, const StripMesh& mesh) {
  std::size_t alone = 0;
  bool paired = true;   // no triangle has two partners
  bool maximal = true;  // no two neighbours are unpaired
  for (restrip::Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    if (mesh.solid_degree(t) > 1) paired = false;
    if (mesh.solid_degree(t) != 0) continue;
    ++alone;
    for (unsigned side = 0; side < 3; ++side)
      if (mesh.solid_degree(StripMesh::triangle(mesh.opposite(StripMesh::halfedge(t, side)))) == 0) maximal = false;
  }
  std::printf("%s: %zu triangles, %zu alone%s%s\n", what, mesh.triangle_count(), alone, paired ? "" : ", NOT IN PAIRS",
              maximal ? "" : ", NOT MAXIMAL");
}

}  // namespace

int main() {
  constexpr restrip::Vertex n = 20;  // a torus of n x n squares
  std::vector<std::array<restrip::Vertex, 3>> triangles;
  const auto at = [](restrip::Vertex row, restrip::Vertex column) { return row % n * n + column % n; };
  for (restrip::Vertex row = 0; row < n; ++row)
    for (restrip::Vertex column = 0; column < n; ++column) {
      triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
      triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
    }
  StripMesh mesh = StripMesh::build(triangles, std::size_t{n} * n);
  for (restrip::Triangle t = 0; t < mesh.triangle_bound(); ++t) pair_up(mesh, StripMesh::halfedge(t, 0));
  print("base", mesh);

  std::uint32_t random = 1;
  const auto any = [&] {
    random = random * 1664525U + 1013904223U;
    const auto t = static_cast<restrip::Triangle>((random >> 8) % mesh.triangle_bound());
    return StripMesh::halfedge(t, (random >> 4) % 3);
  };
  struct Record {
    restrip::Vertex made, other;
  };
  std::vector<Record> records;
  for (int i = 0; i < 3000; ++i) {
    // b -> c of the operation file, with m beyond.
    const Halfedge b_c = rewrite(mesh, restrip::tables::bisect_matching_rules, any());
    records.push_back({mesh.to(StripMesh::next(b_c)), mesh.from(b_c)});
  }
  print("up", mesh);
  StripMesh scratch = mesh;  // for comparison
  scratch.clear_colors();
  for (restrip::Triangle t = 0; t < scratch.triangle_bound(); ++t) pair_up(scratch, StripMesh::halfedge(t, 0));
  print("paired from scratch", scratch);
  for (; !records.empty(); records.pop_back()) {
    const Halfedge m_b = mesh.spoke(records.back().made, records.back().other);
    rewrite(mesh, restrip::tables::merge_matching_rules, StripMesh::next(m_b));
  }
  print("down", mesh);
  for (int i = 0; i < 3000; ++i)
    if (const Halfedge h = any();
        check_apply(mesh, restrip::tables::flip_matching_rules, h) == restrip::Refusal::granted)
      rewrite(mesh, restrip::tables::flip_matching_rules, h);
  print("flipped", mesh);
}
