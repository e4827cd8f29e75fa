// What a restrip_mesh is: a StripMesh, the keeper of its strips, and what else was asked of it.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "keepers.hpp"
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
  using Keeper =
      std::variant<restrip::c::BareKeeper, restrip::StripKeeper, restrip::IndexKeeper, restrip::c::LevelKeeper>;

  // In this order: a keeper points to the mesh and the file, so a restrip_mesh stays where it is.
  const std::unique_ptr<const restrip::BakedFile> file;  // of a baked mesh
  restrip::StripMesh mesh;
  std::unique_ptr<restrip::c::Live> live;
  std::int32_t policy;
  Keeper keeper;

  explicit restrip_mesh(restrip::StripMesh built)
      : mesh(std::move(built)),
        policy(RESTRIP_POLICY_LOCAL),
        keeper(restrip::StripKeeper(mesh, restrip::Policy::local)) {}
  explicit restrip_mesh(std::unique_ptr<const restrip::BakedFile> baked)
      : file(std::move(baked)),
        mesh(base_of(*file)),
        policy(RESTRIP_POLICY_BAKED),
        keeper(restrip::c::LevelKeeper(mesh, *file)) {}
  /// With room for all levels.
  static restrip::StripMesh base_of(const restrip::BakedFile& file) {
    restrip::StripMesh base = file.mesh;
    base.reserve(file.base.size() + 2 * file.splits.size(), file.points.size());
    return base;
  }
  restrip_mesh(const restrip_mesh&) = delete;
  restrip_mesh& operator=(const restrip_mesh&) = delete;
  ~restrip_mesh() = default;

  /// An operation, by the keeper.
  template <class Operation>
  auto kept(Operation&& operation) {
    return std::visit(std::forward<Operation>(operation), keeper);
  }
  template <class Question>
  [[nodiscard]] auto asked(Question&& question) const {
    return std::visit(std::forward<Question>(question), keeper);
  }

  /// Null for meshes that are not baked, and under another policy.
  [[nodiscard]] restrip::c::LevelKeeper* levels() noexcept { return std::get_if<restrip::c::LevelKeeper>(&keeper); }
  [[nodiscard]] const restrip::c::LevelKeeper* levels() const noexcept {
    return std::get_if<restrip::c::LevelKeeper>(&keeper);
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
          self->kept([](auto& own) { own.rebuild(); });
        } catch (...) {
        }
      }
    };
    const Afterwards afterwards{this};
    mesh.watch(nullptr);
    if (live) live->forget();
    if (levels() != nullptr) levels()->leave_step();
    work(mesh);
  }
};
