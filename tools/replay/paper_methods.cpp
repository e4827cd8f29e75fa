// The method of the paper: handmade rules for the 4-vertex and none for other vertices.
//
// A split without a rule leaves the strips as they are. If it cuts a dual edge in two, both halves inherit its colour:
// a cut strip passes through the new triangle, and a new triangle on a dashed edge stays isolated. The paper does not
// say whether two isolated new triangles form a strip, nor how the share of splits that it counts depends on its
// tunnelling, so both are switches. Its 4-vertex rules are assumed to be the optimal ones, as it claims. It does not
// describe collapses and flips in enough detail to reproduce them: they use the rules of the tables.
#include <algorithm>
#include <memory>
#include <optional>

#include "lod/coloring_check.hpp"
#include "replay/methods.hpp"
#include "restrip/mesh/walks.hpp"
#include "restrip/operations/operations.hpp"
#include "search/strip_locator.hpp"
#include "search/tunnel.hpp"

namespace restrip::tools {
namespace {

using Halfedge = StripMesh::Halfedge;
using Where = VertexSplit;
using Spokes = Where::Spokes;

bool around_four_triangles(const StripMesh& mesh, Halfedge spoke) {
  Halfedge h = spoke;
  for (int i = 0; i < 4; ++i) {
    if (StripMesh::on_boundary(h) || (i > 0 && h == spoke)) return false;
    h = turn_ccw(mesh, h);
  }
  return h == spoke;
}

/// Gives both halves of a cut edge its colour. `inner`: the side of the new triangle on the chord.
void inherit(StripMesh& mesh, Halfedge inner, bool solid) {
  if (!solid) return;  // a new triangle's edges are dashed, and one may be a boundary edge
  mesh.set_solid(StripMesh::next(inner), true);
  mesh.set_solid(StripMesh::next(StripMesh::next(inner)), true);
}

/// Splits a vertex as the paper would. `join`: the two new triangles form a strip if both cut edges were dashed.
/// Preconditions and result as for restrip::split, but for the valence.
Rewrite split_as_the_paper(StripMesh& mesh, const Where& where, Vertex v_t, bool join) {
  if (where.spokes == Spokes::both && around_four_triangles(mesh, where.left)) return restrip::split(mesh, where, v_t);
  const bool has_left = where.spokes != Spokes::right_only;
  const bool has_right = where.spokes != Spokes::left_only;
  const bool left = has_left && mesh.solid(where.left);
  const bool right = has_right && mesh.solid(where.right);
  const Halfedge chord = mesh.insert_vertex(where, v_t);
  inherit(mesh, chord, left);
  inherit(mesh, mesh.opposite(chord), right);
  const bool joined = join && has_left && has_right && !left && !right;
  if (joined) mesh.set_solid(chord, true);
  const int alone = int{has_left && !left} + int{has_right && !right};  // new triangles on dashed edges
  return {{joined ? 1 : alone, 0, joined ? 0 : alone}, chord, 0};
}

/// With `tunnel`, tunnels from isolated triangles while they exceed a tenth of the strips, the threshold in Porcu,
/// Sanna, Scateni, "Efficiently keeping an optimal stripification over a CLOD mesh", 2005.
class Paper final : public Maintainer {
 public:
  Paper(StripMesh& mesh, bool join, bool tunnel) : Maintainer(mesh), join_(join) {
    if (tunnel) {
      locator_.emplace();
      Paper::restart(0);
    }
  }

