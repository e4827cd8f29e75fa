// Any triangles replaced by any others: granted exactly if the list of triangles that results builds a manifold mesh,
// and then the mesh is that list; dual edges elsewhere keep their colours. The oracle builds the list anew as a
// StripMesh and reads its report.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <vector>

#include "random_operation.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/stripify.hpp"
#include "sample_meshes.hpp"
#include "whole_mesh.hpp"

namespace restrip {
namespace {

using Corner3 = std::array<Vertex, 3>;

/// Whether all vertices of the list are manifold, with three triangles or more around interior ones.
bool builds_a_manifold(const std::vector<Corner3>& list, Vertex bound) {
  BuildReport report;
  const StripMesh mesh = StripMesh::build(list, bound, &report);
  if (report.degenerate_triangles + report.non_manifold_edges + report.inconsistent_edges +
          report.non_manifold_vertices >
      0)
    return false;
  for (Vertex v = 0; v < mesh.vertex_bound(); ++v)
    if (mesh.spoke(v).id != none && !mesh.leaves_boundary(mesh.spoke(v)) && spoke_count(mesh, v) < 3) return false;
  // Two triangles with the same three corners in opposite directions leave vertices of two triangles; the same
  // direction twice is inconsistent.
  return true;
}

struct Change {
  std::vector<Triangle> out;
  std::vector<Corner3> in;
};

/// A disc around a triangle, a random set, or nothing, goes; what comes is a fan around a new vertex, the same
/// triangles again, random ones, a strip along the rim, or nothing.
Change random_change(const StripMesh& mesh, std::mt19937& random) {
  Change change;
  const auto random_triangle = [&] {
    Triangle t = 0;
    do t = static_cast<Triangle>(random() % mesh.triangle_bound());
    while (!mesh.alive(t));
    return t;
  };
  const auto kind = random() % 6;
  if (kind != 0) {
    change.out.push_back(random_triangle());
    if (kind < 4)
      add_rings(mesh, change.out, static_cast<unsigned>(random() % 2));
    else if (kind == 5)
      for (int n = 0; n < 3; ++n) change.out.push_back(random_triangle());
    detail::sort_unique(change.out);
    std::shuffle(change.out.begin(), change.out.end(), random);
  }
  const auto fresh = static_cast<Vertex>(mesh.vertex_bound() + random() % 3);
  switch (random() % 5) {
    case 0:
      break;
    case 1:  // a fan around one new vertex, over the sides of `out` that have no triangle of `out` beyond
      for (const Triangle t : change.out)
        for (unsigned s = 0; s < 3; ++s) {
          const Halfedge h = StripMesh::halfedge(t, s);
          const Halfedge back = mesh.opposite(h);
          if (StripMesh::on_boundary(back) ||
              std::find(change.out.begin(), change.out.end(), StripMesh::triangle(back)) == change.out.end())
            change.in.push_back({mesh.from(h), mesh.to(h), fresh});
        }
      break;
    case 2:
      for (const Triangle t : change.out) change.in.push_back(mesh.corners(t));
      if (!change.in.empty() && random() % 2 == 0) std::swap(change.in[0][0], change.in[0][1]);
      break;
    case 3:
      for (int n = 0; n < 2; ++n) {
        const auto any = [&] { return static_cast<Vertex>(random() % (mesh.vertex_bound() + 2)); };
        change.in.push_back({any(), any(), any()});
      }
      break;
    default: {  // a triangle on the rim
      for (int n = 0; n < 40 && change.in.empty(); ++n) {
        const Halfedge h = StripMesh::halfedge(random_triangle(), static_cast<unsigned>(random() % 3));
        if (StripMesh::on_boundary(mesh.opposite(h))) change.in.push_back({mesh.to(h), mesh.from(h), fresh});
      }
    }
  }
  return change;
}

TEST(Replace, MakesTheMeshOfTheListOrRefusesIt) {
  std::mt19937 random(7);
  std::size_t granted = 0;
  std::size_t refused = 0;
  for (const StripMesh& start : {sample::torus(6, 5), sample::rectangle(6, 5), sample::tube(5, 6), sample::sphere(1),
                                 sample::tetrahedron(), sample::double_cone(12)}) {
    StripMesh mesh = start;
    stripify(mesh, Effort::fast, Cost::strips());
    for (int n = 0; n < 3000; ++n) {
      if (mesh.triangle_count() < 4 || mesh.triangle_count() > 4 * start.triangle_count()) mesh = start;
      const Change change = random_change(mesh, random);
      std::vector<Corner3> list;
      for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
        if (mesh.alive(t) && std::find(change.out.begin(), change.out.end(), t) == change.out.end())
          list.push_back(mesh.corners(t));
      list.insert(list.end(), change.in.begin(), change.in.end());
      const auto bound = static_cast<Vertex>(mesh.vertex_bound() + 4);
      const Refusal refusal = check_replace(mesh, change.out, change.in);
      ASSERT_EQ(refusal == Refusal::granted, builds_a_manifold(list, bound)) << describe(refusal) << " " << n;
      if (refusal != Refusal::granted) {
        ++refused;
        continue;
      }
      ++granted;
      const StripMesh before = mesh;
      std::vector<Triangle> changed;
      std::vector<Triangle> made;
      mesh.watch(&changed);
      mesh.replace(change.out, change.in, made);
      mesh.watch(nullptr);
      ASSERT_EQ(fault_of(mesh), "") << n;
      ASSERT_EQ(sample::triangles_of(mesh), sample::triangles_of(StripMesh::build(list, bound)));
      ASSERT_TRUE(check_coloring(mesh).valid);
      for (std::size_t i = 0; i < made.size(); ++i) {
        ASSERT_EQ(mesh.corners(made[i]), change.in[i]);
        ASSERT_EQ(mesh.solid_degree(made[i]), 0U);
        if (i < change.out.size()) {
          ASSERT_EQ(made[i], change.out[i]);
        }
      }
      const std::set<Triangle> named(changed.begin(), changed.end());
      for (Triangle t = 0; t < before.triangle_bound(); ++t)
        if (!named.contains(t) && before.alive(t)) {
          ASSERT_TRUE(mesh.alive(t) && mesh.solid_sides(t) == before.solid_sides(t));
        }
    }
  }
  EXPECT_GT(granted, 3000U);
  EXPECT_GT(refused, 3000U);
}

}  // namespace
}  // namespace restrip
