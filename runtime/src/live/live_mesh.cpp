// LiveMesh: its parts, and frames that keep them in step.
//
// Outline. The mesh names changed triangles in `changed` (StripMesh::watch). The first `framed` of them are part of a
// frame of the history already; all of them are what the next update of the buffer must draw. An update ends a frame
// and then updates the buffer, so that a buffer that refuses a vertex leaves a frame that can be undone. undo() and
// redo() do not touch the buffer: what they change is appended to the list, like any change.
//
// Invariant. `history` describes the mesh up to `framed`, unless it is `lost`, because memory ran out while it noted a
// frame; the next update begins it again.
#include "restrip/live_mesh.hpp"

#include <deque>
#include <utility>

#include "live/live_state.hpp"
#include "mesh/history.hpp"
#include "restrip/formats/baked_file.hpp"
#include "restrip/mesh/split_record.hpp"
#include "restrip/operations/refine.hpp"
#include "restrip/output/live_buffer.hpp"
#include "restrip/output/strips.hpp"
#include "restrip/search/keeper.hpp"
#include "restrip/search/stripify.hpp"

namespace restrip {

namespace detail {

/// What undo restores besides the mesh.
struct FrameState {
  std::optional<Keeper::Counts> counts;  ///< none: the keeper reads the mesh
  std::optional<std::size_t> level;      ///< of baked strips, in step
  std::size_t strips = 0;                ///< of that level
};

/// Frames of the mesh, with the states between them.
struct Frames {
  Frames(const StripMesh& now, const FrameState& state, std::size_t most) : mesh(now, most), states{state} {}

  void frame(const StripMesh& now, std::span<const Triangle> triangles, const FrameState& state) {
    const std::size_t before = mesh.undoable();
    if (!mesh.frame(now, triangles)) {
      states[before] = state;
      return;
    }
    states.resize(before + 1);
    states.push_back(state);
    while (states.size() > mesh.undoable() + 1) states.pop_front();
  }

  History mesh;
  std::deque<FrameState> states;  // at the beginning of the first frame and at the end of each
};

}  // namespace detail

namespace {

/// The base of a baked mesh, with room for all levels.
StripMesh base_of(const BakedFile& file) {
  StripMesh base = file.mesh;
  base.reserve(file.base.size() + 2 * file.splits.size(), file.points.size());
  return base;
}

std::vector<std::uint8_t> solid_sides_of(const StripMesh& mesh) {
  std::vector<std::uint8_t> solid_sides(mesh.triangle_bound(), 0);
  for (Triangle t = 0; t < solid_sides.size(); ++t)
    if (mesh.alive(t)) solid_sides[t] = static_cast<std::uint8_t>(mesh.solid_sides(t));
  return solid_sides;
}

}  // namespace

struct LiveMesh::Parts {
  RESTRIP_COLD Parts(StripMesh own, const LiveOptions& options, std::shared_ptr<const BakedFile> from = nullptr)
      : file(std::move(from)),
        mesh(std::move(own)),
        keeper(file ? Keeper(mesh, Policy::local, Cost::strips()) : Keeper(mesh, options.policy, options.cost)),
        buffer(options.format, options.layout),
        most_history(options.history) {
    if (file) level = 0;
    level_strips = keeper.strips();
    if (options.deferred) return;
    buffer.rebuild(mesh);
    begin();
  }

  /// Begins the list of changes and the history.
  void begin() {
    mesh.watch(&changed);
    changed.clear();
    framed = 0;
    begun = true;
    lost = most_history != 0;
    if (lost) history.emplace(mesh, state(), most_history);
    lost = false;
  }
  [[nodiscard]] bool can_step() const noexcept { return history && !lost; }
  /// Before the mesh becomes another one; after that begin() again, if changes are listed.
  void interrupt() noexcept {
    history.reset();
    lost = most_history != 0;
    changed.clear();
    framed = 0;
    buffer.forget();
  }
  void end_frame() {
    if (!can_step()) return;
    lost = true;
    history->frame(mesh, std::span(changed).subspan(framed), state());
    lost = false;
    framed = changed.size();
  }
  Upload update(const RangeOptions& ranges) {
    if (begun) end_frame();
    if (!begun || lost) {
      buffer.forget();
      begin();
    }
    const Upload upload = buffer.update(mesh, changed, ranges);
    changed.clear();
    framed = 0;
    return upload;
  }
  bool step(bool forward) {
    if (!begun || most_history == 0) return false;
    if (lost) {
      buffer.forget();
      begin();
    }
    end_frame();
    if ((forward ? history->mesh.redoable() : history->mesh.undoable()) == 0) return false;
    forward ? history->mesh.redo(mesh) : history->mesh.undo(mesh);
    framed = changed.size();
    const detail::FrameState& then = history->states[history->mesh.undoable()];
    if (then.level) {
      level = then.level;
      level_strips = then.strips;
      keeper.forget();
    } else {
      leave_levels();
      keeper.return_to(then.counts);
    }
    return true;
  }
  [[nodiscard]] detail::FrameState state() const noexcept {
    return level ? detail::FrameState{std::nullopt, level, level_strips}
                 : detail::FrameState{keeper.counts(), std::nullopt, 0};
  }
  /// If memory runs out for the keeper, it reads the mesh before its next operation.
  void recolor(std::span<const std::uint8_t> solid_sides) {
    mesh.set_colors(solid_sides);
    buffer.forget();
    leave_levels();
    keeper.rebuild();
  }
  /// A keeper does not see the records that are played: it reads the mesh before its first operation after them.
  void leave_levels() noexcept {
    if (level) keeper.forget();
    level.reset();
  }
  /// An operation that is not a record: the mesh leaves its levels, unless the operation is refused.
  template <class Operation>
  Checked operate(Operation&& operation) {
    const std::optional<std::size_t> before = level;
    leave_levels();  // also if an exception ends the operation
    const Checked done = operation(keeper);
    if (!done) level = before;
    return done;
  }
  Checked apply(const OperationPlace& at) {
    return operate([&](Keeper& own) { return checked_apply(own, at.table, at.where); });
  }

