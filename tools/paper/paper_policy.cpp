#include "paper/paper_policy.hpp"

#include <algorithm>
#include <memory>

#include "restrip/operations/operations.hpp"
#include "restrip/search/strip_index.hpp"
#include "restrip/search/tunnel.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit<Halfedge>;
using Spokes = Where::Spokes;

Halfedge any_spoke(const Where& where) { return where.spokes == Spokes::right_only ? where.right : where.left; }

bool around_four_triangles(const StripMesh& mesh, Halfedge spoke) {
  Halfedge h = spoke;
  for (int i = 0; i < 4; ++i) {
    if (StripMesh::on_boundary(h) || (i > 0 && h == spoke)) return false;
    h = turn_ccw(mesh, h);
  }
  return h == spoke;
}

/// Both halves of a cut edge take its colour. `inner`: the side of the new triangle on the chord.
void inherit(StripMesh& mesh, Halfedge inner, bool solid) {
  if (!solid) return;  // a new triangle's edges are dashed, and the mesh may end at one of them
  mesh.set_solid(StripMesh::next(inner), true);
  mesh.set_solid(StripMesh::next(StripMesh::next(inner)), true);
}

/// Tunnels from isolated triangles while they are more than a tenth of the strips, the threshold of Porcu, Sanna,
/// Scateni, "Efficiently keeping an optimal stripification over a CLOD mesh", 2005.
class TunnelledPaper {
 public:
  TunnelledPaper(StripMesh& mesh, bool join) : mesh_(mesh), index_(mesh), join_(join) {
    for (Triangle t = 0; t < mesh.triangle_bound(); ++t)
      if (mesh.alive(t)) note(t);
  }

  Halfedge split(const Where& where, Vertex v_t) {
    fan_triangles(mesh_, any_spoke(where), patch_);
    index_.before_patch(mesh_, patch_);
    const Halfedge chord = split_as_the_paper(mesh_, where, v_t, join_);
    edge_triangles(mesh_, chord, patch_);
    index_.after_patch(mesh_, patch_);
    for (const Triangle t : patch_) note(t);
    return chord;
  }

  void tunnel() {
    if (!too_many()) return;
    // Some have found a strip meanwhile, some were noted twice.
    std::sort(alone_.begin(), alone_.end());
    alone_.erase(std::unique(alone_.begin(), alone_.end()), alone_.end());
    std::erase_if(alone_, [&](Triangle t) { return mesh_.solid_degree(t) != 0; });
    std::vector<Triangle> left;
    for (; !alone_.empty() && 10 * (alone_.size() + left.size()) > index_.strips(); alone_.pop_back()) {
      const Triangle t = alone_.back();
      if (mesh_.solid_degree(t) == 0 && !tunnel_.join(mesh_, index_, t, short_tunnel)) left.push_back(t);
    }
    alone_.insert(alone_.end(), left.begin(), left.end());
  }

 private:
  static constexpr std::uint32_t short_tunnel = 50;  // states: chains of four moves or so

  void note(Triangle t) {
    if (mesh_.solid_degree(t) == 0) alone_.push_back(t);
  }
  [[nodiscard]] bool too_many() const { return 10 * alone_.size() > index_.strips(); }

  StripMesh& mesh_;
  StripIndex index_;
  Tunnel tunnel_;
  bool join_;
  std::vector<Triangle> patch_;
  std::vector<Triangle> alone_;  ///< every isolated triangle, and some that no longer are
};

StripPolicy policy(const char* name, const char* says, PaperSwitches switches) {
  return {name, says, [switches](StripMesh& mesh, const ProgressiveMesh&) -> Upkeep {
            if (!switches.tunnel)
              return {[&mesh, switches](const Where& where, Vertex v_t) {
                        return split_as_the_paper(mesh, where, v_t, switches.join);
                      },
                      {}};
            const auto paper = std::make_shared<TunnelledPaper>(mesh, switches.join);
            return {[paper](const Where& where, Vertex v_t) { return paper->split(where, v_t); },
                    [paper] { paper->tunnel(); }};
          }};
}

}  // namespace

Halfedge split_as_the_paper(StripMesh& mesh, const Where& where, Vertex v_t, bool join) {
  if (where.spokes == Spokes::both && around_four_triangles(mesh, where.left))
    return restrip::split(mesh, where, v_t).halfedge;
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  const bool left = has_left && mesh.solid(where.left);
  const bool right = has_right && mesh.solid(where.right);
  const Halfedge chord = mesh.insert_vertex(where, v_t);
  inherit(mesh, chord, left);
  inherit(mesh, mesh.opposite(chord), right);
  if (join && has_left && has_right && !left && !right) mesh.set_solid(chord, true);
  return chord;
}

std::vector<StripPolicy> paper_policies() {
  return {policy("paper", "4-vertex rules; elsewhere colours are inherited, two lonely triangles join", {true, false}),
          policy("paper-alone", "the same, but the two new triangles never join", {false, false}),
          policy("paper-tunnel", "as paper, with short tunnels while over a tenth of the strips are lonely triangles",
                 {true, true}),
          policy("paper-alone-tunnel", "as paper-alone, with the same tunnels", {false, true})};
}

}  // namespace restrip::tools
