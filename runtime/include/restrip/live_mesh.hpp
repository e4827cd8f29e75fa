// LiveMesh: a mesh, its strips and the index buffer that draws them, in one object. Most engines need only this:
//
//   LiveMesh live(triangles, vertex_count);            // upload live.bytes(), with room for live.room() indices
//   live.collapse(live.edge(v_s, v_t));                // and split, flip, as often as the frame wants
//   const auto ranges = live.update();
//   if (ranges.outgrown) make_buffer(live.room());     // the only range is then everything
//   for (const auto& range : ranges) upload(range);
//   live.undo();                                       // the last frame, if a history is kept
//
// The parts can also be used separately: StripMesh, Keeper, StripBuffer, History.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "restrip/mesh/cost.hpp"
#include "restrip/mesh/history.hpp"
#include "restrip/mesh/strip_mesh.hpp"
#include "restrip/operations/apply.hpp"
#include "restrip/operations/checked.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/buffer_history.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strip_format.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {

struct LiveOptions {
  Policy policy = default_policy;
  Cost cost = default_cost;
  Effort effort = default_effort;  ///< for the initial strips
  /// The budget of undo, in changed triangles of all frames together, some 100 bytes each. Beyond it the oldest frames
  /// are dropped, but never the last one. 0: no history.
  std::size_t history = 0;
  /// The format of the buffer; limits of batches are not supported.
  StripFormat format = {.width = IndexWidth::bits32};
};

/// Can be neither copied nor moved. Each call throws what its parts throw. After an exception of update(), undo() or
/// redo() the mesh is valid, and the next update() returns everything that has not been returned; if memory ran out,
/// earlier frames perhaps cannot be undone. `Mesh` is StripMesh: this is a template so that searches and buffers are
/// compiled where a LiveMesh is used, not wherever this header is included.
template <class Mesh>
class BasicLiveMesh {
 public:
  using Halfedge = typename Mesh::Halfedge;

  /// `triangles`: as for StripMesh::build, which leaves out triangles with a corner twice or out of range. Only
  /// `report` counts them; check it unless the triangles are known to be good.
  template <class Triangles>
  BasicLiveMesh(const Triangles& triangles, std::size_t vertex_count, LiveOptions options = {},
                BuildReport* report = nullptr)
      : BasicLiveMesh(with_strips(Mesh::build(triangles, vertex_count, report), options), options) {}
  /// Takes a mesh with its colours.
  explicit BasicLiveMesh(Mesh mesh, LiveOptions options = {})
      : mesh_(std::move(mesh)),
        keeper_(mesh_, options.policy, options.cost),
        buffer_(options.format),
        most_history_(options.history) {
    mesh_.watch(&changed_);
    buffer_.rebuild(mesh_);
    if (options.history != 0) history_.emplace(mesh_, buffer_, options.history);
  }
  BasicLiveMesh(const BasicLiveMesh&) = delete;
  BasicLiveMesh& operator=(const BasicLiveMesh&) = delete;
  ~BasicLiveMesh() = default;

  /// The halfedge from v to w, or {none}, which every operation refuses. O(valence of v).
  [[nodiscard]] Halfedge edge(Vertex v, Vertex w) const noexcept {
    return v < mesh_.vertex_bound() ? mesh_.spoke(v, w) : Halfedge{};
  }

  /// Does the operation under the policy, or refuses it with a reason.
  Checked split(const VertexSplit<Halfedge>& where, Vertex new_vertex = none) {
    return checked_split(keeper_, where, new_vertex);
  }
  Checked collapse(Halfedge chord) { return checked_collapse(keeper_, chord); }
  Checked flip(Halfedge h) { return checked_flip(keeper_, h); }
  /// The operations of refine.hpp, in the same way.
  Checked split_face(Halfedge h) { return checked_split_face(keeper_, h); }
  Checked join_faces(Halfedge chord) { return checked_join_faces(keeper_, chord); }
  Checked bisect(Halfedge h) { return checked_bisect(keeper_, h); }
  Checked merge(Halfedge chord) { return checked_merge(keeper_, chord); }
  /// A custom operation: see apply.hpp.
  template <SurfaceTable Table>
  Checked apply(const Table& table, Halfedge where) {
    return checked_apply(keeper_, table, where);
  }
  /// For idle time: see Keeper::improve. Returns the cost saved.
  std::size_t improve(std::size_t budget) { return keeper_.improve(budget); }

