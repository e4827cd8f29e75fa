#pragma once
// A mesh that is not a StripMesh, for functions that must work on any mesh.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "sample_meshes.hpp"

namespace restrip::sample {

/// A half-edge structure as a user may have one: three halfedges a triangle, ~h beyond the boundary, flips, and a list
/// of what changed. Triangle and vertex numbers begin at 7 and 1000, so that they are not the indices of arrays. It has
/// the triangles and colours of a StripMesh that has not removed any.
class HandMade {
 public:
  using Halfedge = int;
  explicit HandMade(const StripMesh& from) {
    for (const StripMesh::Halfedge h : sides_of(from)) {
      from_.push_back(static_cast<int>(from.from(h)) + 1000);
      solid_.push_back(from.solid(h));
    }
    for (int h = 0; h < size(); ++h) {
      twin_.push_back(~h);
      for (int g = 0; g < size(); ++g)
        if (at(from_, g) == at(from_, next(h)) && at(from_, next(g)) == at(from_, h)) twin_.back() = g;
    }
  }
  [[nodiscard]] int next(int h) const { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] int opposite(int h) const { return h < 0 ? ~h : at(twin_, h); }
  [[nodiscard]] bool on_boundary(int h) const { return h < 0; }
  [[nodiscard]] bool solid(int h) const { return at(solid_, h < 0 ? ~h : h); }
  void set_solid(int h, bool solid) {
    for (const int g : {h, opposite(h)}) {
      solid_[static_cast<std::size_t>(g)] = solid;
      changed.push_back(triangle(g));
    }
  }
  int turn_edge(int h) {
    const int g = opposite(h);
    const std::array<int, 4> sides{next(h), next(next(h)), next(g), next(next(g))};
    struct Side {
      int name, from, twin;
      bool solid;
    };
    std::array<Side, 4> old{};
    for (std::size_t i = 0; i < 4; ++i)
      old[i] = {sides[i], at(from_, sides[i]), at(twin_, sides[i]), at(solid_, sides[i])};
    at(from_, h) = old[3].from;
    at(from_, g) = old[1].from;
    for (const auto& [to, side] :
         {std::pair{sides[0], old[1]}, {sides[1], old[2]}, {sides[2], old[3]}, {sides[3], old[0]}}) {
      at(from_, to) = side.from;
      solid_[static_cast<std::size_t>(to)] = side.solid;
      at(twin_, to) = side.twin < 0 ? ~to : side.twin;
      if (side.twin >= 0) {
        at(twin_, side.twin) = to;
        changed.push_back(triangle(side.twin));
      }
    }
    changed.push_back(triangle(h));
    changed.push_back(triangle(g));
    return h;
  }
  // For buffers.
  [[nodiscard]] std::uint32_t triangle(int h) const { return static_cast<std::uint32_t>(h / 3 + 7); }
  [[nodiscard]] int halfedge(std::uint32_t t) const { return static_cast<int>(t - 7) * 3 + 2; }
  [[nodiscard]] bool has_triangle(std::uint32_t t) const { return t >= 7; }
  [[nodiscard]] std::size_t triangle_bound() const { return from_.size() / 3 + 7; }
  [[nodiscard]] int from(int h) const { return at(from_, h); }

  /// The halfedge that was this one of the StripMesh.
  static int named(StripMesh::Halfedge h) { return static_cast<int>(3 * StripMesh::triangle(h) + StripMesh::side(h)); }
  [[nodiscard]] int size() const { return static_cast<int>(from_.size()); }
  /// From their smallest corners, in order.
  [[nodiscard]] std::vector<Corners> triangles() const {
    std::vector<Corners> all;
    for (int h = 0; h < size(); h += 3)
      all.push_back({static_cast<Vertex>(from(h)), static_cast<Vertex>(from(h + 1)), static_cast<Vertex>(from(h + 2))});
    return sorted(std::move(all));
  }
  /// No two neighbours of the two triangles are one, and no mesh edge is doubled.
  [[nodiscard]] bool can_flip(int h) const {
    if (h < 0 || at(twin_, h) < 0) return false;
    const int left = from(next(next(h)));
    const int right = from(next(next(at(twin_, h))));
    if (left == right) return false;
    for (int g = 0; g < size(); ++g)
      if ((from(g) == left && from(next(g)) == right) || (from(g) == right && from(next(g)) == left)) return false;
    return true;
  }

  std::vector<std::uint32_t> changed;

 private:
  static int& at(std::vector<int>& vector, int h) { return vector[static_cast<std::size_t>(h)]; }
  static int at(const std::vector<int>& vector, int h) { return vector[static_cast<std::size_t>(h)]; }
  static bool at(const std::vector<bool>& vector, int h) { return vector[static_cast<std::size_t>(h)]; }
  std::vector<int> from_, twin_;
  std::vector<bool> solid_;
};

}  // namespace restrip::sample
