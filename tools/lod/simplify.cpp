#include "lod/simplify.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/progress.hpp"
#include "lod/coloring_check.hpp"
#include "lod/recorded_mesh.hpp"

namespace restrip::tools {

std::string why_no_coarser(const LeftOut& left_out) {
  std::size_t edges = 0;
  std::vector<std::string> reasons;
  for (const Obstacle& obstacle : left_out.obstacles) {
    edges += obstacle.edges;
    reasons.push_back(fmt::format("{}: {}", obstacle.edges, obstacle.why));
  }
  return fmt::format("none of the {} edges that are left may collapse ({})", edges, fmt::join(reasons, "; "));
}

Simplification simplify(const Soup& soup, const SimplifyOptions& options) {
  RecordedMesh mesh(soup, options.boundary);
  Simplification result;
  result.left_out = {mesh.report().degenerate_triangles, mesh.report().non_manifold_vertices, mesh.frozen_vertices(),
                     0};
  const std::size_t triangles = mesh.strips().triangle_count();
  result.wanted_triangles = options.triangles != 0
                                ? std::min(options.triangles, triangles)
                                : static_cast<std::size_t>(std::ceil(options.base * static_cast<double>(triangles)));

  if (result.wanted_triangles < triangles) {
    Progress progress("simplifying", (triangles - result.wanted_triangles) / 2);
    mesh.progress = &progress;
    OpenMesh::Decimater::DecimaterT<RecordedMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<RecordedMesh>::Handle quadric;
    decimater.add(quadric);
    decimater.initialize();
    // OpenMesh may hold fewer faces than StripMesh.
    const std::size_t missing = triangles - mesh.n_faces();
    decimater.decimate_to_faces(0, result.wanted_triangles - std::min(missing, result.wanted_triangles));
    mesh.progress = nullptr;
  }
  result.left_out.large_vertices = mesh.large_vertices();
  if (mesh.strips().triangle_count() > result.wanted_triangles)
    mesh.collapse_what_is_left(soup.points, result.wanted_triangles);
  if (mesh.strips().triangle_count() > result.wanted_triangles) result.left_out.obstacles = mesh.obstacles();

  result.mesh.points = soup.points;
  result.mesh.base = triangles_of(mesh.strips());
  result.mesh.splits.assign(mesh.collapses().rbegin(), mesh.collapses().rend());
  return result;
}

}  // namespace restrip::tools
