// Claims: no recorded collapse turns a triangle by 90 degrees or takes its area, breaks the link condition or takes a
// boundary vertex from the boundary; height fields never face down and keep their outline; flat faces and sharp edges
// stay exact; details of any size follow the same rules; fixed vertices stay; what stops short says why. An oracle that
// knows a list of triangles only replays every record and computes all of this again.
#include "lod/simplifier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "restrip/mesh/checks.hpp"
#include "runtime/sample_meshes.hpp"

namespace restrip::simplifier_test {
namespace {

using tools::BoundaryPolicy;
using tools::Obstacle;
using tools::Simplifier;

using Corners = std::array<Vertex, 3>;
using Point = Simplifier::Point;

struct Model {
  std::vector<Point> points;
  std::vector<Corners> triangles;
};

Point normal_of(const std::vector<Point>& points, const Corners& t) {
  const auto& [a, b, c] = std::tie(points[t[0]], points[t[1]], points[t[2]]);
  const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Point v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
double product(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// Squared.
double longest_side(const std::vector<Point>& points, const Corners& t) {
  double longest = 0;
  for (unsigned i = 0; i < 3; ++i) {
    const Point& a = points[t[i]];
    const Point& b = points[t[(i + 1) % 3]];
    const Point way{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    longest = std::max(longest, product(way, way));
  }
  return longest;
}
/// Points on one line may make an area that is nothing but rounding.
bool has_area(const Point& normal, double longest) { return product(normal, normal) > 1e-24 * longest * longest; }

// ---- models
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double unit() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 40U) / static_cast<double>(1U << 24U);
  }
  Vertex below(std::size_t n) { return static_cast<Vertex>(unit() * static_cast<double>(n)); }

 private:
  std::uint64_t state_;
};

/// A sheet of columns × rows squares, without the squares that `has` denies, at the height that `height` returns.
template <class Height, class Has>
Model sheet(unsigned columns, unsigned rows, Height&& height, Has&& has) {
  Model m;
  std::map<std::pair<unsigned, unsigned>, Vertex> number;
  const auto vertex = [&](unsigned x, unsigned y) {
    const auto [place, is_new] = number.try_emplace({x, y}, static_cast<Vertex>(m.points.size()));
    if (is_new) m.points.push_back({double(x), double(y), height(x, y)});
    return place->second;
  };
  for (unsigned y = 0; y < rows; ++y)
    for (unsigned x = 0; x < columns; ++x) {
      if (!has(x, y)) continue;
      const Corners t{vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)};
      m.triangles.push_back(t);
      m.triangles.push_back({t[0], t[2], vertex(x, y + 1)});
    }
  return m;
}
template <class Height>
Model field(unsigned n, Height&& height) {
  return sheet(n, n, height, [](unsigned, unsigned) { return true; });
}
Model island() {
  return field(40, [](unsigned x, unsigned y) {
    const double r = (x - 25.0) * (x - 25.0) + (y - 17.0) * (y - 17.0);
    return std::max(0.0, std::round(1e4 * (8 * std::exp(-r / 40) - 1)) / 1e4);
  });
}
Model cliffs(std::uint64_t seed) {
  Random random(seed);
  return field(24, [&](unsigned x, unsigned) { return (x / 5 % 2 != 0 ? 40.0 : 0.0) + 3 * random.unit(); });
}
Model letter(unsigned n) {
  return sheet(
      n, n, [](unsigned, unsigned) { return 0.0; }, [n](unsigned x, unsigned y) { return x < n / 2 || y < n / 2; });
}
/// A closed box of a × b × c unit squares.
Model prism(unsigned a, unsigned b, unsigned c) {
  Model m;
  std::map<Point, Vertex> number;
  const auto vertex = [&](const Point& p) {
    const auto [place, is_new] = number.try_emplace(p, static_cast<Vertex>(m.points.size()));
    if (is_new) m.points.push_back(p);
    return place->second;
  };
  const std::array<unsigned, 3> size{a, b, c};
  for (unsigned axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) {
      const unsigned i = (axis + 1) % 3;
      const unsigned j = (axis + 2) % 3;
      for (unsigned x = 0; x < size[i]; ++x)
        for (unsigned y = 0; y < size[j]; ++y) {
          const auto at = [&](unsigned dx, unsigned dy) {
            Point p{};
            p[axis] = far ? size[axis] : 0;
            p[i] = x + dx;
            p[j] = y + dy;
            return vertex(p);
          };
          Corners t{at(0, 0), at(1, 0), at(1, 1)};
          Corners u{at(0, 0), at(1, 1), at(0, 1)};
          if (!far) {
            std::swap(t[1], t[2]);
            std::swap(u[1], u[2]);
          }
          m.triangles.push_back(t);
          m.triangles.push_back(u);
        }
    }
  return m;
}
Model torus(unsigned n, unsigned m) {
  Model model;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < m; ++j) {
      const double a = 2 * 3.14159265358979 * i / n;
      const double b = 2 * 3.14159265358979 * j / m;
      model.points.push_back({(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)});
      const auto at = [&](unsigned x, unsigned y) { return (x % n) * m + y % m; };
      model.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      model.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return model;
}
Model joined(const Model& a, const Model& b, double away) {
  Model m = a;
  for (Point p : b.points) {
    p[0] += away;
    m.points.push_back(p);
  }
  for (Corners t : b.triangles) {
    for (Vertex& v : t) v += static_cast<Vertex>(a.points.size());
    m.triangles.push_back(t);
  }
  return m;
}
/// Some triangles are doubled, turned over, removed, made degenerate or joined at random.
Model damaged(Model m, std::uint64_t seed) {
  Random random(seed);
  for (unsigned i = 0; i < 12; ++i) {
    const Vertex t = random.below(m.triangles.size());
    switch (i % 4) {
      case 0:
        m.triangles.push_back(Corners(m.triangles[t]));
        break;
      case 1:
        std::swap(m.triangles[t][0], m.triangles[t][1]);
        break;
      case 2:
        m.triangles.erase(m.triangles.begin() + t);
        break;
      default:
        m.triangles.push_back({random.below(m.points.size()), random.below(m.points.size()), m.triangles[t][0]});
    }
  }
  // Points on one line make triangles without area.
  for (unsigned i = 0; i < 5; ++i) {
    const Corners& t = m.triangles[random.below(m.triangles.size())];
    for (unsigned k = 0; k < 3; ++k) m.points[t[0]][k] = (m.points[t[1]][k] + m.points[t[2]][k]) / 2;
  }
  return m;
}

// ---- the oracle
class Oracle {
 public:
  Oracle(const Model& model, const StripMesh& mesh) : points_(model.points) {
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
      if (mesh.alive(t)) {
        const Point normal = normal_of(points_, mesh.corners(t));
        now_.push_back({mesh.corners(t), normal, has_area(normal, longest_side(points_, mesh.corners(t)))});
      }
  }
  /// Returns what is wrong with the record, or nothing.
  std::string collapse(const SplitRecord& r, BoundaryPolicy policy) {
    const auto edges = edge_counts(r.v_s, r.v_t);
    const auto triangles_at = [&](Vertex a, Vertex b) {
      const auto found = edges.find({std::min(a, b), std::max(a, b)});
      return found == edges.end() ? 0U : found->second;
    };
    const auto on_boundary = [&](Vertex v) {
      return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
        return edge.second == 1 && (edge.first.first == v || edge.first.second == v);
      });
    };
    const unsigned at_edge = triangles_at(r.v_s, r.v_t);
    if (at_edge != r.triangles()) return "the edge has other triangles than the record";
    if (on_boundary(r.v_t) && at_edge != 1) return "a boundary vertex leaves the boundary";
    if (policy == BoundaryPolicy::lock && (on_boundary(r.v_t) || on_boundary(r.v_s))) return "the boundary is locked";
    std::set<Vertex> of_s;
    std::set<Vertex> shared;
    for (const auto& [edge, count] : edges)
      if (edge.first == r.v_s || edge.second == r.v_s) of_s.insert(edge.first ^ edge.second ^ r.v_s);
    for (const auto& [edge, count] : edges)
      if ((edge.first == r.v_t || edge.second == r.v_t) && of_s.contains(edge.first ^ edge.second ^ r.v_t))
        shared.insert(edge.first ^ edge.second ^ r.v_t);
    std::set<Vertex> apexes{r.v_l, r.v_r};
    apexes.erase(none);
    if (shared != apexes) return "the link condition does not hold";
    std::vector<Face> after;
    for (Face face : now_) {
      const bool has_s = std::count(face.corners.begin(), face.corners.end(), r.v_s) != 0;
      const auto at_t = std::find(face.corners.begin(), face.corners.end(), r.v_t);
      if (at_t != face.corners.end()) {
        if (has_s) continue;
        const Point before = normal_of(points_, face.corners);
        const double longest_before = longest_side(points_, face.corners);
        *at_t = r.v_s;
        const Point turned = normal_of(points_, face.corners);
        if (has_area(before, longest_before)) {
          if (!(product(turned, turned) > 0)) return "a triangle loses its area";
          if (!(product(before, turned) > 0)) return "a triangle turns by 90 degrees or more";
          if (face.had_area && !(product(face.original, turned) > 0))
            return "a triangle has turned by 90 degrees or more in all";
        }
      }
      after.push_back(face);
    }
    now_ = std::move(after);
    return "";
  }
  [[nodiscard]] std::vector<Corners> triangles() const {
    std::vector<Corners> all;
    for (const Face& face : now_) all.push_back(face.corners);
    return all;
  }
  [[nodiscard]] double least_facing_up() const {
    double least = 1e300;
    for (const Face& face : now_) least = std::min(least, normal_of(points_, face.corners)[2]);
    return least;
  }
  [[nodiscard]] double area_from_above() const {
    double area = 0;
    for (const Face& face : now_) area += normal_of(points_, face.corners)[2] / 2;
    return area;
  }
  [[nodiscard]] double area() const {
    double sum = 0;
    for (const Face& face : now_) {
      const Point n = normal_of(points_, face.corners);
      sum += std::sqrt(product(n, n)) / 2;
    }
    return sum;
  }

 private:
  struct Face {
    Corners corners;
    Point original;
    bool had_area;
  };
  /// The triangles at each edge of a triangle at one of two vertices.
  [[nodiscard]] std::map<std::pair<Vertex, Vertex>, unsigned> edge_counts(Vertex a, Vertex b) const {
    std::map<std::pair<Vertex, Vertex>, unsigned> edges;
    for (const Face& face : now_) {
      const auto& c = face.corners;
      if (std::count(c.begin(), c.end(), a) + std::count(c.begin(), c.end(), b) == 0) continue;
      for (unsigned i = 0; i < 3; ++i)
        for (const Vertex v : {a, b})
          if (c[i] == v || c[(i + 1) % 3] == v) {
            ++edges[{std::min(c[i], c[(i + 1) % 3]), std::max(c[i], c[(i + 1) % 3])}];
            break;
          }
    }
    return edges;
  }
  std::vector<Point> points_;
  std::vector<Face> now_;
};

