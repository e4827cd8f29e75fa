// The library in two files, restrip.hpp and restrip.cpp, on targets and with options that the other tests do not cover.
// The output must be the same everywhere; two_files.cmake compiles it for each target and compares.
#include <cstdio>
#include <cstring>
#include <vector>

#include "restrip.hpp"

namespace {

using restrip::StripMesh;
using restrip::Triangle;
using restrip::Vertex;
using Halfedge = StripMesh::Halfedge;

// The compiler evaluates a rule of each family.
static_assert(restrip::split_rule({4, 2}, 0b0101, 0).valid && restrip::collapse_rule({4, 2}, 0, 0).valid);
static_assert(restrip::open_split_rule({3, 0, 2}, 0, 0).valid && restrip::open_collapse_rule({3, 0, 2}, 0, 0).valid);
static_assert(restrip::boundary_split_rule({3, 1}, 0, 0).valid && restrip::boundary_collapse_rule({3, 1}, 0, 0).valid);
static_assert(restrip::flip_rule(true, 0b0101).valid && restrip::split_rule({20, 9}, 0, 0).valid);

/// n squares a side, two triangles each.
StripMesh sheet(Vertex n) {
  std::vector<std::array<Vertex, 3>> triangles;
  const auto at = [n](Vertex row, Vertex column) { return row * (n + 1) + column; };
  for (Vertex row = 0; row < n; ++row)
    for (Vertex column = 0; column < n; ++column) {
      triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
      triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
    }
  return StripMesh::build(triangles, (n + std::size_t{1}) * (n + 1));
}

/// Collapses every edge that may be collapsed, from each third vertex on, and splits the vertices again.
template <class Collapse, class Split>
void down_and_up(StripMesh& mesh, Collapse&& collapse, Split&& split) {
  struct Record {
    Vertex v_s, v_t, v_l, v_r;
  };
  std::vector<Record> records;
  for (Vertex v = 0; v < mesh.vertex_bound(); v += 3) {
    if (mesh.spoke(v).id == restrip::none) continue;
    const Halfedge chord = mesh.spoke(v);
    const Halfedge back = mesh.opposite(chord);
    if (restrip::check_collapse(mesh, chord) != restrip::Refusal::granted) continue;
    if (StripMesh::on_boundary(chord) || StripMesh::on_boundary(back)) continue;
    records.push_back({v, mesh.to(chord), mesh.to(StripMesh::next(chord)), mesh.to(StripMesh::next(back))});
    collapse(chord);
  }
  while (!records.empty()) {
    const Record r = records.back();
    records.pop_back();
    split({mesh.spoke(r.v_s, r.v_l), mesh.spoke(r.v_s, r.v_r)});
  }
}

void print(const char* what, const StripMesh& mesh) {
  const restrip::ColoringReport report = restrip::check_coloring(mesh);
  const restrip::Strips strips = restrip::extract_strips(mesh);
  const std::vector<std::uint32_t> indices = restrip::strip_indices(mesh, strips);
  std::uint32_t sum = 0;
  for (const std::uint32_t index : indices) sum = sum * 31 + index;
  std::printf("%s: %s, %u triangles, %u strips, %u isolated, indices %u, sum %lx\n", what,
              report.valid ? "valid" : "not valid", static_cast<unsigned>(report.triangles),
              static_cast<unsigned>(report.strips), static_cast<unsigned>(report.isolated),
              static_cast<unsigned>(indices.size()), static_cast<unsigned long>(sum));
}

void by_rules(const char* what, StripMesh& mesh) {
  using Where = restrip::VertexSplit;
  down_and_up(
      mesh, [&](Halfedge h) { restrip::collapse(mesh, h); }, [&](const Where& where) { restrip::split(mesh, where); });
  print(what, mesh);
  for (Triangle t = 0; t < mesh.triangle_bound(); t += 7) restrip::checked_flip(mesh, StripMesh::halfedge(t, 0));
  print(what, mesh);
}

/// A vertex of 70 triangles takes more than one word; cut and closed again.
void large_fan() {
  std::vector<std::array<Vertex, 3>> triangles;
  for (Vertex v = 0; v < 70; ++v) triangles.push_back({70, v, (v + 1) % 70});
  StripMesh mesh = StripMesh::build(triangles, 71);
  const auto done = restrip::split(mesh, {mesh.spoke(70, 3), mesh.spoke(70, 40)});
  print("large fan split", mesh);
  restrip::collapse(mesh, done.halfedge);
  print("large fan", mesh);
}

void by_keeper(restrip::Policy policy, const char* what) {
  StripMesh mesh = sheet(24);
  restrip::stripify(mesh, policy == restrip::Policy::full ? restrip::Effort::full : restrip::Effort::fast,
                    restrip::Cost::strips());
  std::vector<Triangle> changed;
  mesh.watch(&changed);
  restrip::LiveBuffer buffer({.form = restrip::StripForm::lengths});
  buffer.rebuild(mesh);
  restrip::Keeper keeper(mesh, policy, restrip::Cost::strips());
  down_and_up(
      mesh, [&](Halfedge h) { restrip::checked_collapse(keeper, h); },
      [&](const restrip::VertexSplit& where) { restrip::checked_split(keeper, where); });
  const std::size_t ranges = buffer.update(mesh, changed).size();
  std::vector<restrip::IndexRange> runs;
  buffer.draws(runs);
  keeper.improve(5000);
  std::printf("%u strips, %u runs, %u ranges\n", static_cast<unsigned>(keeper.strips()),
              static_cast<unsigned>(runs.size()), static_cast<unsigned>(ranges));
  print(what, mesh);
}

/// Split and collapse with precomputed flips.
void by_record() {
  StripMesh mesh = sheet(2);
  restrip::stripify(mesh, restrip::Effort::fast, restrip::Cost::strips());
  restrip::BakedRecords records;
  records.flips = {mesh.spoke(4, 5)};
  records.first = {0, 1};
  const auto done = restrip::split_baked(mesh, {mesh.spoke(4, 1), mesh.spoke(4, 7)}, records[0]);
  restrip::collapse_baked(mesh, done.halfedge, records[0]);
  print("baked", mesh);
}

/// A colouring that is not valid must be refused; never returns.
void read_invalid_coloring() {
  StripMesh mesh = StripMesh::build(std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, 4);
  for (unsigned side = 0; side < 3; ++side) mesh.set_solid(StripMesh::halfedge(0, side), true);
  std::printf("%u strips of no valid colouring\n", static_cast<unsigned>(restrip::count_strips(mesh)));
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1 && std::strcmp(arguments[1], "invalid") == 0) {
    read_invalid_coloring();
    return 0;
  }
  StripMesh mesh = sheet(12);
  by_rules("rules", mesh);
  large_fan();
  by_record();
  by_keeper(restrip::Policy::local, "local");
  by_keeper(restrip::Policy::quick, "quick");
  by_keeper(restrip::Policy::full, "full");
}
