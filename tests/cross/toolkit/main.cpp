#include <cstdio>
#include <cstdlib>
#include <restrip/restrip.hpp>

// The rules come from the tables of this build.
static_assert(restrip::table_max_k == MAX_K);
static_assert(restrip::split_rule({MAX_K, MAX_K / 2}, 0, 0).valid);

int main() {
  // A cone over a ring of MAX_K vertices: its two tips have the largest fans that the tables know.
  std::vector<std::array<restrip::Vertex, 3>> triangles;
  for (restrip::Vertex i = 0; i < MAX_K; ++i) {
    const restrip::Vertex next = (i + 1) % MAX_K;
    triangles.push_back({MAX_K, i, next});
    triangles.push_back({MAX_K + 1, next, i});
  }
  restrip::StripMesh mesh = restrip::StripMesh::build(triangles, MAX_K + 2);

  // Each tip is split and collapsed again, with and without joins; both report how the strips change.
  auto strips = static_cast<int>(restrip::count_strips(mesh));
  for (const restrip::Vertex tip : {MAX_K, MAX_K + 1})
    for (restrip::Vertex other = 1; other < MAX_K; ++other) {
      const auto split = restrip::split(mesh, {mesh.spoke(tip, 0), mesh.spoke(tip, other)});
      const auto collapse = restrip::collapse_and_join(mesh, split.halfedge);
      strips += split.strips + collapse.strips;
      const auto again = restrip::split_and_join(mesh, {mesh.spoke(tip, 0), mesh.spoke(tip, other)});
      strips += again.strips + restrip::collapse(mesh, again.halfedge).strips;
      if (!restrip::check_coloring(mesh).valid || strips != static_cast<int>(restrip::count_strips(mesh)))
        return EXIT_FAILURE;
    }
  std::printf("%zu triangles, %d strips\n", mesh.triangle_count(), strips);
}
