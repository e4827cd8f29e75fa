#include "lod/coloring_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/counted.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"

namespace restrip::tools {
namespace {

const char* fault_of_triangle(const StripMesh& mesh, Triangle t) {
  for (unsigned side = 0; side < 3; ++side) {
    const StripMesh::Halfedge h = StripMesh::halfedge(t, side);
    const StripMesh::Halfedge opposite = mesh.opposite(h);
    if (StripMesh::on_boundary(opposite)) {
      if (mesh.solid(h)) return "a boundary edge is solid";
      continue;
    }
    if (!mesh.alive(opposite)) return "a triangle is linked to a triangle that is not there";
    if (!(mesh.opposite(opposite) == h)) return "a link does not lead back";
    if (mesh.from(opposite) != mesh.to(h) || mesh.to(opposite) != mesh.from(h))
      return "neighbours disagree on the vertices of their edge";
    if (mesh.solid(opposite) != mesh.solid(h)) return "neighbours disagree on the colour of their edge";
  }
  return mesh.solid_degree(t) > 2 ? "a triangle has three solid edges" : nullptr;
}

/// Leaves t over its first solid edge and follows the strip; true if it returns to t.
bool on_short_cycle(const StripMesh& mesh, Triangle t) {
  StripMesh::Halfedge out{none};
  for (unsigned side = 0; side < 3; ++side)
    if (mesh.solid(StripMesh::halfedge(t, side))) out = StripMesh::halfedge(t, side);
  for (std::size_t steps = 0; out.id != none && steps < farthest_cycle; ++steps) {
    const StripMesh::Halfedge in = mesh.opposite(out);
    if (StripMesh::triangle(in) == t) return true;
    const StripMesh::Halfedge second = StripMesh::next(in);
    const StripMesh::Halfedge third = StripMesh::next(second);
    out = mesh.solid(second) ? second : mesh.solid(third) ? third : StripMesh::Halfedge{none};
  }
  return false;
}

}  // namespace

std::vector<Corners> corners_of(const StripMesh& mesh) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangle_count());
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    if (mesh.alive(t)) triangles.push_back(mesh.corners(t));
  return triangles;
}

std::vector<Corners> sorted_triangles(std::vector<Corners> triangles) {
  std::erase_if(triangles, degenerate);
  for (Corners& t : triangles) t = rotated(t);
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

std::vector<Corners> decode_strips(std::span<const std::uint32_t> indices) {
  std::vector<Corners> triangles;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == restart_index) {
      begin = i + 1;
      continue;
    }
    if (i - begin < 2) continue;
    Corners t{indices[i - 2], indices[i - 1], indices[i]};
    if ((i - begin) % 2 == 1) std::swap(t[0], t[1]);
    if (!degenerate(t)) triangles.push_back(t);
  }
  return triangles;
}

std::vector<std::string> find_faults(const StripMesh& mesh) {
  std::vector<std::string> faults;
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
    if (!mesh.alive(t)) continue;
    if (const char* fault = fault_of_triangle(mesh, t)) {
      faults.push_back(fmt::format("triangle {}: {}", t, fault));
      break;  // one is enough; later ones may follow from it
    }
  }
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v) {
    const StripMesh::Halfedge first = mesh.spoke(v);
    if (first.id == none) continue;
    if (!mesh.alive(first) || mesh.from(first) != v || StripMesh::on_boundary(first)) {
      faults.push_back(fmt::format("vertex {}: its first spoke does not leave it", v));
      break;
    }
  }
  if (!faults.empty()) return faults;
  // One-sided edges and degrees above two are among the faults of triangles.
  if (const std::size_t cycles = check_coloring(mesh).solid_cycles; cycles != 0)
    faults.push_back(counted(cycles, "solid cycle"));
  return faults;
}

std::string find_fault(const Keeper& keeper) {
  const StripMesh& mesh = keeper.mesh();
  const Strips strips = extract_strips(mesh);
  std::size_t swaps = 0;
  std::size_t isolated = 0;
  for (std::size_t s = 0; s < strips.size(); ++s) {
    const auto strip = strips[s];
    isolated += static_cast<std::size_t>(strip.size() == 1);
    const auto edge_after = [&](std::size_t i) {
      for (unsigned side = 0;; ++side) {
        const StripMesh::Halfedge h = StripMesh::halfedge(strip[i], side);
        if (mesh.solid(h) && StripMesh::triangle(mesh.opposite(h)) == strip[i + 1])
          return std::pair{mesh.from(h), mesh.to(h)};
      }
    };
    // Triangles i - 1, i and i + 1 of a strip share a vertex, around which the strip turns at i. Two consecutive turns
    // around the same vertex are a swap.
    Vertex last = none;
    for (std::size_t i = 1; i + 1 < strip.size(); ++i) {
      const auto in = edge_after(i - 1);
      const auto out = edge_after(i);
      const Vertex around = in.first == out.first || in.first == out.second ? in.first : in.second;
      swaps += static_cast<std::size_t>(around == last);
      last = around;
    }
  }
  const auto differ = [](const char* what, std::size_t counted, std::size_t kept) {
    return counted == kept ? std::string() : fmt::format("{} {}, but the keeper says {}", counted, what, kept);
  };
  return differ("strips", strips.size(), keeper.strips()) + differ("swaps", swaps, keeper.swaps()) +
         differ("isolated triangles", isolated, keeper.isolated());
}

std::string find_fault_around(const StripMesh& mesh, Vertex v) {
  const StripMesh::Halfedge first = mesh.spoke(v);
  if (first.id == none) return {};
  StripMesh::Halfedge h = first;
  do {
    if (!mesh.alive(h) || mesh.from(h) != v) return fmt::format("vertex {}: a spoke does not leave it", v);
    const Triangle t = StripMesh::triangle(h);
    if (const char* fault = fault_of_triangle(mesh, t)) return fmt::format("vertex {}, triangle {}: {}", v, t, fault);
    if (on_short_cycle(mesh, t)) return fmt::format("vertex {}, triangle {}: its strip is a cycle", v, t);
    h = turn_ccw(mesh, h);
  } while (!(h == first) && !StripMesh::on_boundary(h));
  return {};
}

}  // namespace restrip::tools
