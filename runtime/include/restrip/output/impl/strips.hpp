// Colours to strips, function by function. Included by strips.hpp.
#pragma once

#include <algorithm>
#include <array>
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

// Writes strips one after the other, as strip_indices() promises. Equal turns in a row cost a swap each, in either
// direction. A strip starts on an even place and is then free to turn left first; seen from its other end, its last
// turn is the first and has changed sides. Strips turn at random, so no turn is a branch.
template <NumberedMesh Mesh>
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
  using Halfedge = typename Mesh::Halfedge;
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

  WrittenStrip write_from(Triangle t) {
    std::size_t size = size_;
    std::uint32_t* written = indices(size);
    if (size != 0) written[size++] = restart_index;
    Halfedge h = mesh_.halfedge(t);
    Halfedge exit = mesh_.next(h);
    bool joined = false;
    for (int side = 0; side < 3; ++side, h = mesh_.next(h)) {
      if (!mesh_.solid(h)) continue;
      exit = h;
      joined = true;
    }
    // The first triangle ends in the edge over which it is left.
    for (const std::uint32_t v : corners_from(mesh_, mesh_.next(mesh_.next(exit)))) written[size++] = v;
    unsigned first_turn = 0;
    unsigned last_turn = 0;
    for (unsigned free_turn = left; joined;) {
      written = indices(size);
      // A triangle entered over the halfedge `entry` is left over next(entry), a turn to the right, or over the third
      // side, a turn to the left. (Seen from outside, the strip comes in across `entry` from the right of its direction
      // to its left.)
      const Halfedge entry = mesh_.opposite(exit);
      const Halfedge after = mesh_.next(entry);
      const Halfedge before = mesh_.next(after);
      const unsigned turn = mesh_.other_solid_sides(entry);
      // The corner opposite the entry comes next; for a swap, the last but one comes again before it.
      if (turn == 0) {
        t = triangle_of(mesh_, entry);
        written[size++] = from_of(mesh_, before);
        joined = false;
        continue;
      }
      written[size] = written[size - 2];
      size += static_cast<std::size_t>(turn != free_turn);
      written[size++] = from_of(mesh_, before);
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
  std::size_t triangles = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t)) continue;
    if (mesh.solid_degree(t) > 2) detail::throw_three_solid_edges();
    ++triangles;
  }
  const Strips strips = extract_strips(mesh);
  // If no triangle has three solid edges, a strip without an end is a cycle.
  if (strips.order.size() != triangles) detail::throw_solid_cycle();
  return strips.size();
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
    if (!mesh.has_triangle(t) || listed[t] || mesh.solid_degree(t) > 1) continue;
    // In an invalid colouring a strip may return to itself.
    StripStep at{true, detail::into_end(mesh, t)};
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
  detail::StripWriter<Mesh> writer(mesh);
  std::vector<bool> written(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.has_triangle(t) && !written[t] && mesh.solid_degree(t) <= 1) written[writer.write(t, false)] = true;
  return writer.take();
}

template <NumberedMesh Mesh>
std::vector<std::uint32_t> strip_indices(const Mesh& mesh, const Strips& strips) {
  RESTRIP_ASSERT(detail::are_strips_of(mesh, strips), "strip_indices", detail::not_strips);
  detail::StripWriter<Mesh> writer(mesh);
  for (std::size_t s = 0; s < strips.size(); ++s) writer.write(strips[s].front(), strips.directed);
  return writer.take();
}

}  // namespace restrip
