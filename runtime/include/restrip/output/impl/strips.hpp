// Colours to strips, function by function. Included by strips.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace detail {

// For colourings that turn out not to be valid while they are read.
[[noreturn]] inline void throw_three_solid_edges() {
  RESTRIP_THROW(std::invalid_argument, "restrip: the colouring is not valid: a triangle has three solid dual edges");
}
[[noreturn]] inline void throw_solid_cycle() {
  RESTRIP_THROW(std::invalid_argument, "restrip: the colouring is not valid: solid dual edges close a cycle");
}

template <NumberedMesh Mesh>
Triangle triangle_of(const Mesh& mesh, typename Mesh::Halfedge h) {
  return static_cast<Triangle>(mesh.triangle(h));
}
template <NumberedMesh Mesh>
std::uint32_t from_of(const Mesh& mesh, typename Mesh::Halfedge h) {
  return static_cast<std::uint32_t>(mesh.from(h));
}

// A halfedge of t to start strip_step() from, if t ends a strip.
template <NumberedMesh Mesh>
typename Mesh::Halfedge into_end(const Mesh& mesh, Triangle t) {
  const auto h = mesh.halfedge(t);
  return mesh.solid(h) ? mesh.next(h) : h;
}

// The halfedge over which t is left for its neighbour u in the strip.
template <NumberedMesh Mesh>
typename Mesh::Halfedge exit_to(const Mesh& mesh, Triangle t, Triangle u) {
  auto h = mesh.halfedge(t);
  for (int side = 0; side < 2; ++side, h = mesh.next(h))
    if (mesh.solid(h) && triangle_of(mesh, mesh.opposite(h)) == u) break;
  return h;
}

// The vertices of a triangle, from the one that h leaves.
template <NumberedMesh Mesh>
std::array<std::uint32_t, 3> corners_from(const Mesh& mesh, typename Mesh::Halfedge h) {
  const auto second = mesh.next(h);
  return {from_of(mesh, h), from_of(mesh, second), from_of(mesh, mesh.next(second))};
}

inline constexpr const char* not_strips = "these are not the strips of the mesh as it is now";

// Whether all triangles are alive, and consecutive triangles of a strip are joined by a solid dual edge.
template <NumberedMesh Mesh>
bool are_strips_of(const Mesh& mesh, const Strips& strips) {
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const std::span<const Triangle> strip = strips[s];
    if (strip.empty()) return false;
    for (const Triangle t : strip)
      if (t >= mesh.triangle_bound() || !mesh.has_triangle(t)) return false;
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
      const auto h = exit_to(mesh, strip[i], strip[i + 1]);
      if (!mesh.solid(h) || triangle_of(mesh, mesh.opposite(h)) != strip[i + 1]) return false;
    }
  }
  return true;
}

// Writes all strips, as strip_indices() promises, of a mesh that returns turns as StripMesh::other_solid_sides does.
// Branch-free: turns are unpredictable.
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
  // The result of writing a strip from one end.
  struct WrittenStrip {
    Triangle other_end;
    bool wrong;  // it began with a turn to the right
    bool wrong_backwards;
  };
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
      indices_.resize((std::max)((std::min)(indices_.capacity(), size + 512), size + most_at_once));
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

}  // namespace detail

template <NumberedMesh Mesh>
ColoringReport check_coloring(const Mesh& mesh) {
  ColoringReport report;
  std::vector<std::uint32_t> parent(mesh.triangle_bound());
  std::iota(parent.begin(), parent.end(), 0U);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t)) continue;
    ++report.triangles;
    unsigned degree = 0;
    auto h = mesh.halfedge(t);
    for (int side = 0; side < 3; ++side, h = mesh.next(h)) {
      if (!mesh.solid(h)) continue;
      ++degree;
      const auto back = mesh.opposite(h);
      if (!mesh.solid(back)) {
        ++report.one_sided;
      } else if (const Triangle u = detail::triangle_of(mesh, back); t < u) {
        const std::uint32_t a = detail::find_root(parent, t);
        const std::uint32_t b = detail::find_root(parent, u);
        report.solid_cycles += a == b ? 1U : 0U;
        parent[(std::max)(a, b)] = (std::min)(a, b);
      }
    }
    report.over_degree += degree > 2 ? 1U : 0U;
    report.isolated += degree == 0 ? 1U : 0U;
  }
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    report.strips += mesh.has_triangle(t) && parent[t] == t ? 1U : 0U;
  report.valid = report.one_sided + report.over_degree + report.solid_cycles == 0;
  return report;
}

template <NumberedMesh Mesh>
std::size_t count_strips(const Mesh& mesh) {
  std::size_t left = 0;  // triangles of no strip so far
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t)) continue;
    if (detail::solid_degree(mesh, mesh.halfedge(t)) > 2) detail::throw_three_solid_edges();
    ++left;
  }
  std::vector<bool> met(mesh.triangle_bound(), false);
  std::size_t strips = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t) || met[t] || detail::solid_degree(mesh, mesh.halfedge(t)) > 1) continue;
    ++strips;
    for (StripStep<typename Mesh::Halfedge> at{true, detail::into_end(mesh, t)}; at.continues;
         at = strip_step(mesh, at.in)) {
      met[detail::triangle_of(mesh, at.in)] = true;
      --left;
    }
  }
  // If no triangle has three solid edges, a strip without an end is a cycle.
  if (left != 0) detail::throw_solid_cycle();
  return strips;
}

