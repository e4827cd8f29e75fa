// LiveMesh: a mesh, its strips and the index buffer that draws them, in one object. What most engines need:
//
//   LiveMesh live(triangles, vertex_count);            // upload live.indices()
//   live.collapse(live.edge(v_s, v_t));                // and split, flip, as often as the frame wants
//   for (const auto& range : live.update()) upload(range);
//   live.undo();                                       // the last frame, if there is to be a history
//
// The parts can be had one by one: StripMesh, Keeper, StripBuffer, History.
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
#include "restrip/output/buffer_history.hpp"
#include "restrip/output/strip_buffer.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {

struct LiveOptions {
  Policy policy = Policy::quick;
  Cost cost = Cost::indices();
  Effort effort = Effort::full;  ///< of the strips that it begins with
  std::size_t history = 0;       ///< triangles that may have changed in all frames that can be undone; 0: no history
};

/// Stays where it is: neither copied nor moved. Each call throws what its parts throw; after an exception of update(),
/// undo() or redo() the frames before cannot be undone. `Mesh` is StripMesh: this is a template so that searches and
/// buffers are compiled where a LiveMesh is used, not wherever this header is included.
template <class Mesh>
class BasicLiveMesh {
 public:
  using Halfedge = typename Mesh::Halfedge;

  /// `triangles`: what StripMesh::build takes. `report` tells what of them was left out.
  template <class Triangles>
  BasicLiveMesh(const Triangles& triangles, std::size_t vertex_count, LiveOptions options = {},
                BuildReport* report = nullptr)
      : BasicLiveMesh(Mesh::build(triangles, vertex_count, report), options, true) {}
  /// A mesh with the colours that it has.
  explicit BasicLiveMesh(Mesh mesh, LiveOptions options = {}) : BasicLiveMesh(std::move(mesh), options, false) {}
  BasicLiveMesh(const BasicLiveMesh&) = delete;
  BasicLiveMesh& operator=(const BasicLiveMesh&) = delete;
  ~BasicLiveMesh() = default;

  /// The halfedge from v to w, or {none}, which every operation refuses. O(valence of v).
  [[nodiscard]] Halfedge edge(Vertex v, Vertex w) const noexcept {
    const bool there = v < mesh_.vertex_bound() && w < mesh_.vertex_bound() && mesh_.spoke(v).id != none;
    return there ? mesh_.spoke(v, w) : Halfedge{};
  }

  /// Done under the policy, or refused with the reason.
  Checked split(const VertexSplit<Halfedge>& where, Vertex new_vertex = none) {
    return checked_split(keeper_, where, new_vertex);
  }
  Checked collapse(Halfedge chord) { return checked_collapse(keeper_, chord); }
  Checked flip(Halfedge h) { return checked_flip(keeper_, h); }
  /// An operation of your own: see apply.hpp.
  template <SurfaceTable Table>
  Checked apply(const Table& table, Halfedge where) {
    return checked_apply(keeper_, table, where);
  }
  /// In idle time: see Keeper::improve. Returns the cost saved.
  std::size_t improve(std::size_t budget) { return keeper_.improve(budget); }

  /// Ends a frame: the ranges of indices() that must be uploaded, ascending; valid until the next call.
  std::span<const IndexRange> update() {
    if (std::exchange(interrupted_, false)) {
      history_.reset();
      buffers_.reset();
      buffer_ = {};  // to be written as a whole
    }
    const auto ranges = buffer_.update(mesh_, changed_);
    if (history_) {
      interrupted_ = true;
      buffers_->note(buffer_, changed_);
      if (history_->frame(mesh_, changed_)) buffers_->frame(buffer_, history_->undoable());
      interrupted_ = false;
    }
    changed_.clear();
    return ranges;
  }
  /// Takes back the last frame, or does it again; what has not been ended by update() counts as a frame. Triangles,
  /// handles, colours and indices() are those there were, one for one. False when there is nothing to take back. Then
  /// update(), which returns what is to be uploaded. Linear time in the mesh.
  bool undo() {
    return stepped([this] { return buffers_->undo(buffer_) && counted_anew(history_->undo(mesh_)); });
  }
  bool redo() {
    return stepped([this] { return buffers_->redo(buffer_) && counted_anew(history_->redo(mesh_)); });
  }

  /// Draw them as one triangle strip with primitive restart.
  [[nodiscard]] std::span<const std::uint32_t> indices() const noexcept { return buffer_.indices(); }
  [[nodiscard]] const Mesh& mesh() const noexcept { return mesh_; }
  [[nodiscard]] Keeper<Mesh>& keeper() noexcept { return keeper_; }

 private:
  BasicLiveMesh(Mesh&& mesh, const LiveOptions& options, bool from_scratch)
      : mesh_(std::move(mesh)), keeper_(colored(mesh_, options, from_scratch), options.policy, options.cost) {
    mesh_.watch(&changed_);
    buffer_.rebuild(mesh_);
    if (options.history == 0) return;
    history_.emplace(mesh_, options.history);
    buffers_.emplace(buffer_);
  }
  static Mesh& colored(Mesh& mesh, const LiveOptions& options, bool from_scratch) {
    if (from_scratch) stripify(mesh, options.effort, options.cost);
    return mesh;
  }
  template <class Step>
  bool stepped(Step&& step) {
    if (history_) update();
    if (!history_) return false;  // there is none, or it was given up
    buffer_.keep_ranges();
    interrupted_ = true;
    const bool done = step();
    interrupted_ = false;
    return done;
  }
  bool counted_anew(bool done) {
    changed_.clear();  // the buffer has it already
    if (done) keeper_.rebuild();
    return done;
  }

  Mesh mesh_;
  Keeper<Mesh> keeper_;
  std::vector<Triangle> changed_;
  StripBuffer buffer_;
  std::optional<History> history_;
  std::optional<BufferHistory> buffers_;  // where there is a history; in step with it
  bool interrupted_ = false;              // by an exception, so that the histories may be out of step
};

using LiveMesh = BasicLiveMesh<StripMesh>;

}  // namespace restrip
