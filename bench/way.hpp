// Players: a progressive mesh played up and down in one way of keeping strips (replay/ways.hpp).
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "replay/ways.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "subject.hpp"

namespace restrip::bench {

using Halfedge = StripMesh::Halfedge;
using tools::Way;
using tools::way_named;

/// Plays a progressive mesh up and down in one way. A split starts from vertices: finding its spokes is part of it, in
/// every way.
class Player {
 public:
  Player(const std::string& name, const Way& way, const Cost& cost = Cost::strips());

  /// The number of records played so far.
  [[nodiscard]] std::size_t level() const noexcept { return level_; }
  [[nodiscard]] const StripMesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] StripMesh& mesh() noexcept { return mesh_; }
  /// The first record after which the mesh has at least this share of its finest triangles.
  [[nodiscard]] std::size_t level_of(double share) const;

  void up_to(std::size_t level);
  void down_to(std::size_t level);
  /// Starts again from a copy of the mesh taken at that level. Linear time.
  void restart(const StripMesh& mesh, std::size_t level);
  void restart();

 private:
  const Subject* subject_;
  const tools::Plan* plan_;
  std::size_t level_ = 0;
  StripMesh mesh_;
  std::unique_ptr<tools::Upkeep> upkeep_;
};

}  // namespace restrip::bench
