// Triangles in pairs, kept while the mesh changes: as quadrilaterals, say. A pair is a solid dual edge, and no triangle
// has two. Edges of a closed mesh are bisected and flipped, and the vertices removed again, a whole replay up and down;
// the tables of tables/operations/*-matching.json say which pairs an operation leaves. docs/toolkit.md tells how such
// tables are made and proved.
#include <array>
#include <cstdio>
#include <restrip/restrip.hpp>
#include <restrip/tables/operations/bisect_matching.hpp>
#include <restrip/tables/operations/flip_matching.hpp>
#include <restrip/tables/operations/merge_matching.hpp>
#include <vector>

namespace {

using restrip::StripMesh;
using Halfedge = StripMesh::Halfedge;

/// A patch by its dual edges: the inner ones, and the ports, numbered as in the operation files.
template <std::size_t Edges>
struct Patch {
  std::array<Halfedge, Edges> edges;
  std::array<Halfedge, 4> ports;
};

Patch<1> two_beside(const StripMesh& mesh, Halfedge h) {
  const Halfedge left = StripMesh::next(h);
  const Halfedge right = StripMesh::next(mesh.opposite(h));
  return {{h}, {left, StripMesh::next(left), right, StripMesh::next(right)}};
}
/// The patch after a flip: the file's triangle 0 is then the one with ports 1 and 2.
Patch<1> two_beside_turned(const StripMesh& mesh, Halfedge h) {
  const auto [edges, ports] = two_beside(mesh, h);
  return {edges, {ports[3], ports[0], ports[1], ports[2]}};
}
Patch<4> four_around(const StripMesh& mesh, Halfedge chord) {
  const Halfedge up = StripMesh::next(chord);
  const Halfedge right = StripMesh::next(mesh.opposite(chord));
  const Halfedge down = StripMesh::next(right);
  const Halfedge far = StripMesh::next(mesh.opposite(up));
  const Halfedge far_right = StripMesh::next(mesh.opposite(down));
  return {{up, chord, down, far}, {StripMesh::next(far), StripMesh::next(up), right, far_right}};
}

template <std::size_t N>
unsigned pairs_of(const StripMesh& mesh, const std::array<Halfedge, N>& edges) {
  unsigned mask = 0;
  for (std::size_t i = 0; i < N; ++i) mask |= unsigned{mesh.solid(edges[i])} << i;
  return mask;
}

/// An alone triangle takes an alone neighbour.
void pair_up(StripMesh& mesh, Halfedge h) {
  for (int side = 0; side < 3; ++side, h = StripMesh::next(h)) {
    const Halfedge across = mesh.opposite(h);
    if (mesh.solid_degree(StripMesh::triangle(h)) + mesh.solid_degree(StripMesh::triangle(across)) == 0)
      mesh.set_solid(h, true);
  }
}

/// Asks the table, changes the mesh, and leaves the pairs that the rule names; change() returns the patch after it.
template <class Table, std::size_t Edges, class Change>
void rewrite(StripMesh& mesh, const Table& table, const Patch<Edges>& before, Change&& change) {
  const auto rule = restrip::tables::rule_of(table, pairs_of(mesh, before.edges), pairs_of(mesh, before.ports));
  std::array<Halfedge, 4> behind;
  for (std::size_t i = 0; i < 4; ++i) {
    behind[i] = mesh.opposite(before.ports[i]);
    mesh.set_solid(behind[i], mesh.solid(behind[i]) && (rule.ports >> i & 1U) != 0);
  }
  for (const Halfedge h : before.edges) mesh.set_solid(h, false);
  const auto after = change();
  for (std::size_t i = 0; i < after.edges.size(); ++i) mesh.set_solid(after.edges[i], (rule.colors >> i & 1U) != 0);
  for (std::size_t i = 0; i < 4; ++i) mesh.set_solid(after.ports[i], (rule.ports >> i & 1U) != 0);
  for (const Halfedge h : behind) pair_up(mesh, h);
  for (const Halfedge h : after.ports) pair_up(mesh, h);
}

struct Counts {
  std::size_t alone = 0;
  bool paired = true;   // no triangle has two partners
  bool maximal = true;  // no two neighbours are alone
};
Counts count(const StripMesh& mesh) {
  Counts counts;
  for (restrip::Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    if (mesh.solid_degree(t) > 1) counts.paired = false;
    if (mesh.solid_degree(t) != 0) continue;
    ++counts.alone;
    for (unsigned side = 0; side < 3; ++side)
      if (mesh.solid_degree(StripMesh::triangle(mesh.opposite(StripMesh::halfedge(t, side)))) == 0)
        counts.maximal = false;
  }
  return counts;
}

void print(const char* what, const StripMesh& mesh) {
  const Counts counts = count(mesh);
  std::printf("%s: %zu triangles, %zu alone%s%s\n", what, mesh.triangle_count(), counts.alone,
              counts.paired ? "" : ", NOT IN PAIRS", counts.maximal ? "" : ", NOT MAXIMAL");
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
    restrip::Vertex v_s, v_t;
  };
  std::vector<Record> records;
  for (int i = 0; i < 3000; ++i) {
    const Halfedge h = any();
    const restrip::VertexSplit<Halfedge> where{mesh.opposite(StripMesh::next(StripMesh::next(h))),
                                               StripMesh::next(mesh.opposite(h))};
    rewrite(mesh, restrip::tables::bisect_matching, two_beside(mesh, h), [&] {
      const Halfedge chord = mesh.insert_vertex(where);
      records.push_back({mesh.from(chord), mesh.to(chord)});
      return four_around(mesh, chord);
    });
  }
  print("up", mesh);
  StripMesh anew = mesh;  // for comparison
  anew.clear_colors();
  for (restrip::Triangle t = 0; t < anew.triangle_bound(); ++t) pair_up(anew, StripMesh::halfedge(t, 0));
  print("paired anew", anew);
  for (; !records.empty(); records.pop_back()) {
    const Halfedge chord = mesh.spoke(records.back().v_s, records.back().v_t);
    rewrite(mesh, restrip::tables::merge_matching, four_around(mesh, chord),
            [&] { return two_beside(mesh, StripMesh::next(mesh.opposite(mesh.remove_vertex(chord)))); });
  }
  print("down", mesh);
  for (int i = 0; i < 3000; ++i)
    if (const Halfedge h = any(); restrip::check_flip(mesh, h) == restrip::Refusal::granted)
      rewrite(mesh, restrip::tables::flip_matching, two_beside(mesh, h),
              [&] { return two_beside_turned(mesh, mesh.turn_edge(h)); });
  print("flipped", mesh);
}
