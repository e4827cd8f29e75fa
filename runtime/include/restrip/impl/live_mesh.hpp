// LiveMesh: its parts, and frames that keep them in step. Included by live_mesh.hpp.
//
// The mesh names changed triangles in `changed` (StripMesh::watch), an update of the buffer and a frame of the history
// consume the list. What may throw is done in an order that leaves a flag set: `undelivered` until an update returns,
// so that the next one returns its ranges as well, and `interrupted` while the histories may be out of step with mesh
// and buffer; the next update then writes the whole buffer and begins them again.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "restrip/impl/live_state.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/history.hpp"
#include "restrip/operations/checked.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/buffer_history.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {

struct LiveMesh::Parts {
  using Totals = Keeper<StripMesh>::Totals;
  /// Of the mesh, its buffer and its keeper, which have the same frames.
  struct Histories {
    Histories(const StripMesh& now, LiveBuffer& buffer_now, const Totals& totals_now, std::size_t most)
        : mesh(now, most), buffer(buffer_now), totals{totals_now} {}
    /// After the frame of the mesh, which could undo `undoable` frames before it.
    void frame(const Totals& totals_now, std::size_t undoable) {
      totals.resize(undoable + 1);
      totals.push_back(totals_now);
      while (totals.size() > mesh.undoable() + 1) totals.pop_front();
    }
    History mesh;
    LiveHistory buffer;
    std::deque<Totals> totals;  // at the beginning of the first frame and at the end of each
  };

  Parts(StripMesh own, const LiveOptions& options)
      : mesh(std::move(own)),
        keeper(mesh, options.policy, options.cost),
        buffer(options.format, options.layout),
        most_history(options.history) {
    mesh.watch(&changed);
    buffer.rebuild(mesh);
    if (most_history != 0) history.emplace(mesh, buffer, keeper.totals(), most_history);
  }
  Parts(StripMesh own, const LiveOptions& options, detail::LiveState::Reader& in)
      : mesh(std::move(own)),
        keeper(mesh, options.policy, options.cost),
        buffer(options.format, options.layout),
        most_history(options.history) {
    mesh.watch(&changed);
    detail::LiveState::read_buffer(in, mesh, buffer);
    keeper.visit_state(in);
    in.expect_end();
    if (most_history != 0) history.emplace(mesh, buffer, keeper.totals(), most_history);
  }

  [[nodiscard]] bool can_step() const noexcept { return history && !interrupted; }
  Upload end_frame(const RangeOptions& ranges) {
    if (std::exchange(undelivered, true)) buffer.keep_upload();
    if (interrupted) buffer.forget();
    const Upload upload = buffer.update(mesh, changed, ranges);
    if (most_history != 0) {
      if (std::exchange(interrupted, true)) {
        history.emplace(mesh, buffer, keeper.totals(), most_history);
      } else {
        const std::size_t undoable = history->mesh.undoable();
        const bool is_frame = history->mesh.frame(mesh, changed);
        history->buffer.frame(buffer, changed, is_frame, history->mesh.undoable());
        if (is_frame) history->frame(keeper.totals(), undoable);
      }
      interrupted = false;
    }
    changed.clear();
    return upload;
  }
  std::size_t compact(std::size_t budget) {
    end_frame({});
    buffer.keep_upload();
    return buffer.compact(mesh, budget);
  }
  bool step(bool forward) {
    if (most_history == 0) return false;
    end_frame({});
    if ((forward ? history->mesh.redoable() : history->mesh.undoable()) == 0) return false;
    interrupted = true;
    const bool exact = forward ? history->buffer.redo(buffer) : history->buffer.undo(buffer);
    forward ? history->mesh.redo(mesh) : history->mesh.undo(mesh);
    if (exact) changed.clear();  // the buffer is up to date already
    interrupted = false;
    keeper.return_to(history->totals[history->mesh.undoable()]);
    return true;
  }

  StripMesh mesh;
  Keeper<StripMesh> keeper;
  std::vector<Triangle> changed;
  LiveBuffer buffer;
  std::size_t most_history;
  std::optional<Histories> history;
  bool interrupted = false;  // by an exception, so that mesh, buffer and histories may be out of step
  bool undelivered = false;  // the last frame has ended, but nothing was returned
};

RESTRIP_INLINE LiveMesh::LiveMesh(StripMesh mesh, const LiveOptions& options, Colors colors) {
  if (colors == Colors::from_scratch) stripify(mesh, options.effort, options.cost);
  parts_ = std::make_unique<Parts>(std::move(mesh), options);
}
RESTRIP_INLINE LiveMesh::LiveMesh(std::unique_ptr<Parts> parts) noexcept : parts_(std::move(parts)) {}
RESTRIP_INLINE LiveMesh::LiveMesh(LiveMesh&& other) noexcept = default;
RESTRIP_INLINE LiveMesh& LiveMesh::operator=(LiveMesh&& other) noexcept = default;
RESTRIP_INLINE LiveMesh::~LiveMesh() = default;

