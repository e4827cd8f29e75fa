// Colours to strips, function by function. Included by strips.hpp.
#pragma once

#include <algorithm>
#include <bit>
#include <numeric>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/invalid_coloring.hpp"
#include "restrip/output/impl/sided_writer.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

namespace detail {

// Reads strips. A StripMesh does this without a branch for each side: strips turn at random.

template <NumberedMesh Mesh>
Triangle triangle_of(const Mesh& mesh, typename Mesh::Halfedge h) {
  return static_cast<Triangle>(mesh.triangle(h));
}
template <NumberedMesh Mesh>
std::uint32_t from_of(const Mesh& mesh, typename Mesh::Halfedge h) {
  return static_cast<std::uint32_t>(mesh.from(h));
}

template <NumberedMesh Mesh>
std::size_t count_triangles(const Mesh& mesh) {
  std::size_t count = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) count += mesh.has_triangle(t) ? 1U : 0U;
  return count;
}
inline std::size_t count_triangles(const StripMesh& mesh) noexcept { return mesh.triangle_count(); }

// Solid dual edges of t.
template <NumberedMesh Mesh>
unsigned solid_degree(const Mesh& mesh, Triangle t) {
  const auto h = mesh.halfedge(t);
  const auto next = mesh.next(h);
  return (mesh.solid(h) ? 1U : 0U) + (mesh.solid(next) ? 1U : 0U) + (mesh.solid(mesh.next(next)) ? 1U : 0U);
}
inline unsigned solid_degree(const StripMesh& mesh, Triangle t) noexcept { return mesh.solid_degree(t); }

// A halfedge of t to start strip_step() from, if t ends a strip.
template <NumberedMesh Mesh>
typename Mesh::Halfedge into_end(const Mesh& mesh, Triangle t) {
  const auto h = mesh.halfedge(t);
  return mesh.solid(h) ? mesh.next(h) : h;
}
inline StripMesh::Halfedge into_end(const StripMesh& /*mesh*/, Triangle t) noexcept {
  return StripMesh::halfedge(t, 3);
}

// The first solid halfedge of t, which has one.
template <NumberedMesh Mesh>
typename Mesh::Halfedge first_exit(const Mesh& mesh, Triangle t) {
  auto h = mesh.halfedge(t);
  if (!mesh.solid(h)) h = mesh.next(h);
  return mesh.solid(h) ? h : mesh.next(h);
}
// The halfedge over which the strip that enters over `entry` continues; `entry` if it ends.
template <NumberedMesh Mesh>
typename Mesh::Halfedge exit_behind(const Mesh& mesh, typename Mesh::Halfedge entry) {
  const auto right = mesh.next(entry);
  if (mesh.solid(right)) return right;
  const auto left = mesh.next(right);
  return mesh.solid(left) ? left : entry;
}
// The halfedge over which t is left for its neighbour u in the strip.
template <NumberedMesh Mesh>
typename Mesh::Halfedge exit_to(const Mesh& mesh, Triangle t, Triangle u) {
  auto h = mesh.halfedge(t);
  for (int side = 0; side < 2; ++side, h = mesh.next(h))
    if (mesh.solid(h) && triangle_of(mesh, mesh.opposite(h)) == u) break;
  return h;
}
inline StripMesh::Halfedge exit_to(const StripMesh& mesh, Triangle t, Triangle u) noexcept {
  unsigned ways = 0;
  for (unsigned s = 0; s < 3; ++s)
    ways |= static_cast<unsigned>(StripMesh::triangle(mesh.opposite(StripMesh::halfedge(t, s))) == u) << s;
  ways &= mesh.solid_sides(t);
  return StripMesh::halfedge(t, ways != 0 ? static_cast<unsigned>(std::countr_zero(ways)) : 2);
}

// Writes the three vertices of a triangle, from the one that h leaves.
template <NumberedMesh Mesh>
void append_corners(const Mesh& mesh, typename Mesh::Halfedge h, std::vector<std::uint32_t>& indices) {
  for (int corner = 0; corner < 3; ++corner, h = mesh.next(h)) indices.push_back(from_of(mesh, h));
}

