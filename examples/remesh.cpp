// Isotropic remeshing after Botsch and Kobbelt (2004), with maintained strips: split long edges, collapse short ones,
// flip towards six triangles a vertex, smooth, five times over. Every change goes through one keeper; restrip needs
// nothing else from a remesher. The mesh is an ellipsoid of uneven triangles.
//
// It prints the strips under each policy and of strips made from scratch afterwards; with
// `time`, also the time.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <restrip/restrip.hpp>
#include <vector>

namespace {

using restrip::StripMesh;
using restrip::Triangle;
using restrip::Vertex;
using Halfedge = StripMesh::Halfedge;

struct Point3 {
  double x = 0, y = 0, z = 0;
  Point3 operator+(const Point3& p) const { return {x + p.x, y + p.y, z + p.z}; }
  Point3 operator-(const Point3& p) const { return {x - p.x, y - p.y, z - p.z}; }
  Point3 operator*(double s) const { return {x * s, y * s, z * s}; }
};
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Surface {
  StripMesh mesh;
  std::vector<Point3> points;
};

/// Brings edges to the target length. Boundary edges do not collapse, and boundary vertices do not move.
class Remesher {
 public:
  Remesher(restrip::Keeper& keeper, std::vector<Point3>& points, double length)
      : keeper_(keeper), mesh_(keeper.mesh()), points_(points), short_(0.8 * length), long_(length * 4 / 3) {}

  void round() {
    for_each_edge([&](Halfedge h) {
      if (distance(h) <= long_) return;
      const Point3 middle = (points_[mesh_.from(h)] + points_[mesh_.to(h)]) * 0.5;
      const restrip::OperationPlace at = bisect_at(mesh_, h);
      restrip::NewVertices added;
      keeper_.apply(at.table, at.where, &added);
      points_.resize(mesh_.vertex_bound());
      points_[added[0]] = middle;
      ++operations;
    });
    for_each_edge([&](Halfedge h) {
      const Vertex v_s = mesh_.from(h), v_t = mesh_.to(h);
      const Point3 middle = (points_[v_s] + points_[v_t]) * 0.5;
      if (distance(h) >= short_ || on_boundary(v_s) || on_boundary(v_t) || too_far(v_s, middle) || too_far(v_t, middle))
        return;
      if (restrip::check_collapse(mesh_, h) != restrip::Refusal::granted) return;
      keeper_.collapse(h);
      points_[v_s] = middle;
      ++operations;
    });
    for_each_edge([&](Halfedge h) {
      const Halfedge back = mesh_.opposite(h);
      if (StripMesh::on_boundary(back)) return;
      const int fewer = off(mesh_.from(h), -1) + off(mesh_.to(h), -1);
      const int more = off(mesh_.to(mesh_.next(h)), 1) + off(mesh_.to(mesh_.next(back)), 1);
      if (fewer + more >= 0 || restrip::check_flip(mesh_, h) != restrip::Refusal::granted) return;
      keeper_.flip(h);
      ++operations;
    });
    smooth();
  }

  std::size_t operations = 0;

 private:
  /// Visits the edges of the triangles that exist now, in the state that they are in then; edges between two triangles
  /// come twice.
  template <class Visit>
  void for_each_edge(Visit&& visit) {
    const std::size_t bound = mesh_.triangle_bound();
    for (Triangle t = 0; t < bound; ++t)
      for (unsigned side = 0; side < 3 && mesh_.alive(t); ++side) visit(StripMesh::halfedge(t, side));
  }
  [[nodiscard]] double distance(Halfedge h) const {
    const Point3 along = points_[mesh_.to(h)] - points_[mesh_.from(h)];
    return std::sqrt(dot(along, along));
  }
  [[nodiscard]] bool on_boundary(Vertex v) const { return mesh_.leaves_boundary(mesh_.spoke(v)); }
  /// Whether an edge of v would be too long if v were there.
  [[nodiscard]] bool too_far(Vertex v, const Point3& there) const {
    bool far = false;
    restrip::for_each_spoke(mesh_, v, [&](Halfedge h) {
      const Point3 along = points_[mesh_.to(h)] - there;
      far = far || dot(along, along) > long_ * long_;
    });
    return far;
  }
  /// By how much `more` triangles move v away from the best number of triangles (six, or three on the boundary).
  [[nodiscard]] int off(Vertex v, int more) const {
    int spokes = 0;
    restrip::for_each_spoke(mesh_, v, [&](Halfedge) { ++spokes; });
    const int best = on_boundary(v) ? 4 : 6;
    return std::abs(spokes + more - best) - std::abs(spokes - best);
  }
  /// Every vertex moves to the middle of its neighbours, within the tangent plane of the surface.
  void smooth() {
    std::vector<Point3> moved = points_;
    for (Vertex v = 0; v < mesh_.vertex_bound(); ++v) {
      if (mesh_.spoke(v).id == restrip::none || on_boundary(v)) continue;
      Point3 sum, normal;
      double count = 0;
      restrip::for_each_spoke(mesh_, v, [&](Halfedge h) {
        const Point3 to = points_[mesh_.to(h)], next = points_[mesh_.to(mesh_.next(h))];
        sum = sum + to;
        normal = normal + cross(to - points_[v], next - points_[v]);
        ++count;
      });
      const Point3 way = sum * (1 / count) - points_[v];
      if (const double square = dot(normal, normal); square > 0)
        moved[v] = points_[v] + way - normal * (dot(way, normal) / square);
    }
    points_ = moved;
  }

