// A visitor that maintains strips while CGAL's edge_collapse simplifies the mesh.
//
//   namespace SMS = CGAL::Surface_mesh_simplification;
//   restrip::SurfaceMeshStrips strips(mesh);                    // and its colours, e.g. from stripify()
//   restrip::HookTally tally;
//   SMS::edge_collapse(mesh, SMS::Count_stop_predicate<Mesh>(3000),
//                      CGAL::parameters::visitor(restrip::StripVisitor(strips, tally)));
//   tally.strips;                                               // change in the number of strips
//
// Without a visitor edge_collapse leaves colours that are not valid. CGAL first collapses mesh edges of length zero and
// notifies a visitor only afterwards; strips are cut there if necessary, and HookTally::unannounced counts these
// collapses. Include this header only where you have CGAL 5.4 or later.
#pragma once

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>

#include <memory>
#include <optional>
#include <utility>

#include "restrip/mesh/adapters/cgal.hpp"
#include "restrip/operations/hooks.hpp"

namespace restrip {

/// `Base`: another visitor, which is called too. CGAL copies visitors; the copies share their state. The strips and the
/// tally must outlive the simplification.
template <class Point,
          class Base = CGAL::Surface_mesh_simplification::Edge_collapse_visitor_base<CGAL::Surface_mesh<Point>>>
class StripVisitor : public Base {
 public:
  using Mesh = CGAL::Surface_mesh<Point>;
  using Halfedge = typename Mesh::Halfedge_index;
  using Vertex = typename Mesh::Vertex_index;

  StripVisitor(SurfaceMeshStrips<Point>& strips, HookTally& tally, Base base = {})
      : Base(std::move(base)), strips_(&strips), tally_(&tally), pending_(std::make_shared<Pending>()) {}

  // Called by CGAL.
  template <class Profile, class Placement>
  void OnCollapsing(const Profile& profile, const Placement& placement) {
    Base::OnCollapsing(profile, placement);
    pending_->emplace(before_collapse(*strips_, profile.v1_v0()));  // CGAL removes v0
  }
  template <class Profile>
  void OnCollapsed(const Profile& profile, Vertex kept) {
    const Mesh& mesh = profile.surface_mesh();
    // Seen from v1, what CGAL calls right is left.
    const Halfedge left = profile.right_face_exists() ? mesh.halfedge(kept, profile.vR()) : Halfedge();
    const Halfedge right = profile.left_face_exists() ? mesh.halfedge(kept, profile.vL()) : Halfedge();
    if (pending_->has_value()) {
      tally_->add(after_collapse(*strips_, std::move(**pending_), left.is_valid() ? left : right));
      pending_->reset();
    } else {
      // Each was merged from two edges of a removed triangle. All other edges keep their colours.
      for (const Halfedge merged : {left, right})
        if (merged.is_valid()) strips_->set_solid(merged, false);
      ++tally_->unannounced;
    }
    Base::OnCollapsed(profile, kept);
  }

 private:
  using Pending = std::optional<PendingCollapse<Halfedge>>;
  SurfaceMeshStrips<Point>* strips_;
  HookTally* tally_;
  std::shared_ptr<Pending> pending_;
};

template <class Point>
StripVisitor(SurfaceMeshStrips<Point>&, HookTally&) -> StripVisitor<Point>;

}  // namespace restrip
