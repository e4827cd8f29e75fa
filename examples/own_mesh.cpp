// Your own mesh: six small functions around a half-edge structure that you already have, and restrip maintains its
// strips while you flip edges. Splits and collapses need one more function each (mesh.hpp). Five more number triangles
// and vertices (numbered_mesh.hpp), and you get index buffers.
#include <cstdio>
#include <restrip/operations/test_adapter.hpp>
#include <restrip/restrip.hpp>
#include <utility>
#include <vector>

/// Halfedges 3t, 3t + 1, 3t + 2 run counter-clockwise around triangle t. The halfedge on the other side of a boundary
/// edge is named ~h.
class MyMesh {
 public:
  using Halfedge = int;

  explicit MyMesh(std::vector<int> corners) : from_(std::move(corners)), twin_(from_.size()), solid_(from_.size()) {
    const int n = static_cast<int>(from_.size());
    for (int h = 0; h < n; ++h) {
      twin(h) = ~h;
      for (int g = 0; g < n; ++g)
        if (from(g) == from(next(h)) && from(next(g)) == from(h)) twin(h) = g;
    }
  }

  // For restrip.
  [[nodiscard]] int next(int h) const { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] int opposite(int h) const { return h < 0 ? ~h : twin_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] bool on_boundary(int h) const { return h < 0; }
  [[nodiscard]] bool solid(int h) const { return solid_[static_cast<std::size_t>(h < 0 ? ~h : h)]; }
  void set_solid(int h, bool solid) {
    solid_[static_cast<std::size_t>(h)] = solid;
    solid_[static_cast<std::size_t>(opposite(h))] = solid;
  }
  /// The edge u v between triangles (u, v, l) and (v, u, r) becomes r l between (r, l, u) and (l, r, v).
  int turn_edge(int h) {
    const int g = opposite(h);
    const Side v_l = side(next(h));
    const Side l_u = side(next(next(h)));
    const Side u_r = side(next(g));
    const Side r_v = side(next(next(g)));
    leave(h, r_v.from);
    leave(g, l_u.from);
    put(next(h), l_u);
    put(next(next(h)), u_r);
    put(next(g), r_v);
    put(next(next(g)), v_l);
    return h;
  }

  // For index buffers.
  [[nodiscard]] std::uint32_t triangle(int h) const { return static_cast<std::uint32_t>(h) / 3; }
  [[nodiscard]] int halfedge(std::uint32_t t) const { return static_cast<int>(3 * t); }
  [[nodiscard]] bool has_triangle(std::uint32_t) const { return true; }
  [[nodiscard]] std::size_t triangle_bound() const { return from_.size() / 3; }
  [[nodiscard]] std::uint32_t from(int h) const {
    return static_cast<std::uint32_t>(from_[static_cast<std::size_t>(h)]);
  }

 private:
  struct Side {
    int name, from, twin;
    bool solid;
  };
  [[nodiscard]] Side side(int h) { return {h, from_[static_cast<std::size_t>(h)], twin(h), solid(h)}; }
  void put(int h, const Side& side) {
    const bool alone = side.twin == ~side.name;
    leave(h, side.from);
    solid_[static_cast<std::size_t>(h)] = side.solid;
    twin(h) = alone ? ~h : side.twin;
    if (!alone) twin(side.twin) = h;
  }
  void leave(int h, int vertex) { from_[static_cast<std::size_t>(h)] = vertex; }
  int& twin(int h) { return twin_[static_cast<std::size_t>(h)]; }

  std::vector<int> from_, twin_;
  std::vector<bool> solid_;
};
static_assert(restrip::FlippableMesh<MyMesh> && restrip::NumberedMesh<MyMesh>);

int main() {
  // Tests the contract on a mesh with a boundary: eight by eight squares of two triangles each.
  std::vector<int> corners;
  for (int v = 0; v < 72; ++v)
    if (v % 9 != 8) corners.insert(corners.end(), {v, v + 1, v + 10, v, v + 10, v + 9});
  MyMesh trial(corners);
  const restrip::AdapterReport report = restrip::test_adapter(trial, 0);
  std::printf("%s (%zu flips)\n", restrip::describe(report.broken), report.flips);
  if (!report.kept()) return 1;

  // Six triangles around vertex 0, the first five of them one strip.
  MyMesh mesh({0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 6, 0, 6, 1});
  for (int t = 0; t < 4; ++t) mesh.set_solid(3 * t + 2, true);
  for (const int h : {2, 8, 5}) {
    const auto done = restrip::flip(mesh, h);
    std::printf("a flip changed the number of strips by %+d\n", done.strips);
  }
  for (const std::uint32_t index : restrip::strip_indices(mesh))
    index == restrip::restart_index ? (void)std::printf("| ") : (void)std::printf("%u ", index);
  std::printf("\n");
}
