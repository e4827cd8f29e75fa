// What a restrip_mesh is: a StripMesh, the keeper of its strips, and what else was asked of it.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "restrip.h"
#include "restrip/restrip.hpp"

namespace restrip::c {

/// The live buffer of a mesh.
class Live {
 public:
  using Buffer = std::variant<StripBuffer, StripBuffer16, TriangleListBuffer, TriangleListBuffer16>;

  explicit Live(Buffer buffer) : buffer_(std::move(buffer)) {}

  /// Where the mesh reports to.
  [[nodiscard]] std::vector<Triangle>* changed() noexcept { return &changed_; }
  /// The mesh has changed without a report.
  void forget() noexcept { whole_ = true; }

  const std::vector<restrip_range>& update(const StripMesh& mesh) {
    // Until this comes to its end the next update is to write everything.
    const bool whole = std::exchange(whole_, true);
    std::visit([&](auto& buffer) { bring_in_step(buffer, mesh, whole); }, buffer_);
    whole_ = false;
    return ranges_;
  }
  template <class Use>
  void with_indices(Use&& use) const {
    std::visit([&](const auto& buffer) { use(buffer.indices()); }, buffer_);
  }

 private:
  template <class OneBuffer>
  void bring_in_step(OneBuffer& buffer, const StripMesh& mesh, bool whole) {
    if (whole) {
      changed_.clear();
      buffer.rebuild(mesh);
      ranges_.clear();
      if (!buffer.indices().empty()) ranges_.push_back({0, buffer.indices().size()});
      return;
    }
    const auto written = buffer.update(mesh, changed_);
    changed_.clear();
    ranges_.clear();
    for (const IndexRange& range : written) ranges_.push_back({range.first, range.count});
  }

  Buffer buffer_;
  std::vector<Triangle> changed_;
  std::vector<restrip_range> ranges_;
  bool whole_ = true;
};

}  // namespace restrip::c

struct restrip_mesh {
  using Keeper = restrip::Keeper<restrip::StripMesh>;

  // In this order: a keeper points to the mesh and the file, so a restrip_mesh stays where it is.
  const std::unique_ptr<const restrip::BakedFile> file;  // of a baked mesh
  restrip::StripMesh mesh;
  std::unique_ptr<restrip::c::Live> live;
  std::int32_t policy;
  Keeper keeper;

  explicit restrip_mesh(restrip::StripMesh built)
      : mesh(std::move(built)), policy(RESTRIP_POLICY_LOCAL), keeper(mesh, restrip::Policy::local) {}
  explicit restrip_mesh(std::unique_ptr<const restrip::BakedFile> baked)
      : file(std::move(baked)), mesh(base_of(*file)), policy(RESTRIP_POLICY_BAKED), keeper(mesh, file->records) {}
  /// With room for all levels.
  static restrip::StripMesh base_of(const restrip::BakedFile& file) {
    restrip::StripMesh base = file.mesh;
    base.reserve(file.base.size() + 2 * file.splits.size(), file.points.size());
    return base;
  }
  restrip_mesh(const restrip_mesh&) = delete;
  restrip_mesh& operator=(const restrip_mesh&) = delete;
  ~restrip_mesh() = default;

  /// At a level that is baked; false for meshes that are not baked, and under another policy.
  [[nodiscard]] bool in_step() const noexcept { return keeper.baked() != nullptr && keeper.baked()->in_step(); }

  /// Plays at most `most` records towards a level that there is, in step. Returns how many were played.
  std::size_t move(std::size_t level, std::size_t most) {
    std::size_t done = 0;
    for (std::size_t at = keeper.baked()->level(); at != level && done < most; at = keeper.baked()->level(), ++done) {
      const bool up = at < level;
      const restrip::BakedSplit& split = file->splits[up ? at : at - 1];
      if (up)
        keeper.split_record(at, restrip::spokes_of(mesh, split), split.v_t);
      else
        keeper.collapse_record(at - 1, mesh.spoke(split.v_s, split.v_t));
    }
    return done;
  }

  /// Changes colours or the whole mesh, not through the keeper; whatever happens, keeper and live buffer know it.
  template <class Work>
  void recolor(Work&& work) {
    struct Afterwards {
      restrip_mesh* self;
      ~Afterwards() {
        if (self->live) self->mesh.watch(self->live->changed());
        // Without memory the keeper reads the mesh before its next operation.
        try {
          self->keeper.rebuild();
        } catch (...) {
        }
      }
    };
    const Afterwards afterwards{this};
    mesh.watch(nullptr);
    if (live) live->forget();
    if (keeper.baked() != nullptr) keeper.baked()->leave_step();
    work(mesh);
  }
};
