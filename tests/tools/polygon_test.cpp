// Claims: the triangles of a simple polygon cover it exactly once and have its orientation, wherever it lies, also with
// corners on straight lines, corners at one place, and holes joined by an edge that is passed twice. Convex polygons
// become fans. Judged by areas: all are positive, and their sum is that of the outline.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "meshes/soup_builder.hpp"
#include "shapes.hpp"

namespace restrip::tools {
namespace {

using Outline = std::vector<Point>;

Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Twice the area of a polygon, as a vector.
Point area_of(const Outline& outline) {
  Point sum;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Point part = cross(minus(outline[i], outline[0]), minus(outline[i + 1], outline[0]));
    sum = {sum.x + part.x, sum.y + part.y, sum.z + part.z};
  }
  return sum;
}

std::vector<Corners> fan_of(std::size_t size) {
  std::vector<Corners> fan;
  for (std::uint32_t i = 2; i < size; ++i) fan.push_back({0, i - 1, i});
  return fan;
}

std::vector<Corners> cut_outline(const Outline& outline) {
  std::vector<Corners> made = fan_of(outline.size());
  PolygonCutter cutter(outline);
  EXPECT_TRUE(cutter.cut(made));
  return made;
}

/// `flat`: how many triangles have no area.
void expect_covered(const Outline& outline, const std::string& name, std::size_t flat = 0) {
  const std::vector<Corners> triangles = cut_outline(outline);
  const Point whole = area_of(outline);
  const double length = std::sqrt(dot(whole, whole));
  double sum = 0;
  std::size_t without_area = 0;
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const Corners& t : triangles) {
    const double area = dot(area_of({outline[t[0]], outline[t[1]], outline[t[2]]}), whole) / length;
    EXPECT_GE(area, -1e-12 * length) << name;
    sum += std::abs(area);
    if (area <= 1e-12 * length) ++without_area;
    for (std::size_t i = 0; i < 3; ++i) sides.emplace(t[i], t[(i + 1) % 3]);
  }
  EXPECT_NEAR(sum, length, 1e-9 * length) << name;
  EXPECT_EQ(without_area, flat) << name;
  // Each side of the polygon is a side of one triangle; the others are sides of two, in opposite directions.
  for (std::uint32_t i = 0; i < outline.size(); ++i)
    EXPECT_EQ(sides.count({i, (i + 1) % static_cast<std::uint32_t>(outline.size())}), 1U) << name;
  for (const auto& [from, to] : sides)
    EXPECT_EQ(sides.count({to, from}), (from + 1) % outline.size() == to ? 0U : 1U) << name;
}

/// In every order of the corners, both orientations, and eight planes of space.
void expect_covered_everywhere(const Outline& outline, const std::string& name, std::size_t flat = 0) {
  for (std::size_t first = 0; first < outline.size(); ++first)
    for (const bool turned : {false, true})
      for (unsigned plane = 0; plane < 8; ++plane) {
        Outline moved = outline;
        std::rotate(moved.begin(), moved.begin() + static_cast<std::ptrdiff_t>(first), moved.end());
        if (turned) std::reverse(moved.begin(), moved.end());
        for (Point& p : moved) {
          if (plane % 3 == 1) p = {p.y, p.z, p.x};
          if (plane % 3 == 2) p = {p.z, p.x, p.y};
          if (plane > 2) p = {0.75 * p.x - 0.5 * p.y, p.y + 2 * p.z, p.z - 0.25 * p.x};
          if (plane > 5) p = {1024 + p.x / 1024, p.y / 1024 - 4096, p.z / 1024};
        }
        expect_covered(
            moved, fmt::format("{}, from corner {}{}, plane {}", name, first, turned ? ", turned" : "", plane), flat);
        if (testing::Test::HasFailure()) return;
      }
}

/// "x y" of each corner.
Outline flat_outline(const std::string& corners) {
  std::istringstream numbers(corners);
  Outline made;
  for (double x = 0, y = 0; numbers >> x >> y;) made.push_back({x, y, 0});
  return made;
}

TEST(Polygon, ConvexOnesBecomeFans) {
  for (std::size_t size = 4; size < 40; ++size) {
    Outline outline;
    for (std::size_t i = 0; i < size; ++i) {
      const double at = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(size);
      outline.push_back({std::cos(at), std::sin(at), 1});
    }
    EXPECT_EQ(cut_outline(outline), fan_of(size));
  }
}

