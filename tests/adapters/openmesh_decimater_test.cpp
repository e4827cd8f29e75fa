// OpenMesh's decimater with our module maintains the strips and counts them; without the module it breaks them, and
// debug builds say so.
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

struct OpenMeshLibrary {
  using Strips = OpenMeshStrips<Mesh>;

  static Mesh copy_of(const Placed& from) {
    return restrip::copy_of<Mesh>(
        from.mesh,
        [&](restrip::Vertex v) {
          const auto& [x, y, z] = from.points[v];
          return Mesh::Point(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        },
        [](restrip::Vertex v) { return OpenMesh::VertexHandle(static_cast<int>(v)); });
  }
  /// To a fifth of its triangles.
  static HookTally simplify(Mesh& mesh, Strips* strips) {
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    ModStripsT<Mesh>::Handle keeping;
    if (strips != nullptr) {
      decimater.add(keeping);
      decimater.module(keeping).keep(*strips);
    }
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate_to_faces(0, mesh.n_faces() / 5);
    return strips != nullptr ? decimater.module(keeping).tally() : HookTally{};
  }
  static void collect(Mesh& mesh) { mesh.garbage_collection(); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(OpenMesh, Decimation, OpenMeshLibrary);

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
