// A list of changes, sorted into triangles added, removed and changed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "restrip/mesh/numbered_mesh.hpp"

namespace restrip {

/// Sorts a list of changes into triangles added, removed and changed since the last call, each named once and
/// ascending: for acceleration structures and other data kept in step with a mesh.
class ChangeFeed {
 public:
  template <NumberedMesh Mesh>
  explicit ChangeFeed(const Mesh& mesh) {
    known_.resize(mesh.triangle_bound());
    for (std::uint32_t t = 0; t < known_.size(); ++t) known_[t] = mesh.has_triangle(t);
  }

  /// `changed`: as StripMesh::watch and Watched make it. A number that was removed and reused counts as changed. Time
  /// linear in `changed`, up to a logarithm.
  template <NumberedMesh Mesh>
  void update(const Mesh& mesh, std::span<const std::uint32_t> changed) {
    added_.clear();
    removed_.clear();
    changed_.clear();
    if (known_.size() < mesh.triangle_bound()) known_.resize(mesh.triangle_bound(), false);
    named_.assign(changed.begin(), changed.end());
    std::sort(named_.begin(), named_.end());
    named_.erase(std::unique(named_.begin(), named_.end()), named_.end());
    for (const std::uint32_t t : named_) {
      const bool there = t < mesh.triangle_bound() && mesh.has_triangle(t);
      if (there || known_[t]) (!known_[t] ? added_ : there ? changed_ : removed_).push_back(t);
      known_[t] = there;
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> added() const noexcept { return added_; }
  [[nodiscard]] std::span<const std::uint32_t> removed() const noexcept { return removed_; }
  [[nodiscard]] std::span<const std::uint32_t> changed() const noexcept { return changed_; }

 private:
  std::vector<bool> known_;
  std::vector<std::uint32_t> named_;
  std::vector<std::uint32_t> added_;
  std::vector<std::uint32_t> removed_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace restrip
