#include "lod/simplify.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/progress.hpp"
#include "lod/coloring_check.hpp"

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
  BuildReport report;
  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size(), &report);
  const std::size_t triangles = mesh.triangle_count();
  Simplification result;
  result.wanted_triangles = options.triangles != 0
                                ? std::min(options.triangles, triangles)
                                : static_cast<std::size_t>(std::ceil(options.base * static_cast<double>(triangles)));
  std::vector<Simplifier::Point> points;
  points.reserve(soup.points.size());
  for (const Point& p : soup.points) points.push_back({p.x, p.y, p.z});

  Simplifier simplifier(std::move(mesh), points, options.boundary);
  const std::size_t collapses = (triangles - result.wanted_triangles) / 2;
  Progress progress("simplifying", collapses);
  while (!simplifier.run(result.wanted_triangles, collapses / 100 + 1)) progress.at(simplifier.collapses().size());

  result.left_out = {report.degenerate_triangles, report.non_manifold_vertices, simplifier.large_vertices()};
  if (simplifier.mesh().triangle_count() > result.wanted_triangles) result.left_out.obstacles = simplifier.obstacles();
  result.mesh.points = soup.points;
  result.mesh.base = triangles_of(simplifier.mesh());
  result.mesh.splits.assign(simplifier.collapses().rbegin(), simplifier.collapses().rend());
  return result;
}

}  // namespace restrip::tools
