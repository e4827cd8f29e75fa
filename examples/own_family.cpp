// A custom family with strips: own_family.json says, for every k, that a vertex of k triangles is removed and its
// hole becomes a fan around one of its neighbours. One table has the best rules for all k up to 8
// (docs/tutorials/custom-operation.md). Here vertices of all these valences are removed at random, under each policy in
// turn, from a torus.
#include <array>
#include <cstdio>
#include <random>
#include <restrip/restrip.hpp>
#include <restrip/tables/operations/remove_vertex.hpp>
#include <vector>

int main() {
  std::vector<std::uint32_t> indices;  // three for each triangle, counter-clockwise
  constexpr std::uint32_t columns = 80, rows = 30;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const auto at = [](std::uint32_t u, std::uint32_t v) { return v % rows * columns + u % columns; };
      for (const auto v : {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1)})
        indices.push_back(v);
    }

  std::printf("| policy | of 3 | 4 | 5 | 6 | 7 | 8 | triangles | strips |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const restrip::PolicyRow& row : restrip::policies) {
    restrip::StripMesh mesh = restrip::StripMesh::build(indices, columns * rows);
    restrip::stripify(mesh, restrip::Effort::fast, restrip::Cost::strips());
    restrip::Keeper keeper(mesh, row.policy, restrip::Cost::strips());
    std::array<std::size_t, 9> gone{};  // by valence
    std::mt19937 random(1);
    for (int tries = 0; tries < 1'000'000 && mesh.triangle_count() > indices.size() / 6; ++tries) {
      const auto h = restrip::StripMesh::halfedge(static_cast<std::uint32_t>(random() % mesh.triangle_bound()), 0);
      if (!mesh.alive(h)) continue;
      const auto k = static_cast<unsigned>(restrip::spoke_count(mesh, mesh.from(h)));
      const auto removal = position_of(restrip::tables::remove_vertex_rules, {k});
      if (check_apply(mesh, removal, h) != restrip::Refusal::granted) continue;
      keeper.apply(removal, h);
      ++gone[k];
    }
    if (!restrip::check_coloring(mesh).valid || restrip::count_strips(mesh) != keeper.strips()) return 1;
    std::printf("| %s | ", row.name);
    for (unsigned k = 3; k <= 8; ++k) std::printf("%zu | ", gone[k]);
    std::printf("%zu | %zu |\n", mesh.triangle_count(), keeper.strips());
  }
}
