// A level-of-detail loop with a live index buffer: a sheet of triangles is coarsened and refined again, a policy
// maintains its strips, and only the parts of the index buffer that changed are uploaded.
#include <cstdio>
#include <restrip/restrip.hpp>
#include <vector>

namespace {

using restrip::StripMesh;
using restrip::Vertex;

/// A sheet of n × n squares, two triangles each.
StripMesh sheet(Vertex n) {
  std::vector<std::array<Vertex, 3>> triangles;
  const auto at = [n](Vertex row, Vertex column) { return row * (n + 1) + column; };
  for (Vertex row = 0; row < n; ++row)
    for (Vertex column = 0; column < n; ++column) {
      triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
      triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
    }
  return StripMesh::build(triangles, (std::size_t{n} + 1) * (n + 1));
}

/// Data of a collapse, so that a split can undo it.
struct Record {
  Vertex v_s, v_t, v_l, v_r;
};

}  // namespace

int main() {
  StripMesh mesh = sheet(60);
  restrip::stripify(mesh, restrip::Effort::full, restrip::Cost::strips());
  restrip::Keeper keeper(mesh, restrip::Policy::quick, restrip::Cost::strips());

  std::vector<restrip::Triangle> changed;
  mesh.watch(&changed);
  restrip::LiveBuffer buffer({.width = restrip::IndexWidth::bits32});
  buffer.rebuild(mesh);  // upload buffer.indices() once
  const auto upload = [&](const char* what) {
    std::size_t indices = 0;
    for (const auto& range : buffer.update(mesh, changed)) indices += range.count;  // upload each range
    changed.clear();
    std::printf("%-9s %5zu triangles in %3zu strips, %5zu of %5zu indices uploaded\n", what, mesh.triangle_count(),
                keeper.strips(), indices, buffer.indices().size());
  };
  upload("start");

  // Coarser: collapse edges inside the sheet while it is legal. A renderer would choose them by the error they make.
  std::vector<Record> records;
  for (Vertex v = 0; v < 61 * 61 && records.size() < 900; v += 3) {
    const auto chord = mesh.spoke(v);
    if (restrip::check_collapse(mesh, chord) != restrip::Refusal::granted) continue;
    if (StripMesh::on_boundary(chord) || StripMesh::on_boundary(mesh.opposite(chord))) continue;
    const auto apex = [&](StripMesh::Halfedge h) { return mesh.to(StripMesh::next(h)); };
    records.push_back({mesh.from(chord), mesh.to(chord), apex(chord), apex(mesh.opposite(chord))});
    keeper.collapse(chord);
    if (records.size() % 300 == 0) upload("coarser");
  }

  // Finer again: the same vertices are split in the opposite order.
  while (!records.empty()) {
    const Record r = records.back();
    records.pop_back();
    keeper.split({mesh.spoke(r.v_s, r.v_l), mesh.spoke(r.v_s, r.v_r)}, r.v_t);
    if (records.size() % 300 == 0) upload("finer");
  }
  return restrip::check_coloring(mesh).valid ? 0 : 1;
}
