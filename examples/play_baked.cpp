// Playing a baked mesh. The strips of every level are precomputed, here by a keeper with long searches. Each record
// stores the dual edges whose colour it flips. At run time it uses no rules and no searches. `restrip bake` does the
// first part for meshes of any size, with longer searches (docs/how-to/baked-strips.md).
#include <cstdio>
#include <restrip/restrip.hpp>
#include <vector>

namespace {

using restrip::StripMesh;
using restrip::Vertex;

/// A vertex split of the progressive mesh: v_t is split off v_s, between the spokes to v_l and v_r.
struct SplitRecord {
  Vertex v_s, v_t, v_l, v_r;
  [[nodiscard]] restrip::VertexSplit where(const StripMesh& mesh) const {
    return {mesh.spoke(v_s, v_l), mesh.spoke(v_s, v_r)};
  }
};

/// A cylinder of n × n squares, and the records that lead from its coarse base back to it.
StripMesh cylinder(Vertex n) {
  std::vector<std::array<Vertex, 3>> triangles;
  const auto at = [n](Vertex row, Vertex column) { return row * n + column % n; };
  for (Vertex row = 0; row < n; ++row)
    for (Vertex column = 0; column < n; ++column) {
      triangles.push_back({at(row, column), at(row, column + 1), at(row + 1, column + 1)});
      triangles.push_back({at(row, column), at(row + 1, column + 1), at(row + 1, column)});
    }
  return StripMesh::build(triangles, std::size_t{n} * (n + 1));
}
std::vector<SplitRecord> coarsen(StripMesh& mesh) {
  std::vector<SplitRecord> records;
  for (int pass = 0; pass < 2; ++pass)
    for (Vertex v = 0; v < mesh.vertex_bound(); ++v) {
      const auto chord = mesh.spoke(v);
      if (chord.id == restrip::none || mesh.leaves_boundary(chord)) continue;
      if (restrip::check_collapse(mesh, chord) != restrip::Refusal::granted) continue;
      const auto apex = [&](StripMesh::Halfedge h) { return mesh.to(StripMesh::next(h)); };
      records.push_back({v, mesh.to(chord), apex(chord), apex(mesh.opposite(chord))});
      restrip::collapse(mesh, chord);
    }
  return {records.rbegin(), records.rend()};
}

/// Plays all splits twice from the base, once with a keeper and once without flips. A record flips the colours that
/// then differ.
restrip::BakedRecords bake(const StripMesh& base, const std::vector<SplitRecord>& records) {
  restrip::BakedRecords baked;
  StripMesh wanted = base;
  StripMesh plain = base;
  restrip::Keeper keeper(wanted, restrip::Policy::full, restrip::Cost::strips());
  for (const SplitRecord& record : records) {
    keeper.split(record.where(wanted), record.v_t);
    restrip::split_baked(plain, record.where(plain), {}, record.v_t);
    for (restrip::Triangle t = 0; t < plain.triangle_bound(); ++t)
      for (unsigned side = 0; side < 3; ++side) {
        const auto h = StripMesh::halfedge(t, side);
        if (!plain.alive(t) || plain.solid(h) == wanted.solid(h)) continue;
        plain.set_solid(h, wanted.solid(h));  // so the opposite agrees, and is named only once
        baked.flips.push_back(h);
      }
    baked.first.push_back(static_cast<std::uint32_t>(baked.flips.size()));
  }
  return baked;
}

}  // namespace

int main() {
  StripMesh mesh = cylinder(40);
  const std::vector<SplitRecord> records = coarsen(mesh);
  restrip::stripify(mesh, restrip::Effort::full, restrip::Cost::strips());
  const auto baked = bake(mesh, records);
  std::printf("%zu records, %zu flips\n", records.size(), baked.flips.size());

  std::size_t played = 0;  // records
  std::size_t strips = restrip::count_strips(mesh);
  const auto go_to = [&](std::size_t level) {
    for (; played < level; ++played) {
      const SplitRecord& record = records[played];
      const auto done = restrip::split_baked(mesh, record.where(mesh), baked[played], record.v_t);
      strips += static_cast<std::size_t>(done.strips);
    }
    for (; played > level; --played) {
      const SplitRecord& record = records[played - 1];
      const auto chord = mesh.spoke(record.v_s, record.v_t);
      strips += static_cast<std::size_t>(restrip::collapse_baked(mesh, chord, baked[played - 1]).strips);
    }
    std::printf("level %4zu: %4zu triangles in %zu strips\n", level, mesh.triangle_count(), strips);
    return restrip::strip_indices(mesh, restrip::extract_strips(mesh));
  };
  go_to(0);
  const auto first = go_to(records.size() / 2);
  go_to(records.size());
  const auto again = go_to(records.size() / 2);
  std::printf("the same strips from above and from below: %s\n", first == again ? "yes" : "no");
}
