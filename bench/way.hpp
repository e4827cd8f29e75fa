// Players: a progressive mesh played up and down in one way of keeping strips (replay/ways.hpp), and its levels as
// lists.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "replay/ways.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "subject.hpp"

namespace restrip::bench {

using tools::Way;
using tools::way_named;

/// Plays a progressive mesh up and down in one way. A split starts from vertices: finding its spokes is part of it, in
/// every way.
class Player {
 public:
  Player(const std::string& name, const Way& way, const Cost& cost = Cost::strips());

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
  std::size_t level_ = 0;  // the number of records played so far
  StripMesh mesh_;
  std::unique_ptr<tools::Upkeep> upkeep_;
};

/// The triangles of one level as a list: the input for making strips, or an order, from scratch.
struct LevelList {
  std::vector<std::uint32_t> indices;  ///< three a triangle; vertices are numbered by appearance
  std::size_t vertices = 0;
  StripMesh mesh;  ///< the same triangles
};

/// The list of the level with `percent` of the finest triangles. Made on first use, and kept.
[[nodiscard]] const LevelList& level_list(const std::string& name, int percent);

}  // namespace restrip::bench
