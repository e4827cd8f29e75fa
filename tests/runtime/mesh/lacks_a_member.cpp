// Does not compile: a mesh without `has_triangle`. The error must name it.
#include "restrip/search/keeper.hpp"

struct Mesh {
  using Halfedge = int;
  [[nodiscard]] int next(int h) const { return h; }
  [[nodiscard]] int opposite(int h) const { return h; }
  [[nodiscard]] bool on_boundary(int h) const { return h < 0; }
  [[nodiscard]] bool solid(int h) const { return h < 0; }
  void set_solid(int /*h*/, bool /*solid*/) {}
  [[nodiscard]] std::uint32_t triangle(int h) const { return static_cast<std::uint32_t>(h); }
  [[nodiscard]] int halfedge(std::uint32_t t) const { return static_cast<int>(t); }
  [[nodiscard]] std::size_t triangle_bound() const { return 0; }
  [[nodiscard]] std::uint32_t from(int h) const { return static_cast<std::uint32_t>(h); }
};

int main() {
  Mesh mesh;
  restrip::Keeper keeper(mesh, restrip::Policy::quick, restrip::Cost::strips());
}