  std::shared_ptr<const BakedFile> file;  // of a baked mesh
  StripMesh mesh;
  Keeper keeper;
  std::optional<std::size_t> level;  // records played, while the mesh is at a level of the file
  std::size_t level_strips = 0;      // of that level
  std::vector<Triangle> changed;
  std::size_t framed = 0;
  LiveBuffer buffer;
  std::size_t most_history;
  std::optional<detail::Frames> history;
  bool begun = false;
  bool lost = false;
};

// ---- beginning

RESTRIP_COLD LiveMesh::LiveMesh(StripMesh mesh, const LiveOptions& options, Colors colors) {
  if (colors == Colors::from_scratch) stripify(mesh, options.effort, options.cost);
  parts_ = std::make_unique<Parts>(std::move(mesh), options);
}
LiveMesh::LiveMesh(std::shared_ptr<const BakedFile> file, const LiveOptions& options)
    : parts_(std::make_unique<Parts>(base_of(*file), options, file)) {}
LiveMesh::LiveMesh(LiveMesh&& other) noexcept = default;
LiveMesh& LiveMesh::operator=(LiveMesh&& other) noexcept = default;
RESTRIP_COLD LiveMesh::~LiveMesh() = default;

std::vector<std::byte> LiveMesh::save() const {
  LiveOptions options;
  options.policy = keeper().policy();
  options.cost = keeper().weights();
  options.format = buffer().format();
  options.layout = buffer().layout();
  return detail::LiveState::write(mesh(), options);
}
LiveMesh LiveMesh::load(std::span<const std::byte> bytes, std::size_t history) {
  detail::LiveState::Saved saved = detail::LiveState::read(bytes);
  saved.options.history = history;
  return LiveMesh(std::move(saved.mesh), saved.options);
}
Renumbering LiveMesh::pack() {
  Renumbering numbers = detail::LiveState::pack(parts_->mesh);
  parts_->interrupt();
  parts_->leave_levels();
  parts_->keeper.rebuild();
  if (parts_->begun) parts_->begin();
  return numbers;
}

// ---- operations

LiveMesh::Halfedge LiveMesh::edge(Vertex v, Vertex w) const noexcept {
  return v < mesh().vertex_bound() ? mesh().spoke(v, w) : Halfedge{};
}
Checked LiveMesh::split(const VertexSplit& where, Vertex new_vertex) {
  return parts_->operate([&](Keeper& keeper) { return checked_split(keeper, where, new_vertex); });
}
Checked LiveMesh::split(Vertex v, Vertex left, Vertex right, Vertex new_vertex) {
  if (v >= mesh().vertex_bound()) return split(VertexSplit{}, new_vertex);  // refused: no such edge
  return split(spokes_of(mesh(), {v, new_vertex, left, right}), new_vertex);
}
Checked LiveMesh::collapse(Halfedge chord) {
  return parts_->operate([&](Keeper& keeper) { return checked_collapse(keeper, chord); });
}
Checked LiveMesh::flip(Halfedge h) {
  return parts_->operate([&](Keeper& keeper) { return checked_flip(keeper, h); });
}
Checked LiveMesh::apply(const OperationView& table, Halfedge where) { return parts_->apply({table, where}); }
Checked LiveMesh::apply_anywhere(const OperationView& table, Triangle triangle) {
  return apply(table, first_place(mesh(), table, triangle));
}
Checked LiveMesh::split_face(Halfedge h) { return parts_->apply(split_face_at(mesh(), h)); }
Checked LiveMesh::join_faces(Halfedge chord) { return parts_->apply(join_faces_at(mesh(), chord)); }
Checked LiveMesh::bisect(Halfedge h) { return parts_->apply(bisect_at(mesh(), h)); }
Checked LiveMesh::merge(Halfedge chord) { return parts_->apply(merge_at(mesh(), chord)); }

Checked LiveMesh::replace(std::span<const Triangle> out, std::span<const std::array<Vertex, 3>> in) {
  return parts_->operate([&](Keeper& keeper) { return checked_replace(keeper, out, in); });
}

void LiveMesh::keep(Policy policy, const Cost& cost) {
  parts_->keeper.keep(policy, cost);
  parts_->level.reset();
  if (parts_->history)
    for (detail::FrameState& state : parts_->history->states) state = {};  // counts of another cost
}
std::size_t LiveMesh::improve(std::size_t budget) { return keeper().improve(budget); }
std::size_t LiveMesh::recolor(Effort effort, const Cost& cost, std::uint64_t limit, const Interrupt* interrupt) {
  StripMesh other = mesh();
  const std::size_t strips = stripify(other, effort, cost, limit, 1, interrupt != nullptr ? *interrupt : Interrupt{});
  parts_->recolor(solid_sides_of(other));
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

// ---- baked levels

const BakedFile* LiveMesh::baked() const noexcept { return parts_->file.get(); }
std::optional<std::size_t> LiveMesh::level() const noexcept { return parts_->level; }
std::size_t LiveMesh::move_to_level(std::size_t level, std::size_t most) {
  if (!parts_->level) return 0;
  const BakedFile& file = *parts_->file;
  StripMesh& mesh = parts_->mesh;
  RESTRIP_ASSERT(level <= file.splits.size(), "LiveMesh::move_to_level", "the level does not exist");
  std::size_t played = 0;
  std::size_t at = *parts_->level;
  parts_->leave_levels();  // also if an exception ends it
  for (; at != level && played < most; ++played) {
    const bool up = at < level;
    const std::size_t record = up ? at : at - 1;
    const SplitRecord& split = file.splits[record];
    const Rewrite done = up ? split_baked(mesh, spokes_of(mesh, split), file.records[record], split.v_t)
                            : collapse_baked(mesh, mesh.spoke(split.v_s, split.v_t), file.records[record]);
    at = up ? at + 1 : at - 1;
    parts_->level_strips += static_cast<std::size_t>(done.strips);
  }
  parts_->level = at;
  return played;
}
void LiveMesh::restart() {
  RESTRIP_ASSERT(baked() != nullptr, "LiveMesh::restart", "the mesh has no baked strips");
  StripMesh base = base_of(*parts_->file);
  parts_->interrupt();
  parts_->mesh = std::move(base);
  parts_->keeper.forget();  // also if no memory is left for the next line
  parts_->keeper = Keeper(parts_->mesh, Policy::local, Cost::strips());
  parts_->level = 0;
  parts_->level_strips = count_strips(parts_->mesh);
  if (parts_->begun) parts_->begin();
}

// ---- frames

Upload LiveMesh::update(const RangeOptions& ranges) { return parts_->update(ranges); }
void LiveMesh::keep_upload() noexcept { parts_->buffer.keep_upload(); }
bool LiveMesh::undo() { return parts_->step(false); }
bool LiveMesh::redo() { return parts_->step(true); }
std::size_t LiveMesh::undoable() const noexcept { return parts_->can_step() ? parts_->history->mesh.undoable() : 0; }
std::size_t LiveMesh::redoable() const noexcept { return parts_->can_step() ? parts_->history->mesh.redoable() : 0; }
std::size_t LiveMesh::frame() const noexcept { return parts_->can_step() ? parts_->history->mesh.number() : 0; }

// ---- the buffer

void LiveMesh::begin_buffer(const StripFormat& format, const LayoutOptions& layout, std::size_t history) {
  LiveBuffer buffer(format, layout);
  parts_->mesh.watch(nullptr);
  parts_->most_history = history;
  parts_->interrupt();
  parts_->begun = false;
  parts_->buffer = std::move(buffer);
}
void LiveMesh::reserve(std::size_t triangles, std::size_t vertices) {
  parts_->mesh.reserve(triangles, vertices);
  parts_->buffer.reserve(triangles);
  parts_->keeper.reserve(triangles);
}
std::span<const std::uint32_t> LiveMesh::indices() const noexcept { return buffer().indices(); }
std::span<const std::uint16_t> LiveMesh::indices16() const noexcept { return buffer().indices16(); }
std::span<const std::byte> LiveMesh::bytes() const noexcept { return buffer().bytes(); }
std::size_t LiveMesh::index_bytes() const noexcept { return buffer().index_bytes(); }
std::size_t LiveMesh::room() const noexcept { return buffer().room(); }

// ---- the parts

const StripMesh& LiveMesh::mesh() const noexcept { return parts_->mesh; }
std::size_t LiveMesh::strips() const noexcept { return parts_->level ? parts_->level_strips : keeper().strips(); }
std::span<const Triangle> LiveMesh::changed() const noexcept { return parts_->changed; }
const RuleCounts& LiveMesh::rule_counts() const noexcept { return keeper().rule_counts(); }
Keeper& LiveMesh::keeper() noexcept {
  parts_->leave_levels();
  return parts_->keeper;
}
const Keeper& LiveMesh::keeper() const noexcept { return parts_->keeper; }
const LiveBuffer& LiveMesh::buffer() const noexcept { return parts_->buffer; }

}  // namespace restrip
