// From colours to strips, and to indices.
//
// Outline. A strip is walked from one of its ends, triangle by triangle over solid dual edges. check_coloring() does
// not walk: it joins the two triangles of each solid edge in a union-find structure, in which an edge within one
// component closes a cycle. StripWriter writes a strip in one walk and counts nothing in advance: it begins at an even
// place, is free to turn left first, repeats an index for each turn that equals the one before it, and writes the strip
// again from its other end if that saves an index.
//
// Cost: linear; check_coloring() close to it.
#include "restrip/output/strips.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "output/strip_writer.hpp"
#include "restrip/mesh/cost.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

namespace {

Triangle root_of(std::vector<Triangle>& parent, Triangle t) noexcept {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

// A halfedge of t to start strip_step() from, if t ends a strip.
StripMesh::Halfedge into_end(const StripMesh& mesh, Triangle t) {
  const auto h = StripMesh::halfedge(t);
  return mesh.solid(h) ? StripMesh::next(h) : h;
}

// The halfedge over which t is left for its neighbour u in the strip.
StripMesh::Halfedge exit_to(const StripMesh& mesh, Triangle t, Triangle u) {
  auto h = StripMesh::halfedge(t);
  for (int side = 0; side < 2; ++side, h = StripMesh::next(h))
    if (mesh.solid(h) && StripMesh::triangle(mesh.opposite(h)) == u) break;
  return h;
}

[[maybe_unused]] constexpr const char* not_strips_of_mesh = "these are not the strips of the mesh as it is now";

// Whether all triangles are alive, and consecutive triangles of a strip are joined by a solid dual edge.
[[maybe_unused]] bool are_strips_of(const StripMesh& mesh, const Strips& strips) {
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const std::span<const Triangle> strip = strips[s];
    if (strip.empty()) return false;
    for (const Triangle t : strip)
      if (t >= mesh.triangle_bound() || !mesh.alive(t)) return false;
    for (std::size_t i = 0; i + 1 < strip.size(); ++i) {
      const auto h = exit_to(mesh, strip[i], strip[i + 1]);
      if (!mesh.solid(h) || StripMesh::triangle(mesh.opposite(h)) != strip[i + 1]) return false;
    }
  }
  return true;
}

}  // namespace

ColoringReport check_coloring(const StripMesh& mesh) {
  ColoringReport report;
  std::vector<std::uint32_t> parent(mesh.triangle_bound());
  std::iota(parent.begin(), parent.end(), 0U);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    ++report.triangles;
    unsigned degree = 0;
    auto h = StripMesh::halfedge(t);
    for (int side = 0; side < 3; ++side, h = StripMesh::next(h)) {
      if (!mesh.solid(h)) continue;
      ++degree;
      const auto back = mesh.opposite(h);
      if (!mesh.solid(back)) {
        ++report.one_sided;
      } else if (const Triangle u = StripMesh::triangle(back); t < u) {
        const std::uint32_t a = root_of(parent, t);
        const std::uint32_t b = root_of(parent, u);
        report.solid_cycles += a == b ? 1U : 0U;
        parent[(std::max)(a, b)] = (std::min)(a, b);
      }
    }
    report.over_degree += degree > 2 ? 1U : 0U;
    report.isolated += degree == 0 ? 1U : 0U;
  }
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) report.strips += mesh.alive(t) && parent[t] == t ? 1U : 0U;
  report.valid = report.one_sided + report.over_degree + report.solid_cycles == 0;
  return report;
}

Strips detail::valid_strips(const StripMesh& mesh) {
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t) && mesh.solid_degree(t) > 2)
      RESTRIP_THROW(std::invalid_argument,
                    "restrip: the colouring is not valid: a triangle has three solid dual edges");
  Strips strips = extract_strips(mesh);
  // If no triangle has three solid edges, a strip without an end is a cycle.
  if (strips.order.size() != mesh.triangle_count())
    RESTRIP_THROW(std::invalid_argument, "restrip: the colouring is not valid: solid dual edges close a cycle");
  return strips;
}

std::size_t count_strips(const StripMesh& mesh) { return detail::valid_strips(mesh).size(); }

std::size_t count_swaps(const StripMesh& mesh) {
  std::size_t sides = 0;  // each swap has two
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    auto h = StripMesh::halfedge(t);
    for (int side = 0; side < 3; ++side, h = StripMesh::next(h)) sides += mesh.solid(h) && is_swap(mesh, h) ? 1U : 0U;
  }
  return sides / 2;
}

Strips extract_strips(const StripMesh& mesh) {
  Strips strips;
  strips.order.reserve(mesh.triangle_bound());
  std::vector<bool> listed(mesh.triangle_bound(), false);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t) || listed[t] || mesh.solid_degree(t) > 1) continue;
    // In an invalid colouring a strip may return to itself.
    StripStep at{true, into_end(mesh, t)};
    for (; at.continues && !listed[StripMesh::triangle(at.in)]; at = mesh.strip_step(at.in)) {
      strips.order.push_back(StripMesh::triangle(at.in));
      listed[StripMesh::triangle(at.in)] = true;
    }
    strips.start.push_back(strips.order.size());
  }
  return strips;
}

std::size_t strip_index_count(const StripMesh& mesh, const Strips& strips) {
  RESTRIP_ASSERT(are_strips_of(mesh, strips), "strip_index_count", not_strips_of_mesh);
  return strip_indices(mesh, strips).size();
}

std::vector<std::uint32_t> strip_indices(const StripMesh& mesh) {
  RESTRIP_ASSERT(check_coloring(mesh).valid, "strip_indices", "the colouring is not valid");
  return detail::indices_of_strips(mesh);
}

std::vector<std::uint32_t> strip_indices(const StripMesh& mesh, const Strips& strips) {
  RESTRIP_ASSERT(are_strips_of(mesh, strips), "strip_indices", not_strips_of_mesh);
  detail::StripWriter<StripMesh> writer(mesh);
  for (std::size_t s = 0; s < strips.size(); ++s) writer.write(strips[s].front(), strips.directed);
  return writer.take();
}

}  // namespace restrip
