#include "simplify.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cmath>

#include "progress.hpp"
#include "restrip/checks.hpp"
#include "restrip/strip_mesh.hpp"

namespace restrip::replay {
namespace {

using KernelMesh = OpenMesh::TriMesh_ArrayKernelT<>;

/// The fans of a mesh as vertices of another: what is one vertex of several fans here are several vertices there.
/// Returns for each corner 3 t + s of each triangle its fan, and for each fan its vertex.
struct Fans {
  std::vector<std::uint32_t> of_corner;
  std::vector<Vertex> vertex;
};

Fans fans_of(const StripMesh& mesh) {
  Fans fans;
  fans.of_corner.assign(3 * mesh.triangle_bound(), none);
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
    for (unsigned side = 0; side < 3; ++side) {
      if (fans.of_corner[3 * t + side] != none) continue;
      const auto fan = static_cast<std::uint32_t>(fans.vertex.size());
      StripMesh::Halfedge first = StripMesh::halfedge(t, side);
      fans.vertex.push_back(mesh.from(first));
      const StripMesh::Halfedge start = first;
      while (!StripMesh::on_boundary(mesh.opposite(first))) {
        first = turn_cw(mesh, first);
        if (first == start) break;
      }
      StripMesh::Halfedge h = first;
      do {
        fans.of_corner[3 * StripMesh::triangle(h) + StripMesh::side(h)] = fan;
        h = turn_ccw(mesh, h);
      } while (!(h == first) && !StripMesh::on_boundary(h));
    }
  return fans;
}

/// OpenMesh's mesh with two members hidden by ours. The decimater is a template and calls them by name: so it never
/// considers an edge that StripMesh refuses, and every collapse is done on both meshes and recorded.
class RecordedMesh : public KernelMesh {
 public:
  using Vertex = restrip::Vertex;  // not OpenMesh's

  RecordedMesh(const Soup& soup, BoundaryPolicy policy)
      : policy_(policy),
        strips_(StripMesh::build(soup.triangles, soup.points.size(), &report_)),
        frozen_(soup.points.size(), 0) {
    const Fans fans = fans_of(strips_);
    vertex_ = fans.vertex;
    reserve(vertex_.size(), 3 * strips_.triangle_count() / 2, strips_.triangle_count());
    for (const Vertex v : vertex_) add_vertex(Point(soup.points[v].x, soup.points[v].y, soup.points[v].z));
    // OpenMesh reports each face that it cannot hold; we count them.
    omerr().disable();
    for (Triangle t = 0; t < strips_.triangle_bound(); ++t) {
      const auto corner = [&](unsigned side) { return VertexHandle(static_cast<int>(fans.of_corner[3 * t + side])); };
      if (add_face(corner(0), corner(1), corner(2)).is_valid()) continue;
      for (const Vertex v : strips_.corners(t)) frozen_[v] = 1;
    }
    omerr().enable();
  }

  // ---- called by the decimater
  bool is_collapse_ok(HalfedgeHandle h) {
    if (!KernelMesh::is_collapse_ok(h)) return false;
    const Vertex v_t = vertex_[index(from_vertex_handle(h))];
    const Vertex v_s = vertex_[index(to_vertex_handle(h))];
    if (frozen_[v_s] != 0 || frozen_[v_t] != 0 || strips_.irregular(v_s)) return false;
    const StripMesh::Halfedge chord = strips_.spoke(v_s, v_t);
    if (check_collapse(strips_, chord) != Refusal::granted) return false;
    return policy_ == BoundaryPolicy::move ||
           (!strips_.leaves_boundary(chord) && !strips_.leaves_boundary(strips_.opposite(chord)));
  }

  void collapse(HalfedgeHandle h) {
    const Vertex v_t = vertex_[index(from_vertex_handle(h))];
    const Vertex v_s = vertex_[index(to_vertex_handle(h))];
    KernelMesh::collapse(h);
    const StripMesh::Halfedge chord = strips_.spoke(v_s, v_t);
    const StripMesh::Halfedge back = strips_.opposite(chord);
    const auto apex = [&](StripMesh::Halfedge side) {
      return StripMesh::on_boundary(side) ? none : strips_.to(StripMesh::next(side));
    };
    collapses_.push_back({v_s, v_t, apex(chord), apex(back)});
    strips_.remove_vertex(chord);
    if (progress != nullptr) progress->at(collapses_.size());
  }

  Progress* progress = nullptr;

  // ---- the outcome
  [[nodiscard]] const StripMesh& strips() const noexcept { return strips_; }
  [[nodiscard]] const BuildReport& report() const noexcept { return report_; }
  [[nodiscard]] const std::vector<Record>& collapses() const noexcept { return collapses_; }
  [[nodiscard]] std::size_t frozen_vertices() const {
    std::size_t n = 0;
    for (Vertex v = 0; v < frozen_.size(); ++v) n += static_cast<std::size_t>(frozen_[v] != 0 && !strips_.irregular(v));
    return n;
  }

 private:
  static std::size_t index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }

  BoundaryPolicy policy_;
  BuildReport report_;
  StripMesh strips_;
  std::vector<std::uint8_t> frozen_;
  std::vector<Vertex> vertex_;  // of the soup, for each vertex of OpenMesh's
  std::vector<Record> collapses_;
};

}  // namespace

Simplification simplify(const Soup& soup, const SimplifyOptions& options) {
  RecordedMesh mesh(soup, options.boundary);
  Simplification result;
  result.left_out = {mesh.report().degenerate_triangles, mesh.report().irregular_vertices, mesh.frozen_vertices()};
  const std::size_t triangles = mesh.strips().triangle_count();
  result.wanted_triangles = static_cast<std::size_t>(std::ceil(options.base * static_cast<double>(triangles)));

  if (result.wanted_triangles < triangles) {
    Progress progress("simplifying", (triangles - result.wanted_triangles) / 2);
    mesh.progress = &progress;
    OpenMesh::Decimater::DecimaterT<RecordedMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<RecordedMesh>::Handle quadric;
    decimater.add(quadric);
    decimater.initialize();
    // OpenMesh may hold fewer faces than we do.
    const std::size_t missing = triangles - mesh.n_faces();
    decimater.decimate_to_faces(0, result.wanted_triangles - std::min(missing, result.wanted_triangles));
    mesh.progress = nullptr;
  }

  result.mesh.points = soup.points;
  result.mesh.base.reserve(mesh.strips().triangle_count());
  for (Triangle t = 0; t < mesh.strips().triangle_bound(); ++t)
    if (mesh.strips().alive(t)) result.mesh.base.push_back(mesh.strips().corners(t));
  result.mesh.splits.assign(mesh.collapses().rbegin(), mesh.collapses().rend());
  return result;
}

}  // namespace restrip::replay
