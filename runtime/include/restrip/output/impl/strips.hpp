// Colours to strips, function by function. Included by strips.hpp.
#pragma once

#include <algorithm>
#include <bit>
#include <numeric>

#include "restrip/mesh/invalid_coloring.hpp"
#include "restrip/output/strips.hpp"

namespace restrip {

namespace detail {

// The halfedge over which t is left for its neighbour u in the strip. Without a branch for each side: strips turn at
// random.
inline StripMesh::Halfedge exit_to(const StripMesh& mesh, Triangle t, Triangle u) noexcept {
  unsigned ways = 0;
  for (unsigned s = 0; s < 3; ++s)
    ways |= static_cast<unsigned>(StripMesh::triangle(mesh.opposite(StripMesh::halfedge(t, s))) == u) << s;
  ways &= mesh.solid_sides(t);
  return StripMesh::halfedge(t, ways != 0 ? static_cast<unsigned>(std::countr_zero(ways)) : 2);
}

inline std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t t) noexcept {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

inline constexpr const char* not_strips = "the strips are not those of the mesh as it is now";

// Are all triangles alive, and those that follow each other in a strip joined by a solid dual edge?
inline bool are_strips_of(const StripMesh& mesh, const Strips& strips) {
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const std::span<const Triangle> strip = strips[s];
    if (strip.empty()) return false;
    for (const Triangle t : strip)
      if (!mesh.alive(t)) return false;
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
      const StripMesh::Halfedge h = exit_to(mesh, strip[i], strip[i + 1]);
      if (!mesh.solid(h) || StripMesh::triangle(mesh.opposite(h)) != strip[i + 1]) return false;
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
template <class Visit>
void each_turn(const StripMesh& mesh, const Walk& walk, Visit&& turn) {
  if (walk.size() < 3) return;
  StripMesh::Halfedge entry = mesh.opposite(exit_to(mesh, walk[0], walk[1]));
  for (std::size_t i = 1; i + 1 < walk.size(); ++i) {
    const StripMesh::Halfedge exit = exit_to(mesh, walk[i], walk[i + 1]);
    turn(i, exit, !(StripMesh::next(entry) == exit));
    entry = mesh.opposite(exit);
  }
}

// Equal turns in a row cost a swap each, in either direction. A strip starts on an even place and is then free to turn
// left first; seen from its other end, its last turn is the first and has changed sides.
inline bool turns_left(const StripMesh& mesh, Triangle before, Triangle t, Triangle after) noexcept {
  return !(StripMesh::next(mesh.opposite(exit_to(mesh, before, t))) == exit_to(mesh, t, after));
}
inline bool is_shorter_backwards(const StripMesh& mesh, std::span<const Triangle> strip) noexcept {
  const std::size_t n = strip.size();
  return n >= 3 && !turns_left(mesh, strip[0], strip[1], strip[2]) &&
         !turns_left(mesh, strip[n - 3], strip[n - 2], strip[n - 1]);
}
inline std::size_t count_swaps(const StripMesh& mesh, std::span<const Triangle> strip) {
  std::size_t swaps = 0;
  bool last = false;  // the even place
  each_turn(mesh, {strip, is_shorter_backwards(mesh, strip)}, [&](std::size_t, StripMesh::Halfedge, bool left) {
    swaps += left == last ? 1U : 0U;
    last = left;
  });
  return swaps;
}

// Writes the indices of one strip, from the end that needs fewer.
inline void append_indices(const StripMesh& mesh, std::span<const Triangle> strip,
                           std::vector<std::uint32_t>& indices) {
  const Walk walk{strip, is_shorter_backwards(mesh, strip)};
  if (walk.size() == 1) {
    for (const Vertex v : mesh.corners(walk[0])) indices.push_back(v);
    return;
  }
  // The first triangle ends in the edge over which it is left.
  const StripMesh::Halfedge first = exit_to(mesh, walk[0], walk[1]);
  for (const Vertex v : {mesh.to(StripMesh::next(first)), mesh.from(first), mesh.to(first)}) indices.push_back(v);
  // Each further triangle has the last two indices a, b already and adds its third corner c; that leads over the edge
  // (b, c). To leave over (a, c), say a once more before c.
  bool free_turn_left = true;
  each_turn(mesh, walk, [&](std::size_t, StripMesh::Halfedge exit, bool left) {
    const Vertex a = indices[indices.size() - 2];
    if (left != free_turn_left) indices.push_back(a);
    indices.push_back(left ? mesh.from(exit) : mesh.to(exit));
    free_turn_left = !left;
  });
  const StripMesh::Halfedge into = mesh.opposite(exit_to(mesh, walk[walk.size() - 2], walk[walk.size() - 1]));
  indices.push_back(mesh.to(StripMesh::next(into)));
}

// Writes the strip that ends at t from there, as append_indices does, but follows the colours.
struct WrittenStrip {
  Triangle other_end;
  bool wrong;  // it began with a turn to the right
  bool wrong_backwards;
};
inline WrittenStrip append_from(const StripMesh& mesh, Triangle t, std::vector<std::uint32_t>& indices) {
  if (mesh.solid_sides(t) == 0) {
    for (const Vertex v : mesh.corners(t)) indices.push_back(v);
    return {t, false, false};
  }
  WrittenStrip strip{t, false, false};
  const StripMesh::Halfedge first =
      StripMesh::halfedge(t, static_cast<unsigned>(std::countr_zero(mesh.solid_sides(t))));
  for (const Vertex v : {mesh.to(StripMesh::next(first)), mesh.from(first), mesh.to(first)}) indices.push_back(v);
  StripMesh::Halfedge entry = mesh.opposite(first);
  bool begins = true;
  bool free_turn_left = true;
  for (;;) {
    const Triangle u = StripMesh::triangle(entry);
    const unsigned ways = mesh.solid_sides(u) & ~(1U << StripMesh::side(entry));
    if (ways == 0) break;
    const StripMesh::Halfedge exit = StripMesh::halfedge(u, static_cast<unsigned>(std::countr_zero(ways)));
    const bool left = !(StripMesh::next(entry) == exit);
    if (begins) strip.wrong = !left;
    begins = false;
    strip.wrong_backwards = left;
    const Vertex a = indices[indices.size() - 2];
    if (left != free_turn_left) indices.push_back(a);
    indices.push_back(left ? mesh.from(exit) : mesh.to(exit));
    free_turn_left = !left;
    entry = mesh.opposite(exit);
  }
  indices.push_back(mesh.to(StripMesh::next(entry)));
  strip.other_end = StripMesh::triangle(entry);
  return strip;
}

}  // namespace detail

inline ColoringReport check_coloring(const StripMesh& mesh) {
  ColoringReport report;
  std::vector<std::uint32_t> parent(mesh.triangle_bound());
  std::iota(parent.begin(), parent.end(), 0U);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    ++report.triangles;
    unsigned degree = 0;
    for (unsigned s = 0; s < 3; ++s) {
      const StripMesh::Halfedge h = StripMesh::halfedge(t, s);
      if (!mesh.solid(h)) continue;
      ++degree;
      const StripMesh::Halfedge back = mesh.opposite(h);
      if (!mesh.solid(back)) {
        ++report.one_sided;
      } else if (h.id < back.id) {
        const std::uint32_t a = detail::find_root(parent, t);
        const std::uint32_t b = detail::find_root(parent, StripMesh::triangle(back));
        report.solid_cycles += a == b ? 1U : 0U;
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
    report.over_degree += degree > 2 ? 1U : 0U;
    report.isolated += degree == 0 ? 1U : 0U;
  }
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) report.strips += mesh.alive(t) && parent[t] == t ? 1U : 0U;
  report.valid = report.one_sided + report.over_degree + report.solid_cycles == 0;
  return report;
}

inline std::size_t count_strips(const StripMesh& mesh) {
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t) && mesh.solid_degree(t) > 2) detail::throw_three_solid_edges();
  std::vector<bool> met(mesh.triangle_bound(), false);
  std::size_t strips = 0;
  std::size_t triangles = 0;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t) || met[t] || mesh.solid_degree(t) > 1) continue;
    ++strips;
    for (StripStep<StripMesh::Halfedge> at{true, StripMesh::halfedge(t, 3)}; at.goes_on; at = mesh.strip_step(at.in)) {
      met[StripMesh::triangle(at.in)] = true;
      ++triangles;
    }
  }
  // Where no triangle has three solid edges, a strip without an end is a cycle.
  if (triangles != mesh.triangle_count()) detail::throw_solid_cycle();
  return strips;
}

