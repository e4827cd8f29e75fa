#include "meshes/made_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/random.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"

namespace restrip::tools {
namespace {

struct OnCircle {
  double x;
  double y;
};

/// Point i of n on the unit circle, by the rational parametrisation of each quarter. It uses only +, -, * and /, which
/// IEEE arithmetic rounds the same everywhere; sines from different libraries differ in the last bit.
OnCircle on_circle(std::size_t i, std::size_t n) {
  std::size_t quarter = 4 * i / n;
  const double t = (4.0 * static_cast<double>(i) - static_cast<double>(quarter * n)) / static_cast<double>(n);
  const double length = 1.0 + t * t;
  OnCircle p{(1.0 - t * t) / length, 2.0 * t / length};
  for (; quarter > 0; --quarter) p = {-p.y, p.x};
  return p;
}

}  // namespace

Soup make_mesh(std::size_t triangles, std::uint64_t seed) {
  if (triangles < least_made_triangles || triangles > most_made_triangles)
    throw BadInput(fmt::format("a made mesh has between {} and {} triangles, not {}", least_made_triangles,
                               most_made_triangles, triangles));
  // Twice as many steps the long way around as the short way; at least four, so that every edge exists only once.
  const auto across =
      std::max<std::size_t>(4, static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 4.0)));
  const std::size_t along = std::max<std::size_t>(4, (triangles + across) / (2 * across));
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>(i % along * across + j % across);
  };

  Random random(seed);
  Soup soup;
  soup.points.reserve(along * across);
  soup.triangles.reserve(2 * along * across);
  for (std::size_t i = 0; i < along; ++i) {
    const OnCircle ring = on_circle(i, along);
    for (std::size_t j = 0; j < across; ++j) {
      const OnCircle tube = on_circle(j, across);
      const double bump = 0.4 + 0.02 * static_cast<double>(random.below(1024)) / static_cast<double>(across);
      const double reach = 1.0 + bump * tube.x;
      soup.points.push_back(
          {static_cast<float>(reach * ring.x), static_cast<float>(reach * ring.y), static_cast<float>(bump * tube.y)});
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }

  StripMesh mesh = StripMesh::build(soup.triangles, soup.points.size());
  constexpr std::size_t most_around = 10;
  const auto sides = static_cast<std::uint32_t>(3 * mesh.triangle_count());
  for (std::size_t flip = 0; flip < soup.points.size(); ++flip) {
    const std::uint32_t pick = random.below(sides);
    const StripMesh::Halfedge h = StripMesh::halfedge(pick / 3, pick % 3);
    if (check_flip(mesh, h) != Refusal::granted) continue;
    const StripMesh::Halfedge back = mesh.opposite(h);
    const Vertex left = mesh.to(StripMesh::next(h));
    const Vertex right = mesh.to(StripMesh::next(back));
    if (spoke_count(mesh, left) >= most_around || spoke_count(mesh, right) >= most_around) continue;
    mesh.turn_edge(h);
  }
  for (Triangle t = 0; t < mesh.triangle_bound(); ++t) soup.triangles[t] = mesh.corners(t);
  return soup;
}

}  // namespace restrip::tools
