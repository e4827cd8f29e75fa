// A custom operation, and a custom cost: own_operation.json says that a vertex of six triangles is removed, and how its
// hole is closed; own_cost.json says the same, but ranks ports given up before strips
// (docs/reference/operation-file.md, "Cost"). So fewer strips are cut, and more remain. The build makes tables of best
// rules from both files, which are applied at random places of a torus.
#include <bit>
#include <cstdio>
#include <random>
#include <restrip/restrip.hpp>
#include <restrip/tables/operations/remove_six.hpp>
#include <restrip/tables/operations/remove_six_whole.hpp>
#include <vector>

template <class Table>
void report(const char* name, const Table& table) {
  int given_up = 0;  // by the rules of all configurations
  int strips = 0;
  for (std::uint32_t inner = 0; inner < 1U << 6; ++inner)
    for (std::uint32_t ports = 0; ports < 1U << 6; ++ports)
      if (const auto rule = rule_of(table, inner, ports); rule.valid) {
        given_up += std::popcount(ports & ~rule.ports);
        strips += rule.strips;
      }

  constexpr std::uint32_t columns = 80, rows = 30;  // a torus
  std::vector<std::uint32_t> indices;
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      const auto at = [](std::uint32_t u, std::uint32_t v) { return v % rows * columns + u % columns; };
      for (const auto v : {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1)})
        indices.push_back(v);
    }
  restrip::StripMesh mesh = restrip::StripMesh::build(indices, columns * rows);
  restrip::stripify(mesh, restrip::Effort::fast, restrip::Cost::strips());
  std::mt19937 random(1);
  int removed = 0;
  for (int tries = 0; tries < 100'000 && removed < 300; ++tries) {
    const auto h = restrip::StripMesh::halfedge(static_cast<std::uint32_t>(random() % mesh.triangle_bound()), 0);
    if (!mesh.alive(h) || check_apply(mesh, table, h) != restrip::Refusal::granted) continue;
    apply(mesh, table, h);
    ++removed;
  }
  std::printf("%s: the rules give up %d ports and change strips by %d in all; %d vertices removed, %zu strips left\n",
              name, given_up, strips, removed, restrip::count_strips(mesh));
}

int main() {
  report("fewest strips first", restrip::tables::remove_six_rules);
  report("fewest cuts first  ", restrip::tables::remove_six_whole_rules);
}
