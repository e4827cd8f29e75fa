// LiveMesh: its parts, and frames that keep them in step. Included by live_mesh.hpp.
//
// The mesh names changed triangles in `changed` (StripMesh::watch), an update of the buffer and a frame of the history
// consume the list. What may throw is done in an order that leaves a flag set: `undelivered` until an update returns,
// so that the next one returns its ranges as well, and `interrupted` while the histories may be out of step with mesh
// and buffer; the next update then writes the whole buffer and begins them again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "restrip/formats/baked_file.hpp"
#include "restrip/impl/live_state.hpp"
#include "restrip/live_mesh.hpp"
#include "restrip/mesh/history.hpp"
#include "restrip/mesh/split_record.hpp"
#include "restrip/operations/checked.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/buffer_history.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {

struct LiveMesh::Parts {
  using State = Keeper<StripMesh>::State;
  /// Of the mesh, its buffer and its keeper, which have the same frames.
  struct Histories {
    RESTRIP_COLD Histories(const StripMesh& now, LiveBuffer& buffer_now, const State& state, std::size_t most)
        : mesh(now, most), buffer(buffer_now), states{state} {}
    void frame(const StripMesh& now, LiveBuffer& buffer_now, std::span<const Triangle> triangles, const State& state) {
      const std::size_t undoable = mesh.undoable();
      const bool is_frame = mesh.frame(now, triangles);
      buffer.frame(buffer_now, triangles, is_frame, mesh.undoable());
      if (!is_frame) {
        states[undoable] = state;
        return;
      }
      while (states.size() > undoable + 1) states.pop_back();
      states.push_back(state);
      for (; states.size() > mesh.undoable() + 1; ++dropped) states.pop_front();
    }
    History mesh;
    LiveHistory buffer;
    std::deque<State> states;  // at the beginning of the first frame and at the end of each
    std::size_t dropped = 0;   // frames before the first one
  };

  RESTRIP_COLD Parts(StripMesh own, const LiveOptions& options, std::shared_ptr<const BakedFile> from = nullptr)
      : file(std::move(from)),
        mesh(std::move(own)),
        keeper(file ? Keeper<StripMesh>(mesh, file->records) : Keeper<StripMesh>(mesh, options.policy, options.cost)),
        buffer(options.format, options.layout),
        most_history(options.history) {
    if (options.deferred) return;
    begin();
    buffer.rebuild(mesh);
    begin_history();
  }
  Parts(StripMesh own, const LiveOptions& options, detail::LiveState::Reader& in)
      : mesh(std::move(own)),
        keeper(mesh, options.policy, options.cost),
        buffer(options.format, options.layout),
        most_history(options.history) {
    begin();
    detail::LiveState::read_buffer(in, mesh, buffer);
    keeper.visit_state(in);
    in.expect_end();
    begin_history();
  }
  /// The base of a baked mesh, with room for all levels.
  static StripMesh base_of(const BakedFile& file) {
    StripMesh base = file.mesh;
    base.reserve(file.base.size() + 2 * file.splits.size(), file.points.size());
    return base;
  }

  void begin() noexcept { mesh.watch(&changed); }
  RESTRIP_COLD void begin_history() {
    if (most_history != 0) history.emplace(mesh, buffer, keeper.state(), most_history);
    interrupted = false;
  }
  [[nodiscard]] bool can_step() const noexcept { return history && !interrupted; }
  Upload end_frame(const RangeOptions& ranges) {
    begin();
    if (std::exchange(undelivered, true)) buffer.keep_upload();
    if (interrupted) buffer.forget();
    if (can_step() && !changed.empty()) {
      interrupted = true;
      history->buffer.before_update(buffer);
      interrupted = false;
    }
    const Upload upload = buffer.update(mesh, changed, ranges);
    if (std::exchange(interrupted, true)) {
      begin_history();
    } else {
      if (history) history->frame(mesh, buffer, changed, keeper.state());
      interrupted = false;
    }
    changed.clear();
    return upload;
  }
  bool step(bool forward) {
    if (most_history == 0) return false;
    end_frame({});  // begins a missing history
    if ((forward ? history->mesh.redoable() : history->mesh.undoable()) == 0) return false;
    interrupted = true;
    const bool exact = forward ? history->buffer.redo(buffer) : history->buffer.undo(buffer);
    forward ? history->mesh.redo(mesh) : history->mesh.undo(mesh);
    if (exact) changed.clear();  // the buffer is up to date already
    interrupted = false;
    keeper.return_to(history->states[history->mesh.undoable()]);
    return true;
  }
  /// If memory runs out for the keeper, it reads the mesh before its next operation.
  void recolor(std::span<const std::uint8_t> solid_sides) {
    mesh.set_colors(solid_sides);
    buffer.forget();
    if (keeper.baked() != nullptr) keeper.baked()->leave_step();
    keeper.rebuild();
  }
  std::size_t move_to_level(std::size_t level, std::size_t most) {
    const auto* const player = keeper.baked();
    if (player == nullptr || !player->in_step()) return 0;
    RESTRIP_ASSERT(level <= file->splits.size(), "LiveMesh::move_to_level", "the level does not exist");
    std::size_t played = 0;
    for (; player->level() != level && played < most; ++played) {
      const std::size_t at = player->level();
      const SplitRecord& split = file->splits[at < level ? at : at - 1];
      if (at < level)
        keeper.split_record(at, spokes_of(mesh, split), split.v_t);
      else
        keeper.collapse_record(at - 1, mesh.spoke(split.v_s, split.v_t));
    }
    return played;
  }
  void restart() {
    RESTRIP_ASSERT(file != nullptr, "LiveMesh::restart", "the mesh has no baked strips");
    StripMesh base = base_of(*file);
    interrupted = true;
    mesh = std::move(base);
    keeper.rebuild();  // also if no memory is left for the next line
    keeper = Keeper<StripMesh>(mesh, file->records);
  }