  restrip::Keeper& keeper_;
  const StripMesh& mesh_;
  std::vector<Point3>& points_;
  double short_, long_;
};

/// An octahedron, of whose triangles the longest edges are bisected and put on an ellipsoid: needles and large
/// triangles next to each other. Rounding is the same on all machines.
Surface ellipsoid(std::size_t triangles) {
  const std::vector<std::array<Vertex, 3>> octahedron{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  Surface made{StripMesh::build(octahedron, 6), {{4, 0, 0}, {-4, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 2}, {0, 0, -2}}};
  StripMesh& mesh = made.mesh;
  const auto middle = [&](Halfedge h) { return (made.points[mesh.from(h)] + made.points[mesh.to(h)]) * 0.5; };
  const auto square = [&](Halfedge h) {
    const Point3 along = made.points[mesh.to(h)] - made.points[mesh.from(h)];
    return dot(along, along);
  };
  for (Triangle t = 0; mesh.triangle_count() < triangles; t = (t + 1) % static_cast<Triangle>(mesh.triangle_bound())) {
    Halfedge longest = StripMesh::halfedge(t);
    for (unsigned side = 1; side < 3; ++side)
      if (const Halfedge h = StripMesh::halfedge(t, side); square(h) > square(longest)) longest = h;
    const Point3 p = middle(longest);
    restrip::bisect(mesh, longest);
    made.points.push_back(p * (1 / std::sqrt(p.x * p.x / 16 + p.y * p.y + p.z * p.z / 4)));
  }
  mesh.clear_colors();  // strips come later
  return made;
}

/// The mean length of edges, the target of remeshing.
double mean_length(const Surface& surface) {
  double sum = 0;
  std::size_t count = 0;
  for (Triangle t = 0; t < surface.mesh.triangle_bound(); ++t)
    for (unsigned side = 0; side < 3; ++side, ++count) {
      const Halfedge h = StripMesh::halfedge(t, side);
      const Point3 along = surface.points[surface.mesh.to(h)] - surface.points[surface.mesh.from(h)];
      sum += std::sqrt(dot(along, along));
    }
  return sum / static_cast<double>(count);
}

template <class Work>
double milliseconds(Work&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// A row of the table that main() prints.
struct Row {
  const char* way;
  std::size_t strips = 0;
  double remeshing = 0;  // milliseconds
  double stripifying = 0;
};

std::size_t remesh(restrip::Keeper& keeper, std::vector<Point3>& points, double length, Row& row) {
  Remesher remesher(keeper, points, length);
  row.remeshing = milliseconds([&] {
    for (int round = 0; round < 5; ++round) remesher.round();
  });
  return remesher.operations;
}

}  // namespace

int main(int argc, char** argv) {
  const bool timed = argc == 2 && std::strcmp(argv[1], "time") == 0;
  const Surface start = ellipsoid(3000);
  const double length = mean_length(start);

  // Remeshed without strips, stripified afterwards.
  Surface bare = start;
  restrip::Keeper alone(bare.mesh, restrip::Policy::bare);
  Row scratch{"from scratch, fast"};
  const std::size_t operations = remesh(alone, bare.points, length, scratch);
  scratch.stripifying = milliseconds(
      [&] { scratch.strips = restrip::stripify(bare.mesh, restrip::Effort::fast, restrip::Cost::strips()); });
  std::vector<Row> rows{scratch};
  // Stripified first, then maintained.
  Surface striped = start;
  const std::size_t before = restrip::stripify(striped.mesh, restrip::Effort::full, restrip::Cost::strips());
  for (const auto& [policy, way] : {std::pair{restrip::Policy::local, "kept, local"},
                                    {restrip::Policy::quick, "kept, quick"},
                                    {restrip::Policy::full, "kept, full"}}) {
    Surface kept = striped;
    restrip::Keeper keeper(kept.mesh, policy, restrip::Cost::strips());
    Row& row = rows.emplace_back(Row{way});
    const bool same = remesh(keeper, kept.points, length, row) == operations;
    const restrip::ColoringReport counted = restrip::check_coloring(kept.mesh);
    if (!same || !counted.valid || counted.strips != keeper.strips()) return 1;
    row.strips = counted.strips;
  }

  std::printf("%zu triangles in %zu strips; after %zu operations %zu triangles:\n\n", start.mesh.triangle_count(),
              before, operations, bare.mesh.triangle_count());
  std::printf("| strips | how many |%s\n", timed ? " remeshing, ms | stripifying, ms |" : "");
  std::printf("| --- | --- |%s\n", timed ? " --- | --- |" : "");
  for (const auto& [way, strips, remeshing, stripifying] : rows) {
    std::printf("| %s | %zu |", way, strips);
    if (timed) std::printf(" %.1f | %.1f |", remeshing, stripifying);
    std::printf("\n");
  }
}