StripMesh mesh_of(const Model& model) { return StripMesh::build(model.triangles, model.points.size()); }

/// Simplifies and lets the oracle replay; `at_each` is called with the oracle after each collapse.
template <class AtEach>
Simplifier expect_right(const Model& model, std::size_t wanted, BoundaryPolicy policy, AtEach&& at_each) {
  Simplifier simplifier(mesh_of(model), model.points, policy);
  EXPECT_TRUE(simplifier.run(wanted));
  Oracle oracle(model, mesh_of(model));
  for (const SplitRecord& record : simplifier.collapses()) {
    const std::string fault = oracle.collapse(record, policy);
    EXPECT_EQ(fault, "") << record.v_t << " into " << record.v_s;
    if (!fault.empty()) break;
    at_each(oracle);
  }
  EXPECT_EQ(sample::sorted(oracle.triangles()), sample::triangles_of(simplifier.mesh()));
  const bool is_short = simplifier.mesh().triangle_count() > wanted;
  if (is_short) {
    const auto obstacles = simplifier.obstacles();
    EXPECT_FALSE(obstacles.empty());
    for (const Obstacle& obstacle : obstacles) EXPECT_STRNE(obstacle.why, describe(Refusal::granted));
  }
  return simplifier;
}
Simplifier expect_right(const Model& model, std::size_t wanted, BoundaryPolicy policy = BoundaryPolicy::move) {
  return expect_right(model, wanted, policy, [](const Oracle&) {});
}