  Rewrite split(const Where& where, Vertex v_t, std::size_t) override {
    fan_triangles(mesh_, where.spoke(), patch_);
    before();
    Rewrite done = split_as_the_paper(mesh_, where, v_t, join_);
    done.valence = static_cast<std::uint32_t>(patch_.size());
    edge_triangles(mesh_, done.halfedge, patch_);
    after();
    return done;
  }
  Rewrite collapse(Halfedge chord, std::size_t) override {
    edge_triangles(mesh_, chord, patch_);
    before();
    const Rewrite done = restrip::collapse(mesh_, chord);
    fan_triangles(mesh_, done.halfedge, patch_);
    after();
    return done;
  }
  Rewrite flip(Halfedge h) override {
    patch_.assign({StripMesh::triangle(h), StripMesh::triangle(mesh_.opposite(h))});
    before();
    const Rewrite done = restrip::flip(mesh_, h);
    after();
    // It may give ports up and so isolate a triangle next to the patch.
    for (const Triangle t : patch_)
      for (unsigned side = 0; side < 3; ++side)
        if (const Halfedge across = mesh_.opposite(StripMesh::halfedge(t, side));
            locator_ && !StripMesh::on_boundary(across))
          note(StripMesh::triangle(across));
    return done;
  }

  ColoringChange between() override {
    if (!locator_) return {};
    // Some are in a strip by now, some were noted twice, some no longer exist.
    const auto too_many = [&](std::size_t isolated) { return 10 * isolated > locator_->strips(); };
    if (!too_many(alone_.size())) return {};
    std::sort(alone_.begin(), alone_.end());
    alone_.erase(std::unique(alone_.begin(), alone_.end()), alone_.end());
    std::erase_if(alone_, [&](Triangle t) { return !alone(t); });
    const std::size_t strips = locator_->strips();
    const std::ptrdiff_t isolated = tunnel_.counts().isolated;
    std::vector<Triangle> left;
    for (; !alone_.empty() && too_many(alone_.size() + left.size()); alone_.pop_back()) {
      const Triangle t = alone_.back();
      if (alone(t) && !tunnel_.join(mesh_, *locator_, t, short_tunnel)) left.push_back(t);
    }
    alone_.insert(alone_.end(), left.begin(), left.end());
    return {-static_cast<int>(strips - locator_->strips()), 0, static_cast<int>(tunnel_.counts().isolated - isolated)};
  }

  void restart(std::size_t) override {
    if (!locator_) return;
    locator_->rebuild(mesh_);
    alone_.clear();
    for (Triangle t = 0; t < mesh_.triangle_bound(); ++t) note(t);
  }
  [[nodiscard]] std::string fault() const override { return locator_ ? find_fault(mesh_, *locator_) : std::string(); }

 private:
  static constexpr std::uint32_t short_tunnel = 50;  // states: chains of about four moves

  [[nodiscard]] bool alone(Triangle t) const { return mesh_.alive(t) && mesh_.solid_degree(t) == 0; }
  void note(Triangle t) {
    if (alone(t)) alone_.push_back(t);
  }
  void before() {
    if (locator_) locator_->before_patch(mesh_, patch_);
  }
  void after() {
    if (!locator_) return;
    locator_->after_patch(mesh_, patch_);
    for (const Triangle t : patch_) note(t);
  }

  bool join_;
  std::optional<StripLocator> locator_;  // of the variants that tunnel
  Tunnel tunnel_;
  std::vector<Triangle> patch_;
  std::vector<Triangle> alone_;  ///< every isolated triangle, and some that are not isolated any more
};

Method method(const char* name, const char* description, bool join, bool tunnel) {
  return {name, description, Method::Kind::paper,
          [join, tunnel](StripMesh& mesh, const MaintainerInputs&) -> std::unique_ptr<Maintainer> {
            return std::make_unique<Paper>(mesh, join, tunnel);
          }};
}

}  // namespace

std::vector<Method> paper_methods() {
  return {method("paper", "4-vertex rules; elsewhere colours are inherited, two isolated triangles join", true, false),
          method("paper-alone", "the same, but the two new triangles never join", false, false),
          method("paper-tunnel", "as paper, with short tunnels while over a tenth of the strips are isolated triangles",
                 true, true),
          method("paper-alone-tunnel", "as paper-alone, with the same tunnels", false, true)};
}

}  // namespace restrip::tools
