// The ways of doing an operation that are compared: the mesh alone, the rules alone, each policy, baked strips.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/baked.hpp"
#include "restrip/operations/operations.hpp"
#include "restrip/search/keeper.hpp"
#include "subject.hpp"

namespace restrip::bench {

using Halfedge = StripMesh::Halfedge;

enum class Way { bare, rules, local, linked, quick, full, baked };
inline constexpr std::array<const char*, 7> way_names{"bare", "rules", "local", "linked", "quick", "full", "baked"};
[[nodiscard]] constexpr const char* name_of(Way way) { return way_names[static_cast<std::size_t>(way)]; }
inline constexpr std::array<Way, 4> policies{Way::local, Way::linked, Way::quick, Way::full};
[[nodiscard]] constexpr Policy policy_of(Way way) {
  switch (way) {
    case Way::linked:
      return Policy::linked;
    case Way::quick:
      return Policy::quick;
    case Way::full:
      return Policy::full;
    default:
      return Policy::local;
  }
}

/// Calls visit(operations) with an object that has split(where, v_t), collapse(chord) and flip(h), each returning a
/// halfedge as restrip::split and friends do; so that the choice of the way is made once, outside the clock. The
/// policies want a keeper: without one std::bad_optional_access is thrown.
template <class Visit>
void with_operations(Way way, StripMesh& mesh, std::optional<StripKeeper>& keeper, Visit&& visit) {
  struct Bare {
    StripMesh* mesh;
    Halfedge split(const VertexSplit<Halfedge>& where, Vertex v_t) const { return mesh->insert_vertex(where, v_t); }
    Halfedge collapse(Halfedge chord) const { return mesh->remove_vertex(chord); }
    Halfedge flip(Halfedge h) const { return mesh->turn_edge(h); }
  };
  struct Rules {
    StripMesh* mesh;
    Halfedge split(const VertexSplit<Halfedge>& where, Vertex v_t) const {
      return restrip::split(*mesh, where, v_t).halfedge;
    }
    Halfedge collapse(Halfedge chord) const { return restrip::collapse(*mesh, chord).halfedge; }
    Halfedge flip(Halfedge h) const { return restrip::flip(*mesh, h).halfedge; }
  };
  struct Kept {
    StripKeeper* keeper;
    Halfedge split(const VertexSplit<Halfedge>& where, Vertex v_t) const { return keeper->split(where, v_t).halfedge; }
    Halfedge collapse(Halfedge chord) const { return keeper->collapse(chord).halfedge; }
    Halfedge flip(Halfedge h) const { return keeper->flip(h).halfedge; }
  };
  if (way == Way::bare)
    visit(Bare{&mesh});
  else if (way == Way::rules)
    visit(Rules{&mesh});
  else
    visit(Kept{&keeper.value()});
}

/// Plays a progressive mesh up and down in one way. A split starts from vertices: finding its spokes is part of it, in
/// every way alike.
class Player {
 public:
  Player(const std::string& name, Way way);

  /// The number of records played so far.
  [[nodiscard]] std::size_t level() const noexcept { return level_; }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] StripMesh& mesh() noexcept { return mesh_; }
  /// The first record after which the mesh has at least this share of its finest triangles.
  [[nodiscard]] std::size_t level_of(double share) const;

  void up_to(std::size_t level);
  void down_to(std::size_t level);
  /// Starts anew from a copy of the mesh taken at that level. Linear time.
  void restart(const StripMesh& mesh, std::size_t level);
  void restart();

 private:
  const Subject* subject_;
  const tools::BakedMesh* baked_ = nullptr;
  Way way_;
  std::size_t level_ = 0;
  StripMesh mesh_;
  std::optional<StripKeeper> keeper_;
  std::optional<BakedPlayer<StripMesh>> player_;
};

}  // namespace restrip::bench
