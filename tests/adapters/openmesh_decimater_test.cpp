// OpenMesh's decimater with our module keeps the strips, and tells how many there are; without the module it breaks
// them, and debug builds say so.
#include "throwing_checks.hpp"
// That one first.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "decimation.hpp"
#include "lockstep.hpp"
#include "restrip/operations/adapters/openmesh_decimater.hpp"

namespace restrip {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

Mesh copy_of(const Placed& from) {
  return copy_of<Mesh>(
      from.mesh,
      [&](restrip::Vertex v) {
        const auto& [x, y, z] = from.points[v];
        return Mesh::Point(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
      },
      [](restrip::Vertex v) { return OpenMesh::VertexHandle(static_cast<int>(v)); });
}

/// To a fifth of its triangles; `strips`: to be kept, or nullptr.
HookTally decimate(Mesh& mesh, OpenMeshStrips<Mesh>* strips, HookRules rules = HookRules::local) {
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  ModStripsT<Mesh>::Handle keeping;
  if (strips != nullptr) {
    decimater.add(keeping);
    decimater.module(keeping).keep(*strips, rules);
  }
  EXPECT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, mesh.n_faces() / 5);
  return strips != nullptr ? decimater.module(keeping).tally() : HookTally{};
}

void expect_decimater_keeps(const Placed& start) {
  std::size_t kept = start.mesh.triangle_count();
  for (const HookRules rules : {HookRules::local, HookRules::linked}) {
    Mesh mesh = copy_of(start);
    OpenMeshStrips<Mesh> strips(mesh);
    take_colors(strips, start.mesh);
    const ColoringReport before = check_coloring(strips);
    expect_kept(strips, before, decimate(mesh, &strips, rules));
    mesh.garbage_collection();
    const ColoringReport after = check_coloring(strips);
    EXPECT_TRUE(after.valid);
    EXPECT_LT(after.strips, kept);  // the same triangles in fewer strips by linked rules
    kept = after.strips;
  }
}

TEST(OpenMeshDecimater, KeepsStripsOfMadeMeshes) {
  expect_decimater_keeps(bumpy_torus(40, 30));
  expect_decimater_keeps(bumpy_sheet(30, 30));
}
TEST(OpenMeshDecimater, KeepsStripsOfRockerArm) {
  const auto file = REAL_MESH("rocker-arm.obj");
  expect_decimater_keeps(read_placed(file));
}
TEST(OpenMeshDecimater, KeepsStripsOfBunnyWithItsHoles) {
  const auto file = REAL_MESH("bunny.obj");
  expect_decimater_keeps(read_placed(file));
}
TEST(OpenMeshDecimater, BreaksThemWithoutTheModule) {
  const Placed start = bumpy_torus(40, 30);
  Mesh mesh = copy_of(start);
  OpenMeshStrips<Mesh> strips(mesh);
  take_colors(strips, start.mesh);
  decimate(mesh, nullptr);
  expect_broken(strips);
}
TEST(OpenMeshDecimater, ModuleAsksForStrips) {
  Mesh mesh;
  OpenMeshStrips<Mesh> strips(mesh);
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  ModStripsT<Mesh>::Handle keeping;
  decimater.add(keeping);
  EXPECT_THROW(decimater.initialize(), std::logic_error);
  Mesh other;
  OpenMeshStrips<Mesh> of_other(other);
  EXPECT_THROW(decimater.module(keeping).keep(of_other), std::logic_error);
  decimater.module(keeping).keep(strips);
  EXPECT_TRUE(decimater.initialize());
}

}  // namespace
}  // namespace restrip