TEST(Polygon, ShapesThatAreHardToCut) {
  struct Shape {
    const char* name;
    const char* corners;
    std::size_t flat = 0;
  };
  for (const auto& [name, corners, flat] : {
           Shape{"an arrow", "0 0  2 1  4 0  2 4"},
           {"a U", "0 0  4 0  4 4  3 4  3 1  1 1  1 4  0 4"},
           {"a comb", "0 0  7 0  7 3  6 3  6 1  5 1  5 5  4 5  4 1  3 1  3 2  2 2  2 1  1 1  1 4  0 4"},
           {"corners on straight lines", "0 0  1 0  2 0  3 0  3 2  3 3  0 3  0 1"},
           {"one corner on a line", "0 0  1 0  2 0  1 1"},
           {"a hole", "0 0  9 0  9 9  0 9  0 0  3 3  3 6  6 6  6 3  3 3"},
           {"two holes in a row", "0 0  9 0  9 9  0 9  0 0  1 1  1 2  2 2  5 5  5 6  6 6  6 5  5 5  2 2  2 1  1 1"},
           {"a spiral", "0 0  8 0  8 1  2 1  2 7  7 7  7 3  4 3  4 5  5 5  5 4  6 4  6 6  3 6  3 2  8 2  8 8  0 8"},
           {"a corner twice in a row", "0 0  0 0  4 0  2 1  4 4  0 4", 1},
       })
    expect_covered_everywhere(flat_outline(corners), name, flat);
}

// A star around a centre that sees all of it, with random radii: simple by construction.
TEST(Polygon, RandomStars) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> radius(0.05, 1);
  for (std::size_t size = 4; size < 400; size += 1 + size / 8)
    for (int i = 0; i < 8; ++i) {
      Outline outline;
      for (std::size_t corner = 0; corner < size; ++corner) {
        const double at = 2 * std::numbers::pi * static_cast<double>(corner) / static_cast<double>(size);
        const double r = radius(random);
        outline.push_back({r * std::cos(at), r * std::sin(at), 0.5 * r * std::cos(at)});
      }
      expect_covered(outline, fmt::format("a star of {} corners", size));
    }
}

// Whatever the corners are, there are as many triangles, of these corners, at once.
TEST(Polygon, OutlinesThatCrossThemselvesEnd) {
  std::mt19937 random(3);
  const auto number = [&random](unsigned range) { return static_cast<double>(random() % range); };
  for (std::size_t size = 4; size < 300; size += 1 + size / 3)
    for (const unsigned range : {1U, 2U, 3U, 10U, 1000U}) {
      Outline outline;
      for (std::size_t i = 0; i < size; ++i) outline.push_back({number(range), number(range), number(2)});
      std::set<std::uint32_t> named;
      for (const Corners& t : cut_outline(outline)) {
        EXPECT_FALSE(degenerate(t));
        named.insert(t.begin(), t.end());
      }
      EXPECT_EQ(named.size(), size);
    }
  for (const double far : {1e38, 1e-38})
    (void)cut_outline({{0, 0, 0}, {far, 0, 0}, {far, far, 0}, {far / 2, far / 4, 0}});
}

// Every reader hands its polygons over: the same outline in each format that has polygons.
TEST(Polygon, EveryFormat) {
  const Outline outline = flat_outline("0 0  4 0  4 4  2 1  0 4");
  std::string points;
  std::string vs;
  for (const Point& p : outline) {
    points += fmt::format("{} {} 0\n", p.x, p.y);
    vs += fmt::format("v {} {} 0\nvt {} {}\n", p.x, p.y, p.x, p.y);
  }
  const std::string ply =
      "ply\nformat ascii 1.0\n{}element vertex 5\nproperty float x\nproperty float y\nproperty float z\n{}end_header\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_index\n";
  for (const Soup& soup : {read_as(".obj", vs + "f 1 2 3 4 5\n"), read_as(".obj", "f 1 2 3 4 5\n" + vs),
                           read_as(".obj", vs + "f 1/1 2/2 3/3 4/4 5/5\n", ReadAttributes::yes),
                           read_as(".off", "OFF 5 1 0\n" + points + "5 0 1 2 3 4\n"),
                           read_as(".ply", fmt::format(fmt::runtime(ply), "", faces) + points + "5 0 1 2 3 4\n"),
                           read_as(".ply", fmt::format(fmt::runtime(ply), faces, "") + "5 0 1 2 3 4\n" + points)}) {
    EXPECT_EQ(soup.polygons, 1U);
    double sum = 0;
    for (const Corners& t : soup.triangles) {
      const double area = area_of({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]}).z / 2;
      EXPECT_GT(area, 0);
      sum += area;
    }
    EXPECT_EQ(soup.triangles.size(), 3U);
    EXPECT_DOUBLE_EQ(sum, 10);
  }
  // The strips of the file beside it stay, and its triangles are strips of one.
  const Soup both = read_as(".ply", fmt::format(fmt::runtime(ply), "",
                                                faces + "element tristrips 1\nproperty list uchar int vertex_index\n") +
                                        points + "5 0 1 2 3 4\n4 0 1 2 3\n");
  ASSERT_EQ(both.triangles.size(), 5U);
  std::vector<std::uint32_t> strips;
  for (std::size_t t = 0; t < 3; ++t) {
    strips.insert(strips.end(), both.triangles[t].begin(), both.triangles[t].end());
    strips.push_back(strip_end);
  }
  strips.insert(strips.end(), {0, 1, 2, 3});
  EXPECT_EQ(both.strips, strips);
}

}  // namespace
}  // namespace restrip::tools
