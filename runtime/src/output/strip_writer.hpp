// StripWriter: indices of strips, of a mesh or of a coloured list (search/strips_of.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::detail {

/// `Mesh`: StripMesh, or what has the same numbers of halfedges, and from(), opposite() across solid edges, solid(),
/// other_solid_sides(), solid_degree(), alive() and triangle_bound().
// Writes strips one after the other, as strip_indices() promises. Equal turns in a row cost a swap each, in either
// direction. A strip starts on an even place and is then free to turn left first; seen from its other end, its last
// turn is the first and has changed sides. Strips turn at random, so no turn is a branch.
template <class Mesh>
class StripWriter {
 public:
  explicit StripWriter(const Mesh& mesh) : mesh_(mesh) {
    indices_.reserve(mesh.triangle_bound() + mesh.triangle_bound() / 2 + most_at_once);
  }

  /// Writes the strip that has an end at t, from there if it is `directed`, and returns its other end.
  Triangle write(Triangle t, bool directed) {
    const std::size_t begin = size_;
    const WrittenStrip strip = write_from(t);
    if (strip.wrong && !strip.wrong_backwards && !directed) {
      size_ = begin;
      write_from(strip.other_end);
    }
    return strip.other_end;
  }
  std::vector<std::uint32_t> take() {
    indices_.resize(size_);
    return std::move(indices_);
  }

 private:
  // The result of writing a strip from one end.
  struct WrittenStrip {
    Triangle other_end;
    bool wrong;  // it began with a turn to the right
    bool wrong_backwards;
  };
  static constexpr std::size_t most_at_once = 4;  // a restart and a triangle
  static constexpr unsigned right = 1;            // turns
  static constexpr unsigned left = 2;

  // With room for what is written at once.
  std::uint32_t* indices(std::size_t size) {
    if (indices_.size() - size < most_at_once)
      indices_.resize((std::max)((std::min)(indices_.capacity(), size + 512), size + most_at_once));
    return indices_.data();
  }

  // The vertices of a triangle, from the one that h leaves.
  [[nodiscard]] std::array<Vertex, 3> corners_from(Halfedge h) const noexcept {
    const Halfedge second = StripMesh::next(h);
    return {mesh_.from(h), mesh_.from(second), mesh_.from(StripMesh::next(second))};
  }

  WrittenStrip write_from(Triangle t) {
    std::size_t size = size_;
    std::uint32_t* written = indices(size);
    if (size != 0) written[size++] = restart_index;
    Halfedge h = StripMesh::halfedge(t);
    Halfedge exit = StripMesh::next(h);
    bool joined = false;
    for (int side = 0; side < 3; ++side, h = StripMesh::next(h)) {
      if (!mesh_.solid(h)) continue;
      exit = h;
      joined = true;
    }
    // The first triangle ends in the edge over which it is left.
    for (const std::uint32_t v : corners_from(StripMesh::next(StripMesh::next(exit)))) written[size++] = v;
    unsigned first_turn = 0;
    unsigned last_turn = 0;
    for (unsigned free_turn = left; joined;) {
      written = indices(size);
      // A triangle entered over the halfedge `entry` is left over next(entry), a turn to the right, or over the third
      // side, a turn to the left. (Seen from outside, the strip comes in across `entry` from the right of its direction
      // to its left.)
      const Halfedge entry = mesh_.opposite(exit);
      const Halfedge after = StripMesh::next(entry);
      const Halfedge before = StripMesh::next(after);
      const unsigned turn = mesh_.other_solid_sides(entry);
      // The corner opposite the entry comes next; for a swap, the last but one comes again before it.
      if (turn == 0) {
        t = StripMesh::triangle(entry);
        written[size++] = mesh_.from(before);
        joined = false;
        continue;
      }
      written[size] = written[size - 2];
      size += static_cast<std::size_t>(turn != free_turn);
      written[size++] = mesh_.from(before);
      free_turn = left + right - turn;
      first_turn = first_turn == 0 ? turn : first_turn;
      last_turn = turn;
      exit = turn == right ? after : before;
    }
    size_ = size;
    return {t, first_turn == right, last_turn == left};
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> indices_;
  std::size_t size_ = 0;
};

/// strip_indices(): of each strip, from its end with the lower number.
template <class Mesh>
std::vector<std::uint32_t> indices_of_strips(const Mesh& mesh) {
  StripWriter<Mesh> writer(mesh);
  std::vector<bool> written(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t) && !written[t] && mesh.solid_degree(t) <= 1) written[writer.write(t, false)] = true;
  return writer.take();
}

}  // namespace restrip::detail