TEST(Simplifier, EveryCollapseIsPermitted) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    for (const Model& model : {torus(20, 12), cliffs(seed), joined(prism(3, 4, 5), letter(8), 20), island()})
      for (const BoundaryPolicy policy : {BoundaryPolicy::lock, BoundaryPolicy::move}) {
        expect_right(damaged(model, seed), 1, policy);
        if (seed == 1) expect_right(model, 1, policy);
      }
  }
}

TEST(Simplifier, StopsShortOnlyWhenNoEdgeMayCollapse) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Model model = damaged(seed % 2 == 0 ? torus(12, 8) : prism(2, 3, 4), seed);
    const Simplifier simplifier = expect_right(model, 1);
    const StripMesh& mesh = simplifier.mesh();
    Oracle oracle(model, mesh_of(model));
    for (const SplitRecord& record : simplifier.collapses()) oracle.collapse(record, BoundaryPolicy::move);
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
      for (unsigned side = 0; side < 3 && mesh.alive(t); ++side)
        for (const auto h : {StripMesh::halfedge(t, side), mesh.opposite(StripMesh::halfedge(t, side))}) {
          if (check_collapse(mesh, h) != Refusal::granted) continue;
          Oracle next = oracle;
          EXPECT_NE(next.collapse(record_of_collapse(mesh, h), BoundaryPolicy::move), "") << seed;
        }
  }
}

