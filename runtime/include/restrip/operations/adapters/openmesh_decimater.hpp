// A module for OpenMesh's decimaters that maintains strips while they simplify the mesh.
//
//   restrip::OpenMeshStrips strips(mesh);                       // and its colours, e.g. from stripify()
//   OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
//   OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
//   restrip::ModStripsT<Mesh>::Handle keeping;
//   decimater.add(quadric);
//   decimater.add(keeping);
//   decimater.module(keeping).keep(strips);
//   decimater.initialize();
//   decimater.decimate_to_faces(0, 2000);
//   decimater.module(keeping).tally().strips;                   // change in the number of strips
//
// It works with DecimaterT, McDecimaterT and MixedDecimaterT and does not influence which collapses are made. Without
// it a decimater leaves colours that are not valid. Include this header only where you have OpenMesh 8 or later.
#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "restrip/mesh/adapters/openmesh.hpp"
#include "restrip/operations/hooks.hpp"
#include "restrip/precondition.hpp"

namespace restrip {

template <class MeshT>
class ModStripsT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  // The names that OpenMesh expects of a module.
  using Self = ModStripsT;
  using Handle = OpenMesh::Decimater::ModHandleT<Self>;
  using Base = OpenMesh::Decimater::ModBaseT<MeshT>;
  using Mesh = typename Base::Mesh;
  using CollapseInfo = typename Base::CollapseInfo;

  explicit ModStripsT(MeshT& mesh) : Base(mesh, true) {}
  [[nodiscard]] const std::string& name() const override {
    static const std::string strips = "Strips";
    return strips;
  }

  /// Sets the strips to maintain, on the decimater's mesh. The strips must outlive the decimation.
  void keep(OpenMeshStrips<MeshT>& strips) {
    RESTRIP_ASSERT(&strips.mesh() == &this->mesh(), "ModStripsT::keep", "these strips belong to another mesh");
    strips_ = &strips;
  }
  /// Changes by collapses since keep().
  [[nodiscard]] const HookTally& tally() const noexcept { return tally_; }

  /// Called by OpenMesh. Throws std::logic_error if keep() has not been called.
  void initialize() override {
    if (strips_ == nullptr) RESTRIP_THROW(std::logic_error, "restrip: ModStripsT has no strips to keep: call keep()");
  }
  void preprocess_collapse(const CollapseInfo& info) override {
    pending_.emplace(before_collapse(*strips_, info.v1v0));  // OpenMesh removes v0
  }
  void postprocess_collapse(const CollapseInfo& info) override {
    // Seen from v1, what OpenMesh calls right is left.
    const auto apex = info.vr.is_valid() ? info.vr : info.vl;
    tally_.add(after_collapse(*strips_, std::move(*pending_), this->mesh().find_halfedge(info.v1, apex)));
    pending_.reset();
  }

 private:
  OpenMeshStrips<MeshT>* strips_ = nullptr;
  std::optional<PendingCollapse<OpenMesh::HalfedgeHandle>> pending_;
  HookTally tally_;
};

}  // namespace restrip