inline std::uint32_t find_root(std::vector<std::uint32_t>& parent, Triangle t) noexcept {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
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

// A way through a strip: forwards or backwards.
struct Walk {
  std::span<const Triangle> triangles;
  bool backwards = false;
  [[nodiscard]] std::size_t size() const noexcept { return triangles.size(); }
  [[nodiscard]] Triangle operator[](std::size_t i) const noexcept {
    return triangles[backwards ? triangles.size() - 1 - i : i];
  }
};

// Calls turn(i, exit, left) for each triangle i between the two ends of the walk. A triangle entered over the halfedge
// e is left over next(e), a turn to the right, or over the third side, a turn to the left. (Seen from outside, the
// strip comes in across e from the right of e's direction to its left.)
template <NumberedMesh Mesh, class Visit>
void each_turn(const Mesh& mesh, const Walk& walk, Visit&& turn) {
  if (walk.size() < 3) return;
  auto entry = mesh.opposite(exit_to(mesh, walk[0], walk[1]));
  for (std::size_t i = 1; i + 1 < walk.size(); ++i) {
    const auto exit = exit_to(mesh, walk[i], walk[i + 1]);
    turn(i, exit, !(mesh.next(entry) == exit));
    entry = mesh.opposite(exit);
  }
}

// Equal turns in a row cost a swap each, in either direction. A strip starts on an even place and is then free to turn
// left first; seen from its other end, its last turn is the first and has changed sides.
template <NumberedMesh Mesh>
bool turns_left(const Mesh& mesh, Triangle before, Triangle t, Triangle after) {
  return !(mesh.next(mesh.opposite(exit_to(mesh, before, t))) == exit_to(mesh, t, after));
}
template <NumberedMesh Mesh>
bool is_shorter_backwards(const Mesh& mesh, std::span<const Triangle> strip) {
  const std::size_t n = strip.size();
  return n >= 3 && !turns_left(mesh, strip[0], strip[1], strip[2]) &&
         !turns_left(mesh, strip[n - 3], strip[n - 2], strip[n - 1]);
}
template <NumberedMesh Mesh>
std::size_t count_swaps(const Mesh& mesh, std::span<const Triangle> strip) {
  std::size_t swaps = 0;
  bool last = false;  // the even place
  each_turn(mesh, {strip, is_shorter_backwards(mesh, strip)}, [&](std::size_t, typename Mesh::Halfedge, bool left) {
    swaps += left == last ? 1U : 0U;
    last = left;
  });
  return swaps;
}

// Writes the indices of one strip, from the end that needs fewer.
template <NumberedMesh Mesh>
void append_indices(const Mesh& mesh, std::span<const Triangle> strip, std::vector<std::uint32_t>& indices) {
  const Walk walk{strip, is_shorter_backwards(mesh, strip)};
  if (walk.size() == 1) {
    append_corners(mesh, mesh.halfedge(walk[0]), indices);
    return;
  }
  // The first triangle ends in the edge over which it is left.
  const auto first = exit_to(mesh, walk[0], walk[1]);
  append_corners(mesh, mesh.next(mesh.next(first)), indices);
  // Each further triangle has the last two indices a, b and adds its third corner c, which leads over the edge (b, c).
  // To leave over (a, c), a is repeated before c.
  bool free_turn_left = true;
  each_turn(mesh, walk, [&](std::size_t, typename Mesh::Halfedge exit, bool left) {
    const std::uint32_t a = indices[indices.size() - 2];
    if (left != free_turn_left) indices.push_back(a);
    indices.push_back(from_of(mesh, left ? exit : mesh.next(exit)));
    free_turn_left = !left;
  });
  const auto into = mesh.opposite(exit_to(mesh, walk[walk.size() - 2], walk[walk.size() - 1]));
  indices.push_back(from_of(mesh, mesh.next(mesh.next(into))));
}

// Writes the strip that ends at t from there, as append_indices does, but follows the colours.
template <NumberedMesh Mesh>
WrittenStrip append_from(const Mesh& mesh, Triangle t, std::vector<std::uint32_t>& indices) {
  if (solid_degree(mesh, t) == 0) {
    append_corners(mesh, mesh.halfedge(t), indices);
    return {t, false, false};
  }
  WrittenStrip strip{t, false, false};
  const auto first = first_exit(mesh, t);
  append_corners(mesh, mesh.next(mesh.next(first)), indices);
  auto entry = mesh.opposite(first);
  bool begins = true;
  bool free_turn_left = true;
  for (;;) {
    const auto exit = exit_behind(mesh, entry);
    if (exit == entry) break;
    const bool left = !(mesh.next(entry) == exit);
    if (begins) strip.wrong = !left;
    begins = false;
    strip.wrong_backwards = left;
    const std::uint32_t a = indices[indices.size() - 2];
    if (left != free_turn_left) indices.push_back(a);
    indices.push_back(from_of(mesh, left ? exit : mesh.next(exit)));
    free_turn_left = !left;
    entry = mesh.opposite(exit);
  }
  indices.push_back(from_of(mesh, mesh.next(mesh.next(entry))));
  strip.other_end = triangle_of(mesh, entry);
  return strip;
}

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
        parent[std::max(a, b)] = std::min(a, b);
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
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.has_triangle(t) && detail::solid_degree(mesh, t) > 2) detail::throw_three_solid_edges();
  std::vector<bool> met(mesh.triangle_bound(), false);
  std::size_t strips = 0;
  std::size_t triangles = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t) || met[t] || detail::solid_degree(mesh, t) > 1) continue;
    ++strips;
    for (StripStep<typename Mesh::Halfedge> at{true, detail::into_end(mesh, t)}; at.goes_on;
         at = strip_step(mesh, at.in)) {
      met[detail::triangle_of(mesh, at.in)] = true;
      ++triangles;
    }
  }
  // If no triangle has three solid edges, a strip without an end is a cycle.
  if (triangles != detail::count_triangles(mesh)) detail::throw_solid_cycle();
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
  strips.order.reserve(detail::count_triangles(mesh));
  std::vector<bool> listed(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t) || listed[t] || detail::solid_degree(mesh, t) > 1) continue;
    // In an invalid colouring a strip may return to itself.
    StripStep<typename Mesh::Halfedge> at{true, detail::into_end(mesh, t)};
    for (; at.goes_on && !listed[detail::triangle_of(mesh, at.in)]; at = strip_step(mesh, at.in)) {
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
  std::size_t count = strips.order.size() + strips.size() * 2;
  for (std::size_t s = 0; s < strips.size(); ++s) count += detail::count_swaps(mesh, strips[s]);
  return strips.size() == 0 ? 0 : count + strips.size() - 1;
}

