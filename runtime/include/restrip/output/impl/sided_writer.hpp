// Strips written by the numbers of sides. Included by strips.hpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::detail {

// The result of writing a strip from one end.
struct WrittenStrip {
  Triangle other_end;
  bool wrong;  // it began with a turn to the right
  bool wrong_backwards;
};

// Writes all strips, as strip_indices() promises, of a mesh that returns turns as StripMesh::other_solid_sides does.
// Strips turn at random, so no turn is a branch.
template <class Mesh>
class SidedWriter {
 public:
  explicit SidedWriter(const Mesh& mesh) noexcept : mesh_(mesh) {}

  std::vector<std::uint32_t> run() {
    indices_.reserve(mesh_.triangle_count() + mesh_.triangle_count() / 2 + most_at_once);
    std::vector<bool> written(mesh_.triangle_bound(), false);
    for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) {
      if (!mesh_.alive(t) || (one_side_at_most >> mesh_.solid_sides(t) & 1U) == 0 || written[t]) continue;
      const std::size_t begin = size_;
      const WrittenStrip strip = write_from(t);
      written[strip.other_end] = true;
      if (!strip.wrong || strip.wrong_backwards) continue;
      size_ = begin;
      write_from(strip.other_end);
    }
    indices_.resize(size_);
    return std::move(indices_);
  }

 private:
  using Halfedge = typename Mesh::Halfedge;
  static constexpr std::size_t most_at_once = 4;              // a restart and a triangle
  static constexpr unsigned one_side_at_most = 0b0001'0111U;  // bit m: m has one bit or none
  static constexpr unsigned right = 1;                        // turns
  static constexpr unsigned left = 2;

  // `side`: up to 5.
  static Halfedge side_of(Triangle t, unsigned side) noexcept {
    return StripMesh::halfedge(t, side >= 3 ? side - 3 : side);
  }
  [[nodiscard]] std::uint32_t corner(Triangle t, unsigned side) const noexcept { return mesh_.from(side_of(t, side)); }
  // With room for what is written at once.
  std::uint32_t* indices(std::size_t size) {
    if (indices_.size() - size < most_at_once)
      indices_.resize(std::max(std::min(indices_.capacity(), size + 512), size + most_at_once));
    return indices_.data();
  }

  WrittenStrip write_from(Triangle t) {
    std::size_t size = size_;
    std::uint32_t* written = indices(size);
    if (size != 0) written[size++] = restart_index;
    const unsigned solid = mesh_.solid_sides(t);
    // The first triangle ends in the edge over which it is left.
    const unsigned first = solid == 0 ? 1 : static_cast<unsigned>(std::countr_zero(solid));
    for (const unsigned beyond : {2U, 0U, 1U}) written[size++] = corner(t, first + beyond);
    unsigned first_turn = 0;
    unsigned last_turn = 0;
    unsigned free_turn = left;
    Halfedge entry = solid == 0 ? Halfedge{} : mesh_.opposite(side_of(t, first));
    unsigned turn = solid;  // not 0 as long as the strip continues
    while (turn != 0) {
      written = indices(size);
      t = StripMesh::triangle(entry);
      const unsigned side = StripMesh::side(entry);
      turn = mesh_.other_solid_sides(entry);
      // The corner opposite the entry comes next; for a swap, the last but one comes again before it.
      const std::uint32_t third = corner(t, side + 2);
      if (turn == 0) {
        written[size++] = third;
        break;
      }
      written[size] = written[size - 2];
      size += static_cast<std::size_t>(turn != free_turn);
      written[size++] = third;
      free_turn = left + right - turn;
      first_turn = first_turn == 0 ? turn : first_turn;
      last_turn = turn;
      entry = mesh_.opposite(side_of(t, side + turn));
    }
    size_ = size;
    return {t, first_turn == right, last_turn == left};
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> indices_;
  std::size_t size_ = 0;
};

}  // namespace restrip::detail
