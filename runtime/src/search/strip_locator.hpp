// StripLocator: finds whether two triangles are in one strip, and their order along it, without walking it, while
// strips are cut, linked, reversed and rewritten.
//
// Costs, for strips of n triangles: a query, cut(), link(), and each strip through a patch, expected O(log n);
// linear in the patch besides. Memory: 20 bytes a triangle. Nothing is allocated once the arrays have grown.
//
// Colours and locator must change together: colour dual edges through cut() and link(), and call before_patch() before
// every local operation and after_patch() after it. After an exception (std::bad_alloc) of any function the mesh's
// colouring is valid, and the locator must be rebuilt. Preconditions are checked in debug builds (precondition.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"

namespace restrip {

class StripLocator {
 public:
  using Halfedge = StripMesh::Halfedge;

  /// Two triangles are in the same strip if `strip` is equal, and then `order` grows along it, from 0 in steps of 1.
  /// Valid until the next change; the direction of counting is arbitrary.
  struct Position {
    std::uint32_t strip = none;
    std::uint32_t order = 0;
  };

  StripLocator() = default;
  /// Reads a valid colouring; throws std::invalid_argument if it is not. O(n log n) for n triangles.
  explicit StripLocator(const StripMesh& mesh) { rebuild(mesh); }
  /// Reads the whole colouring again, as the constructor does.
  void rebuild(const StripMesh& mesh);

  /// False if the locator does not know a triangle, because the mesh was changed without it.
  [[nodiscard]] bool knows(Triangle t) const noexcept { return t < nodes_.size() && nodes_[t].size != 0; }
  /// The position of a triangle that is alive.
  [[nodiscard]] Position position(Triangle t) const noexcept;
  /// The position of t and the order of `next`, which must follow or precede it in its strip, for the price of one.
  [[nodiscard]] std::pair<Position, std::uint32_t> position(Triangle t, Triangle next) const noexcept;
  /// Number of strips.
  [[nodiscard]] std::size_t strips() const noexcept { return strips_; }

  /// Makes the solid dual edge of h dashed.
  void cut(StripMesh& mesh, Halfedge h);
  /// Makes the dashed dual edge of h solid. Both its triangles must be ends, of different strips.
  void link(StripMesh& mesh, Halfedge h);

  /// A local rewrite, in three steps: before_patch with the triangles about to be rewritten, the rewrite, after_patch
  /// with the new triangles. Colours of dual edges that are not of the patch may not change, except from solid to
  /// dashed between the patch and its neighbours.
  void before_patch(const StripMesh& mesh, std::span<const Triangle> patch);
  void after_patch(const StripMesh& mesh, std::span<const Triangle> patch);

  /// Makes room for this many triangles, so that operations up to there do not allocate.
  void reserve(std::size_t triangles) { nodes_.reserve(triangles); }

 private:
  /// A triangle in the tree of its strip.
  struct Node {
    Triangle parent = none;
    std::array<Triangle, 2> child{none, none};
    std::uint32_t size = 0;  // of the subtree; 0: not a triangle
    bool turned = false;     // the order of the whole subtree is to be reversed
    bool in_patch = false;   // while before_patch() or after_patch() runs
  };

  [[nodiscard]] Position climb(Triangle t, Triangle above, int& step) const noexcept;
  void turn(Triangle t) noexcept;
  void push_down(Triangle t) noexcept;
  void push_down_to(Triangle t) noexcept;
  void hang(Triangle child, Triangle parent, unsigned side) noexcept;
  Triangle append(Triangle first, Triangle second) noexcept;
  void part(Triangle a, Triangle b) noexcept;
  void join(Triangle a, Triangle b) noexcept;
  template <class Visit>
  void for_each_solid_edge(const StripMesh& mesh, std::span<const Triangle> patch, Visit&& visit) const;

  std::vector<Node> nodes_;
  std::size_t strips_ = 0;
};

}  // namespace restrip
