// Pictures of the page other than the index buffer: the triangles with their strips, and the triangle under the cursor.
// Linear in the mesh; called only while such a picture is shown.
#pragma once

#include "session.hpp"

namespace restrip::web {

/// A triangle of the picture. `beyond` and `joined` are by its sides, side i from corner i to the next one: the
/// triangle there, `none` at the boundary, and bit i if the strip continues to it.
struct PaintedTriangle {
  Triangle triangle = none;
  Corners corners{};
  std::array<Triangle, 3> beyond{};
  std::uint32_t joined = 0;
  std::uint32_t strip = 0;  ///< named by its lowest triangle
};

class Picture {
 public:
  using Point = Vector<float>;

  /// The triangles, strip by strip, in the order of their strips.
  std::span<const PaintedTriangle> ribbon(const StripMesh& mesh) {
    const Strips strips = extract_strips(mesh);
    ribbon_.clear();
    for (std::size_t s = 0; s < strips.size(); ++s) {
      const Triangle lowest = *std::min_element(strips[s].begin(), strips[s].end());
      for (const Triangle t : strips[s]) {
        PaintedTriangle& painted = ribbon_.emplace_back(PaintedTriangle{t, mesh.corners(t), {}, 0, lowest});
        for (unsigned side = 0; side < 3; ++side) {
          const Halfedge h = StripMesh::halfedge(t, side);
          const Halfedge back = mesh.opposite(h);
          painted.beyond[side] = StripMesh::on_boundary(back) ? none : StripMesh::triangle(back);
          if (mesh.solid(h)) painted.joined |= 1U << side;
        }
      }
    }
    return ribbon_;
  }

  /// The nearest triangle that a ray meets, and where (three numbers); empty when it meets none.
  std::span<const float> pick(const Session& session, const Point& from, const Point& along) {
    hit_.clear();
    float nearest = std::numeric_limits<float>::max();
    const StripMesh& mesh = session.mesh();
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t) {
      if (!mesh.alive(t)) continue;
      const auto [i, j, k] = mesh.corners(t);
      // The distance along the ray (Moller and Trumbore 1997).
      const Point a = point(session, i);
      const Point e = point(session, j) - a;
      const Point f = point(session, k) - a;
      const Point p = cross(along, f);
      const float determinant = dot(e, p);
      if (determinant == 0) continue;
      const Point s = from - a;
      const float u = dot(s, p) / determinant;
      const Point q = cross(s, e);
      const float v = dot(along, q) / determinant;
      if (u < 0 || v < 0 || u + v > 1) continue;
      const float distance = dot(f, q) / determinant;
      if (!(distance > 0) || distance >= nearest) continue;
      nearest = distance;
      hit_ = {from.x + distance * along.x, from.y + distance * along.y, from.z + distance * along.z};
    }
    return hit_;
  }

 private:
  [[nodiscard]] static Point point(const Session& session, Vertex v) noexcept {
    const auto p = session.points().subspan(3 * std::size_t{v}, 3);
    return {p[0], p[1], p[2]};
  }

  std::vector<PaintedTriangle> ribbon_;
  std::vector<float> hit_;
};

}  // namespace restrip::web
