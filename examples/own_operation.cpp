// A custom operation with strips: own_operation.json says that a vertex of six triangles is removed, and how its
// hole is closed; the build makes a table of best rules from that (docs/tutorials/custom-operation.md). Here it is
// applied all over a torus, under each policy in turn.
#include <algorithm>
#include <cstdio>
#include <random>
#include <restrip/restrip.hpp>
#include <restrip/tables/operations/remove_six.hpp>
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

  const auto& operation = restrip::tables::remove_six_rules;
  std::printf("| policy | operations | triangles | strips | triangles a strip |\n| --- | --- | --- | --- | --- |\n");
  for (const restrip::PolicyRow& row : restrip::policies) {
    restrip::StripMesh mesh = restrip::StripMesh::build(indices, columns * rows);
    restrip::stripify(mesh, restrip::Effort::fast, restrip::Cost::strips());
    restrip::Keeper keeper(mesh, row.policy, restrip::Cost::strips());
    const std::size_t wanted = std::min<std::size_t>(10'000, indices.size() / 3 / 6);
    std::size_t done = 0;
    std::mt19937 random(1);
    for (int tries = 0; tries < 1'000'000 && done < wanted; ++tries) {
      const auto h = restrip::StripMesh::halfedge(static_cast<std::uint32_t>(random() % mesh.triangle_bound()), 0);
      if (!mesh.alive(h) || check_apply(mesh, operation, h) != restrip::Refusal::granted) continue;
      keeper.apply(operation, h);
      ++done;
    }
    if (!restrip::check_coloring(mesh).valid || restrip::count_strips(mesh) != keeper.strips()) return 1;
    std::printf("| %s | %zu | %zu | %zu | %zu |\n", row.name, done, mesh.triangle_count(), keeper.strips(),
                mesh.triangle_count() / keeper.strips());
  }
}
