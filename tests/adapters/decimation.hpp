// Shared by the tests of other libraries' decimaters: meshes with points, made and real, strips copied to a foreign
// mesh, and a check that the strips have been maintained.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../runtime/sample_meshes.hpp"
#include "../tools/real_meshes.hpp"
#include "restrip/mesh/checks.hpp"
#include "restrip/operations/hooks.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {

/// A mesh with strips and points.
struct Placed {
  StripMesh mesh;
  std::vector<std::array<double, 3>> points;
};

inline Placed placed(StripMesh mesh, std::vector<std::array<double, 3>> points) {
  stripify(mesh, Effort::fast, Cost::strips());
  return {std::move(mesh), std::move(points)};
}

inline Placed bumpy_torus(Vertex columns, Vertex rows) {
  std::vector<std::array<double, 3>> points;
  for (Vertex y = 0; y < rows; ++y)
    for (Vertex x = 0; x < columns; ++x) {
      const double u = 2 * 3.141592653589793 * x / columns;
      const double v = 2 * 3.141592653589793 * y / rows;
      const double around = 3 + std::cos(v) * (1 + 0.1 * std::sin(5 * u));
      points.push_back({around * std::cos(u), around * std::sin(u), std::sin(v) + 0.05 * std::sin(7 * u + 3 * v)});
    }
  return placed(sample::torus(columns, rows), std::move(points));
}

inline Placed bumpy_sheet(Vertex columns, Vertex rows) {
  std::vector<std::array<double, 3>> points;
  for (Vertex y = 0; y <= rows; ++y)
    for (Vertex x = 0; x <= columns; ++x)
      points.push_back({double(x), double(y), std::sin(0.7 * x) * std::cos(0.4 * y + 0.1 * x)});
  return placed(sample::rectangle(columns, rows), std::move(points));
}

/// Vertices and triangles of an OBJ file.
inline Placed read_placed(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::array<double, 3>> points;
  std::vector<sample::Corners> triangles;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      auto& [x, y, z] = points.emplace_back();
      words >> x >> y >> z;
    } else if (kind == "f") {
      sample::Corners corners{};
      for (Vertex& corner : corners) {
        std::string word;
        words >> word;
        corner = static_cast<Vertex>(std::stoul(word)) - 1;
      }
      triangles.push_back(corners);
    }
  }
  BuildReport report;
  StripMesh mesh = StripMesh::build(triangles, points.size(), &report);
  EXPECT_EQ(report.non_manifold_vertices, 0U) << file;
  EXPECT_EQ(mesh.triangle_count(), triangles.size()) << file;
  return placed(std::move(mesh), std::move(points));
}

/// `strips` is a numbered mesh whose triangle t has the corners of triangle t of `from`.
template <class Strips>
void take_colors(Strips& strips, const StripMesh& from) {
  for (Triangle t = 0; t < from.triangle_bound(); ++t) {
    auto h = strips.halfedge(t);
    for (int turn = 0; turn < 3; ++turn, h = strips.next(h))
      for (unsigned side = 0; side < 3; ++side)
        if (const auto there = StripMesh::halfedge(t, side); from.from(there) == strips.from(h) && from.solid(there))
          strips.set_solid(h, true);
  }
  ASSERT_EQ(count_strips(strips), count_strips(from));
}

/// Calls visit(h) for every halfedge with a triangle.
template <class Strips, class Visit>
void for_each_side(const Strips& strips, Visit&& visit) {
  for (std::uint32_t t = 0; t < strips.triangle_bound(); ++t) {
    if (!strips.has_triangle(t)) continue;
    auto h = strips.halfedge(t);
    for (int turn = 0; turn < 3; ++turn, h = strips.next(h)) visit(h);
  }
}

/// The strips were maintained: colours are valid, no boundary edge is solid, and the number of strips is the reported
/// one.
template <class Strips>
void expect_kept(const Strips& strips, const ColoringReport& before, const HookTally& tally) {
  const ColoringReport after = check_coloring(strips);
  EXPECT_TRUE(after.valid);
  EXPECT_EQ(static_cast<long>(after.strips), static_cast<long>(before.strips) + tally.strips);
  EXPECT_EQ(static_cast<long>(after.isolated), static_cast<long>(before.isolated) + tally.isolated);
  EXPECT_EQ(extract_strips(strips).size(), after.strips);
  EXPECT_EQ(tally.unannounced, 0U);
  EXPECT_GT(tally.operations, before.triangles / 4);
  EXPECT_LE(after.triangles, before.triangles / 2);
  EXPECT_LT(after.strips, after.triangles / 3);
  for_each_side(strips, [&](auto h) {
    if (strips.on_boundary(strips.opposite(h))) {
      EXPECT_FALSE(strips.solid(h));
    }
  });
}

/// The colours are no longer valid, and the next operation at a triangle with three solid edges reports it.
template <class Strips>
void expect_broken(Strips& strips) {
  EXPECT_FALSE(check_coloring(strips).valid);
  std::size_t refused = 0;
  for_each_side(strips, [&](auto h) {
    const auto second = strips.next(h);
    if (!strips.solid(h) || !strips.solid(second) || !strips.solid(strips.next(second))) return;
    try {
      flip(strips, h);
      ADD_FAILURE() << "three solid edges, but no complaint";
    } catch (const std::logic_error& error) {
      if (std::string(error.what()) == std::string("flip: ") + describe(Refusal::colors_not_valid)) ++refused;
    }
  });
  EXPECT_GT(refused, 0U);
}

/// Compares the strips after a library's decimater with our hook and without it. A Library has
///   Strips                   one of our meshes, over the library's mesh
///   copy_of(Placed)          returns a mesh of the library
///   simplify(mesh, Strips*)  removes at least half of the triangles, maintaining the strips unless null; a HookTally
///   collect(mesh)            removes deleted elements
template <class Library>
class Decimation : public testing::Test {
 protected:
  static void expect_strips_are_kept(const Placed& start) {
    auto mesh = Library::copy_of(start);
    typename Library::Strips strips(mesh);
    take_colors(strips, start.mesh);
    const ColoringReport before = check_coloring(strips);
    expect_kept(strips, before, Library::simplify(mesh, &strips));
    Library::collect(mesh);
    EXPECT_TRUE(check_coloring(strips).valid);
  }
};
TYPED_TEST_SUITE_P(Decimation);

TYPED_TEST_P(Decimation, KeepsStripsOfMadeMeshes) {
  this->expect_strips_are_kept(bumpy_torus(40, 30));
  this->expect_strips_are_kept(bumpy_sheet(30, 30));
}
TYPED_TEST_P(Decimation, KeepsStripsOfRockerArm) {
  const auto file = REAL_MESH("rocker-arm.obj");
  this->expect_strips_are_kept(read_placed(file));
}
TYPED_TEST_P(Decimation, KeepsStripsOfBunnyWithItsHoles) {
  const auto file = REAL_MESH("bunny.obj");
  this->expect_strips_are_kept(read_placed(file));
}
TYPED_TEST_P(Decimation, BreaksThemWithoutTheHook) {
  const Placed start = bumpy_torus(40, 30);
  auto mesh = TypeParam::copy_of(start);
  typename TypeParam::Strips strips(mesh);
  take_colors(strips, start.mesh);
  TypeParam::simplify(mesh, nullptr);
  expect_broken(strips);
}
REGISTER_TYPED_TEST_SUITE_P(Decimation, KeepsStripsOfMadeMeshes, KeepsStripsOfRockerArm, KeepsStripsOfBunnyWithItsHoles,
                            BreaksThemWithoutTheHook);

}  // namespace restrip
