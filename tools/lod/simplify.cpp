#include "lod/simplify.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/counted.hpp"
#include "common/progress.hpp"
#include "lod/coloring_check.hpp"
#include "meshes/mend.hpp"

namespace restrip::tools {
namespace {

/// Triangles on the same three corners as an earlier one of the other orientation.
std::size_t back_to_back(std::vector<Corners> triangles) {
  std::size_t pairs = 0;
  std::vector<Corners> turned;
  for (Corners& t : triangles) {
    turned.push_back(rotated({t[0], t[2], t[1]}));
    t = rotated(t);
  }
  std::sort(triangles.begin(), triangles.end());
  for (const Corners& t : turned) pairs += std::binary_search(triangles.begin(), triangles.end(), t) ? 1U : 0U;
  return pairs / 2;
}

}  // namespace

std::string why_no_coarser(const LeftOut& left_out) {
  std::size_t edges = 0;
  std::vector<std::string> reasons;
  for (const Obstacle& obstacle : left_out.obstacles) {
    edges += obstacle.edges;
    reasons.push_back(fmt::format("{}: {}", obstacle.edges, obstacle.why));
  }
  std::string why =
      fmt::format("none of the {} edges that are left may collapse ({})", edges, fmt::join(reasons, "; "));
  if (left_out.seam_vertices != 0)
    why += fmt::format(
        "; {} on seams stay, where attributes differ: without --attributes, or with --weld if they are "
        "equal after all, seams are closed",
        counted(left_out.seam_vertices, "vertex", "vertices"));
  if (left_out.back_to_back != 0)
    why += fmt::format(
        "; {} back to back on the same corners, as in a sheet with two sides: remove one side, simplify, "
        "and draw it without culling, or write it twice",
        counted(left_out.back_to_back, "pair of triangles lies", "pairs of triangles lie"));
  return why;
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

  const std::vector<std::uint32_t> fixed =
      soup.attributes.empty() ? std::vector<std::uint32_t>() : vertices_on_seams(soup);
  Simplifier simplifier(std::move(mesh), points, options.boundary, fixed);
  const std::size_t collapses = (triangles - result.wanted_triangles) / 2;
  Progress progress("simplifying", collapses);
  while (!simplifier.run(result.wanted_triangles, collapses / 100 + 1)) progress.at(simplifier.collapses().size());

  result.left_out = {report.degenerate_triangles, report.non_manifold_vertices, simplifier.large_vertices(),
                     fixed.size()};
  if (simplifier.mesh().triangle_count() > result.wanted_triangles) {
    result.left_out.obstacles = simplifier.obstacles();
    result.left_out.back_to_back = back_to_back(corners_of(simplifier.mesh()));
  }
  result.mesh.points = soup.points;
  result.mesh.base = corners_of(simplifier.mesh());
  result.mesh.splits.assign(simplifier.collapses().rbegin(), simplifier.collapses().rend());
  return result;
}

}  // namespace restrip::tools
