// The contents of a restrip_mesh: a StripMesh, the keeper of its strips, and optional parts.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "restrip.h"
#include "restrip/restrip.hpp"

namespace restrip::c {

inline std::vector<restrip_range> ranges_of(std::span<const IndexRange> ranges) {
  std::vector<restrip_range> made;
  made.reserve(ranges.size());
  for (const IndexRange& range : ranges) made.push_back({range.first, range.count});
  return made;
}

/// The live buffer of a mesh.
struct Live {
  explicit Live(const StripFormat& format) : buffer(format) {}

  LiveBuffer buffer;
  std::vector<Triangle> changed;  // the list of changes of the mesh
  std::vector<restrip_range> ranges;
  std::vector<restrip_range> draws;
  std::size_t budget = 0;  // of the history; 0: no history
  std::optional<History> history;

  /// Ends a frame of the history, or starts the history. After an exception it starts again.
  void end_frame(const StripMesh& mesh) {
    if (budget == 0) return;
    try {
      if (history)
        history->frame(mesh, changed);
      else
        history.emplace(mesh, budget);
    } catch (...) {
      history.reset();
      throw;
    }
  }
};

}  // namespace restrip::c

struct restrip_buffer {
  explicit restrip_buffer(restrip::IndexBuffer made) : buffer(std::move(made)) {
    if (buffer.form != restrip::StripForm::lengths) {
      draws = restrip::c::ranges_of(buffer.batches);
      return;
    }
    std::size_t first = 0;
    for (const std::uint32_t length : buffer.lengths) {
      draws.push_back({first, length});
      first += length;
    }
  }
  const restrip::IndexBuffer buffer;
  std::vector<restrip_range> draws;
};

struct restrip_mesh {
  using Keeper = restrip::Keeper<restrip::StripMesh>;

  // In this order: a keeper points to the mesh and the file, so a restrip_mesh stays where it is.
  const std::unique_ptr<const restrip::BakedFile> file;  // of a baked mesh
  restrip::StripMesh mesh;
  std::unique_ptr<restrip::c::Live> live;
  std::int32_t policy;
  Keeper keeper;

  explicit restrip_mesh(restrip::StripMesh built)
      : mesh(std::move(built)), policy(static_cast<std::int32_t>(restrip::default_policy)), keeper(mesh) {}
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

  /// Whether the mesh is at a baked level; false for meshes that are not baked, and under another policy.
  [[nodiscard]] bool in_step() const noexcept { return keeper.baked() != nullptr && keeper.baked()->in_step(); }

  /// Changes colours or the whole mesh without the keeper; keeper and live buffer are updated even after an exception.
  /// The history starts again.
  template <class Work>
  void recolor(Work&& work) {
    if (live) live->history.reset();
    replace(work);
  }
  /// The same, but the history stays.
  template <class Work>
  void replace(Work&& work) {
    struct Afterwards {
      restrip_mesh* self;
      ~Afterwards() {
        if (self->live) self->mesh.watch(&self->live->changed);
        // If memory runs out, the keeper reads the mesh before its next operation.
        try {
          self->keeper.rebuild();
        } catch (...) {
        }
      }
    };
    const Afterwards afterwards{this};
    mesh.watch(nullptr);
    if (live) {
      live->changed.clear();
      live->buffer.forget();
    }
    if (keeper.baked() != nullptr) keeper.baked()->leave_step();
    work(mesh);
  }
};