  /// Ends a frame and returns the ranges of the buffer that must be uploaded, ascending; valid until the next call.
  /// Upload::outgrown says that the buffer on the device is too small.
  Upload update(const RangeOptions& ranges = {}) {
    const Upload upload = end_frame(ranges);
    undelivered_ = false;
    return upload;
  }
  /// Undo or redo a frame; changes since the last update() count as a frame. Triangles, handles and colours are
  /// restored exactly, and so are the indices of strips and their width. False when there is nothing to undo or redo.
  /// Call update() next, which returns the ranges to upload. Your data of vertices is not restored, and the numbers of
  /// removed vertices are used again: save the data of a vertex before an operation that changes it. Linear time in the
  /// mesh.
  bool undo() { return step(false); }
  bool redo() { return step(true); }

  /// The number of frames that can be undone and redone; update() ends a frame first.
  [[nodiscard]] std::size_t undoable() const noexcept { return can_step() ? history_->mesh.undoable() : 0; }
  [[nodiscard]] std::size_t redoable() const noexcept { return can_step() ? history_->mesh.redoable() : 0; }

  /// The buffer: see live_buffer.hpp. `indices` are empty when they have 16 bits.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return buffer_.indices(); }
  [[nodiscard]] std::span<const std::uint16_t> indices16() const noexcept { return buffer_.indices16(); }
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return buffer_.bytes(); }
  [[nodiscard]] std::size_t index_bytes() const noexcept { return buffer_.index_bytes(); }
  /// The number of indices that the buffer on the device should have room for.
  [[nodiscard]] std::size_t room() const noexcept { return buffer_.room(); }
  [[nodiscard]] const LiveBuffer& buffer() const noexcept { return buffer_; }
  [[nodiscard]] const Mesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] Keeper<Mesh>& keeper() noexcept { return keeper_; }
  /// Counts of rules used and not used in all operations so far.
  [[nodiscard]] const RuleCounts& rule_counts() const noexcept { return keeper_.rule_counts(); }

 private:
  static Mesh with_strips(Mesh mesh, const LiveOptions& options) {
    stripify(mesh, options.effort, options.cost);
    return mesh;
  }
  /// Of the mesh and its buffer, which have the same frames.
  struct Histories {
    Histories(const Mesh& now, LiveBuffer& buffer_now, std::size_t most) : mesh(now, most), buffer(buffer_now) {}
    History mesh;
    LiveHistory buffer;
  };

  [[nodiscard]] bool can_step() const noexcept { return history_ && !interrupted_; }
  Upload end_frame(const RangeOptions& ranges) {
    if (std::exchange(undelivered_, true)) buffer_.keep_upload();
    if (interrupted_) buffer_.forget();
    const Upload upload = buffer_.update(mesh_, changed_, ranges);
    if (most_history_ != 0) {
      if (std::exchange(interrupted_, true)) {
        history_.emplace(mesh_, buffer_, most_history_);
      } else {
        const bool is_frame = history_->mesh.frame(mesh_, changed_);
        history_->buffer.frame(buffer_, changed_, is_frame, history_->mesh.undoable());
      }
      interrupted_ = false;
    }
    changed_.clear();
    return upload;
  }
  bool step(bool forward) {
    if (most_history_ == 0) return false;
    end_frame({});
    if ((forward ? redoable() : undoable()) == 0) return false;
    interrupted_ = true;
    const bool exact = forward ? history_->buffer.redo(buffer_) : history_->buffer.undo(buffer_);
    forward ? history_->mesh.redo(mesh_) : history_->mesh.undo(mesh_);
    if (exact) changed_.clear();  // the buffer is up to date already
    interrupted_ = false;
    keeper_.rebuild();
    return true;
  }

  Mesh mesh_;
  Keeper<Mesh> keeper_;
  std::vector<Triangle> changed_;
  LiveBuffer buffer_;
  std::size_t most_history_ = 0;
  std::optional<Histories> history_;
  bool interrupted_ = false;  // by an exception, so that mesh, buffer and histories may be out of step
  bool undelivered_ = false;  // the last frame has ended, but nothing was returned
};

using LiveMesh = BasicLiveMesh<StripMesh>;

}  // namespace restrip