TEST(Simplifier, AHeightFieldNeverFacesDownAndKeepsItsArea) {
  Random random(3);
  const auto rough = field(20, [&](unsigned, unsigned) { return 10 * random.unit(); });
  for (const Model& model : {island(), cliffs(1), cliffs(2), letter(12), rough}) {
    const double whole = Oracle(model, mesh_of(model)).area_from_above();
    for (const BoundaryPolicy policy : {BoundaryPolicy::lock, BoundaryPolicy::move})
      for (const std::size_t wanted : {model.triangles.size() / 10, std::size_t{12}})
        expect_right(model, wanted, policy, [&](const Oracle& oracle) {
          EXPECT_GT(oracle.least_facing_up(), 0);
          EXPECT_NEAR(oracle.area_from_above(), whole, 1e-9 * whole);
        });
  }
}

TEST(Simplifier, VerticalWallsNeverLeanOver) {
  // The walls are triangles whose normals are exactly horizontal.
  Model model = field(12, [](unsigned x, unsigned y) { return x > 5 ? 9.0 + (x * y) % 3 : 0.0; });
  for (Point& p : model.points)
    if (p[0] > 5) p[0] -= 1;
  ASSERT_EQ(Oracle(model, mesh_of(model)).least_facing_up(), 0);
  expect_right(model, 8, BoundaryPolicy::move, [](const Oracle& oracle) { EXPECT_GE(oracle.least_facing_up(), 0); });
}

TEST(Simplifier, APrismStaysAPrismUntilTwelveTriangles) {
  for (const auto& [a, b, c] : {std::array{1U, 1U, 3U}, {4U, 5U, 6U}, {1U, 9U, 2U}}) {
    const Model model = prism(a, b, c);
    const double whole = 2.0 * (a * b + b * c + c * a);
    const Simplifier simplifier = expect_right(model, 12, BoundaryPolicy::move, [&](const Oracle& oracle) {
      EXPECT_NEAR(oracle.area(), whole, 1e-9 * whole);
    });
    EXPECT_EQ(simplifier.mesh().triangle_count(), 12U);
  }
}

TEST(Simplifier, CornersOfTheOutlineStayUntilNothingElseIsLeft) {
  Random random(9);
  // A rough field, in which a corner would be cheap.
  const Model model = field(16, [&](unsigned, unsigned) { return 30 * random.unit(); });
  const Simplifier simplifier = expect_right(model, 12);
  std::set<Vertex> left;
  for (const Corners& t : sample::triangles_of(simplifier.mesh())) left.insert(t.begin(), t.end());
  for (Vertex v = 0; v < model.points.size(); ++v) {
    const auto& [x, y, z] = model.points[v];
    if ((x == 0 || x == 16) && (y == 0 || y == 16)) {
      EXPECT_TRUE(left.contains(v)) << x << ' ' << y;
    }
  }
  EXPECT_EQ(expect_right(letter(20), 4).mesh().triangle_count(), 4U);  // its six corners
}