inline Strips extract_strips(const StripMesh& mesh) {
  Strips strips;
  strips.order.reserve(mesh.triangle_count());
  std::vector<bool> listed(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t) || listed[t] || mesh.solid_degree(t) > 1) continue;
    // Where the colouring is not valid a strip may come back to itself.
    StripStep<StripMesh::Halfedge> at{true, StripMesh::halfedge(t, 3)};
    for (; at.goes_on && !listed[StripMesh::triangle(at.in)]; at = mesh.strip_step(at.in)) {
      strips.order.push_back(StripMesh::triangle(at.in));
      listed[StripMesh::triangle(at.in)] = true;
    }
    strips.start.push_back(strips.order.size());
  }
  return strips;
}

inline std::size_t strip_index_count(const StripMesh& mesh, const Strips& strips) {
  RESTRIP_ASSERT(detail::are_strips_of(mesh, strips), "strip_index_count", detail::not_strips);
  std::size_t count = strips.order.size() + strips.size() * 2;
  for (std::size_t s = 0; s < strips.size(); ++s) count += detail::count_swaps(mesh, strips[s]);
  return strips.size() == 0 ? 0 : count + strips.size() - 1;
}

inline std::vector<std::uint32_t> strip_indices(const StripMesh& mesh) {
  RESTRIP_ASSERT(check_coloring(mesh).valid, "strip_indices", "the colouring is not valid");
  std::vector<std::uint32_t> indices;
  indices.reserve(mesh.triangle_count() + mesh.triangle_count() / 2);
  std::vector<bool> written(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t) || written[t] || mesh.solid_degree(t) > 1) continue;
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

inline std::vector<std::uint32_t> strip_indices(const StripMesh& mesh, const Strips& strips) {
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