template <NumberedMesh Mesh>
std::size_t count_swaps(const Mesh& mesh) {
  std::size_t sides = 0;  // each swap has two
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t)) continue;
    auto h = mesh.halfedge(t);
    for (int side = 0; side < 3; ++side, h = mesh.next(h)) sides += mesh.solid(h) && is_swap(mesh, h) ? 1U : 0U;
  }
  return sides / 2;
}

template <NumberedMesh Mesh>
Strips extract_strips(const Mesh& mesh) {
  Strips strips;
  strips.order.reserve(mesh.triangle_bound());
  std::vector<bool> listed(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t) || listed[t] || detail::solid_degree(mesh, mesh.halfedge(t)) > 1) continue;
    // In an invalid colouring a strip may return to itself.
    StripStep<typename Mesh::Halfedge> at{true, detail::into_end(mesh, t)};
    for (; at.continues && !listed[detail::triangle_of(mesh, at.in)]; at = strip_step(mesh, at.in)) {
      strips.order.push_back(detail::triangle_of(mesh, at.in));
      listed[detail::triangle_of(mesh, at.in)] = true;
    }
    strips.start.push_back(strips.order.size());
  }
  return strips;
}

template <NumberedMesh Mesh>
std::size_t strip_index_count(const Mesh& mesh, const Strips& strips) {
  RESTRIP_ASSERT(detail::are_strips_of(mesh, strips), "strip_index_count", detail::not_strips);
  return strip_indices(mesh, strips).size();
}

template <NumberedMesh Mesh>
std::vector<std::uint32_t> strip_indices(const Mesh& mesh) {
  RESTRIP_ASSERT(check_coloring(mesh).valid, "strip_indices", "the colouring is not valid");
  if constexpr (std::same_as<Mesh, StripMesh>)
    return detail::SidedWriter(mesh).run();
  else
    return strip_indices(mesh, extract_strips(mesh));
}

template <NumberedMesh Mesh>
std::vector<std::uint32_t> strip_indices(const Mesh& mesh, const Strips& strips) {
  RESTRIP_ASSERT(detail::are_strips_of(mesh, strips), "strip_indices", detail::not_strips);
  std::vector<std::uint32_t> indices;
  indices.reserve(strips.order.size() + strips.order.size() / 2);
  for (std::size_t s = 0; s < strips.size(); ++s) {
    if (s != 0) indices.push_back(restart_index);
    const std::span<const Triangle> strip = strips[s];
    const std::size_t n = strip.size();
    // Equal turns in a row cost a swap each, in either direction. A strip starts on an even place and is then free to
    // turn left first; seen from its other end, its last turn is the first and has changed sides.
    const auto turns_right = [&](std::size_t i) {
      return mesh.next(mesh.opposite(detail::exit_to(mesh, strip[i - 1], strip[i]))) ==
             detail::exit_to(mesh, strip[i], strip[i + 1]);
    };
    const bool backwards = n >= 3 && turns_right(1) && turns_right(n - 2);
    const auto exit_of = [&](std::size_t i) {
      return backwards ? detail::exit_to(mesh, strip[n - 1 - i], strip[n - 2 - i])
                       : detail::exit_to(mesh, strip[i], strip[i + 1]);
    };
    // The first triangle ends in the edge over which it is left.
    auto exit = n == 1 ? mesh.next(mesh.halfedge(strip[0])) : exit_of(0);
    const auto corners = detail::corners_from(mesh, mesh.next(mesh.next(exit)));
    indices.insert(indices.end(), corners.begin(), corners.end());
    if (n == 1) continue;
    // Each further triangle has the last two indices a, b and adds its third corner c, which leads over the edge (b,
    // c). To leave over (a, c), a is repeated before c. A triangle entered over the halfedge `entry` is left over
    // next(entry), a turn to the right, or over the third side, a turn to the left. (Seen from outside, the strip comes
    // in across `entry` from the right of its direction to its left.)
    auto entry = mesh.opposite(exit);
    bool free_turn_left = true;
    for (std::size_t i = 1; i + 1 < n; ++i) {
      exit = exit_of(i);
      const bool left = !(mesh.next(entry) == exit);
      const std::uint32_t a = indices[indices.size() - 2];
      if (left != free_turn_left) indices.push_back(a);
      indices.push_back(detail::from_of(mesh, left ? exit : mesh.next(exit)));
      free_turn_left = !left;
      entry = mesh.opposite(exit);
    }
    indices.push_back(detail::from_of(mesh, mesh.next(mesh.next(entry))));
  }
  return indices;
}

}  // namespace restrip