TEST(Simplifier, FlatRegionsGetNoNeedles) {
  const Model model = field(32, [](unsigned, unsigned) { return 0.0; });
  const Simplifier simplifier = expect_right(model, 300);
  double worst = 1;
  for (const Corners& t : sample::triangles_of(simplifier.mesh())) {
    double longest = 0;
    for (unsigned i = 0; i < 3; ++i) {
      const Point& a = model.points[t[i]];
      const Point& b = model.points[t[(i + 1) % 3]];
      longest = std::max(longest, (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
    }
    worst = std::min(worst, normal_of(model.points, t)[2] / longest);
  }
  EXPECT_GT(worst, 0.05);  // height over longest side
}

TEST(Simplifier, ScaleAndPlaceDoNotMatter) {
  const Model model = joined(torus(20, 12), island(), 64);
  const auto collapses = [&](double scale, double offset) {
    Model other = model;
    for (Point& p : other.points)
      for (double& x : p) x = (std::round(x * 1024) / 1024 + offset) * scale;
    Simplifier simplifier(mesh_of(other), other.points);
    EXPECT_TRUE(simplifier.run(60));
    return simplifier.collapses();
  };
  const auto expected = collapses(1, 0);
  for (const int exponent : {-1000, -300, -20, 20, 300, 1000})
    EXPECT_EQ(collapses(std::ldexp(1.0, exponent), 0), expected) << exponent;
  EXPECT_EQ(collapses(1, 1 << 20), expected);
}

TEST(Simplifier, RunsInPiecesAsAtOnce) {
  const Model model = torus(30, 20);
  Simplifier at_once(mesh_of(model), model.points);
  EXPECT_TRUE(at_once.run(100));
  Simplifier pieces(mesh_of(model), model.points);
  std::size_t calls = 1;
  for (; !pieces.run(100, 7); ++calls) EXPECT_EQ(pieces.collapses().size(), 7 * calls);
  EXPECT_GT(calls, 50U);
  EXPECT_EQ(pieces.collapses(), at_once.collapses());
}

TEST(Simplifier, PointsThatAreNotFiniteStay) {
  Model model = torus(20, 12);
  model.points[7][1] = std::nan("");
  model.points[99][2] = std::numeric_limits<double>::infinity();
  Simplifier simplifier(mesh_of(model), model.points);
  EXPECT_TRUE(simplifier.run(1));
  EXPECT_LT(simplifier.mesh().triangle_count(), 100U);
  for (const SplitRecord& record : simplifier.collapses()) {
    EXPECT_NE(record.v_t, 7U);
    EXPECT_NE(record.v_t, 99U);
  }
}

// The oracle's squares would underflow, so triangles are judged as if the grid were 1 wide.
TEST(Simplifier, DetailsOfAnySizeNeverTurnOver) {
  Random random(1);
  Model grid = field(11, [](unsigned, unsigned) { return 0.0; });
  for (Point& p : grid.points)
    for (unsigned i = 0; i < 2; ++i) p[i] += 0.4 * random.unit();
  for (const double low : {0.0, -1.0})  // the corner of the box, or its middle, is at the detail
    for (const double size : {1.0, 1e-40, 1e-75, 1e-80, 1e-82, 1e-100, 1e-150, 1e-160}) {
      Model model = grid;
      for (Point& p : model.points)
        for (double& x : p) x *= size;
      const auto n = static_cast<Vertex>(model.points.size());
      for (const Point& p : {Point{low, low, 1}, Point{1, low, 1}, Point{low, 1, 1}}) model.points.push_back(p);
      model.triangles.push_back({n, n + 1, n + 2});
      Simplifier simplifier(mesh_of(model), model.points);
      EXPECT_TRUE(simplifier.run(60));
      EXPECT_LE(simplifier.mesh().triangle_count(), 60U) << size;
      for (const Corners& t : sample::triangles_of(simplifier.mesh())) {
        if (t[0] < n) {
          EXPECT_GT(normal_of(grid.points, t)[2], 0) << size;
        }
      }
    }
}

TEST(Simplifier, FixedVerticesStay) {
  const Model model = joined(torus(20, 12), letter(12), 20);
  Random random(4);
  for (const BoundaryPolicy policy : {BoundaryPolicy::lock, BoundaryPolicy::move}) {
    std::set<Vertex> chosen;
    for (unsigned i = 0; i < 40; ++i) chosen.insert(random.below(model.points.size()));
    const std::vector<Vertex> fixed(chosen.begin(), chosen.end());
    Simplifier simplifier(mesh_of(model), model.points, policy, fixed);
    EXPECT_TRUE(simplifier.run(1));
    EXPECT_GT(simplifier.collapses().size(), 50U);
    Oracle oracle(model, mesh_of(model));
    for (const SplitRecord& record : simplifier.collapses()) {
      EXPECT_FALSE(chosen.contains(record.v_t));
      EXPECT_EQ(oracle.collapse(record, policy), "");
    }
  }
  std::vector<Vertex> all(model.points.size());
  for (Vertex v = 0; v < all.size(); ++v) all[v] = v;
  Simplifier simplifier(mesh_of(model), model.points, BoundaryPolicy::move, all);
  EXPECT_TRUE(simplifier.run(1));
  EXPECT_TRUE(simplifier.collapses().empty());
  ASSERT_EQ(simplifier.obstacles().size(), 1U);
  EXPECT_STREQ(simplifier.obstacles().front().why, "both ends stay where they are");
}

}  // namespace
}  // namespace restrip::simplifier_test
