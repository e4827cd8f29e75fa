// A terrain under longest-edge bisection (Rivara 1984; ROAM, right-triangulated terrains): refined in front of a camera
// that flies over it, coarsened behind it. The rules of bisect() and merge() maintain the strips: here one strip covers
// the whole terrain. This flies a hundred frames; `example_terrain time` flies a thousand, and prints the time of the
// rules in a frame, compared with strips from scratch.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <restrip/restrip.hpp>
#include <vector>

namespace {

using restrip::StripMesh;
using restrip::Vertex;
using Halfedge = StripMesh::Halfedge;
using Clock = std::chrono::steady_clock;

constexpr int side = 1024;  // the terrain is a square of side x side

struct Point {
  int x = 0, y = 0;
};

/// Ridges of five sizes. Rounding is the same on all machines.
double height(Point p) {
  const auto ridge = [&](double a, double b) {
    return std::abs(a * p.x + b * p.y - std::floor(a * p.x + b * p.y + 0.5));
  };
  return 90 * ridge(0.0021, 0.0013) + 50 * ridge(-0.0052, 0.0071) + 24 * ridge(0.017, 0.011) +
         9 * ridge(0.031, -0.043) + 3 * ridge(0.11, 0.093);
}

class Terrain {
 public:
  Terrain() : mesh(StripMesh::build(std::vector<std::array<Vertex, 3>>{{0, 1, 2}, {0, 2, 3}}, 4)) {
    points_ = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    tails_.resize(4);
    restrip::stripify(mesh, restrip::Effort::fast, restrip::Cost::strips());
  }

  /// Merges triangles that are too fine and bisects triangles that are too coarse, seen from the camera.
  void move(Point camera) {
    for (Vertex v = 4; v < mesh.vertex_bound(); ++v) {
      if (mesh.spoke(v).id == restrip::none) continue;
      const Halfedge chord = mesh.spoke(tails_[v], v);
      if (chord.id == restrip::none || check_apply(mesh, restrip::merge_at(mesh, chord)) != restrip::Refusal::granted)
        continue;
      bool newest = true;  // no triangle at v has been bisected since
      restrip::for_each_spoke(mesh, v, [&](Halfedge h) {
        if (!StripMesh::on_boundary(h) && !(longest(h) == StripMesh::next(h))) newest = false;
      });
      const Point a = points_[tails_[v]], b{2 * points_[v].x - a.x, 2 * points_[v].y - a.y};
      if (newest && !wants(a, b, 1.5, camera)) timed([&] { return restrip::merge(mesh, chord); });
    }
    for (restrip::Triangle t = 0; t < mesh.triangle_bound(); ++t)
      while (mesh.alive(t)) {
        const Halfedge h = longest(StripMesh::halfedge(t));
        if (!wants(point(h), point(StripMesh::next(h)), 1, camera)) break;
        refine(h);
      }
  }

  StripMesh mesh;
  std::size_t operations = 0;
  Clock::duration spent{};  // in the operations

 private:
  [[nodiscard]] Point point(Halfedge h) const { return points_[mesh.from(h)]; }
  /// The longest edge of the triangle of h; all triangles are right-angled and isosceles.
  [[nodiscard]] Halfedge longest(Halfedge h) const {
    const auto length = [&](Halfedge g) {
      const Point a = point(g), b = point(StripMesh::next(g));
      return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
    };
    const Halfedge second = StripMesh::next(h), third = StripMesh::next(second);
    if (length(h) > length(second)) return length(h) > length(third) ? h : third;
    return length(second) > length(third) ? second : third;
  }
  /// Whether a vertex in the middle of this edge is worth its triangles. `slack` keeps it a little longer.
  [[nodiscard]] static bool wants(Point a, Point b, double slack, Point camera) {
    if (((a.x + b.x) | (a.y + b.y)) % 2 != 0) return false;  // below the resolution of the grid
    const Point p{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double error = slack * 40 * std::abs(height(p) - (height(a) + height(b)) / 2);
    const double x = p.x - camera.x, y = p.y - camera.y;
    return std::abs(a.x - b.x) + std::abs(a.y - b.y) > 128 || error * error > x * x + y * y;
  }
  template <class Operation>
  restrip::Checked timed(Operation&& operation) {
    const auto start = Clock::now();
    const auto done = operation();
    spent += Clock::now() - start;
    ++operations;
    return done;
  }
  /// Bisects the edge of h, the longest of its triangle, after the edges that must be bisected before it.
  void refine(Halfedge h) {
    while (!StripMesh::on_boundary(mesh.opposite(h)) && !(longest(mesh.opposite(h)) == mesh.opposite(h)))
      refine(longest(mesh.opposite(h)));
    const Point a = point(h), b = point(StripMesh::next(h));
    const Vertex tail = mesh.from(h);
    const Vertex made = timed([&] { return restrip::bisect(mesh, h); }).new_vertex();
    points_.resize(mesh.vertex_bound());
    tails_.resize(mesh.vertex_bound());
    points_[made] = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    tails_[made] = tail;
  }

  std::vector<Point> points_;
  std::vector<Vertex> tails_;  // an end of the edge on which a vertex was made
};

}  // namespace

int main(int argc, char** argv) {
  const bool timed = argc == 2 && std::strcmp(argv[1], "time") == 0;
  Terrain terrain;
  const int frames = timed ? 1000 : 100;
  Clock::duration from_scratch{};
  for (int frame = 0; frame <= frames; ++frame) {
    terrain.move({100 + frame * 4 / 5, 150 + frame * 7 / 10});
    const bool told_of = frame % (frames / 4) == 0;
    if (!timed && !told_of) continue;
    StripMesh copy = terrain.mesh;
    const auto start = Clock::now();
    restrip::stripify(copy, restrip::Effort::fast, restrip::Cost::strips());
    from_scratch += Clock::now() - start;
    if (!told_of) continue;
    const auto report = [](const char* how, const StripMesh& mesh) {
      const auto indices = static_cast<double>(restrip::strip_index_count(mesh, restrip::extract_strips(mesh)));
      std::printf("  %s: %3zu strips, %.2f indices a triangle\n", how, restrip::count_strips(mesh),
                  indices / static_cast<double>(mesh.triangle_count()));
    };
    std::printf("frame %4d: %zu triangles after %zu operations\n", frame, copy.triangle_count(), terrain.operations);
    report("kept        ", terrain.mesh);
    report("from scratch", copy);
  }
  if (timed) {
    const auto us = [frames](Clock::duration d) {
      return std::chrono::duration<double, std::micro>(d).count() / frames;
    };
    std::printf("a frame: %.1f us for the operations and their rules, %.1f us for strips from scratch\n",
                us(terrain.spent), us(from_scratch));
  }
  return restrip::check_coloring(terrain.mesh).valid ? 0 : 1;
}