template <NumberedMesh Mesh>
std::vector<std::uint32_t> strip_indices(const Mesh& mesh) {
  RESTRIP_ASSERT(check_coloring(mesh).valid, "strip_indices", "the colouring is not valid");
  if constexpr (std::same_as<Mesh, StripMesh>) return detail::SidedWriter(mesh).run();
  std::vector<std::uint32_t> indices;
  const std::size_t triangles = detail::count_triangles(mesh);
  indices.reserve(triangles + triangles / 2);
  std::vector<bool> written(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.has_triangle(t) || written[t] || detail::solid_degree(mesh, t) > 1) continue;
    if (!indices.empty()) indices.push_back(restart_index);
    const std::size_t begin = indices.size();
    const detail::WrittenStrip strip = detail::append_from(mesh, t, indices);
    written[strip.other_end] = true;
    if (!strip.wrong || strip.wrong_backwards) continue;
    indices.resize(begin);
    detail::append_from(mesh, strip.other_end, indices);
  }
  return indices;
}

template <NumberedMesh Mesh>
std::vector<std::uint32_t> strip_indices(const Mesh& mesh, const Strips& strips) {
  RESTRIP_ASSERT(detail::are_strips_of(mesh, strips), "strip_indices", detail::not_strips);
  std::vector<std::uint32_t> indices;
  indices.reserve(strip_index_count(mesh, strips));
  for (std::size_t s = 0; s < strips.size(); ++s) {
    if (s != 0) indices.push_back(restart_index);
    detail::append_indices(mesh, strips[s], indices);
  }
  return indices;
}

}  // namespace restrip
