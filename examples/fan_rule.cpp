// The rules alone, on a mesh that is not restrip's: a vertex with a closed fan is split, and its strips are repaired by
// one look-up. This program needs only the headers of restrip::rules.
//
// The mesh stores the colour of each edge: true if two triangles follow each other in a strip across it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <restrip/rules/rules.hpp>
#include <utility>
#include <vector>

namespace {

using Edge = std::pair<int, int>;
Edge edge(int v, int w) { return v < w ? Edge{v, w} : Edge{w, v}; }

struct OwnMesh {
  std::map<Edge, bool> solid;
  std::map<int, std::vector<int>> ring;  // the neighbours of an interior vertex, counter-clockwise
};

/// Splits v along its edges to ring[v][0] (left) and ring[v][a] (right). v keeps the triangles between them, counted
/// counter-clockwise from left; the new vertex gets the others. Two triangles come: v, fresh, left and fresh, v, right.
int split(OwnMesh& mesh, int v, std::size_t a, int fresh) {
  const std::vector<int> ring = mesh.ring[v];
  const std::size_t k = ring.size();
  // Triangle t_i lies between the edges to ring[i] and ring[i + 1]. Its port is the edge opposite v; loop edge i lies
  // between t_i and t_{i+1} (docs/reference/notation.md).
  restrip::Word loop = 0;
  restrip::Word ports = 0;
  for (std::size_t i = 0; i < k; ++i) {
    const int next = ring[(i + 1) % k];
    ports |= restrip::Word{mesh.solid[edge(ring[i], next)]} << i;
    loop |= restrip::Word{mesh.solid[edge(v, next)]} << i;
  }
  const restrip::Rule rule = restrip::split_rule({k, a}, loop, ports);
  if (!rule.valid) return 0;  // colours that no strips have
  const auto colored = [&](std::size_t j) { return (rule.colors >> j & 1U) != 0; };

  // The mesh changes: edges of the triangles from right on leave the new vertex.
  const int left = ring[0];
  const int right = ring[a];
  for (std::size_t i = a + 1; i < k; ++i) mesh.solid.erase(edge(v, ring[i]));
  mesh.ring[v].assign(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(a) + 1);
  mesh.ring[v].push_back(fresh);
  mesh.ring[fresh].assign(ring.begin() + static_cast<std::ptrdiff_t>(a), ring.end());
  mesh.ring[fresh].insert(mesh.ring[fresh].end(), {left, v});

  // The new colours. Inner edges are numbered around the ring: the one before t_0 is 0, then one after each triangle;
  // the last number is the edge between the two new triangles.
  mesh.solid[edge(v, left)] = colored(0);
  for (std::size_t i = 1; i < a; ++i) mesh.solid[edge(v, ring[i])] = colored(i);
  mesh.solid[edge(v, right)] = colored(a);
  mesh.solid[edge(fresh, right)] = colored(a + 1);
  for (std::size_t i = a + 1; i < k; ++i) mesh.solid[edge(fresh, ring[i])] = colored(i + 1);
  mesh.solid[edge(fresh, left)] = colored(k + 1);
  mesh.solid[edge(v, fresh)] = colored(k + 2);
  return rule.strips;
}

}  // namespace

int main() {
  OwnMesh mesh;  // vertex 0 with six triangles, and strips that enter by three of their ports
  mesh.ring[0] = {1, 2, 3, 4, 5, 6};
  for (const Edge& e : {Edge{1, 2}, Edge{3, 4}, Edge{5, 6}}) mesh.solid[edge(e.first, e.second)] = true;
  for (const int w : {2, 4}) mesh.solid[edge(0, w)] = true;
  const int more = split(mesh, 0, 3, 7);
  std::printf("strips: %+d\nsolid edges at the two vertices:", more);
  for (const auto& [e, is_solid] : mesh.solid)
    if (is_solid && (e.first == 0 || e.second == 7)) std::printf(" %d-%d", e.first, e.second);
  std::printf("\n");
}