  std::shared_ptr<const BakedFile> file;  // of a baked mesh
  StripMesh mesh;
  Keeper<StripMesh> keeper;
  std::vector<Triangle> changed;
  LiveBuffer buffer;
  std::size_t most_history;
  std::optional<Histories> history;
  bool interrupted = true;   // mesh, buffer and histories may be out of step: not begun, or after an exception
  bool undelivered = false;  // the last frame has ended, but nothing was returned
};

RESTRIP_COLD LiveMesh::LiveMesh(StripMesh mesh, const LiveOptions& options, Colors colors) {
  if (colors == Colors::from_scratch) stripify(mesh, options.effort, options.cost);
  parts_ = std::make_unique<Parts>(std::move(mesh), options);
}
LiveMesh::LiveMesh(std::shared_ptr<const BakedFile> file, const LiveOptions& options)
    : parts_(std::make_unique<Parts>(Parts::base_of(*file), options, file)) {}
LiveMesh::LiveMesh(std::unique_ptr<Parts> parts) noexcept : parts_(std::move(parts)) {}
LiveMesh::LiveMesh(LiveMesh&& other) noexcept = default;
LiveMesh& LiveMesh::operator=(LiveMesh&& other) noexcept = default;
RESTRIP_COLD LiveMesh::~LiveMesh() = default;

LiveMesh::Halfedge LiveMesh::edge(Vertex v, Vertex w) const noexcept {
  return v < mesh().vertex_bound() ? mesh().spoke(v, w) : Halfedge{};
}

Checked LiveMesh::split(const VertexSplit& where, Vertex new_vertex) {
  return checked_split(parts_->keeper, where, new_vertex);
}
Checked LiveMesh::collapse(Halfedge chord) { return checked_collapse(parts_->keeper, chord); }
Checked LiveMesh::flip(Halfedge h) { return checked_flip(parts_->keeper, h); }
Checked LiveMesh::apply(const OperationView& table, Halfedge where) {
  return checked_apply(parts_->keeper, table, where);
}
Checked LiveMesh::apply_anywhere(const OperationView& table, Triangle triangle) {
  return apply(table, first_place(parts_->mesh, table, triangle));
}
Checked LiveMesh::split_face(Halfedge h) {
  const OperationPlace at = split_face_at(parts_->mesh, h);
  return apply(at.table, at.where);
}
Checked LiveMesh::join_faces(Halfedge chord) {
  const OperationPlace at = join_faces_at(parts_->mesh, chord);
  return apply(at.table, at.where);
}
Checked LiveMesh::bisect(Halfedge h) {
  const OperationPlace at = bisect_at(parts_->mesh, h);
  return apply(at.table, at.where);
}
Checked LiveMesh::merge(Halfedge chord) {
  const OperationPlace at = merge_at(parts_->mesh, chord);
  return apply(at.table, at.where);
}
void LiveMesh::keep(Policy policy, const Cost& cost) { parts_->keeper.keep(policy, cost); }
std::size_t LiveMesh::recolor(Effort effort, const Cost& cost, std::uint64_t limit) {
  StripMesh other = mesh();
  const std::size_t strips = stripify(other, effort, cost, limit);
  std::vector<std::uint8_t> solid_sides(other.triangle_bound(), 0);
  for (Triangle t = 0; t < solid_sides.size(); ++t)
    if (other.alive(t)) solid_sides[t] = static_cast<std::uint8_t>(other.solid_sides(t));
  parts_->recolor(solid_sides);
  return strips;
}
bool LiveMesh::recolor(std::span<const std::uint8_t> solid_sides) {
  if (solid_sides.size() != mesh().triangle_bound()) return false;
  for (Triangle t = 0; t < solid_sides.size(); ++t)
    for (unsigned side = 0; side < 8; ++side) {
      if ((solid_sides[t] >> side & 1U) == 0) continue;
      if (side > 2 || !mesh().alive(t)) return false;
      const Halfedge across = mesh().opposite(StripMesh::halfedge(t, side));
      if (StripMesh::on_boundary(across) ||
          (std::uint32_t{solid_sides[StripMesh::triangle(across)]} >> StripMesh::side(across) & 1U) == 0)
        return false;
    }
  StripMesh other = mesh();
  other.set_colors(solid_sides);
  if (!check_coloring(other).valid) return false;
  parts_->recolor(solid_sides);
  return true;
}