RESTRIP_INLINE LiveMesh::Halfedge LiveMesh::edge(Vertex v, Vertex w) const noexcept {
  return v < mesh().vertex_bound() ? mesh().spoke(v, w) : Halfedge{};
}

RESTRIP_INLINE Checked LiveMesh::split(const VertexSplit<Halfedge>& where, Vertex new_vertex) {
  return checked_split(parts_->keeper, where, new_vertex);
}
RESTRIP_INLINE Checked LiveMesh::collapse(Halfedge chord) { return checked_collapse(parts_->keeper, chord); }
RESTRIP_INLINE Checked LiveMesh::flip(Halfedge h) { return checked_flip(parts_->keeper, h); }
RESTRIP_INLINE Checked LiveMesh::split_face(Halfedge h) { return checked_split_face(parts_->keeper, h); }
RESTRIP_INLINE Checked LiveMesh::join_faces(Halfedge chord) { return checked_join_faces(parts_->keeper, chord); }
RESTRIP_INLINE Checked LiveMesh::bisect(Halfedge h) { return checked_bisect(parts_->keeper, h); }
RESTRIP_INLINE Checked LiveMesh::merge(Halfedge chord) { return checked_merge(parts_->keeper, chord); }
RESTRIP_INLINE std::size_t LiveMesh::improve(std::size_t budget) { return parts_->keeper.improve(budget); }
RESTRIP_INLINE std::size_t LiveMesh::compact(std::size_t budget) { return parts_->compact(budget); }

RESTRIP_INLINE Upload LiveMesh::update(const RangeOptions& ranges) {
  const Upload upload = parts_->end_frame(ranges);
  parts_->undelivered = false;
  return upload;
}
RESTRIP_INLINE bool LiveMesh::undo() { return parts_->step(false); }
RESTRIP_INLINE bool LiveMesh::redo() { return parts_->step(true); }
RESTRIP_INLINE std::vector<std::byte> LiveMesh::save() {
  using State = detail::LiveState;
  parts_->end_frame({});
  State::Writer out;
  out.bytes.reserve(64 + 44 * mesh().triangle_bound());
  State::write_header(out, parts_->keeper, parts_->buffer);
  State::write_mesh(out, mesh());
  State::write_buffer(out, mesh(), parts_->buffer);
  parts_->keeper.visit_state(out);
  out.put(baked_format::fnv1a(std::span<const std::byte>(out.bytes)));
  return std::move(out.bytes);
}
RESTRIP_INLINE LiveMesh LiveMesh::load(std::span<const std::byte> bytes, std::size_t history) {
  using State = detail::LiveState;
  State::Reader in(bytes);
  LiveOptions options = State::read_header(in);
  options.history = history;
  StripMesh mesh = State::read_mesh(in);
  return LiveMesh(std::make_unique<Parts>(std::move(mesh), options, in));
}
RESTRIP_INLINE std::size_t LiveMesh::undoable() const noexcept {
  return parts_->can_step() ? parts_->history->mesh.undoable() : 0;
}
RESTRIP_INLINE std::size_t LiveMesh::redoable() const noexcept {
  return parts_->can_step() ? parts_->history->mesh.redoable() : 0;
}

RESTRIP_INLINE std::span<const std::uint32_t> LiveMesh::indices() const noexcept { return parts_->buffer.indices(); }
RESTRIP_INLINE std::span<const std::uint16_t> LiveMesh::indices16() const noexcept {
  return parts_->buffer.indices16();
}
RESTRIP_INLINE std::span<const std::byte> LiveMesh::bytes() const noexcept { return parts_->buffer.bytes(); }
RESTRIP_INLINE std::size_t LiveMesh::index_bytes() const noexcept { return parts_->buffer.index_bytes(); }
RESTRIP_INLINE std::size_t LiveMesh::room() const noexcept { return parts_->buffer.room(); }
RESTRIP_INLINE const StripMesh& LiveMesh::mesh() const noexcept { return parts_->mesh; }
RESTRIP_INLINE std::size_t LiveMesh::strips() const noexcept { return parts_->keeper.strips(); }
RESTRIP_INLINE const RuleCounts& LiveMesh::rule_counts() const noexcept { return parts_->keeper.rule_counts(); }
RESTRIP_INLINE Keeper<StripMesh>& LiveMesh::keeper() noexcept { return parts_->keeper; }
RESTRIP_INLINE const LiveBuffer& LiveMesh::buffer() const noexcept { return parts_->buffer; }

}  // namespace restrip