const BakedFile* LiveMesh::baked() const noexcept { return parts_->file.get(); }
std::optional<std::size_t> LiveMesh::level() const noexcept {
  const auto* const player = parts_->keeper.baked();
  return player != nullptr && player->in_step() ? std::optional(player->level()) : std::nullopt;
}
std::size_t LiveMesh::move_to_level(std::size_t level, std::size_t most) { return parts_->move_to_level(level, most); }
void LiveMesh::restart() { parts_->restart(); }

std::size_t LiveMesh::improve(std::size_t budget) { return parts_->keeper.improve(budget); }

Upload LiveMesh::update(const RangeOptions& ranges) {
  const Upload upload = parts_->end_frame(ranges);
  parts_->undelivered = false;
  return upload;
}
void LiveMesh::keep_upload() noexcept { parts_->undelivered = true; }
bool LiveMesh::undo() { return parts_->step(false); }
bool LiveMesh::redo() { return parts_->step(true); }
std::vector<std::byte> LiveMesh::save() {
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
LiveMesh LiveMesh::load(std::span<const std::byte> bytes, std::size_t history) {
  using State = detail::LiveState;
  State::Reader in(bytes);
  LiveOptions options = State::read_header(in);
  options.history = history;
  StripMesh mesh = State::read_mesh(in);
  return LiveMesh(std::make_unique<Parts>(std::move(mesh), options, in));
}
std::size_t LiveMesh::undoable() const noexcept { return parts_->can_step() ? parts_->history->mesh.undoable() : 0; }
std::size_t LiveMesh::redoable() const noexcept { return parts_->can_step() ? parts_->history->mesh.redoable() : 0; }

std::size_t LiveMesh::frame() const noexcept {
  return parts_->can_step() ? parts_->history->dropped + parts_->history->mesh.undoable() : 0;
}

void LiveMesh::begin_buffer(const StripFormat& format, const LayoutOptions& layout, std::size_t history) {
  LiveBuffer buffer(format, layout);
  parts_->mesh.watch(nullptr);
  parts_->changed.clear();
  parts_->history.reset();
  parts_->most_history = history;
  parts_->buffer = std::move(buffer);
  parts_->interrupted = true;
  parts_->undelivered = false;
}
void LiveMesh::reserve(std::size_t triangles, std::size_t vertices) {
  parts_->mesh.reserve(triangles, vertices);
  parts_->buffer.reserve(triangles);
  parts_->keeper.reserve(triangles);
}

std::span<const std::uint32_t> LiveMesh::indices() const noexcept { return parts_->buffer.indices(); }
std::span<const std::uint16_t> LiveMesh::indices16() const noexcept { return parts_->buffer.indices16(); }
std::span<const std::byte> LiveMesh::bytes() const noexcept { return parts_->buffer.bytes(); }
std::size_t LiveMesh::index_bytes() const noexcept { return parts_->buffer.index_bytes(); }
std::size_t LiveMesh::room() const noexcept { return parts_->buffer.room(); }
const StripMesh& LiveMesh::mesh() const noexcept { return parts_->mesh; }
std::size_t LiveMesh::strips() const noexcept { return parts_->keeper.strips(); }
std::span<const Triangle> LiveMesh::changed() const noexcept { return parts_->changed; }
const RuleCounts& LiveMesh::rule_counts() const noexcept { return parts_->keeper.rule_counts(); }
Keeper<StripMesh>& LiveMesh::keeper() noexcept { return parts_->keeper; }
const Keeper<StripMesh>& LiveMesh::keeper() const noexcept { return parts_->keeper; }
const LiveBuffer& LiveMesh::buffer() const noexcept { return parts_->buffer; }

}  // namespace restrip
